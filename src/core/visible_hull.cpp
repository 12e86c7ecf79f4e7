// SPDX-License-Identifier: BSD-3-Clause
#include "convex_hull.h"
#include "flat_points.h"
#include "instruction_set.h"

#include <pcl_attention/core/visible_hull.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_attention
{

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
    std::array<Eigen::Vector3f, 3> corners;
    for (int corner = 0; corner < 3; ++corner)
      corners[corner] = hull.vertices[triangle[corner]];
    const Eigen::Vector3f area = (corners[1] - corners[0]).cross (corners[2] - corners[0]);
    if (area.norm () <= 0.0f)
      continue;
    const Eigen::Vector3f normal = area.normalized ();
    // Qhull through PCL does not orient its facets. A flat hull is seen from whichever side the viewer is on.
    const Eigen::Vector3f towards_inside = hull.dimension == 3 ? Eigen::Vector3f (inside - corners[0]) : corners[0];
    hull.addFace (corners, normal.dot (towards_inside) > 0.0f ? Eigen::Vector3f (-normal) : normal);
  }
  return (hull);
}

void
VisibleHull::addFace (const std::array<Eigen::Vector3f, 3>& corners, const Eigen::Vector3f& normal)
{
  const Face face{corners, normal, -normal.dot (corners[0])};
  // Seen edge-on, as the sides of what is cut out along rays are, a face shows nothing.
  constexpr float edge_on = 1e-4f;
  (face.offset > edge_on * corners[0].norm () ? faces : hidden_faces).push_back (face);
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

namespace
{

/** \brief Distance from a point to the nearest of some faces, of which the nearest plane's distance is known. */
float
distanceToFaces (const Eigen::Vector3f& point, const std::vector<VisibleHull::Face>& faces, float plane_distance)
{
  const auto toPlane = [&point] (const VisibleHull::Face& face) { return (std::abs (face.normal.dot (point) + face.offset)); };
  // No triangle is nearer than its plane, and the nearest plane's triangle is nearly always the nearest one.
  float nearest = std::numeric_limits<float>::max ();
  for (const VisibleHull::Face& face : faces)
    if (toPlane (face) <= plane_distance)
    {
      nearest = distanceToTriangle (point, face);
      break;
    }
  if (nearest > plane_distance)
    for (const VisibleHull::Face& face : faces)
      if (toPlane (face) < nearest)
        nearest = std::min (nearest, distanceToTriangle (point, face));
  return (nearest);
}

/** \brief Distance of each point to the nearest plane of some faces. */
std::vector<float>
distancesToPlanes (const std::vector<Eigen::Vector3f>& points, const std::vector<VisibleHull::Face>& faces)
{
  const FlatPoints flat (points.data (), points.size ());
  std::vector<float> nearest (flat.size ());
  std::vector<FlatPlane> planes;
  planes.reserve (faces.size ());
  for (const VisibleHull::Face& face : faces)
    planes.push_back ({{face.normal.x (), face.normal.y (), face.normal.z ()}, face.offset});
  laneKernels ().nearestPlane (flat.arrays (), flat.size (), planes.data (), planes.size (), nearest.data ());
  return (nearest);
}

float
meanDistance (const std::vector<Eigen::Vector3f>& points, const std::vector<float>& weights, const VisibleHull& hull,
              const std::vector<VisibleHull::Face>& faces, FaceDistance face_distance)
{
  if (points.empty () || faces.empty () || hull.dimension < 3)
    return (0.0f);
  const std::vector<float> to_planes = distancesToPlanes (points, faces);
  double sum = 0.0, total = 0.0;
  for (std::size_t i = 0; i < points.size (); ++i)
  {
    const double weight = weights.empty () ? 1.0 : weights[i];
    const float to_plane = to_planes[i];
    sum += weight * (face_distance == FaceDistance::plane ? to_plane : distanceToFaces (points[i], faces, to_plane));
    total += weight;
  }
  return (static_cast<float> (sum / total));
}

} // namespace

float
distanceToFaces (const Eigen::Vector3f& point, const std::vector<VisibleHull::Face>& faces)
{
  return (faces.empty () ? 0.0f : distanceToFaces (point, faces, distancesToPlanes ({point}, faces)[0]));
}

float
compactness (const std::vector<Eigen::Vector3f>& points, const VisibleHull& hull, const std::vector<float>& weights,
             FaceDistance face_distance)
{
  return (meanDistance (points, weights, hull, hull.faces, face_distance));
}

float
hollowCompactness (const std::vector<Eigen::Vector3f>& points, const VisibleHull& hull, const std::vector<float>& weights,
                   FaceDistance face_distance)
{
  return (meanDistance (points, weights, hull, hull.hidden_faces, face_distance));
}

} // namespace pcl_attention
