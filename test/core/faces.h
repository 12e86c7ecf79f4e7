// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/visible_hull.h>

#include <Eigen/Geometry>

namespace pcl_attention
{

inline double
area (const std::vector<VisibleHull::Face>& faces)
{
  double sum = 0.0;
  for (const VisibleHull::Face& face : faces)
    sum += 0.5 * (face.corners[1] - face.corners[0]).cross (face.corners[2] - face.corners[0]).norm ();
  return (sum);
}

} // namespace pcl_attention
