// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/image.h>
#include <pcl_attention/core/organized_cloud.h>

namespace pcl_attention
{

/** \brief Settings of the reflective symmetry and its pyramid (paper III-A and III-B). */
struct SaliencyParameters
{
  int window_radius{3};            /**< offsets +-1..radius without the centre row and column, pixels, 1..8 (N(p)) */
  int levels{4};                   /**< pyramid levels, 1..8 (L_1..L_n, eq. 9) */
  int maximum_columns{400};        /**< of the finest level: those with more columns are left out, as their windows see more noise
                                     than shape; 0: none is */
  float distance_scale{1000.0f};   /**< units of the exponentials of eq. 3, 1/m: 1000 is millimetres */
  bool convexity_gate{true};       /**< symmetry is 0 unless both halves' mean normals point away from the plane */
  int blur_radius{2};              /**< box blur of every level map, pixels; 0 is off */
  float level_threshold{0.0f};     /**< share of a level's maximum under which its values become 0 (repair A), 0..1 */
  bool normalize_levels{true};     /**< divide every level map by its maximum before the sum */
  float saliency_floor{1e-6f};     /**< absolute symmetry (0..4) under which a value is rounding, whatever the maximum */
};

/** \brief Symmetry of one pyramid level. */
struct SymmetryMap
{
  Image<float> symmetry;            /**< s(p) of eq. 2, 0..4 */
  Image<std::uint8_t> winning_axis; /**< 1..3: which principal axis won in eq. 2; 0 where s(p) is 0 */
};

/** \brief Local reflective symmetry of every point (paper eq. 1-8): PCA on the extended Gaussian image of the window, three
  * reflective planes through the point, and the best of the products of eq. 3.
  * \param[in] cloud points of the level, sensor frame
  * \param[in] normals normals of the level
  * \param[in] parameters window, units and gate; the pyramid settings are not used
  * \param[in] threads number of threads, at least 1; the result does not depend on it
  * \param[out] map of the level's size */
PCL_ATTENTION_EXPORTS void
computeSymmetry (const OrganizedCloud& cloud, const NormalImage& normals, const SaliencyParameters& parameters,
                 int threads, SymmetryMap& map);

} // namespace pcl_attention
