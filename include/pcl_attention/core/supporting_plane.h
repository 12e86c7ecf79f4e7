// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/patch_graph.h>
#include <pcl_attention/core/pyramid.h>

namespace pcl_attention
{

/** \brief Settings of the search for the surfaces that objects stand on or before. */
struct SupportParameters
{
  float minimum_area{0.03f};      /**< of a patch to be a candidate, m^2 */
  float tolerance{0.004f};        /**< a point this near to the plane belongs to it, metres ... */
  float noise_tolerance{3.0f};    /**< ... plus this many standard deviations of the depth at its distance */
  float minimum_confidence{0.8f}; /**< a supporting plane under this confidence is none, 0..1 */
  float background_area{0.25f};   /**< a plane at least this large is background even if nothing stands on it, m^2 */
  float background_share{0.4f};   /**< and so is one that covers this share of the valid points, 0..1 */
};

/** \brief A large plane that objects stand on, or a wall or floor behind them. */
struct SupportingPlane
{
  Eigen::Vector4f coefficients{Eigen::Vector4f::Zero ()}; /**< a, b, c, d of ax + by + cz + d = 0, unit normal towards the
                                                            viewpoint, metres */
  pcl::Indices indices;         /**< its points, ascending */
  float area{0.0f};             /**< m^2 */
  float confidence{0.0f};       /**< 0..1: of what lies near its outline, the share that is above it, not below; of what is below
                                  only what faces the same way counts */
  std::vector<Eigen::Vector3f> outline; /**< of the plane that objects stand on: corners of the convex outline of its large pieces,
                                          counter-clockwise as seen from the viewpoint, metres; empty for other planes */
  std::vector<std::uint8_t> ends; /**< for the outline's edge after each corner 1 if the plane is seen to end there, 0 if the image
                                    ends, or something before it hides whether it goes on */
  bool supports_objects{false}; /**< true for the plane that objects stand on; false for other planes of the background */
};

/** \brief How many times a scene is halved to look for planes in it: until it has at most 160 columns. */
PCL_ATTENTION_EXPORTS int
supportLevels (int width);

/** \brief Find the supporting plane and the other planes of the background.
  * \param[in] coarser at least \ref supportLevels levels, see \ref coarserLevels
  * \param[in] threads number of threads, 0: all processors
  * \return the plane that objects stand on first, if there is one */
PCL_ATTENTION_EXPORTS std::vector<SupportingPlane>
findSupportingPlanes (const OrganizedCloud& cloud, const SensorModel& sensor, const NormalImage& normals,
                      const std::vector<PyramidLevel>& coarser, const SupportParameters& parameters, int threads = 1);

/** \brief Whether a point stands on a plane that objects stand on: above it, at most half a metre, and its foot within the plane's
  * outline or 5 cm around it. */
PCL_ATTENTION_EXPORTS bool
standsOn (const SupportingPlane& plane, const Eigen::Vector3f& point);

/** \brief Whether a point lies beside a plane that objects stand on: from the middle of the plane to the point's foot on it one
  * leaves the outline where the plane is seen to end.
  * \param[in] margin that the foot may lie outside of the outline, metres */
PCL_ATTENTION_EXPORTS bool
liesBeside (const SupportingPlane& plane, const Eigen::Vector3f& point, float margin);

/** \brief The points of the planes, of the first one where several have a point.
  * \return 0, or 1, 2, ... for the first, second, ... plane, of the cloud's size */
PCL_ATTENTION_EXPORTS Image<int>
labelPlanes (const OrganizedCloud& cloud, const std::vector<SupportingPlane>& planes);

/** \brief Cut the patches along the background: its points become patches of their own, one a plane, and what is left of a
  * patch falls into its connected pieces, of which those under minimum_size are left over.
  * \param[in] planes in the sensor frame
  * \return 1 at [label] for the patches that are background */
PCL_ATTENTION_EXPORTS std::vector<std::uint8_t>
cutAlongPlanes (const OrganizedCloud& cloud, const std::vector<SupportingPlane>& planes, const PatchParameters& parameters,
                PlanarPatches& patches);

} // namespace pcl_attention
