// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/image.h>
#include <pcl_attention/core/organized_cloud.h>

#include <Eigen/Core>

namespace pcl_attention
{

/** \brief Red, green and blue of every pixel, 0..1. */
using ColorImage = Image<Eigen::Vector3f>;

/** \brief The colours of a cloud that has them, also where it has no coordinates. */
ColorImage colorsOf (const OrganizedCloud& cloud);

/** \brief CIE 1976 L*a*b* of an sRGB colour, white point D65: L in 0..100.
 * \param[in] rgb 0..1 */
Eigen::Vector3f labOf (const Eigen::Vector3f& rgb);

/** \brief Settings of the boundary detector. */
struct ColorEdgeParameters
{
  int brightness_radius{6};       /**< of the disc, pixels, 1..30 */
  int color_radius{10};           /**< of the disc for a* and b*, pixels, 1..30 */
  int texture_radius{12};         /**< of the disc for texture, pixels, 1..30 */
  float brightness_weight{0.35f}; /**< of the four cues in the sum, each at least 0 */
  float color_weight{0.5f};       /**< for a* and b* each */
  float texture_weight{0.35f};
  float threshold{0.1f}; /**< weaker boundaries are none, 0..1 */
};

/** \brief Boundaries on lines about a pixel wide. */
struct EdgeMap
{
  Image<float> strength; /**< 0..1; 0: none */
  Image<float>
      direction; /**< of the line: angle to the rows, clockwise in the image, radians, 0..pi; 0 where there is none */
};

/** \brief Boundaries between regions of different colour or texture.
 *
 * A gradient after Martin, Fowlkes and Malik (Pb, PAMI 2004): at each of eight orientations a disc is cut in two, and
 * the chi-square distance of the halves' histograms of L*, a*, b* and local texture tells how different they are.
 * \param[in] threads number of threads, at least 1; the result does not depend on it */
EdgeMap detectColorEdges (const ColorImage& colors, const ColorEdgeParameters& parameters = {}, int threads = 1);

} // namespace pcl_attention
