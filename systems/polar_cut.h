// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "systems/color_edges.h"

#include <cstdint>

namespace pcl_attention
{

/** \brief Settings of the segmentation around a fixation. */
struct PolarCutParameters
{
  float border_strength{20 / 255.0f}; /**< of the boundary that the image's own border is, 0..1 */
  float empty_strength{5 / 255.0f};   /**< between weaker boundaries there is none, 0..1 */
  float empty_cost{50.0f};            /**< of a contour where there is no boundary, per cell */
  float steepness{20.0f};             /**< with a boundary of strength m it costs exp (-steepness m) */
  float tie_cost{100.0f};             /**< of the fixation outside or the rim of the grid inside, per cell */
};

/** \brief The region around a fixation, after Mishra, Aloimonos and Fah, "Active Segmentation with Fixation" (ICCV
 * 2009).
 *
 * In polar coordinates around the fixation every closed contour around it is a path from one end of the directions to
 * the other, so that a small contour is no cheaper than a large one; the cheapest path along strong boundaries is found
 * as a minimum cut.
 * \param[in] column,row the fixation, in the image
 * \return 1 inside, of the image's size */
Image<std::uint8_t> segmentAround (const EdgeMap& edges, int column, int row,
                                   const PolarCutParameters& parameters = {});

} // namespace pcl_attention
