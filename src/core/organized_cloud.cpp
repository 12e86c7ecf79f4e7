// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/organized_cloud.h>

#include <algorithm>

namespace pcl_attention
{

std::string
imageSizeProblem (std::uint64_t columns, std::uint64_t rows)
{
  if (columns <= longest_side && rows <= longest_side && columns * rows <= most_pixels)
    return ("");
  return (std::to_string (columns) + " x " + std::to_string (rows) + ", more than the " + std::to_string (longest_side) +
          " a side and " + std::to_string (most_pixels) + " in all that are taken");
}

float
estimateFocalLength (const OrganizedCloud& cloud)
{
  // Columns and rows are fitted together: one focal length, a principal point for each axis.
  double count = 0.0;
  double sum_slope_x = 0.0, sum_column = 0.0, sum_slope_y = 0.0, sum_row = 0.0;
  double square = 0.0, product = 0.0;
  // Some of the rows fix three numbers as well as all of them.
  const int row_step = std::max (1, cloud.height / 30);
  for (int row = 0; row < cloud.height; row += row_step)
    for (int column = 0; column < cloud.width; ++column)
    {
      const std::size_t index = static_cast<std::size_t> (row) * cloud.width + column;
      if (!cloud.valid[index] || cloud.z[index] <= 0.0f)
        continue;
      const double slope_x = cloud.x[index] / cloud.z[index], slope_y = cloud.y[index] / cloud.z[index];
      count += 1.0;
      sum_slope_x += slope_x;
      sum_slope_y += slope_y;
      sum_column += column;
      sum_row += row;
      square += slope_x * slope_x + slope_y * slope_y;
      product += slope_x * column + slope_y * row;
    }
  if (count < 3.0)
    return (0.0f);
  const double variance = square - (sum_slope_x * sum_slope_x + sum_slope_y * sum_slope_y) / count;
  const double covariance = product - (sum_slope_x * sum_column + sum_slope_y * sum_row) / count;
  if (variance <= 1e-12 || covariance <= 0.0)
    return (0.0f);
  return (static_cast<float> (covariance / variance));
}

} // namespace pcl_attention
