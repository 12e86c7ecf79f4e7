// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "systems/color_edges.h"

#include <cstdint>

namespace pcl_attention
{

/** \brief Settings of the segmentation from strokes. */
struct StarCutParameters
{
  int reduction{2};             /**< the cut is made on an image smaller by this factor, 1..8 */
  int mixture_components{5};    /**< of the colours of the object, and of those of the background, 1..20 */
  float uniform_share{0.05f};   /**< of a colour that neither stroke has shown, 0..1 */
  float greatest_unary{100.0f}; /**< cost of a pixel that looks like the other side */
  float contrast{150.0f};       /**< cost of a contour between pixels of the same colour */
  float geodesic{0.3f};         /**< share of the image's contrast in the length of a path, 0: as the crow flies, 1 */
  bool star_constraint{true};   /**< without it colours and contours alone decide */
};

/** \brief The region of an object that strokes mark, after Gulshan, Rother, Criminisi, Blake and Zisserman, "Geodesic
 * Star Convexity for Interactive Image Segmentation" (CVPR 2010).
 *
 * The cheapest cut by the colours of both strokes and by contrast, in which every pixel of the object is reached from a
 * stroke on a shortest path inside the object.
 * \param[in] object,background strokes, non-zero, of the image's size; where both are, it is the object's. Each has at
 * least a pixel of its own
 * \return 1 on the object, of the image's size */
Image<std::uint8_t> segmentFromStrokes (const ColorImage& colors, const Image<std::uint8_t>& object,
                                        const Image<std::uint8_t>& background,
                                        const StarCutParameters& parameters = {});

} // namespace pcl_attention
