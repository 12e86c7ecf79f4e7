// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/sensor_model.h>

#include <algorithm>
#include <cmath>

namespace pcl_attention
{

namespace
{

/** \brief How much the inverse depth bends from pixel to pixel so many columns apart, median, 1/m; 0 for too few points. The inverse
  * depth of a plane is linear along a row, so that its second difference is noise, wherever there is no edge. */
float
medianSecondDifference (const OrganizedCloud& cloud, int distance)
{
  std::vector<float> differences;
  const int step = std::max (1, cloud.height / 120); // some ten thousand pixels give the median to a hundredth
  for (int row = 0; row < cloud.height; row += step)
    for (int column = distance; column + distance < cloud.width; column += step)
    {
      const std::size_t index = static_cast<std::size_t> (row) * cloud.width + column;
      if (!cloud.valid[index] || !cloud.valid[index - distance] || !cloud.valid[index + distance] ||
          std::min ({cloud.z[index], cloud.z[index - distance], cloud.z[index + distance]}) <= 0.0f)
        continue;
      differences.push_back (std::abs (1.0f / cloud.z[index - distance] + 1.0f / cloud.z[index + distance] -
                                       2.0f / cloud.z[index]));
    }
  if (differences.size () < 100)
    return (0.0f);
  const auto middle = differences.begin () + static_cast<std::ptrdiff_t> (differences.size () / 2);
  std::nth_element (differences.begin (), middle, differences.end ());
  return (*middle);
}

} // namespace

SensorModel
estimateSensor (const OrganizedCloud& cloud)
{
  return {estimateFocalLength (cloud), estimateDepthNoise (cloud), hasSmoothedDepth (cloud)};
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

float
estimateDepthNoise (const OrganizedCloud& cloud)
{
  // The median of |normal| is 0.6745 standard deviations; the second difference has six times the variance.
  return (medianSecondDifference (cloud, 8) / 0.6745f / std::sqrt (6.0f));
}

bool
hasSmoothedDepth (const OrganizedCloud& cloud)
{
  constexpr float as_much = 0.42f; // in the middle between recordings of both kinds
  constexpr float rounding = 1e-5f; // 1/m
  const float far = medianSecondDifference (cloud, 16);
  return (far > rounding && medianSecondDifference (cloud, 4) < as_much * far);
}

} // namespace pcl_attention
