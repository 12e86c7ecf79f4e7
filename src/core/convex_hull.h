// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/** \brief Convex hull by pcl::ConvexHull.
  * \param[in] points that span the dimension
  * \param[in] dimension 2 (one polygon, as a fan of triangles) or 3
  * \return empty when Qhull fails */
ConvexHullMesh
computeConvexHull (const std::vector<Eigen::Vector3f>& points, int dimension);

} // namespace pcl_attention
