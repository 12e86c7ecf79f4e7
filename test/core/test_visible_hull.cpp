// SPDX-License-Identifier: BSD-3-Clause
// Paper eq. 13 and 14: the hull, its visible faces and the compactness.
#include "../../src/core/convex_hull.h"

#include "faces.h"
#include <pcl_attention/core/visible_hull.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl_attention;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace
{

std::vector<Vector3f>
cube (const Vector3f& center, float side)
{
  std::vector<Vector3f> corners;
  for (const float x : {-0.5f, 0.5f})
    for (const float y : {-0.5f, 0.5f})
      for (const float z : {-0.5f, 0.5f})
        corners.push_back (center + side * Vector3f (x, y, z));
  return (corners);
}

/** \brief Area of the faces with this normal. */
double
areaTowards (const std::vector<VisibleHull::Face>& faces, const Vector3f& normal)
{
  std::vector<VisibleHull::Face> some;
  for (const VisibleHull::Face& face : faces)
    if ((face.normal - normal).norm () < 1e-3f)
      some.push_back (face);
  return (area (some));
}

bool
contains (const std::vector<Vector3f>& points, const Vector3f& point, float tolerance = 1e-6f)
{
  return (std::any_of (points.begin (), points.end (),
                       [&] (const Vector3f& other) { return ((other - point).norm () <= tolerance); }));
}

/** \brief What every face of a hull must be. */
void
expectFaces (const VisibleHull& hull, const std::vector<Vector3f>& points)
{
  float size = 0.0f, reach = 0.0f;
  for (const Vector3f& point : points)
  {
    size = std::max (size, (point - points.front ()).norm ());
    reach = std::max (reach, point.norm ());
  }
  const float tolerance = 1e-4f * size + 1e-6f * reach;
  for (const bool visible : {true, false})
    for (const VisibleHull::Face& face : visible ? hull.faces : hull.hidden_faces)
    {
      EXPECT_NEAR (face.normal.norm (), 1.0f, 1e-5f);
      for (const Vector3f& corner : face.corners)
      {
        EXPECT_NEAR (face.normal.dot (corner) + face.offset, 0.0f, tolerance);
        EXPECT_TRUE (contains (points, corner)) << "a corner that is no point";
      }
      for (const Vector3f& point : points)
        EXPECT_LE (face.normal.dot (point) + face.offset, tolerance) << "a point beyond a face";
      // The viewpoint is the origin.
      EXPECT_EQ (face.offset > 0.0f, visible);
    }
}

VisibleHull::Face
triangle (const Vector3f& a, const Vector3f& b, const Vector3f& c)
{
  VisibleHull::Face face;
  face.corners = {a, b, c};
  face.normal = (b - a).cross (c - a).normalized ();
  face.offset = -face.normal.dot (a);
  return (face);
}

/** \brief Distance to a triangle by trying points of it, finer and finer around the best. */
double
sampledDistance (const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  double u = 1.0 / 3.0, v = 1.0 / 3.0, step = 1.0 / 3.0, best = 1e300;
  for (int round = 0; round < 60; ++round, step *= 0.7)
  {
    const double u0 = u, v0 = v;
    for (int i = -5; i <= 5; ++i)
      for (int j = -5; j <= 5; ++j)
      {
        double s = std::clamp (u0 + i * step / 2.5, 0.0, 1.0), t = std::clamp (v0 + j * step / 2.5, 0.0, 1.0);
        if (s + t > 1.0)
        {
          const double over = 0.5 * (s + t - 1.0);
          s = std::clamp (s - over, 0.0, 1.0);
          t = 1.0 - s;
        }
        const double distance = (a + s * (b - a) + t * (c - a) - p).norm ();
        if (distance < best)
        {
          best = distance;
          u = s;
          v = t;
        }
      }
  }
  return (best);
}

} // namespace

