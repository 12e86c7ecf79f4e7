// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/image.h>
#include <pcl_attention/core/object_contour.h>
#include <pcl_attention/core/skeleton.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pcl_attention
{

namespace
{

/** \brief What decides is so much wider around a point than the contour may move. */
constexpr int reach_of_width = 4;

/** \brief How alike two colours are, 0..1: a Gaussian of their distance in RGB, a table of its square. */
class Likeness
{
public:
  Likeness ()
  {
    constexpr double deviation = 20.0; // of 255: shading and noise of one surface
    for (std::size_t i = 0; i < table_.size (); ++i)
      table_[i] = static_cast<float> (std::exp (-static_cast<double> (i * cell) / (2.0 * deviation * deviation)));
  }

  float
  operator() (int red, int green, int blue) const
  {
    const auto place = static_cast<std::size_t> (red * red + green * green + blue * blue) / cell;
    return (place < table_.size () ? table_[place] : 0.0f);
  }

private:
  static constexpr std::size_t cell = 16;
  std::array<float, 512> table_;
};

using Mask = Image<std::uint8_t>;

void
uniteWith (const std::uint8_t* from, int count, std::uint8_t* to)
{
  for (int i = 0; i < count; ++i)
    to[i] |= from[i];
}

/** \brief Unite every pixel of a mask with those so many columns, or rows, before and behind it. */
Mask
spread (const Mask& mask, int columns, int rows)
{
  Mask result = mask;
  for (int row = 0; row < mask.height; ++row)
  {
    std::uint8_t* const to = &result (0, row);
    if (columns > 0 && columns < mask.width)
    {
      uniteWith (&mask (0, row), mask.width - columns, to + columns);
      uniteWith (&mask (columns, row), mask.width - columns, to);
    }
    for (const int other : {row - rows, row + rows})
      if (rows > 0 && other >= 0 && other < mask.height)
        uniteWith (&mask (0, other), mask.width, to);
  }
  return (result);
}

/** \brief All bits of a mask at most so many columns and rows off. */
Mask
dilated (Mask mask, int width)
{
  // What has spread so far leaves no gap when it is moved by one more, not even where the mask ends and it has spread to one side.
  for (int reach = 0, step; reach < width; reach += step)
  {
    step = std::min (reach + 1, width - reach);
    mask = spread (spread (mask, step, 0), 0, step);
  }
  return (mask);
}

/** \brief The image around an object: what is of it and what is not, and what lies clearly within either. */
class Surroundings
{
public:
  Surroundings (const OrganizedCloud& cloud, int width, const pcl::Indices& indices)
  : cloud_ (cloud), width_ (width), reach_ (reach_of_width * width)
  {
    int left = cloud.width, right = -1;
    for (const pcl::index_t index : indices)
    {
      left = std::min (left, index % cloud.width);
      right = std::max (right, index % cloud.width);
    }
    const int margin = width + reach_;
    first_column_ = std::max (0, left - margin);
    first_row_ = std::max (0, indices.front () / cloud.width - margin);
    const int columns = std::min (cloud.width, right + margin + 1) - first_column_;
    const int rows = std::min (cloud.height, indices.back () / cloud.width + margin + 1) - first_row_;
    all_ = Mask (columns, rows, unsure);
    for (int row = 0; row < rows; ++row)
      std::transform (&cloud.valid[indexOf (0, row)], &cloud.valid[indexOf (0, row)] + columns, &all_ (0, row),
                      [] (std::uint8_t valid) { return (static_cast<std::uint8_t> (valid ? of_rest : unsure)); });
    for (const pcl::index_t index : indices)
      all_ (index % cloud.width - first_column_, index / cloud.width - first_row_) = of_object;
    // Sure is what has nothing of the other side near it.
    sure_ = dilated (all_, width);
    std::transform (all_.data.begin (), all_.data.end (), sure_.data.begin (), sure_.data.begin (),
                    [] (std::uint8_t side, std::uint8_t near) { return (near == side ? side : static_cast<std::uint8_t> (unsure)); });
  }

  void
  extend (int threads, pcl::Indices& indices) const
  {
    const std::size_t before = indices.size ();
    std::vector<Pixel> front;
    for (const pcl::index_t index : indices)
    {
      const Pixel pixel{index % cloud_.width - first_column_, index / cloud_.width - first_row_};
      if (sure_ (pixel.column, pixel.row) == unsure)
        front.push_back (pixel);
    }
    Mask seen = all_;
    for (int ring = 0; ring < width_; ++ring)
    {
      std::vector<Pixel> around;
      for (const Pixel& pixel : front)
        for (int row = std::max (0, pixel.row - 1); row <= std::min (seen.height - 1, pixel.row + 1); ++row)
          for (int column = std::max (0, pixel.column - 1); column <= std::min (seen.width - 1, pixel.column + 1); ++column)
            if (seen (column, row) != of_object && goesOn (indexOf (pixel.column, pixel.row), indexOf (column, row)))
            {
              seen (column, row) = of_object;
              around.push_back ({column, row});
            }
      std::vector<std::uint8_t> is_alike (around.size ());
      constexpr int together = 128;
      forEachBand (static_cast<int> (around.size ()), together, threads, [&] (int begin, int end) {
        for (int i = begin; i < end; ++i)
          is_alike[i] = looksLikeObject (around[i].column, around[i].row);
      });
      front.clear ();
      for (std::size_t i = 0; i < around.size (); ++i)
        if (is_alike[i])
        {
          front.push_back (around[i]);
          indices.push_back (indexOf (around[i].column, around[i].row));
        }
    }
    std::sort (indices.begin () + static_cast<std::ptrdiff_t> (before), indices.end ());
    std::inplace_merge (indices.begin (), indices.begin () + static_cast<std::ptrdiff_t> (before), indices.end ());
  }

private:
  /** \brief As bits, of which a pixel near both has two. */
  enum Side : std::uint8_t
  {
    unsure = 0,
    of_object = 1,
    of_rest = 2
  };

  pcl::index_t
  indexOf (int column, int row) const
  {
    return ((first_row_ + row) * cloud_.width + first_column_ + column);
  }

  bool
  goesOn (pcl::index_t from, pcl::index_t to) const
  {
    constexpr float largest_step = 0.02f; // metres
    return (cloud_.valid[to] && std::abs (cloud_.z[to] - cloud_.z[from]) <= largest_step);
  }

  /** \brief Whether the colours of the object nearby are more likely to have this point's than those of the rest. */
  bool
  looksLikeObject (int column, int row) const
  {
    static const Likeness likeness;
    constexpr int step = 3, enough = 8;
    constexpr float clearly = 2.0f, least = 1e-3f;
    const pcl::index_t index = indexOf (column, row);
    const int red = cloud_.red[index], green = cloud_.green[index], blue = cloud_.blue[index];
    // The samples lie on the same grid around the point wherever the image ends.
    const auto firstInImage = [this] (int place) {
      const int first = place - reach_;
      return (first >= 0 ? first : (step + first % step) % step);
    };
    const int last_row = std::min (sure_.height - 1, row + reach_), last_column = std::min (sure_.width - 1, column + reach_);
    std::array<float, 3> sums{};
    std::array<int, 3> counts{};
    for (int r = firstInImage (row); r <= last_row; r += step)
    {
      const std::uint8_t* const sides = &sure_ (0, r);
      const pcl::index_t first = indexOf (0, r);
      for (int c = firstInImage (column); c <= last_column; c += step)
      {
        if (sides[c] == unsure)
          continue;
        const pcl::index_t other = first + c;
        sums[sides[c]] += likeness (cloud_.red[other] - red, cloud_.green[other] - green, cloud_.blue[other] - blue);
        ++counts[sides[c]];
      }
    }
    if (counts[of_object] < enough || counts[of_rest] < enough)
      return (false);
    return (sums[of_object] / static_cast<float> (counts[of_object]) >
            clearly * sums[of_rest] / static_cast<float> (counts[of_rest]) + least);
  }

  const OrganizedCloud& cloud_;
  int width_, reach_;
  int first_column_, first_row_;
  Mask all_;  /**< \ref Side of every pixel; unsure where there is no point */
  Mask sure_; /**< the same, as far as it is sure */
};

} // namespace

void
extendToColors (const OrganizedCloud& cloud, int width, int threads, pcl::Indices& indices)
{
  if (cloud.hasColor () && width > 0 && !indices.empty ())
    Surroundings (cloud, width, indices).extend (threads, indices);
}

} // namespace pcl_attention
