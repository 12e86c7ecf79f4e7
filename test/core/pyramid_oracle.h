// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "symmetry_oracle.h"

#include <vector>

/** \brief The pyramid and the across-scale sum (paper III-B, eq. 9) in double precision, by the simplest means. */
namespace pcl_attention::oracle
{

inline Image<double>
toDouble (const Image<float>& map)
{
  Image<double> result (map.width, map.height);
  for (std::size_t index = 0; index < map.size (); ++index)
    result[index] = map[index];
  return (result);
}

/** \brief A level of the pyramid. */
struct Level
{
  int width{0}, height{0};
  std::vector<bool> valid;
  std::vector<double> weight; /**< share of the kernel that was valid */
  std::vector<Eigen::Vector3d> points, normals;
};

inline Level
levelOf (const OrganizedCloud& cloud, const NormalImage& normals)
{
  Level level{cloud.width, cloud.height, {}, {}, {}, {}};
  for (std::size_t index = 0; index < cloud.size (); ++index)
  {
    level.valid.push_back (cloud.valid[index] && normals.valid[index]);
    level.weight.push_back (level.valid.back () ? 1.0 : 0.0);
    level.points.emplace_back (cloud.x[index], cloud.y[index], cloud.z[index]);
    level.normals.emplace_back (normals.x[index], normals.y[index], normals.z[index]);
  }
  return (level);
}

/** \brief Weighted mean over the 4x4 pixels around the point between four, weights 1 3 3 1 over 8 in each direction. */
inline Level
halved (const Level& fine)
{
  Level half;
  half.width = (fine.width + 1) / 2;
  half.height = (fine.height + 1) / 2;
  for (int row = 0; row < half.height; ++row)
    for (int column = 0; column < half.width; ++column)
    {
      double weights = 0.0;
      Eigen::Vector3d point = Eigen::Vector3d::Zero (), normal = Eigen::Vector3d::Zero ();
      for (int r = 0; r < fine.height; ++r)
        for (int c = std::max (0, 2 * column - 2); c < std::min (fine.width, 2 * column + 4); ++c)
        {
          // Half a pixel from the point between four weighs 3, one and a half 1.
          const double dx = std::abs (c - (2 * column + 0.5)), dy = std::abs (r - (2 * row + 0.5));
          const std::size_t index = static_cast<std::size_t> (r) * fine.width + c;
          if (dx > 2.0 || dy > 2.0 || !fine.valid[index])
            continue;
          const double weight = (dx < 1.0 ? 3.0 : 1.0) * (dy < 1.0 ? 3.0 : 1.0) / 64.0;
          weights += weight;
          point += weight * fine.points[index];
          normal += weight * fine.normals[index];
        }
      half.valid.push_back (weights >= 0.5 && normal.norm () > 1e-6);
      half.weight.push_back (weights);
      half.points.emplace_back (weights > 0.0 ? Eigen::Vector3d (point / weights) : point);
      half.normals.emplace_back (normal.normalized ());
    }
  return (half);
}

/** \brief Bilinear interpolation where coarse pixel c covers the fine pixels 2c and 2c+1; the outermost values reach
 * outwards. */
inline Image<double>
doubled (const Image<double>& map, int width, int height)
{
  Image<double> fine (width, height);
  const auto value = [&] (int column, int row) {
    return (map (std::clamp (column, 0, map.width - 1), std::clamp (row, 0, map.height - 1)));
  };
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      const double x = 0.5 * (column - 0.5), y = 0.5 * (row - 0.5);
      const int left = static_cast<int> (std::floor (x)), top = static_cast<int> (std::floor (y));
      const double u = x - left, v = y - top;
      fine (column, row) = (1 - u) * (1 - v) * value (left, top) + u * (1 - v) * value (left + 1, top) +
                           (1 - u) * v * value (left, top + 1) + u * v * value (left + 1, top + 1);
    }
  return (fine);
}

inline Image<double>
boxBlurred (const Image<double>& map, int radius)
{
  Image<double> blurred (map.width, map.height);
  for (int row = 0; row < map.height; ++row)
    for (int column = 0; column < map.width; ++column)
    {
      double sum = 0.0;
      int count = 0;
      for (int r = row - radius; r <= row + radius; ++r)
        for (int c = column - radius; c <= column + radius; ++c)
          if (map.contains (c, r))
          {
            sum += map (c, r);
            ++count;
          }
      blurred (column, row) = sum / count;
    }
  return (blurred);
}

/** \brief Eq. 9 from the raw symmetry of every level, finest first: blur, thresholds, each level divided by its
 * maximum, enlarged and added; then the sum divided by its maximum. \param[out] maximum the sum's maximum; may be null
 */
inline Image<double>
acrossScaleSum (const std::vector<Image<double>>& levels, const std::vector<std::uint8_t>& valid,
                const SaliencyParameters& parameters, double* maximum = nullptr)
{
  const auto largest = [] (const Image<double>& map) {
    return (map.size () == 0 ? 0.0 : *std::max_element (map.data.begin (), map.data.end ()));
  };
  Image<double> sum (levels.front ().width, levels.front ().height, 0.0);
  for (std::size_t level = 0; level < levels.size (); ++level)
  {
    Image<double> map = boxBlurred (levels[level], parameters.blur_radius);
    const double peak = largest (map);
    for (double& value : map.data)
    {
      if (value < parameters.level_threshold * peak || value < parameters.saliency_floor)
        value = 0.0;
      if (parameters.normalize_levels && peak > 0.0)
        value /= peak;
    }
    for (std::size_t finer = level; finer-- > 0;)
      map = doubled (map, levels[finer].width, levels[finer].height);
    for (std::size_t index = 0; index < sum.size (); ++index)
      if (valid[index])
        sum[index] += map[index];
  }
  const double peak = largest (sum);
  if (maximum)
    *maximum = peak;
  for (double& value : sum.data)
    if (peak > 0.0)
      value /= peak;
  return (sum);
}

} // namespace pcl_attention::oracle
