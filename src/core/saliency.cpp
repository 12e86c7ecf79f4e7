// SPDX-License-Identifier: BSD-3-Clause
#include "largest_value.h"

#include <pcl_attention/core/saliency.h>

#include <algorithm>

namespace pcl_attention
{

namespace
{

/** \brief Blur a level's map and drop what is noise on it. */
void
cleanLevel (const SaliencyParameters& parameters, int threads, SymmetryMap& level)
{
  level.symmetry = boxBlur (level.symmetry, parameters.blur_radius, threads);
  const float threshold = std::max (parameters.level_threshold * largestValue (level.symmetry), parameters.saliency_floor);
  for (float& value : level.symmetry.data)
    value = value < threshold ? 0.0f : value;
}

/** \brief What a level's values count in the sum of paper eq. 9; 0 for a level without any. */
float
scaleOf (const SaliencyParameters& parameters, const SymmetryMap& level)
{
  const float peak = largestValue (level.symmetry);
  return (peak <= 0.0f ? 0.0f : parameters.normalize_levels ? 1.0f / peak : 1.0f);
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

/** \brief Paper eq. 9: the sum of all levels at the cloud's size. From the coarsest on the sum so far is brought to the size of the
  * next finer level, which is the same as bringing each to the finest, and is done once for all. */
void
acrossScaleSum (const SaliencyParameters& parameters, const OrganizedCloud& cloud, int threads, SaliencyMaps& maps)
{
  Image<float>& sum = maps.saliency;
  for (int halvings = maps.skipped + parameters.levels - 1; halvings >= 0; --halvings)
  {
    const int width = halvedSize (cloud.width, halvings), height = halvedSize (cloud.height, halvings);
    if (halvings == maps.skipped + parameters.levels - 1)
      sum.assign (width, height, 0.0f);
    else
      sum = doubleSize (sum, width, height, threads);
    if (halvings < maps.skipped)
      continue;
    const SymmetryMap& level = maps.levels[halvings - maps.skipped];
    const float scale = scaleOf (parameters, level);
    for (std::size_t index = 0; index < sum.size (); ++index)
      sum[index] += scale * level.symmetry[index];
  }
  for (std::size_t index = 0; index < cloud.size (); ++index)
    sum[index] = cloud.valid[index] ? sum[index] : 0.0f;
  maps.maximum = largestValue (sum);
  if (maps.maximum > 0.0f)
    for (float& value : sum.data)
      value /= maps.maximum;
}

} // namespace

int
skippedLevels (int width, const SaliencyParameters& parameters)
{
  int skipped = 0;
  while (parameters.maximum_columns > 0 && halvedSize (width, skipped) > parameters.maximum_columns)
    ++skipped;
  return (skipped);
}

void
computeSaliency (const OrganizedCloud& cloud, const NormalImage& normals, const std::vector<PyramidLevel>& coarser,
                 const SaliencyParameters& parameters, int threads, SaliencyMaps& maps)
{
  maps.levels.resize (parameters.levels);
  maps.skipped = skippedLevels (cloud.width, parameters);
  for (int level = 0; level < parameters.levels; ++level)
  {
    SymmetryMap& map = maps.levels[level];
    const int halvings = maps.skipped + level;
    computeSymmetry (halvings == 0 ? cloud : coarser[halvings - 1].cloud,
                     halvings == 0 ? normals : coarser[halvings - 1].normals, parameters, threads, map);
    cleanLevel (parameters, threads, map);
  }
  acrossScaleSum (parameters, cloud, threads, maps);
}

void
computeSaliency (const OrganizedCloud& cloud, const NormalImage& normals, const SaliencyParameters& parameters, int threads,
                 SaliencyMaps& maps)
{
  const int count = skippedLevels (cloud.width, parameters) + parameters.levels - 1;
  computeSaliency (cloud, normals, coarserLevels (cloud, normals, count, threads), parameters, threads, maps);
}

WinningSymmetry
findWinningSymmetry (const SaliencyMaps& maps, const SaliencyParameters& parameters)
{
  const int width = maps.saliency.width, height = maps.saliency.height;
  WinningSymmetry winning{{width, height, 0}, {width, height, 0}};
  Image<float> best (width, height, 0.0f);
  for (std::size_t level = 0; level < maps.levels.size (); ++level)
  {
    Image<float> contribution = maps.levels[level].symmetry;
    for (int finer = maps.skipped + static_cast<int> (level) - 1; finer >= 0; --finer)
      contribution = doubleSize (contribution, halvedSize (width, finer), halvedSize (height, finer), 1);
    const float scale = scaleOf (parameters, maps.levels[level]);
    for (std::size_t index = 0; index < best.size (); ++index)
      if (maps.saliency[index] > 0.0f && scale * contribution[index] > best[index])
      {
        best[index] = scale * contribution[index];
        winning.level[index] = static_cast<std::uint8_t> (level + 1);
      }
  }
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      if (const int level = winning.level (column, row))
      {
        const int halvings = maps.skipped + level - 1;
        winning.plane (column, row) =
          winningAxis (maps.levels[level - 1], column >> halvings, row >> halvings, parameters.blur_radius + 1);
      }
  return (winning);
}

} // namespace pcl_attention