// Qhull would say so in many lines on stderr, which in a robot's log look like an error.
TEST (ConvexHull, OfWhatDoesNotSpanTheDimensionIsEmptyWithoutAWord)
{
  std::vector<Eigen::Vector3f> column, diagonal, square;
  for (int i = 0; i < 20; ++i)
  {
    column.emplace_back (120.0f, static_cast<float> (i), 0.0f);
    diagonal.emplace_back (static_cast<float> (i), static_cast<float> (i), 0.0f);
    square.emplace_back (static_cast<float> (i % 5), static_cast<float> (i / 5), 0.0f);
  }
  testing::internal::CaptureStderr ();
  EXPECT_TRUE (computeConvexHull ({}, 2).vertices.empty ());
  EXPECT_TRUE (computeConvexHull (column, 2).vertices.empty ());
  EXPECT_TRUE (computeConvexHull (diagonal, 2).vertices.empty ());
  EXPECT_TRUE (computeConvexHull (square, 3).vertices.empty ());
  EXPECT_EQ (testing::internal::GetCapturedStderr (), "");
  EXPECT_EQ (computeConvexHull (square, 2).vertices.size (), 4u);
}

TEST (VisibleHull, OfACubeSeenAtItsCornerHasThreeVisibleSides)
{
  // Right of, below and before the viewer: the left, the upper and the near side are seen.
  std::vector<Vector3f> points = cube ({0.5f, 0.4f, 1.0f}, 0.2f);
  points.emplace_back (0.5f, 0.4f, 1.0f); // inside
  points.emplace_back (0.55f, 0.38f, 0.98f);
  const VisibleHull hull = computeVisibleHull (points);
  EXPECT_EQ (hull.dimension, 3);
  EXPECT_EQ (hull.vertices.size (), 8u);
  for (const Vector3f& corner : cube ({0.5f, 0.4f, 1.0f}, 0.2f))
    EXPECT_TRUE (contains (hull.vertices, corner));
  expectFaces (hull, points);
  for (const Vector3f& normal : {Vector3f (-1, 0, 0), Vector3f (0, -1, 0), Vector3f (0, 0, -1)})
  {
    EXPECT_NEAR (areaTowards (hull.faces, normal), 0.04, 1e-6);
    EXPECT_NEAR (areaTowards (hull.hidden_faces, -normal), 0.04, 1e-6);
  }
  EXPECT_NEAR (area (hull.faces), 0.12, 1e-6);
  EXPECT_NEAR (area (hull.hidden_faces), 0.12, 1e-6);
}

TEST (VisibleHull, OfACubeSeenFromTheFrontHasOneVisibleSide)
{
  const std::vector<Vector3f> points = cube ({0, 0, 1}, 0.2f);
  const VisibleHull hull = computeVisibleHull (points);
  expectFaces (hull, points);
  EXPECT_NEAR (area (hull.faces), 0.04, 1e-6);
  EXPECT_NEAR (areaTowards (hull.faces, {0, 0, -1}), 0.04, 1e-6);
  EXPECT_NEAR (area (hull.hidden_faces), 0.2, 1e-6);
}

TEST (VisibleHull, SidesThatAreSeenEdgeOnAreNotVisible)
{
  // What is cut out along rays, as every patch at the image's border is, has sides through the viewpoint.
  for (const float tilt : {0.0f, 0.1f, 0.3f})
    for (const float distance : {1.0f, 0.7f, 0.55f})
    {
      SCOPED_TRACE (::testing::Message () << "tilt " << tilt << " distance " << distance);
      std::vector<Vector3f> points;
      for (const float z : {distance, 1.5f * distance})
        for (const float x : {-0.1f, 0.13f})
          for (const float y : {-0.07f, 0.11f})
            points.push_back (z * Vector3f (x + tilt, y - tilt, 1.0f));
      const VisibleHull hull = computeVisibleHull (points);
      EXPECT_NEAR (area (hull.faces), 0.23 * 0.18 * distance * distance, 1e-5);
      // The middle lies a quarter of the distance behind the near side.
      const float middle = 1.25f * distance;
      EXPECT_NEAR (compactness ({{tilt * middle, -tilt * middle, middle}}, hull), 0.25f * distance, 1e-4f);
    }
}

TEST (VisibleHull, AroundTheViewerHasNoVisibleSide)
{
  const VisibleHull hull = computeVisibleHull (cube ({0, 0, 0}, 2.0f));
  EXPECT_TRUE (hull.faces.empty ());
  EXPECT_NEAR (area (hull.hidden_faces), 24.0, 1e-4);
}

