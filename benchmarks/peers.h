// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scenes.h"

namespace pcl_attention
{

/** \brief Register what PCL offers for the same work, on one thread: its normals of organized clouds, and its LCCP with
  * settings tuned on the learning set of mOSD. The clouds must outlive the measurements. */
void
measurePeers (const std::vector<SceneCloud::ConstPtr>& clouds);

} // namespace pcl_attention
