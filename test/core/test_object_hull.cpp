// SPDX-License-Identifier: BSD-3-Clause
// The hull that is kept and extended, against Qhull's.
#include "../../src/core/object_hull.h"

#include "faces.h"
#include <pcl_attention/core/organized_cloud.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace pcl_attention;
using Eigen::Vector3f;

namespace
{

/** \brief Steps of 1/64 metre, which floats hold exactly. */
HullGrid
exactGrid ()
{
  HullGrid grid;
  grid.step = 1.0f / 64.0f;
  return (grid);
}

std::vector<Vector3f>
randomPoints (int count, unsigned seed, int reach)
{
  std::mt19937 generator (seed);
  std::uniform_int_distribution<int> coordinate (-reach, reach);
  std::vector<Vector3f> points;
  for (int i = 0; i < count; ++i)
  {
    const float x = static_cast<float> (coordinate (generator)), y = static_cast<float> (coordinate (generator));
    points.push_back (Vector3f (x, y, static_cast<float> (coordinate (generator))) / 64.0f + Vector3f (0.0f, 0.0f, 20.0f));
  }
  return (points);
}

double
volume (const VisibleHull& hull)
{
  double sum = 0.0;
  for (const auto* faces : {&hull.faces, &hull.hidden_faces})
    for (const VisibleHull::Face& face : *faces)
      sum -= face.offset * area ({face}) / 3.0;
  return (sum);
}

/** \brief The same solid; a corner of the one may lie on an edge or a face of the other. */
void
expectSameHull (const VisibleHull& hull, const VisibleHull& expected)
{
  ASSERT_EQ (hull.dimension, expected.dimension);
  if (hull.dimension < 3)
    return;
  EXPECT_NEAR (area (hull.faces), area (expected.faces), 1e-4 * area (expected.faces));
  EXPECT_NEAR (area (hull.hidden_faces), area (expected.hidden_faces), 1e-4 * area (expected.hidden_faces) + 1e-6);
  EXPECT_NEAR (volume (hull), volume (expected), 1e-4 * volume (expected));
  for (const Vector3f& vertex : expected.vertices)
    EXPECT_TRUE (std::any_of (hull.vertices.begin (), hull.vertices.end (),
                              [&] (const Vector3f& other) { return (other.isApprox (vertex, 1e-6f)); }));
}

} // namespace

class GrowingHullOfRandomPoints : public testing::TestWithParam<unsigned>
{};

TEST_P (GrowingHullOfRandomPoints, IsQhulls)
{
  // A small reach makes many points share planes, lines and places: what a hull with a tolerance fails on.
  for (const int reach : {2, 5, 60, 2000})
    for (const int count : {8, 40, 300})
    {
      SCOPED_TRACE (testing::Message () << "reach " << reach << ", count " << count);
      const std::vector<Vector3f> points = randomPoints (count, GetParam (), reach);
      GrowingHull hull (exactGrid ());
      hull.add (points);
      expectSameHull (hull.visible (), computeVisibleHull (points));
    }
}

TEST_P (GrowingHullOfRandomPoints, IsTheSameWhateverTheOrder)
{
  std::vector<Vector3f> points = randomPoints (200, GetParam (), 6);
  const VisibleHull expected = computeVisibleHull (points);
  GrowingHull one_by_one (exactGrid ());
  std::mt19937 generator (GetParam ());
  std::shuffle (points.begin (), points.end (), generator);
  for (const Vector3f& point : points)
    one_by_one.add ({point});
  expectSameHull (one_by_one.visible (), expected);
}

TEST_P (GrowingHullOfRandomPoints, GrowsByAnother)
{
  const std::vector<Vector3f> first = randomPoints (100, GetParam (), 50), second = randomPoints (100, GetParam () + 1000, 80);
  GrowingHull united (exactGrid ()), other (exactGrid ());
  united.add (first);
  other.add (second);
  united.add (other);
  std::vector<Vector3f> all = first;
  all.insert (all.end (), second.begin (), second.end ());
  expectSameHull (united.visible (), computeVisibleHull (all));
}

