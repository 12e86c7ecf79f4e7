// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/pyramid.h>
#include <pcl_attention/core/saliency.h>

#include <algorithm>

namespace pcl_attention
{

namespace
{

/** \brief The largest of values from 0 up. */
float
largest (const Image<float>& map)
{
  // Several at a time, so that none waits for the one before.
  constexpr std::size_t lanes = 16;
  float maxima[lanes] = {};
  std::size_t index = 0;
  for (; index + lanes <= map.size (); index += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane)
      maxima[lane] = map[index + lane] > maxima[lane] ? map[index + lane] : maxima[lane];
  for (; index < map.size (); ++index)
    maxima[0] = std::max (maxima[0], map[index]);
  return (*std::max_element (maxima, maxima + lanes));
}

/** \brief Blur a level's map and drop what is noise on it. */
void
cleanLevel (const SaliencyParameters& parameters, SymmetryMap& level)
{
  level.symmetry = boxBlur (level.symmetry, parameters.blur_radius);
  const float threshold = std::max (parameters.level_threshold * largest (level.symmetry), parameters.saliency_floor);
  for (float& value : level.symmetry.data)
    value = value < threshold ? 0.0f : value;
}

Image<float>
enlarge (Image<float> map, std::size_t level, const std::vector<std::pair<int, int>>& sizes)
{
  while (level > 0)
  {
    --level;
    map = doubleSize (map, sizes[level].first, sizes[level].second);
  }
  return (map);
}

/** \brief The axis that won at a pixel, or nearest to it where the symmetry was spread there by the blur or the up-sampling. */
std::uint8_t
winningAxis (const SymmetryMap& map, int column, int row, int reach)
{
  for (int ring = 0; ring <= reach; ++ring)
    for (int r = row - ring; r <= row + ring; ++r)
      for (int c = column - ring; c <= column + ring; ++c)
        if (map.winning_axis.contains (c, r) && map.winning_axis (c, r) != 0)
          return (map.winning_axis (c, r));
  return (0);
}

/** \brief What every level contributes to the sum of paper eq. 9, at the finest size. */
template <typename Take> void
forEachContribution (const SaliencyParameters& parameters, const SaliencyMaps& maps, const Take& take)
{
  std::vector<std::pair<int, int>> sizes;
  for (const SymmetryMap& level : maps.levels)
    sizes.emplace_back (level.symmetry.width, level.symmetry.height);
  for (std::size_t level = 0; level < maps.levels.size (); ++level)
  {
    const Image<float>& symmetry = maps.levels[level].symmetry;
    const float peak = largest (symmetry);
    if (peak > 0.0f)
      take (level, enlarge (symmetry, level, sizes), parameters.normalize_levels ? 1.0f / peak : 1.0f);
  }
}

/** \brief Paper eq. 9: the sum of all levels at the finest size. */
void
acrossScaleSum (const SaliencyParameters& parameters, const OrganizedCloud& cloud, SaliencyMaps& maps)
{
  maps.saliency.assign (cloud.width, cloud.height, 0.0f);
  forEachContribution (parameters, maps, [&] (std::size_t, const Image<float>& contribution, float scale) {
    for (std::size_t index = 0; index < cloud.size (); ++index)
      maps.saliency[index] += scale * contribution[index];
  });
  for (std::size_t index = 0; index < cloud.size (); ++index)
    maps.saliency[index] = cloud.valid[index] ? maps.saliency[index] : 0.0f;
  maps.maximum = largest (maps.saliency);
  if (maps.maximum > 0.0f)
    for (float& value : maps.saliency.data)
      value /= maps.maximum;
}

} // namespace

void
computeSaliency (const OrganizedCloud& cloud, const NormalImage& normals, const SaliencyParameters& parameters, int threads,
                 SaliencyMaps& maps)
{
  maps.levels.resize (parameters.levels);
  OrganizedCloud level_cloud, half_cloud;
  NormalImage level_normals, half_normals;
  for (int level = 0; level < parameters.levels; ++level)
  {
    const bool finest = level == 0;
    if (!finest)
    {
      halve (level == 1 ? cloud : level_cloud, level == 1 ? normals : level_normals, half_cloud, half_normals);
      std::swap (level_cloud, half_cloud);
      std::swap (level_normals, half_normals);
    }
    SymmetryMap& map = maps.levels[level];
    computeSymmetry (finest ? cloud : level_cloud, finest ? normals : level_normals, parameters, threads, map);
    cleanLevel (parameters, map);
  }
  acrossScaleSum (parameters, cloud, maps);
}

WinningSymmetry
findWinningSymmetry (const SaliencyMaps& maps, const SaliencyParameters& parameters)
{
  const int width = maps.saliency.width, height = maps.saliency.height;
  WinningSymmetry winning{{width, height, 0}, {width, height, 0}};
  Image<float> best (width, height, 0.0f);
  forEachContribution (parameters, maps, [&] (std::size_t level, const Image<float>& contribution, float scale) {
    for (std::size_t index = 0; index < best.size (); ++index)
      if (maps.saliency[index] > 0.0f && scale * contribution[index] > best[index])
      {
        best[index] = scale * contribution[index];
        winning.level[index] = static_cast<std::uint8_t> (level + 1);
      }
  });
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      if (const int level = winning.level (column, row))
        winning.plane (column, row) =
          winningAxis (maps.levels[level - 1], column >> (level - 1), row >> (level - 1), parameters.blur_radius + 1);
  return (winning);
}

} // namespace pcl_attention
