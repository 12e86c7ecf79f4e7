// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/image.h>
#include <pcl_attention/core/organized_cloud.h>

namespace pcl_attention
{

/** \brief Settings of the symmetry of the colour image (WTA2D of paper V-A). */
struct ImageSymmetryParameters
{
  int levels{3};             /**< scales: 1/2, 1/4, ... of the image's size, 1..6 */
  int inner_radius{7};       /**< pixels of a pair are at least so far from their centre, pixels of the scale, 1..100 */
  int outer_radius{17};      /**< ... and at most, 1..100 */
  float pair_distance{16.0f}; /**< standard deviation of a pair's weight over its distance, pixels of the scale, 0.1..1000 */
};

/** \brief Isotropic symmetry at every pixel of a grey image: the sum over all pairs of pixels that lie opposite each other
  * around it (Reisfeld et al. 1995; Kootstra, Nederveen and de Boer 2008, eq. 1 to 5):
  * (1 - cos (g_i + g_j)) (1 - cos (g_i - g_j)) log (1 + m_i) log (1 + m_j) exp (-d^2 / (2 sigma^2)), with m the gradient's
  * magnitude, g its direction against the line through the pair, and d the distance of the pair.
  * \param[in] grey in [0, 255]
  * \param[in] threads number of threads, at least 1; the result does not depend on it */
PCL_ATTENTION_EXPORTS Image<float>
isotropicSymmetry (const Image<float>& grey, const ImageSymmetryParameters& parameters, int threads);

/** \brief Symmetry saliency of the colours of a cloud alone, its geometry left aside: the symmetry of every scale, each from 0 to
  * its maximum made 1, summed at the image's size.
  * \param[in] cloud with colours
  * \param[in] threads number of threads, at least 1; the result does not depend on it
  * \return in [0, 1], of the cloud's size; all 0 without colours or where nothing is symmetric */
PCL_ATTENTION_EXPORTS Image<float>
computeImageSaliency (const OrganizedCloud& cloud, const ImageSymmetryParameters& parameters, int threads);

} // namespace pcl_attention
