// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/planar_patches.h>

#include <map>
#include <utility>

namespace pcl_attention
{

/** \brief Settings of the patch graph. */
struct PatchGraphParameters
{
  int maximum_gap{10};               /**< borders are found across at most this many pixels without a patch */
  float connection_distance{0.01f};  /**< two border pixels are connected in 3D if nearer than this, metres ... */
  float gap_slack{1.5f};             /**< ... plus this many pixel widths at their depth for every pixel of the gap */
  int sample_distance{6};            /**< convexity is judged between points this far inside either side, pixels */
};

/** \brief What is known of the border two patches (or groups of patches) share. Sums, so that borders of groups add up. */
struct PCL_ATTENTION_EXPORTS PatchBorder
{
  int pairs{0};             /**< pixel pairs across the border */
  int connected{0};         /**< of them connected in 3D */
  int first_in_front{0};    /**< not connected, the first (lower) label nearer to the viewer */
  int second_in_front{0};   /**< not connected, the second label nearer */
  int convexity_pairs{0};   /**< pairs whose convexity could be judged */
  double convexity_sum{0.0}; /**< sum over pairs of (n_b - n_a) . D, D the unit vector from a to b: > 0 convex, < 0 concave */

  float
  connectedShare () const { return (pairs > 0 ? static_cast<float> (connected) / pairs : 0.0f); }

  /** \brief Mean convexity, -2..2; 0 when it could not be judged. */
  float
  convexity () const { return (convexity_pairs > 0 ? static_cast<float> (convexity_sum / convexity_pairs) : 0.0f); }

  PatchBorder&
  operator+= (const PatchBorder& other);

  /** \brief The same border seen from the other patch. */
  PatchBorder
  reversed () const;
};

/** \brief Which patches touch in the image, and how. Labels start at 1. */
struct PCL_ATTENTION_EXPORTS PatchGraph
{
  std::map<std::pair<int, int>, PatchBorder> borders; /**< first label < second label */
  std::vector<std::vector<int>> neighbors;            /**< of label k at [k], ascending; [0] is empty */
  std::vector<int> perimeter;                         /**< contour pairs of label k at [k], towards anything or out of the image */

  /** \brief The border of two labels, seen from the first one; empty when they do not touch. */
  PatchBorder
  border (int first, int second) const;
};

/** \brief Find which patches share a border, how much of it is connected in 3D, and whether it is convex or concave.
  * \param[in] labels 0 = none, else 1..count */
PCL_ATTENTION_EXPORTS PatchGraph
buildPatchGraph (const OrganizedCloud& cloud, const NormalImage& normals, const Image<int>& labels, int count,
                 const PatchGraphParameters& parameters);

} // namespace pcl_attention
