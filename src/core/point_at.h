// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/organized_cloud.h>

#include <Eigen/Core>
#include <pcl/types.h>

#include <algorithm>

namespace pcl_attention
{

/** \brief A point of the flat arrays, in the sensor's frame. */
inline Eigen::Vector3f
pointAt (const OrganizedCloud& cloud, std::size_t index)
{
  return {cloud.x[index], cloud.y[index], cloud.z[index]};
}

/** \brief Whether an index is the first or the last one of its row: the outline of the points goes through those.
  * \param[in] indices ascending
  * \param[in] width of the image */
inline bool
isRowEnd (const pcl::Indices& indices, std::size_t i, int width)
{
  const auto rowOf = [&] (std::size_t k) { return (indices[k] / width); };
  return (i == 0 || i + 1 == indices.size () || rowOf (i - 1) != rowOf (i) || rowOf (i + 1) != rowOf (i));
}

/** \brief So many points, evenly taken, fix a plane as well as all of them: their deviation to a hundredth. */
constexpr std::size_t enough_points = 4000;

/** \brief Every how many-th of so many points to take for about enough of them. */
inline std::size_t
stepOf (std::size_t count)
{
  return (std::max<std::size_t> (1, count / enough_points));
}

} // namespace pcl_attention