INSTANTIATE_TEST_SUITE_P (Seeds, GrowingHullOfRandomPoints, testing::Range (1u, 21u));

TEST (GrowingHull, StaysFlatUntilAPointLeavesThePlane)
{
  std::vector<Vector3f> square;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      square.emplace_back (static_cast<float> (x) / 4.0f, static_cast<float> (y) / 4.0f, 2.0f);
  GrowingHull hull (exactGrid ());
  hull.add (square);
  EXPECT_EQ (hull.visible ().dimension, 2);
  EXPECT_TRUE (hull.visible ().faces.empty ());
  hull.add ({Vector3f (0.5f, 0.5f, 1.0f)});
  const VisibleHull pyramid = hull.visible ();
  EXPECT_EQ (pyramid.dimension, 3);
  EXPECT_EQ (pyramid.vertices.size (), 5u);
  EXPECT_NEAR (volume (pyramid), 1.0 / 3.0, 1e-6);
}

TEST (GrowingHull, LeavesOffWhatLiesOutsideByLessThanItsTolerance)
{
  // A cube of 1 m and points above the middle of its side at x = 1.
  const auto verticesWith = [] (float above, float tolerance) {
    GrowingHull hull (exactGrid (), tolerance);
    std::vector<Vector3f> cube;
    for (int corner = 0; corner < 8; ++corner)
      cube.emplace_back (static_cast<float> (corner / 4), static_cast<float> (corner / 2 % 2), 1.0f + static_cast<float> (corner % 2));
    hull.add (cube);
    hull.add ({Vector3f (1.0f + above, 0.5f, 1.5f)});
    return (hull.vertices ().size ());
  };
  EXPECT_EQ (verticesWith (0.0625f, 0.0f), 9u);
  EXPECT_EQ (verticesWith (0.0625f, 0.07f), 8u);
  EXPECT_EQ (verticesWith (0.0625f, 0.05f), 9u);
}

TEST (GrowingHull, OfNothingAPointOrALineHasNoFaces)
{
  GrowingHull hull (exactGrid ());
  hull.add (std::vector<Vector3f> ());
  EXPECT_TRUE (hull.vertices ().empty ());
  for (int i = 0; i < 4; ++i)
  {
    hull.add ({Vector3f (0.25f * static_cast<float> (i), 0.0f, 1.0f)});
    EXPECT_TRUE (hull.visible ().faces.empty ());
    EXPECT_LT (hull.visible ().dimension, 3);
  }
}

TEST (HullGrid, RoundsNoPointOfTheFrameByMoreThanHalfAStep)
{
  OrganizedCloud cloud;
  const std::vector<Vector3f> points = randomPoints (500, 7, 300);
  cloud.width = 500;
  cloud.height = 1;
  for (const Vector3f& point : points)
  {
    cloud.x.push_back (point.x ());
    cloud.y.push_back (point.y ());
    cloud.z.push_back (point.z ());
    cloud.valid.push_back (1);
  }
  const HullGrid grid (cloud);
  GrowingHull hull (grid);
  hull.add (points);
  for (const Vector3f& vertex : hull.vertices ())
    EXPECT_TRUE (std::any_of (points.begin (), points.end (), [&] (const Vector3f& point) {
      return ((point - vertex).cwiseAbs ().maxCoeff () <= 0.51f * grid.step + 2e-6f);
    }));
}

TEST (ObjectHull, IsTheSameByEitherMethod)
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    ObjectHull growing (HullMethod::growing, exactGrid ()), qhull (HullMethod::qhull, exactGrid ());
    for (unsigned part = 0; part < 4; ++part)
    {
      const std::vector<Vector3f> points = randomPoints (50, 10 * seed + part, 20 + 10 * static_cast<int> (part));
      growing.add (points);
      qhull.add (points);
    }
    expectSameHull (growing.visible (), qhull.visible ());
  }
}
