// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/image.h>
#include <pcl_attention/core/object_contour.h>
#include <pcl_attention/core/skeleton.h>

#include <Eigen/Core>

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

/** \brief Colours of one side at some places of a grid, row by row. */
struct ColorSamples
{
  std::vector<float> red, green, blue;
  std::vector<int> before; /**< how many there are before each place of the grid, which has one more at the end of each row */

  /** \brief How alike a colour and some of the samples are, 0..1 each, in sum: a Gaussian of their distance in RGB, but that it ends. */
  float
  likenessTo (const Eigen::Array3f& color, int begin, int end) const
  {
    constexpr float deviation = 20.0f; // of 255: shading and noise of one surface
    const auto squareOf = [&] (const std::vector<float>& channel, float value) {
      return ((Eigen::Map<const Eigen::ArrayXf> (channel.data () + begin, end - begin) - value).square ());
    };
    const auto distance = squareOf (red, color.x ()) + squareOf (green, color.y ()) + squareOf (blue, color.z ());
    // (1 - x / 8)^8 for exp (-x)
    const auto root = (1.0f - distance / (16.0f * deviation * deviation)).max (0.0f);
    return (root.square ().square ().square ().sum ());
  }
};

/** \brief The image around an object: what is of it and what is not, and what lies clearly within either. */
class Surroundings
{
public:
  Surroundings (const OrganizedCloud& cloud, int width, const pcl::Indices& indices)
  : cloud_ (cloud), width_ (width), reach_ (reach_of_width * width), grid_step_ (2 + width / 3)
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
    takeSamples ();
    // What has no depth is no object.
    std::replace (all_.data.begin (), all_.data.end (), static_cast<std::uint8_t> (unsure), static_cast<std::uint8_t> (of_rest));
  }

  /** \brief Let the object grow over what has its colours. */
  void
  extend (bool across_jumps, int threads)
  {
    advance (of_object, across_jumps, threads);
  }

  /** \brief Take away what has the colours of the rest. */
  void
  shrink (int threads)
  {
    advance (of_rest, true, threads);
  }

  pcl::Indices
  indices () const
  {
    pcl::Indices result;
    for (int row = 0; row < all_.height; ++row)
      for (int column = 0; column < all_.width; ++column)
        if (all_ (column, row) == of_object)
          result.push_back (indexOf (column, row));
    return (result);
  }

