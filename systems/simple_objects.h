// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "systems/polar_cut.h"
#include <pcl_attention/core/organized_cloud.h>
#include <pcl_attention/core/skeleton.h>
#include <pcl_attention/core/supporting_plane.h>

#include <Eigen/Core>

namespace pcl_attention
{

/** \brief Settings of the simple objects. */
struct SimpleObjectParameters
{
  float step{0.015f};         /**< in depth from which on a boundary is one, metres at a distance of 1 m; grows with
                                the distance squared, as the noise does */
  float table_height{0.008f}; /**< what is nearer to a supporting plane is part of it, metres at 1 m, grows alike */
  float color_strength{50 / 255.0f}; /**< of a colour edge without a step or contact, 0..1 */
  int shortest_boundary{40};         /**< shorter ones have no fixation, pixels */
  int maximum_fixations{30};         /**< only as many of the longest boundaries have one */
  int longest_ray{100};              /**< how far from its boundary a surface is looked for, pixels */
  float owned_share{0.5f};           /**< of a region's contour that has to be the region's own boundary, 0..1 */
  float overlap{0.5f}; /**< with an earlier region, intersection over union, from which on it is dropped, 0..1 */
  PolarCutParameters cut;
};

/** \brief Where surfaces end, and whose the boundary is. */
struct OwnedBoundaries
{
  Image<std::uint8_t> boundary;  /**< 1 on the outermost pixels of what owns the boundary */
  Image<Eigen::Vector2f> inward; /**< unit vector from there to the owner's side; 0 elsewhere */
  Image<std::uint8_t> table;     /**< 1 on supporting planes */
  Image<float> depth;            /**< metres, holes filled with the farther of the surfaces beside them */
};

/** \brief Boundaries at steps in depth, which the nearer side owns, and at the contact with a supporting plane, which
 * what stands there owns.
 * \param[in] planes in the sensor frame */
OwnedBoundaries findOwnedBoundaries (const OrganizedCloud& cloud, const std::vector<SupportingPlane>& planes,
                                     const SimpleObjectParameters& parameters);

/** \brief A compact region whose own boundary encloses it. */
struct SimpleObject
{
  Pixel fixation;
  Image<std::uint8_t> mask; /**< 1 inside */
  float owned_share{0.0f};  /**< of its contour, 0..1 */
};

/** \brief Simple objects, after Mishra, Shrivastava and Aloimonos, "Segmenting 'Simple' Objects Using RGB-D" (ICRA
 * 2012).
 *
 * Connected boundaries of one owner give a fixation on the owner's side each; around it a region is cut out by
 * \ref segmentAround, and kept if most of its contour is boundary that it owns itself.
 * \param[in] threads number of threads, at least 1; the result does not depend on it
 * \return in descending order of owned_share */
std::vector<SimpleObject> findSimpleObjects (const OwnedBoundaries& boundaries, const EdgeMap& color_edges,
                                             const SimpleObjectParameters& parameters = {}, int threads = 1);

} // namespace pcl_attention
