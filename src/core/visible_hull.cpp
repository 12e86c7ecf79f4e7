// SPDX-License-Identifier: BSD-3-Clause
#include "convex_hull.h"

#include <pcl_attention/core/visible_hull.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_attention
{

namespace
{

/** \brief How many dimensions the points span; differences under a micrometre, or float rounding at their distance, are none. */
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

} // namespace

VisibleHull
computeVisibleHull (const std::vector<Eigen::Vector3f>& points)
{
  VisibleHull hull;
  hull.dimension = points.empty () ? 0 : spannedDimension (points);
  ConvexHullMesh mesh;
  if (hull.dimension >= 2)
    mesh = computeConvexHull (points, hull.dimension);
  if (mesh.vertices.empty ())
  {
    // Nothing solid to see: keep all points, so that a later union can still be spanned.
    hull.dimension = std::min (hull.dimension, 1);
    hull.vertices = points;
    return (hull);
  }
  hull.vertices = mesh.vertices;
  Eigen::Vector3f inside = Eigen::Vector3f::Zero ();
  for (const Eigen::Vector3f& vertex : hull.vertices)
    inside += vertex / static_cast<float> (hull.vertices.size ());
  for (const auto& triangle : mesh.triangles)
  {
    VisibleHull::Face face;
    for (int corner = 0; corner < 3; ++corner)
      face.corners[corner] = hull.vertices[triangle[corner]];
    const Eigen::Vector3f area = (face.corners[1] - face.corners[0]).cross (face.corners[2] - face.corners[0]);
    if (area.norm () <= 0.0f)
      continue;
    face.normal = area.normalized ();
    face.offset = -face.normal.dot (face.corners[0]);
    // Qhull through PCL does not orient its facets. A flat hull is seen from whichever side the viewer is on.
    const float towards_inside = hull.dimension == 3 ? face.normal.dot (inside) + face.offset : -face.offset;
    if (towards_inside > 0.0f)
    {
      face.normal = -face.normal;
      face.offset = -face.offset;
    }
    // Seen edge-on, as the sides of what is cut out along rays are, a face shows nothing.
    constexpr float edge_on = 1e-4f;
    (face.offset > edge_on * face.corners[0].norm () ? hull.faces : hull.hidden_faces).push_back (face);
  }
  return (hull);
}

float
distanceToTriangle (const Eigen::Vector3f& point, const VisibleHull::Face& face)
{
  const float height = face.normal.dot (point) + face.offset;
  bool over_face = true;
  float nearest = std::numeric_limits<float>::max ();
  for (int corner = 0; corner < 3; ++corner)
  {
    const Eigen::Vector3f& a = face.corners[corner];
    const Eigen::Vector3f edge = face.corners[(corner + 1) % 3] - a;
    const Eigen::Vector3f& opposite = face.corners[(corner + 2) % 3];
    const Eigen::Vector3f outwards = edge.cross (face.normal);
    // The winding is not known: the third corner tells which side of the edge is inside.
    const float side = outwards.dot (point - a) * outwards.dot (opposite - a);
    if (side >= 0.0f)
      continue;
    over_face = false;
    const float along = std::clamp ((point - a).dot (edge) / edge.squaredNorm (), 0.0f, 1.0f);
    nearest = std::min (nearest, (a + along * edge - point).norm ());
  }
  return (over_face ? std::abs (height) : nearest);
}

float
distanceToFaces (const Eigen::Vector3f& point, const std::vector<VisibleHull::Face>& faces)
{
  if (faces.empty ())
    return (0.0f);
  // No triangle is nearer than its plane, and the nearest plane's triangle is nearly always the nearest one.
  const auto toPlane = [&point] (const VisibleHull::Face& face) { return (std::abs (face.normal.dot (point) + face.offset)); };
  const VisibleHull::Face* nearest_plane = &faces.front ();
  float plane_distance = toPlane (*nearest_plane);
  for (const VisibleHull::Face& face : faces)
  {
    const float distance = toPlane (face);
    if (distance < plane_distance)
    {
      plane_distance = distance;
      nearest_plane = &face;
    }
  }
  float nearest = distanceToTriangle (point, *nearest_plane);
  if (nearest > plane_distance)
    for (const VisibleHull::Face& face : faces)
      if (toPlane (face) < nearest)
        nearest = std::min (nearest, distanceToTriangle (point, face));
  return (nearest);
}

namespace
{

float
meanDistance (const std::vector<Eigen::Vector3f>& points, const std::vector<float>& weights, const VisibleHull& hull,
              const std::vector<VisibleHull::Face>& faces)
{
  if (points.empty () || hull.dimension < 3)
    return (0.0f);
  double sum = 0.0, total = 0.0;
  for (std::size_t i = 0; i < points.size (); ++i)
  {
    const double weight = weights.empty () ? 1.0 : weights[i];
    sum += weight * distanceToFaces (points[i], faces);
    total += weight;
  }
  return (static_cast<float> (sum / total));
}

} // namespace

float
compactness (const std::vector<Eigen::Vector3f>& points, const VisibleHull& hull, const std::vector<float>& weights)
{
  return (meanDistance (points, weights, hull, hull.faces));
}

float
hollowCompactness (const std::vector<Eigen::Vector3f>& points, const VisibleHull& hull, const std::vector<float>& weights)
{
  return (meanDistance (points, weights, hull, hull.hidden_faces));
}

} // namespace pcl_attention
