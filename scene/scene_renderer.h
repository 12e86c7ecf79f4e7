// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_description.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>

namespace pcl_attention
{

/** \brief Cast a ray through every pixel, e.g. renderScene (makeScene (SceneKind::clutter, 7)).
 *
 * Intersections are analytic, in double precision. Labels and colours are those of the ray without noise; where the
 * sensor has no depth the point is NaN and its label 0. Visible pieces of an object (8-connected, at least 20 pixels)
 * are numbered within its label by decreasing size.
 * \param[in] scene
 * \param[in] seed of the sensor noise: the same seed gives the same cloud
 * \param[in] threads 0 for all; does not change the result
 * \return an organized cloud; empty, after PCL_ERROR, if the camera or the noise level makes no sense */
pcl::PointCloud<pcl::PointXYZRGBL>::Ptr renderScene (const SceneDescription& scene, std::uint64_t seed = 0,
                                                     unsigned threads = 0);

} // namespace pcl_attention
