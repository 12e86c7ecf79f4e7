// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/organized_cloud.h>

#include <Eigen/Core>

namespace pcl_attention
{

/** \brief A point of the flat arrays, in the sensor's frame. */
inline Eigen::Vector3f
pointAt (const OrganizedCloud& cloud, std::size_t index)
{
  return {cloud.x[index], cloud.y[index], cloud.z[index]};
}

} // namespace pcl_attention
