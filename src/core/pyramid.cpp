// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/pyramid.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_attention
{

void
halve (const OrganizedCloud& cloud, const NormalImage& normals, OrganizedCloud& half_cloud, NormalImage& half_normals)
{
  constexpr std::array<float, 4> kernel{0.125f, 0.375f, 0.375f, 0.125f};
  const int width = (cloud.width + 1) / 2, height = (cloud.height + 1) / 2;
  half_cloud.reset (width, height);
  half_normals.reset (half_cloud.size ());
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      float weights = 0.0f;
      std::array<float, 6> sums{};
      for (int dy = 0; dy < 4; ++dy)
      {
        const int fine_row = 2 * row - 1 + dy;
        if (fine_row < 0 || fine_row >= cloud.height)
          continue;
        for (int dx = 0; dx < 4; ++dx)
        {
          const int fine_column = 2 * column - 1 + dx;
          if (fine_column < 0 || fine_column >= cloud.width)
            continue;
          const std::size_t index = static_cast<std::size_t> (fine_row) * cloud.width + fine_column;
          if (!cloud.valid[index] || !normals.valid[index])
            continue;
          const float weight = kernel[dx] * kernel[dy];
          weights += weight;
          sums[0] += weight * cloud.x[index];
          sums[1] += weight * cloud.y[index];
          sums[2] += weight * cloud.z[index];
          sums[3] += weight * normals.x[index];
          sums[4] += weight * normals.y[index];
          sums[5] += weight * normals.z[index];
        }
      }
      const float length = std::sqrt (sums[3] * sums[3] + sums[4] * sums[4] + sums[5] * sums[5]);
      if (weights < 0.5f || length < 1e-6f)
        continue;
      const std::size_t target = static_cast<std::size_t> (row) * width + column;
      half_cloud.valid[target] = half_normals.valid[target] = 1;
      half_cloud.x[target] = sums[0] / weights;
      half_cloud.y[target] = sums[1] / weights;
      half_cloud.z[target] = sums[2] / weights;
      half_normals.x[target] = sums[3] / length;
      half_normals.y[target] = sums[4] / length;
      half_normals.z[target] = sums[5] / length;
    }
}

Image<float>
doubleSize (const Image<float>& map, int width, int height)
{
  Image<float> fine (width, height);
  for (int row = 0; row < height; ++row)
  {
    // A fine pixel lies a quarter of a coarse pixel off its parent's centre, to the side of its parity.
    const int row0 = std::min (row / 2, map.height - 1);
    const int row1 = std::clamp (row % 2 == 0 ? row0 - 1 : row0 + 1, 0, map.height - 1);
    for (int column = 0; column < width; ++column)
    {
      const int column0 = std::min (column / 2, map.width - 1);
      const int column1 = std::clamp (column % 2 == 0 ? column0 - 1 : column0 + 1, 0, map.width - 1);
      fine (column, row) = 0.5625f * map (column0, row0) + 0.1875f * (map (column1, row0) + map (column0, row1)) +
                           0.0625f * map (column1, row1);
    }
  }
  return (fine);
}

Image<float>
boxBlur (const Image<float>& map, int radius)
{
  if (radius == 0)
    return (map);
  Image<float> horizontal (map.width, map.height), blurred (map.width, map.height);
  for (int row = 0; row < map.height; ++row)
    for (int column = 0; column < map.width; ++column)
    {
      const int begin = std::max (0, column - radius), end = std::min (map.width - 1, column + radius);
      float sum = 0.0f;
      for (int c = begin; c <= end; ++c)
        sum += map (c, row);
      horizontal (column, row) = sum / static_cast<float> (end - begin + 1);
    }
  std::vector<float> sums (map.width);
  for (int row = 0; row < map.height; ++row)
  {
    const int begin = std::max (0, row - radius), end = std::min (map.height - 1, row + radius);
    std::fill (sums.begin (), sums.end (), 0.0f);
    for (int r = begin; r <= end; ++r)
      for (int column = 0; column < map.width; ++column)
        sums[column] += horizontal (column, r);
    for (int column = 0; column < map.width; ++column)
      blurred (column, row) = sums[column] / static_cast<float> (end - begin + 1);
  }
  return (blurred);
}

} // namespace pcl_attention
