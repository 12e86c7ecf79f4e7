// SPDX-License-Identifier: BSD-3-Clause
#include "instruction_set.h"
#include "surface_rows.h"

#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/pyramid.h>

#include <algorithm>

namespace pcl_attention
{

void
halve (const OrganizedCloud& cloud, const NormalImage& normals, int threads, OrganizedCloud& half_cloud,
       NormalImage& half_normals)
{
  const LaneKernels& kernels = laneKernels ();
  const int width = (cloud.width + 1) / 2, height = (cloud.height + 1) / 2;
  half_cloud.resize (width, height);
  half_normals.resize (half_cloud.size ());
  std::fill (half_normals.curvature.begin (), half_normals.curvature.end (), 0.0f);
  constexpr int ring_size = 4, band_height = 30;
  forEachBand (height, band_height, threads, [&] (int begin, int end) {
    SurfaceRows even (ring_size, width, 1, 2 * kernels.lanes), odd (ring_size, width, 1, 2 * kernels.lanes);
    const auto at = [&] (int row) { return (SplitRow{even.at (row + 1), odd.at (row + 1)}); };
    int filled = 2 * begin - 1;
    for (int row = begin; row < end; ++row)
    {
      for (; filled <= 2 * row + 2; ++filled)
        if (filled >= 0 && filled < cloud.height)
          kernels.fillSplitRow (storedRow (cloud, normals, filled), cloud.width, at (filled));
        else
        {
          even.clear (filled + 1);
          odd.clear (filled + 1);
        }
      SplitRow rows[ring_size];
      const SplitRow* around[ring_size];
      for (int step = 0; step < ring_size; ++step)
      {
        rows[step] = at (2 * row - 1 + step);
        around[step] = &rows[step];
      }
      const std::size_t first = static_cast<std::size_t> (row) * width;
      kernels.halveRow (around, width,
                        {&half_cloud.x[first], &half_cloud.y[first], &half_cloud.z[first], &half_normals.x[first],
                         &half_normals.y[first], &half_normals.z[first], &half_cloud.valid[first], &half_normals.valid[first]});
    }
  });
}

std::vector<PyramidLevel>
coarserLevels (const OrganizedCloud& cloud, const NormalImage& normals, int count, int threads)
{
  std::vector<PyramidLevel> levels (count);
  for (int level = 0; level < count; ++level)
    halve (level == 0 ? cloud : levels[level - 1].cloud, level == 0 ? normals : levels[level - 1].normals, threads,
           levels[level].cloud, levels[level].normals);
  return (levels);
}

Image<float>
doubleSize (const Image<float>& map, int width, int height, int threads)
{
  Image<float> fine (width, height);
  const auto mix = [] (float center, float beside, float above, float across) {
    return (0.5625f * center + 0.1875f * (beside + above) + 0.0625f * across);
  };
  const auto doubleRow = [&] (int row) {
    // A fine pixel lies a quarter of a coarse pixel off its parent's centre, to the side of its parity.
    const int row0 = std::min (row / 2, map.height - 1);
    const int row1 = std::clamp (row % 2 == 0 ? row0 - 1 : row0 + 1, 0, map.height - 1);
    const float *const near = &map (0, row0), *const far = &map (0, row1);
    float* const target = &fine (0, row);
    const auto at = [&] (int column) {
      const int column0 = std::min (column / 2, map.width - 1);
      const int column1 = std::clamp (column % 2 == 0 ? column0 - 1 : column0 + 1, 0, map.width - 1);
      target[column] = mix (near[column0], near[column1], far[column0], far[column1]);
    };
    const int last = std::min (map.width - 1, width / 2);
    for (int column = 0; column < std::min (2, width); ++column)
      at (column);
    for (int column = 1; column < last; ++column)
    {
      target[2 * column] = mix (near[column], near[column - 1], far[column], far[column - 1]);
      target[2 * column + 1] = mix (near[column], near[column + 1], far[column], far[column + 1]);
    }
    for (int column = std::max (2, 2 * last); column < width; ++column)
      at (column);
  };
  constexpr int band_height = 60;
  forEachBand (height, band_height, threads, [&] (int begin, int end) {
    for (int row = begin; row < end; ++row)
      doubleRow (row);
  });
  return (fine);
}

namespace
{

/** \brief Mean of a row's values within a radius, over those inside the image.
  * \param[out] target of the row's width */
void
blurRow (const float* source, int width, int radius, float* target)
{
  const auto at = [&] (int column) {
    const int begin = std::max (0, column - radius), end = std::min (width - 1, column + radius);
    float sum = 0.0f;
    for (int c = begin; c <= end; ++c)
      sum += source[c];
    target[column] = sum / static_cast<float> (end - begin + 1);
  };
  const int size = 2 * radius + 1, inner_end = std::max (radius, width - radius);
  for (int column = 0; column < std::min (radius, width); ++column)
    at (column);
  std::fill (target + std::min (radius, inner_end), target + inner_end, 0.0f);
  for (int step = 0; step < size; ++step)
    for (int column = radius; column < width - radius; ++column)
      target[column] += source[column - radius + step];
  for (int column = radius; column < width - radius; ++column)
    target[column] /= static_cast<float> (size);
  for (int column = inner_end; column < width; ++column)
    at (column);
}

} // namespace

Image<float>
boxBlur (const Image<float>& map, int radius, int threads)
{
  if (radius == 0)
    return (map);
  Image<float> blurred (map.width, map.height);
  constexpr int band_height = 60;
  forEachBand (map.height, band_height, threads, [&] (int begin, int end) {
    const int first = std::max (0, begin - radius), last = std::min (map.height - 1, end - 1 + radius);
    Image<float> horizontal (map.width, last - first + 1);
    for (int row = first; row <= last; ++row)
      blurRow (&map (0, row), map.width, radius, &horizontal (0, row - first));
    for (int row = begin; row < end; ++row)
    {
      const int top = std::max (0, row - radius), bottom = std::min (map.height - 1, row + radius);
      float* const target = &blurred (0, row);
      for (int r = top; r <= bottom; ++r)
      {
        const float* const source = &horizontal (0, r - first);
        for (int column = 0; column < map.width; ++column)
          target[column] += source[column];
      }
      for (int column = 0; column < map.width; ++column)
        target[column] /= static_cast<float> (bottom - top + 1);
    }
  });
  return (blurred);
}

} // namespace pcl_attention
