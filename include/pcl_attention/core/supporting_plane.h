// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/patch_graph.h>

namespace pcl_attention
{

/** \brief Settings of the search for the surfaces that objects stand on or before. */
struct SupportParameters
{
  float minimum_area{0.03f};    /**< of a patch to be a candidate, m^2 */
  float tolerance{0.004f};      /**< a point this near to the plane belongs to it, metres ... */
  float noise_tolerance{3.0f};  /**< ... plus this many standard deviations of the depth at its distance */
  float minimum_confidence{0.8f}; /**< planes under this confidence remove nothing, 0..1 */
};

/** \brief A large plane that objects stand on, or a wall or floor behind them. */
struct SupportingPlane
{
  Eigen::Vector4f coefficients{Eigen::Vector4f::Zero ()}; /**< a, b, c, d of ax + by + cz + d = 0, unit normal towards the
                                                            viewpoint, metres */
  pcl::Indices indices;      /**< its points, ascending */
  float area{0.0f};          /**< m^2 */
  float confidence{0.0f};    /**< 0..1: share of what lies beyond its face near it that is in front of it, not behind */
  bool supports_objects{false}; /**< true for the plane that objects stand on; false for other planes of the background */
};

/** \brief Standard deviation of the depth as sigma = a z^2, with a estimated from the second differences of the inverse depth.
  * \return a in 1/m; 0 if the cloud is too small or free of noise */
PCL_ATTENTION_EXPORTS float
estimateDepthNoise (const OrganizedCloud& cloud);

/** \brief Find the supporting plane and the other planes of the background.
  * \param[in] graph of the patches
  * \return the plane that objects stand on first, if there is one */
PCL_ATTENTION_EXPORTS std::vector<SupportingPlane>
findSupportingPlanes (const OrganizedCloud& cloud, const NormalImage& normals, const PlanarPatches& patches,
                      const PatchGraph& graph, const SupportParameters& parameters);

} // namespace pcl_attention
