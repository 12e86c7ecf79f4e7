// SPDX-License-Identifier: BSD-3-Clause
#include "instruction_set.h"
#include "surface_rows.h"

#include <pcl_attention/core/pyramid.h>

#include <algorithm>

namespace pcl_attention
{

void
halve (const OrganizedCloud& cloud, const NormalImage& normals, OrganizedCloud& half_cloud, NormalImage& half_normals)
{
  const LaneKernels& kernels = laneKernels ();
  const int width = (cloud.width + 1) / 2, height = (cloud.height + 1) / 2;
  half_cloud.resize (width, height);
  half_normals.resize (half_cloud.size ());
  std::fill (half_normals.curvature.begin (), half_normals.curvature.end (), 0.0f);
  constexpr int ring_size = 4;
  SurfaceRows even (ring_size, width, 1, 2 * kernels.lanes), odd (ring_size, width, 1, 2 * kernels.lanes);
  const auto at = [&] (int row) { return (SplitRow{even.at (row + 1), odd.at (row + 1)}); };
  int filled = -1;
  for (int row = 0; row < height; ++row)
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
                      {&half_cloud.x[first], &half_cloud.y[first], &half_cloud.z[first], &half_normals.x[first], &half_normals.y[first],
                       &half_normals.z[first], &half_cloud.valid[first], &half_normals.valid[first]});
  }
}

Image<float>
doubleSize (const Image<float>& map, int width, int height)
{
  Image<float> fine (width, height);
  const auto mix = [] (float center, float beside, float above, float across) {
    return (0.5625f * center + 0.1875f * (beside + above) + 0.0625f * across);
  };
  for (int row = 0; row < height; ++row)
  {
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
  }
  return (fine);
}

Image<float>
boxBlur (const Image<float>& map, int radius)
{
  if (radius == 0)
    return (map);
  Image<float> horizontal (map.width, map.height), blurred (map.width, map.height);
  const int size = 2 * radius + 1;
  for (int row = 0; row < map.height; ++row)
  {
    const float* const source = &map (0, row);
    float* const target = &horizontal (0, row);
    const auto at = [&] (int column) {
      const int begin = std::max (0, column - radius), end = std::min (map.width - 1, column + radius);
      float sum = 0.0f;
      for (int c = begin; c <= end; ++c)
        sum += source[c];
      target[column] = sum / static_cast<float> (end - begin + 1);
    };
    const int inner_end = std::max (radius, map.width - radius);
    for (int column = 0; column < std::min (radius, map.width); ++column)
      at (column);
    for (int step = 0; step < size; ++step)
      for (int column = radius; column < map.width - radius; ++column)
        target[column] += source[column - radius + step];
    for (int column = radius; column < map.width - radius; ++column)
      target[column] /= static_cast<float> (size);
    for (int column = inner_end; column < map.width; ++column)
      at (column);
  }
  for (int row = 0; row < map.height; ++row)
  {
    const int begin = std::max (0, row - radius), end = std::min (map.height - 1, row + radius);
    float* const target = &blurred (0, row);
    for (int r = begin; r <= end; ++r)
    {
      const float* const source = &horizontal (0, r);
      for (int column = 0; column < map.width; ++column)
        target[column] += source[column];
    }
    for (int column = 0; column < map.width; ++column)
      target[column] /= static_cast<float> (end - begin + 1);
  }
  return (blurred);
}

} // namespace pcl_attention
