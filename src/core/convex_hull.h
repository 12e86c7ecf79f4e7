// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/export.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl_attention
{

/** \brief Vertices and triangles of a convex hull; the triangles are not oriented. */
struct ConvexHullMesh
{
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<int, 3>> triangles;
};

/** \brief How many dimensions the points span; differences under a micrometre, or float rounding at their distance, are none. */
int
spannedDimension (const std::vector<Eigen::Vector3f>& points);

/** \brief Convex hull by pcl::ConvexHull.
  * \param[in] dimension 2 (one polygon, as a fan of triangles) or 3
  * \return empty where the points do not span the dimension, or Qhull fails */
PCL_ATTENTION_EXPORTS ConvexHullMesh
computeConvexHull (const std::vector<Eigen::Vector3f>& points, int dimension);

} // namespace pcl_attention
