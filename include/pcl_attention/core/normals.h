// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/organized_cloud.h>

namespace pcl_attention
{

/** \brief How the normals are estimated when the user brings none. */
enum class NormalMethod
{
  gated_window,   /**< plane fit to the neighbours within a window that are close in depth; keeps edges sharp */
  integral_image, /**< pcl::IntegralImageNormalEstimation, COVARIANCE_MATRIX */
};

/** \brief Settings of the normal estimation (paper III-A: "locally fitting planes to neighboring points"). */
struct NormalParameters
{
  NormalMethod method{NormalMethod::gated_window};
  int radius{4};             /**< half width of the window, pixels, 1..15 */
  float depth_gate{0.015f};  /**< largest depth difference of neighbours that are fitted together, metres */
};

/** \brief Fit a plane to the neighbours of every point (paper III-A). Normals point to the viewpoint, the origin.
  * \param[in] cloud the points, sensor frame
  * \param[in] parameters method, window and gate
  * \param[in] threads number of threads, at least 1; the result does not depend on it
  * \param[out] normals one per point; not valid where fewer than 4 neighbours support a plane */
PCL_ATTENTION_EXPORTS void
estimateNormals (const OrganizedCloud& cloud, const NormalParameters& parameters, int threads, NormalImage& normals);

} // namespace pcl_attention
