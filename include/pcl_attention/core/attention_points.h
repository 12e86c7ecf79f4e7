// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/skeleton.h>

#include <string>

namespace pcl_attention
{

/** \brief Where an attention point comes from. */
enum class AttentionPointKind
{
  junction, /**< a junction of a skeleton (TJ3D) */
  midpoint, /**< the middle of a simple skeleton line (TJ3D) */
  winner,   /**< a winner-take-all maximum */
  coverage, /**< a patch that no segment had claimed */
  user      /**< given by the user */
};

/** \brief "junction", "midpoint", "winner", "coverage" or "user". */
PCL_ATTENTION_EXPORTS const char*
toString (AttentionPointKind kind);

/** \brief How attention points are chosen. */
enum class AttentionStrategy
{
  symmetry_lines,        /**< junctions and mid-points of the skeletons (TJ3D, paper III-C) */
  winner_take_all,       /**< winners on the saliency map (WTA3D, paper V-A) */
  image_winner_take_all  /**< winners on the symmetry saliency of the colours, see \ref computeImageSaliency (WTA2D, paper V-A) */
};

/** \brief Settings of the attention points (paper III-C). */
struct AttentionPointParameters
{
  AttentionStrategy strategy{AttentionStrategy::symmetry_lines};
  float pixel_threshold{0.1f};     /**< share of the map's maximum a pixel must exceed to be in a component, 0..1; 0: eq. "S > 0";
                                     of a winner's cell likewise */
  float component_threshold{0.1f}; /**< theta_sal: share of the map's maximum the component's mean must exceed, 0..1 */
  bool all_junctions{true};        /**< every junction of a component, or only the most salient one */
  float junction_merge_radius{3.0f}; /**< junctions nearer than this are one, pixels */
  int minimum_skeleton_length{1};  /**< shorter skeletons give no point, pixels */
  int winner_cell_size{16};        /**< pixels of the map's square that a neuron of the winner-take-all network sees, 1..64 */
  float inhibition_width{0.6f};    /**< standard deviation of the inhibition of return around a winner, cells, 0.1..10 */
};

/** \brief A fixation: where to look, and why. */
struct AttentionPoint
{
  int column{0};
  int row{0};
  float saliency{0.0f};       /**< mean saliency of its component (eq. 10), or of a winner's cell, 0..1 */
  float point_saliency{0.0f}; /**< saliency at the point itself, 0..1 */
  AttentionPointKind kind{AttentionPointKind::user};
  int component{0};           /**< 1, 2, ...: index into the components; 0: none */
  float weight{1.0f};         /**< how well it matches what is asked for, 0..1; 1 without an \ref AttentionPrior */
};

/** \brief Attention points with what they were made of. */
struct AttentionPoints
{
  std::vector<AttentionPoint> points; /**< in order of attention: mean saliency, own saliency, row, column; winners in the order
                                        in which they won */
  Image<int> components;              /**< 0 = none, else 1, 2, ...; components under theta_sal are kept; winners have none */
  std::vector<float> mean_saliency;   /**< of component k at [k - 1] (eq. 10) */
  Image<std::uint8_t> skeleton;       /**< 1 on the skeleton lines of the valid components */
};

/** \brief Mean saliency of every component (paper eq. 10).
  * \param[in] labels 0 = none, 1..count */
PCL_ATTENTION_EXPORTS std::vector<float>
meanSaliency (const Image<float>& saliency, const Image<int>& labels, int count);

/** \brief Attention points of a saliency map (paper III-C), or winners on it (paper V-A).
  * \param[in] saliency any map; not finite and negative values count as 0
  * \param[in] valid 1 where an attention point may lie (of the map's size); points are moved to the nearest such skeleton
  * pixel, winners to the nearest such pixel within their cell's size; where there is none, there is no point
  * \param[in] parameters see \ref AttentionPointParameters
  * \param[out] result see \ref AttentionPoints */
PCL_ATTENTION_EXPORTS void
extractAttentionPoints (const Image<float>& saliency, const std::vector<std::uint8_t>& valid,
                        const AttentionPointParameters& parameters, AttentionPoints& result);

} // namespace pcl_attention
