// SPDX-License-Identifier: BSD-3-Clause
// pcl::ConvexHull is instantiated here alone: libpcl_surface, which has it too, would draw in VTK.
#define PCL_NO_PRECOMPILE
#include "convex_hull.h"

#include <Eigen/Eigenvalues>
#include <pcl/point_types.h>
#include <pcl/surface/convex_hull.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcl_attention
{

int
spannedDimension (const std::vector<Eigen::Vector3f>& points)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero ();
  for (const Eigen::Vector3f& point : points)
    mean += point.cast<double> () / static_cast<double> (points.size ());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero ();
  float farthest = 0.0f;
  for (const Eigen::Vector3f& point : points)
  {
    const Eigen::Vector3d difference = point.cast<double> () - mean;
    covariance += difference * difference.transpose () / static_cast<double> (points.size ());
    farthest = std::max (farthest, point.cwiseAbs ().maxCoeff ());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (covariance, Eigen::EigenvaluesOnly);
  const double thickness = std::max (1e-6, 4.0 * static_cast<double> (farthest) * std::numeric_limits<float>::epsilon ());
  return (static_cast<int> ((solver.eigenvalues ().array () > thickness * thickness).count ()));
}

ConvexHullMesh
computeConvexHull (const std::vector<Eigen::Vector3f>& points, int dimension)
{
  ConvexHullMesh mesh;
  if (points.empty () || spannedDimension (points) < dimension)
    return (mesh); // on which Qhull would fail with many lines on stderr
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