TEST (VisibleHull, OfATetrahedron)
{
  const std::vector<Vector3f> points{{0, 0, 1}, {0.1f, 0, 1}, {0, 0.1f, 1}, {0, 0, 0.9f}};
  const VisibleHull hull = computeVisibleHull (points);
  expectFaces (hull, points);
  EXPECT_EQ (hull.vertices.size (), 4u);
  EXPECT_EQ (hull.faces.size () + hull.hidden_faces.size (), 4u);
  // Two faces are edge-on; the slanted one has its normal along (1, 1, -1), away from the line of sight only by being
  // below it: its plane x + y - z = -0.9 has the origin beyond it.
  ASSERT_EQ (hull.faces.size (), 1u);
  EXPECT_LT ((hull.faces[0].normal - Vector3f (1, 1, -1).normalized ()).norm (), 1e-5f);
  EXPECT_NEAR (hull.faces[0].offset, 0.9 / std::sqrt (3.0), 1e-5);
}

TEST (VisibleHull, OfASphereHasAllItsPointsAndItsCapInSight)
{
  std::mt19937 random (1);
  std::normal_distribution<float> normal;
  const Vector3f center (0.1f, -0.2f, 1.5f);
  std::vector<Vector3f> points;
  for (int k = 0; k < 400; ++k)
    points.push_back (center + 0.2f * Vector3f (normal (random), normal (random), normal (random)).normalized ());
  const VisibleHull hull = computeVisibleHull (points);
  EXPECT_EQ (hull.dimension, 3);
  EXPECT_EQ (hull.vertices.size (), points.size ());
  // Euler: a triangulated sphere has 2 n - 4 faces.
  EXPECT_EQ (hull.faces.size () + hull.hidden_faces.size (), 2 * points.size () - 4);
  expectFaces (hull, points);
  // The visible cap of a sphere at distance d: 2 pi r^2 (1 - r / d).
  EXPECT_NEAR (area (hull.faces), 2.0 * std::acos (-1.0) * 0.04 * (1.0 - 0.2 / center.norm ()), 0.012);
}

TEST (VisibleHull, OfAUnionIsThatOfTheHullsVertices)
{
  std::mt19937 random (2);
  std::uniform_real_distribution<float> uniform (-0.1f, 0.1f);
  for (int round = 0; round < 20; ++round)
  {
    std::vector<Vector3f> a, b;
    for (int k = 0; k < 60; ++k)
    {
      a.emplace_back (uniform (random), uniform (random), 1.0f + uniform (random));
      b.emplace_back (0.1f + uniform (random), uniform (random), 1.1f + uniform (random));
    }
    std::vector<Vector3f> all = a, vertices = computeVisibleHull (a).vertices;
    all.insert (all.end (), b.begin (), b.end ());
    const std::vector<Vector3f> others = computeVisibleHull (b).vertices;
    vertices.insert (vertices.end (), others.begin (), others.end ());
    const VisibleHull of_all = computeVisibleHull (all), of_vertices = computeVisibleHull (vertices);
    EXPECT_EQ (of_all.vertices.size (), of_vertices.vertices.size ());
    for (const Vector3f& vertex : of_all.vertices)
      EXPECT_TRUE (contains (of_vertices.vertices, vertex));
    EXPECT_NEAR (area (of_all.faces), area (of_vertices.faces), 1e-6);
    EXPECT_NEAR (compactness (all, of_all), compactness (all, of_vertices), 1e-6);
  }
}

TEST (VisibleHull, OfPointsOnAPlaneIsFlatAndFacesTheViewer)
{
  std::mt19937 random (3);
  std::uniform_real_distribution<float> uniform (-0.1f, 0.1f);
  for (int round = 0; round < 60; ++round)
  {
    SCOPED_TRACE (round);
    const Vector3f normal =
        round == 0 ? Vector3f (0, 0, 1) : Vector3f (uniform (random), uniform (random), uniform (random)).normalized ();
    const Vector3f u = normal.unitOrthogonal (), v = normal.cross (u);
    const Vector3f center (10.0f * uniform (random), 10.0f * uniform (random), 2.0f + 10.0f * uniform (random));
    if (std::abs (normal.dot (center)) < 0.1f)
      continue; // nearly edge-on
    std::vector<Vector3f> points;
    for (const float a : {-0.1f, 0.1f})
      for (const float b : {-0.1f, 0.1f})
        points.push_back (center + a * u + b * v);
    for (int k = 0; k < 50; ++k)
      points.push_back (center + 0.99f * uniform (random) * u + 0.99f * uniform (random) * v);
    const VisibleHull hull = computeVisibleHull (points);
    EXPECT_EQ (hull.dimension, 2);
    EXPECT_EQ (hull.vertices.size (), 4u);
    EXPECT_NEAR (area (hull.faces), 0.04, 1e-5);
    EXPECT_TRUE (hull.hidden_faces.empty ());
    for (const VisibleHull::Face& face : hull.faces)
      EXPECT_LT (face.normal.dot (center), 0.0f);
    EXPECT_EQ (compactness (points, hull), 0.0f);
  }
}