private:
  /** \brief As bits, of which a pixel near both has two. */
  enum Side : std::uint8_t
  {
    unsure = 0,
    of_object = 1,
    of_rest = 2
  };

  /** \brief Give a side what looks like it and lies next to it, pixel by pixel. */
  void
  advance (Side side, bool across_jumps, int threads)
  {
    const Mask near = dilated (all_, 1);
    std::vector<Pixel> front;
    for (int row = 0; row < all_.height; ++row)
      for (int column = 0; column < all_.width; ++column)
        if (near (column, row) == (of_object | of_rest) && all_ (column, row) == side)
          front.push_back ({column, row});
    Mask tried (all_.width, all_.height, 0);
    for (int ring = 0; ring < width_; ++ring)
    {
      std::vector<Pixel> around;
      for (const Pixel& pixel : front)
        for (int row = std::max (0, pixel.row - 1); row <= std::min (all_.height - 1, pixel.row + 1); ++row)
          for (int column = std::max (0, pixel.column - 1); column <= std::min (all_.width - 1, pixel.column + 1); ++column)
          {
            const pcl::index_t index = indexOf (column, row);
            if (all_ (column, row) == side || tried (column, row) || !cloud_.valid[index] ||
                !(across_jumps || goesOn (indexOf (pixel.column, pixel.row), index)))
              continue;
            tried (column, row) = 1;
            around.push_back ({column, row});
          }
      std::vector<std::uint8_t> is_alike (around.size ());
      constexpr int together = 128;
      forEachBand (static_cast<int> (around.size ()), together, threads, [&] (int begin, int end) {
        for (int i = begin; i < end; ++i)
          is_alike[i] = looksLike (side, around[i].column, around[i].row);
      });
      front.clear ();
      for (std::size_t i = 0; i < around.size (); ++i)
        if (is_alike[i])
        {
          front.push_back (around[i]);
          all_ (around[i].column, around[i].row) = side;
        }
    }
  }

  pcl::index_t
  indexOf (int column, int row) const
  {
    return ((first_row_ + row) * cloud_.width + first_column_ + column);
  }

  bool
  goesOn (pcl::index_t from, pcl::index_t to) const
  {
    constexpr float largest_step = 0.02f; // metres
    return (std::abs (cloud_.z[to] - cloud_.z[from]) <= largest_step);
  }

  /** \brief How many columns or rows lie before the grid. \param[in] first column or row of the masks in the image */
  int
  offsetOf (int first) const
  {
    return ((grid_step_ - first % grid_step_) % grid_step_);
  }

  /** \brief The first place of the grid at a column or row of the masks or after it. */
  int
  gridPlace (int first, int place) const
  {
    return (std::max (0, (place - offsetOf (first) + grid_step_ - 1) / grid_step_));
  }

  /** \brief Colours of what is sure. The grid is that of the image, so that it does not hang on the object's outline. */
  void
  takeSamples ()
  {
    grid_columns_ = gridPlace (first_column_, sure_.width);
    for (int row = offsetOf (first_row_); row < sure_.height; row += grid_step_)
    {
      for (int column = offsetOf (first_column_); column < sure_.width; column += grid_step_)
      {
        for (ColorSamples& samples : samples_)
          samples.before.push_back (static_cast<int> (samples.red.size ()));
        if (sure_ (column, row) == unsure)
          continue;
        ColorSamples& samples = samples_[sure_ (column, row) == of_rest];
        const pcl::index_t index = indexOf (column, row);
        samples.red.push_back (cloud_.red[index]);
        samples.green.push_back (cloud_.green[index]);
        samples.blue.push_back (cloud_.blue[index]);
      }
      for (ColorSamples& samples : samples_)
        samples.before.push_back (static_cast<int> (samples.red.size ()));
    }
  }

  /** \brief How alike a point's colour and those of a side nearby are, 0..1, on average.
    * \param[in] most what is more need not be known: it is returned as this
    * \return -1 if there are too few of them to tell */
  float
  likenessTo (Side side, int column, int row, float most) const
  {
    constexpr int enough = 4;
    const ColorSamples& samples = samples_[side == of_rest];
    const pcl::index_t index = indexOf (column, row);
    const Eigen::Array3f color (cloud_.red[index], cloud_.green[index], cloud_.blue[index]);
    const int left = gridPlace (first_column_, column - reach_);
    const int right = std::min (grid_columns_, gridPlace (first_column_, column + reach_ + 1));
    const int first_row = gridPlace (first_row_, row - reach_);
    const int last_row = std::min (gridPlace (first_row_, sure_.height), gridPlace (first_row_, row + reach_ + 1));
    const auto rowAt = [&] (int grid_row) { return (&samples.before[static_cast<std::size_t> (grid_row) * (grid_columns_ + 1)]); };
    int count = 0;
    for (int grid_row = first_row; grid_row < last_row; ++grid_row)
      count += rowAt (grid_row)[right] - rowAt (grid_row)[left];
    if (count < enough)
      return (-1.0f);
    const float most_of_all = most * static_cast<float> (count);
    float sum = 0.0f;
    for (int grid_row = first_row; grid_row < last_row; ++grid_row)
    {
      sum += samples.likenessTo (color, rowAt (grid_row)[left], rowAt (grid_row)[right]);
      if (sum >= most_of_all)
        return (most);
    }
    return (sum / static_cast<float> (count));
  }

  /** \brief Whether the colours of one side nearby are more likely to have this point's than those of the other. */
  bool
  looksLike (Side side, int column, int row) const
  {
    constexpr float clearly = 3.0f, least = 1e-3f, too_like = (1.0f - least) / clearly;
    const float of_other = likenessTo (side == of_object ? of_rest : of_object, column, row, too_like);
    if (of_other < 0.0f || of_other >= too_like)
      return (false);
    const float limit = clearly * of_other + least;
    return (likenessTo (side, column, row, limit) >= limit);
  }

  const OrganizedCloud& cloud_;
  int width_, reach_;
  int grid_step_; /**< between samples, pixels; more where they reach farther */
  int first_column_, first_row_;
  Mask all_;  /**< \ref Side of every pixel */
  Mask sure_; /**< the same, as far as it is sure; unsure where there is no point */
  int grid_columns_;
  std::array<ColorSamples, 2> samples_; /**< of the object and of the rest */
};

/** \brief Let a contour move to the colours, outwards up to jumps of the depth, or either way and across them. */
void
moveContour (const OrganizedCloud& cloud, int width, int threads, bool either_way, pcl::Indices& indices)
{
  if (!cloud.hasColor () || width <= 0 || indices.empty ())
    return;
  Surroundings surroundings (cloud, width, indices);
  if (either_way)
    surroundings.shrink (threads);
  surroundings.extend (either_way, threads);
  indices = surroundings.indices ();
}

} // namespace

void
extendToColors (const OrganizedCloud& cloud, int width, int threads, pcl::Indices& indices)
{
  moveContour (cloud, width, threads, false, indices);
}

void
fitToColors (const OrganizedCloud& cloud, int width, int threads, pcl::Indices& indices)
{
  moveContour (cloud, width, threads, true, indices);
}

} // namespace pcl_attention
