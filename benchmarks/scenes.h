// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>
#include <vector>

namespace pcl_attention
{

using SceneCloud = pcl::PointCloud<pcl::PointXYZRGB>;

/** \brief The scenes to measure on.
  * \param[in] paths PCD files; without any, four scenes are rendered
  * \param[in] columns of rendered scenes, pixels; there are three quarters as many rows
  * \throws std::runtime_error with one line that names the file and what is wrong */
std::vector<SceneCloud::ConstPtr>
loadScenes (const std::vector<std::string>& paths, int columns);

} // namespace pcl_attention