TEST (VisibleHull, OfALineAPointOrNothingHasNoFaces)
{
  std::vector<Vector3f> line;
  for (int k = 0; k < 10; ++k)
    line.push_back (Vector3f (0.1f, 0.2f, 1.0f) + 0.01f * static_cast<float> (k) * Vector3f (1, 2, 3));
  const VisibleHull of_line = computeVisibleHull (line);
  EXPECT_EQ (of_line.dimension, 1);
  EXPECT_TRUE (of_line.faces.empty () && of_line.hidden_faces.empty ());
  EXPECT_EQ (compactness (line, of_line), 0.0f);

  const std::vector<Vector3f> point{{0.1f, 0.2f, 1.0f}};
  const VisibleHull of_point = computeVisibleHull (point);
  EXPECT_EQ (of_point.dimension, 0);
  EXPECT_TRUE (of_point.faces.empty ());
  EXPECT_TRUE (contains (of_point.vertices, point[0]));

  const VisibleHull of_duplicates = computeVisibleHull (std::vector<Vector3f> (20, point[0]));
  EXPECT_EQ (of_duplicates.dimension, 0);
  EXPECT_TRUE (of_duplicates.faces.empty ());

  const VisibleHull of_nothing = computeVisibleHull ({});
  EXPECT_EQ (of_nothing.dimension, 0);
  EXPECT_TRUE (of_nothing.vertices.empty ());
}

TEST (VisibleHull, IgnoresDuplicates)
{
  std::vector<Vector3f> points = cube ({0.5f, 0.4f, 1.0f}, 0.2f);
  const std::vector<Vector3f> once = points;
  for (int k = 0; k < 5; ++k)
    points.insert (points.end (), once.begin (), once.end ());
  const VisibleHull hull = computeVisibleHull (points);
  EXPECT_EQ (hull.vertices.size (), 8u);
  EXPECT_NEAR (area (hull.faces), 0.12, 1e-6);
}

TEST (VisibleHull, WorksForSmallLargeAndDistantThings)
{
  for (const auto& [side, distance] : std::vector<std::pair<float, float>>{
           {0.002f, 0.5f}, {0.01f, 5.0f}, {0.5f, 100.0f}, {20.0f, 30.0f}, {0.1f, 0.2f}})
  {
    SCOPED_TRACE (::testing::Message () << side << " at " << distance);
    const Vector3f center (0.5f * distance, 0.4f * distance, distance);
    const std::vector<Vector3f> points = cube (center, side);
    const VisibleHull hull = computeVisibleHull (points);
    EXPECT_EQ (hull.dimension, 3);
    EXPECT_EQ (hull.vertices.size (), 8u);
    expectFaces (hull, points);
    EXPECT_NEAR (area (hull.faces) / (side * side), 3.0, 0.01);
    EXPECT_NEAR (compactness ({center}, hull) / side, 0.5, 0.005);
  }
}

TEST (VisibleHull, OfAThinSheetStaysSolid)
{
  // 0.1 mm thick: thicker than rounding, thinner than any sensor's noise.
  std::vector<Vector3f> points;
  for (const Vector3f& corner : cube ({0, 0, 0}, 1.0f))
    points.push_back (Vector3f (0.3f, 0.2f, 1.0f) + corner.cwiseProduct (Vector3f (0.2f, 0.1f, 1e-4f)));
  const VisibleHull hull = computeVisibleHull (points);
  EXPECT_EQ (hull.dimension, 3);
  EXPECT_NEAR (areaTowards (hull.faces, {0, 0, -1}), 0.02, 1e-4);
}

