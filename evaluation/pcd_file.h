// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <pcl/PCLPointCloud2.h>

#include <string>

namespace pcl_attention
{

/** \brief Read a PCD file; unlike pcl::io::loadPCDFile (1.13) it does not crash on a file that is none.
 * \throws std::runtime_error that names the file: missing, not a PCD file, cut short, or without points */
void readPcdFile (const std::string& path, pcl::PCLPointCloud2& cloud, Eigen::Vector4f& sensor_origin,
                  Eigen::Quaternionf& sensor_orientation);

/** \brief The field of that name, or nullptr. */
const pcl::PCLPointField* findField (const pcl::PCLPointCloud2& cloud, const std::string& name);

} // namespace pcl_attention
