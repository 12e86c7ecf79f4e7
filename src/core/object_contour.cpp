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

/** \brief The pixels at most so many columns and rows from one of a mask. */
Mask
dilated (const Mask& mask, int width)
{
  Mask along_rows = mask;
  for (int row = 0; row < mask.height; ++row)
    for (int shift = 1; shift <= std::min (width, mask.width - 1); ++shift)
    {
      const std::uint8_t* const from = &mask (0, row);
      std::uint8_t* const to = &along_rows (0, row);
      uniteWith (from, mask.width - shift, to + shift);
      uniteWith (from + shift, mask.width - shift, to);
    }
  Mask result = along_rows;
  for (int row = 0; row < mask.height; ++row)
    for (int r = std::max (0, row - width); r <= std::min (mask.height - 1, row + width); ++r)
      uniteWith (&along_rows (0, row), mask.width, &result (0, r));
  return (result);
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
    object_ = Mask (columns, rows, 0);
    for (const pcl::index_t index : indices)
      object_ (index % cloud.width - first_column_, index / cloud.width - first_row_) = 1;
    Mask rest (columns, rows, 0);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        rest (column, row) = cloud.valid[indexOf (column, row)] && !object_ (column, row);
    const Mask near_object = dilated (object_, width), near_rest = dilated (rest, width);
    side_ = Mask (columns, rows, unsure);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        if (object_ (column, row) && !near_rest (column, row))
          side_ (column, row) = of_object;
        else if (rest (column, row) && !near_object (column, row))
          side_ (column, row) = of_rest;
  }

  void
  extend (int threads, pcl::Indices& indices) const
  {
    const std::size_t before = indices.size ();
    std::vector<Pixel> front;
    for (const pcl::index_t index : indices)
    {
      const Pixel pixel{index % cloud_.width - first_column_, index / cloud_.width - first_row_};
      if (side_ (pixel.column, pixel.row) == unsure)
        front.push_back (pixel);
    }
    Mask seen = object_;
    for (int ring = 0; ring < width_; ++ring)
    {
      std::vector<Pixel> around;
      for (const Pixel& pixel : front)
        for (int row = std::max (0, pixel.row - 1); row <= std::min (object_.height - 1, pixel.row + 1); ++row)
          for (int column = std::max (0, pixel.column - 1); column <= std::min (object_.width - 1, pixel.column + 1); ++column)
            if (!seen (column, row) && goesOn (indexOf (pixel.column, pixel.row), indexOf (column, row)))
            {
              seen (column, row) = 1;
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
  enum Side : std::uint8_t
  {
    unsure,
    of_object,
    of_rest
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
    const int last_row = std::min (side_.height - 1, row + reach_), last_column = std::min (side_.width - 1, column + reach_);
    std::array<float, 3> sums{};
    std::array<int, 3> counts{};
    for (int r = firstInImage (row); r <= last_row; r += step)
    {
      const std::uint8_t* const sides = &side_ (0, r);
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
  Mask object_;
  Mask side_; /**< \ref Side */
};

} // namespace

void
extendToColors (const OrganizedCloud& cloud, int width, int threads, pcl::Indices& indices)
{
  if (cloud.hasColor () && width > 0 && !indices.empty ())
    Surroundings (cloud, width, indices).extend (threads, indices);
}

} // namespace pcl_attention
