// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/organized_cloud.h>
#include <pcl_attention/export.h>

#include <pcl/types.h>

namespace pcl_attention
{

/** \brief Give an object the points at its contour that have its colours and not those around it. Where the depth jumps it tells
  * to the pixel where an object ends, but where one stands on or touches something the planes of both tell it to some pixels only.
  * Points are only added, and never across a jump. Does nothing without colours.
  * \param[in] width how far its contour may move, pixels
  * \param[in] threads that decide; the result does not depend on them
  * \param[in,out] indices of the object's points in the cloud, ascending */
PCL_ATTENTION_EXPORTS void
extendToColors (const OrganizedCloud& cloud, int width, int threads, pcl::Indices& indices);

/** \brief Let an object end where colours do, within some pixels, across jumps of the depth as well: for sensors that smooth their
  * depth, with which points of what lies around get the depth of the object, and points of the object that of what lies around.
  * Does nothing without colours.
  * \param[in] width how far its contour may move, pixels
  * \param[in] threads that decide; the result does not depend on them
  * \param[in,out] indices of the object's points in the cloud, ascending */
PCL_ATTENTION_EXPORTS void
fitToColors (const OrganizedCloud& cloud, int width, int threads, pcl::Indices& indices);

} // namespace pcl_attention