TEST (DistanceToTriangle, EqualsTheNearestOfItsSampledPoints)
{
  std::mt19937 random (4);
  std::uniform_real_distribution<float> uniform (-1.0f, 1.0f);
  const auto vector = [&] { return (Vector3f (uniform (random), uniform (random), uniform (random))); };
  double largest = 0.0;
  for (int round = 0; round < 1500; ++round)
  {
    const Vector3f a = vector (), b = vector ();
    // Every third one is long and narrow.
    const Vector3f c = round % 3 == 0 ? Vector3f (a + 0.4f * (b - a) + 0.05f * vector ()) : vector ();
    if ((b - a).cross (c - a).norm () < 1e-2f)
      continue;
    const VisibleHull::Face face = triangle (a, b, c);
    for (int k = 0; k < 4; ++k)
    {
      const Vector3f p = 1.5f * vector ();
      const double expected =
          sampledDistance (p.cast<double> (), a.cast<double> (), b.cast<double> (), c.cast<double> ());
      largest = std::max (largest, std::abs (distanceToTriangle (p, face) - expected));
    }
  }
  EXPECT_LT (largest, 1e-4);
}

TEST (DistanceToTriangle, ByHandInEveryRegion)
{
  const VisibleHull::Face face = triangle ({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_FLOAT_EQ (distanceToTriangle ({0.2f, 0.2f, 0.5f}, face), 0.5f);
  EXPECT_FLOAT_EQ (distanceToTriangle ({0.2f, 0.2f, -0.5f}, face), 0.5f);
  EXPECT_FLOAT_EQ (distanceToTriangle ({0.5f, -2.0f, 0.0f}, face), 2.0f);            // an edge
  EXPECT_FLOAT_EQ (distanceToTriangle ({-3.0f, -4.0f, 0.0f}, face), 5.0f);           // a corner
  EXPECT_FLOAT_EQ (distanceToTriangle ({1.0f, 1.0f, 0.0f}, face), std::sqrt (0.5f)); // the slanted edge
  EXPECT_FLOAT_EQ (distanceToTriangle ({3.0f, 0.0f, 0.0f}, face), 2.0f);             // another corner
  EXPECT_NEAR (distanceToTriangle ({0.25f, 0.25f, 0.0f}, face), 0.0f, 1e-7f);
  // Whatever the winding.
  const VisibleHull::Face reversed = triangle ({0, 0, 0}, {0, 1, 0}, {1, 0, 0});
  EXPECT_FLOAT_EQ (distanceToTriangle ({0.5f, -2.0f, 0.0f}, reversed), 2.0f);
  EXPECT_FLOAT_EQ (distanceToTriangle ({0.2f, 0.2f, 0.5f}, reversed), 0.5f);
}

TEST (DistanceToFaces, IsTheSmallestOfAll)
{
  const std::vector<VisibleHull::Face> faces{triangle ({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                                             triangle ({0, 0, 3}, {1, 0, 3}, {0, 1, 3}),
                                             // Its plane passes near every test point, the triangle does not.
                                             triangle ({100, 0, 0}, {100, 0, 1}, {101, 0, 0})};
  EXPECT_FLOAT_EQ (distanceToFaces ({0.2f, 0.2f, 1.0f}, faces), 1.0f);
  EXPECT_FLOAT_EQ (distanceToFaces ({0.2f, 0.2f, 2.0f}, faces), 1.0f);
  EXPECT_FLOAT_EQ (distanceToFaces ({0.2f, 0.2f, 2.75f}, faces), 0.25f);
  EXPECT_EQ (distanceToFaces ({0, 0, 0}, {}), 0.0f);
}

TEST (Compactness, OfPointsOnTheVisibleFacesIsZero)
{
  std::vector<Vector3f> points = cube ({0.5f, 0.4f, 1.0f}, 0.2f);
  const VisibleHull hull = computeVisibleHull (points);
  std::mt19937 random (5);
  std::uniform_real_distribution<float> uniform (-0.1f, 0.1f);
  std::vector<Vector3f> on_faces;
  for (int k = 0; k < 100; ++k)
  {
    on_faces.emplace_back (0.4f, 0.4f + uniform (random), 1.0f + uniform (random));
    on_faces.emplace_back (0.5f + uniform (random), 0.3f, 1.0f + uniform (random));
    on_faces.emplace_back (0.5f + uniform (random), 0.4f + uniform (random), 0.9f);
  }
  EXPECT_NEAR (compactness (on_faces, hull), 0.0f, 1e-6f);
  // On the hidden faces, the distance to the visible ones is not 0, and the other way round.
  EXPECT_NEAR (compactness ({{0.6f, 0.4f, 1.0f}}, hull), 0.1f, 1e-6f);
  EXPECT_NEAR (hollowCompactness ({{0.6f, 0.4f, 1.0f}}, hull), 0.0f, 1e-6f);
}

TEST (Compactness, IsTheMeanDistanceByHand)
{
  const VisibleHull hull = computeVisibleHull (cube ({0.5f, 0.4f, 1.0f}, 0.2f));
  // The centre is 10 cm from each of the visible sides, the second point 5 cm from the left one, the third 2 cm from
  // the near one.
  EXPECT_NEAR (compactness ({{0.5f, 0.4f, 1.0f}}, hull), 0.1f, 1e-6f);
  EXPECT_NEAR (compactness ({{0.5f, 0.4f, 1.0f}, {0.45f, 0.4f, 1.0f}, {0.5f, 0.4f, 0.92f}}, hull),
               (0.1f + 0.05f + 0.02f) / 3.0f, 1e-6f);
  EXPECT_NEAR (hollowCompactness ({{0.5f, 0.4f, 1.0f}, {0.57f, 0.4f, 1.0f}}, hull), 0.5f * (0.1f + 0.03f), 1e-6f);
  EXPECT_EQ (compactness ({}, hull), 0.0f);
}

TEST (Compactness, CountsAPointAsOftenAsItsWeight)
{
  const VisibleHull hull = computeVisibleHull (cube ({0.5f, 0.4f, 1.0f}, 0.2f));
  // Depths of 10, 5 and 2 cm, standing for 1, 2 and 7 points.
  const std::vector<Vector3f> points{{0.5f, 0.4f, 1.0f}, {0.45f, 0.4f, 1.0f}, {0.5f, 0.4f, 0.92f}};
  EXPECT_NEAR (compactness (points, hull, {1.0f, 2.0f, 7.0f}), (0.1f + 2.0f * 0.05f + 7.0f * 0.02f) / 10.0f, 1e-6f);
  EXPECT_NEAR (compactness (points, hull, {3.0f, 3.0f, 3.0f}), compactness (points, hull), 1e-7f);
  EXPECT_NEAR (hollowCompactness ({{0.5f, 0.4f, 1.0f}, {0.57f, 0.4f, 1.0f}}, hull, {3.0f, 1.0f}),
               (3.0f * 0.1f + 0.03f) / 4.0f, 1e-6f);
}

TEST (Compactness, OfACylindersFrontIsTheHeightOfItsFacets)
{
  // 15 degrees a facet: the hull is the cylinder but for its facets' sagitta of at most r (1 - cos 7.5 degrees).
  std::vector<Vector3f> points;
  const double radius = 0.05;
  for (int degree = -60; degree <= 60; degree += 15)
    for (const float y : {-0.05f, 0.05f})
    {
      const double angle = degree * std::acos (-1.0) / 180.0;
      points.emplace_back (static_cast<float> (radius * std::sin (angle)), y,
                           static_cast<float> (1.0 - radius * std::cos (angle)));
    }
  const VisibleHull hull = computeVisibleHull (points);
  EXPECT_NEAR (compactness (points, hull), 0.0f, 1e-6f);
  std::vector<Vector3f> between;
  for (double degree = -52.5; degree <= 52.5; degree += 15.0)
  {
    const double angle = degree * std::acos (-1.0) / 180.0;
    between.emplace_back (static_cast<float> (radius * std::sin (angle)), 0.0f,
                          static_cast<float> (1.0 - radius * std::cos (angle)));
  }
  const double sagitta = radius * (1.0 - std::cos (7.5 * std::acos (-1.0) / 180.0));
  EXPECT_NEAR (compactness (between, hull), sagitta, 1e-6);
}

TEST (Compactness, OfABowlIsSmallOnlyToItsHiddenFaces)
{
  // The inside of half a sphere that opens towards the viewer.
  std::vector<Vector3f> points;
  for (int ring = 0; ring <= 12; ++ring)
    for (int k = 0; k < 24; ++k)
    {
      const double polar = ring * std::acos (-1.0) / 24.0, azimuth = k * std::acos (-1.0) / 12.0;
      points.emplace_back (static_cast<float> (0.08 * std::sin (polar) * std::cos (azimuth)),
                           static_cast<float> (0.08 * std::sin (polar) * std::sin (azimuth)),
                           static_cast<float> (1.0 + 0.08 * std::cos (polar)));
    }
  const VisibleHull hull = computeVisibleHull (points);
  EXPECT_GT (compactness (points, hull), 0.03f);
  EXPECT_LT (hollowCompactness (points, hull), 0.002f);
}
