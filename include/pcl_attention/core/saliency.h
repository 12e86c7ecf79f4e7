// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/pyramid.h>
#include <pcl_attention/core/symmetry.h>

#include <vector>

namespace pcl_attention
{

/** \brief The multi-scale symmetry saliency (paper III-B, eq. 9) with what it was made of. */
struct SaliencyMaps
{
  Image<float> saliency;              /**< S, normalised to [0, 1]; 0 on invalid points */
  float maximum{0.0f};                /**< the sum's maximum before the normalisation; 0 when nothing is symmetric */
  std::vector<SymmetryMap> levels;    /**< finest first, each of its own size, after blur and thresholds */
  int skipped{0};                     /**< how many times the cloud was halved before the first of them */
};

/** \brief How many levels are left out for their size, see \ref SaliencyParameters::maximum_columns. */
PCL_ATTENTION_EXPORTS int
skippedLevels (int width, const SaliencyParameters& parameters);

/** \brief Where a saliency map comes from. */
struct WinningSymmetry
{
  Image<std::uint8_t> level; /**< 1..levels: the level that contributes most; 0 where S is 0 */
  Image<std::uint8_t> plane; /**< 1..3: the winning axis at that level; 0 where S is 0 */
};

/** \brief Symmetry on every level of a Gaussian pyramid, summed across scales and normalised (paper eq. 9).
  * \param[in] cloud points, sensor frame
  * \param[in] normals of the same size
  * \param[in] parameters see \ref SaliencyParameters
  * \param[in] threads number of threads, at least 1; the result does not depend on it
  * \param[out] maps see \ref SaliencyMaps */
PCL_ATTENTION_EXPORTS void
computeSaliency (const OrganizedCloud& cloud, const NormalImage& normals, const SaliencyParameters& parameters, int threads,
                 SaliencyMaps& maps);

/** \brief The same where the pyramid is there already.
  * \param[in] coarser at least one level less than are skipped and summed, see \ref coarserLevels */
PCL_ATTENTION_EXPORTS void
computeSaliency (const OrganizedCloud& cloud, const NormalImage& normals, const std::vector<PyramidLevel>& coarser,
                 const SaliencyParameters& parameters, int threads, SaliencyMaps& maps);

/** \brief Which level gives most of the saliency at every pixel, and about which plane it is symmetric there (paper eq. 2 and 9).
  * \param[in] parameters those that the maps were computed with
  * \return all 0 for maps without levels, as those that a user brings */
PCL_ATTENTION_EXPORTS WinningSymmetry
findWinningSymmetry (const SaliencyMaps& maps, const SaliencyParameters& parameters);

} // namespace pcl_attention
