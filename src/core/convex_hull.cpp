// SPDX-License-Identifier: BSD-3-Clause
// pcl::ConvexHull is instantiated here alone: libpcl_surface, which has it too, would draw in VTK.
#define PCL_NO_PRECOMPILE
#include "convex_hull.h"

#include <pcl/point_types.h>
#include <pcl/surface/convex_hull.h>

#include <numeric>

namespace pcl_attention
{

ConvexHullMesh
computeConvexHull (const std::vector<Eigen::Vector3f>& points, int dimension)
{
  ConvexHullMesh mesh;
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);
  for (const Eigen::Vector3f& point : points)
    cloud->emplace_back (point.x (), point.y (), point.z ());
  pcl::ConvexHull<pcl::PointXYZ> hull;
  hull.setDimension (dimension);
  hull.setInputCloud (cloud);
  // PCL's own list of all points would be left empty, and the hull wrong, where there is no memory for it.
  const pcl::IndicesPtr all (new pcl::Indices (cloud->size ()));
  std::iota (all->begin (), all->end (), 0);
  hull.setIndices (all);
  pcl::PointCloud<pcl::PointXYZ> vertices;
  std::vector<pcl::Vertices> polygons;
  hull.reconstruct (vertices, polygons);
  for (const pcl::PointXYZ& vertex : vertices)
    mesh.vertices.emplace_back (vertex.x, vertex.y, vertex.z);
  for (const pcl::Vertices& polygon : polygons)
    for (std::size_t corner = 2; corner < polygon.vertices.size (); ++corner)
      mesh.triangles.push_back ({static_cast<int> (polygon.vertices[0]), static_cast<int> (polygon.vertices[corner - 1]),
                                 static_cast<int> (polygon.vertices[corner])});
  return (mesh);
}

} // namespace pcl_attention
