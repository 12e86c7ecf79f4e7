// SPDX-License-Identifier: BSD-3-Clause
// Paper eq. 1 to 8 against a double-precision transcription.
#include "shapes.h"
#include "symmetry_oracle.h"

#include <gtest/gtest.h>

using namespace pcl_attention;
using shapes::Frame;

namespace
{

struct Comparison
{
  int valid{0};    /**< pixels with a point and a normal */
  int compared{0}; /**< of them those where the symmetry is well defined */
  int positive{0}; /**< of the compared ones those with a symmetry */
  double largest_difference{0.0};
  double largest_value{0.0};
};

Comparison
compare (const Frame& frame, const SaliencyParameters& parameters)
{
  SymmetryMap map;
  computeSymmetry (frame.cloud, frame.normals, parameters, 1, map);
  const Image<oracle::Symmetry> expected = oracle::symmetryMap (frame.cloud, frame.normals, parameters);
  Comparison comparison;
  for (std::size_t index = 0; index < expected.size (); ++index)
  {
    EXPECT_TRUE (std::isfinite (map.symmetry[index]));
    EXPECT_GE (map.symmetry[index], 0.0f);
    EXPECT_LE (map.symmetry[index], 4.0f);
    EXPECT_EQ (map.winning_axis[index] != 0, map.symmetry[index] > 0.0f);
    if (!frame.cloud.valid[index] || !frame.normals.valid[index])
    {
      EXPECT_EQ (map.symmetry[index], 0.0f);
      continue;
    }
    ++comparison.valid;
    if (!expected[index].isWellDefined ())
      continue;
    ++comparison.compared;
    comparison.positive += expected[index].value > 1e-3;
    comparison.largest_value = std::max (comparison.largest_value, expected[index].value);
    comparison.largest_difference =
        std::max (comparison.largest_difference, std::abs (expected[index].value - map.symmetry[index]));
  }
  ::testing::Test::RecordProperty ("largest_difference", std::to_string (comparison.largest_difference));
  std::printf ("             valid %d, compared %d, positive %d, largest value %.3f, largest difference %.2e\n",
               comparison.valid, comparison.compared, comparison.positive, comparison.largest_value,
               comparison.largest_difference);
  return (comparison);
}

void
expectSame (const Frame& frame, const SaliencyParameters& parameters, double share_compared)
{
  const Comparison comparison = compare (frame, parameters);
  EXPECT_LE (comparison.largest_difference, 1e-4);
  // The comparison would be empty if hardly any pixel were well defined, or all were 0.
  EXPECT_GE (comparison.compared, share_compared * comparison.valid);
  EXPECT_GT (comparison.positive, 100);
  EXPECT_GT (comparison.largest_value, 0.1);
}

SaliencyParameters
settings (int window_radius, bool gate, float distance_scale = 1000.0f)
{
  SaliencyParameters parameters;
  parameters.window_radius = window_radius;
  parameters.convexity_gate = gate;
  parameters.distance_scale = distance_scale;
  return (parameters);
}

} // namespace

TEST (Symmetry, EqualsTheEquationsOnRandomHills)
{
  for (unsigned seed = 1; seed <= 6; ++seed)
  {
    const Frame frame = shapes::hills (seed);
    for (const int radius : {2, 3, 5, 8})
      for (const bool gate : {true, false})
      {
        SCOPED_TRACE (::testing::Message () << "seed " << seed << " radius " << radius << " gate " << gate);
        expectSame (frame, settings (radius, gate), 0.85);
      }
  }
}

TEST (Symmetry, EqualsTheEquationsInOtherUnits)
{
  const Frame frame = shapes::hills (7);
  for (const float scale : {0.0f, 1.0f, 100.0f, 10000.0f})
  {
    SCOPED_TRACE (scale);
    expectSame (frame, settings (3, true, scale), 0.9);
    expectSame (frame, settings (5, false, scale), 0.9);
  }
}

TEST (Symmetry, EqualsTheEquationsBetweenHolesAndAtOddSizes)
{
  for (const int width : {61, 62, 63, 64, 65})
  {
    SCOPED_TRACE (width);
    Frame frame = shapes::hills (static_cast<unsigned> (width), {width, 37});
    shapes::punchHoles (frame, 1, 0.2);
    for (const int radius : {3, 5})
      expectSame (frame, settings (radius, true), 0.9);
  }
}

TEST (Symmetry, EqualsTheEquationsOnScenesWithNoise)
{
  for (const SceneKind kind : {SceneKind::clutter, SceneKind::cylinders})
  {
    const Frame frame = shapes::rendered (kind, 3, 240, 180, 1.0);
    expectSame (frame, settings (3, true), 0.9);
    expectSame (frame, settings (5, false), 0.9);
  }
}

TEST (Symmetry, EqualsTheEquationsOnScenesWithoutNoise)
{
  // On exact planes all normals are alike and the axes are not defined.
  const Frame frame = shapes::rendered (SceneKind::clutter, 5, 240, 180, 0.0);
  expectSame (frame, settings (3, true), 0.25);
  expectSame (frame, settings (5, true), 0.25);
  expectSame (frame, settings (3, false), 0.25);
}

TEST (Symmetry, EqualsTheEquationsAtTheImageBorder)
{
  // Whole windows do not fit into an image this small: every pixel has a cut one.
  const Frame frame = shapes::hills (11, {7, 6});
  SymmetryMap map;
  computeSymmetry (frame.cloud, frame.normals, settings (8, false), 1, map);
  int compared = 0;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 7; ++column)
    {
      const oracle::Symmetry expected =
          oracle::symmetryAt (frame.cloud, frame.normals, settings (8, false), column, row);
      if (!expected.isWellDefined ())
        continue;
      ++compared;
      EXPECT_NEAR (map.symmetry (column, row), expected.value, 1e-4) << column << " " << row;
    }
  EXPECT_GT (compared, 30);
}

TEST (Symmetry, OfAnEmptyCloudOrWithoutNormalsIsZero)
{
  for (const bool has_points : {false, true})
  {
    Frame frame = has_points ? shapes::hills (1) : shapes::emptyFrame (20, 10);
    frame.normals.reset (frame.cloud.size ());
    SymmetryMap map;
    computeSymmetry (frame.cloud, frame.normals, SaliencyParameters (), 1, map);
    EXPECT_EQ (map.symmetry.size (), frame.cloud.size ());
    for (const float value : map.symmetry.data)
      EXPECT_EQ (value, 0.0f);
  }
}

TEST (Symmetry, DoesNotDependOnTheNumberOfThreads)
{
  const Frame frame = shapes::rendered (SceneKind::clutter, 4, 160, 121, 1.0);
  SymmetryMap one;
  computeSymmetry (frame.cloud, frame.normals, SaliencyParameters (), 1, one);
  for (const int threads : {2, 3})
  {
    SymmetryMap more;
    computeSymmetry (frame.cloud, frame.normals, SaliencyParameters (), threads, more);
    EXPECT_EQ (one.symmetry.data, more.symmetry.data);
    EXPECT_EQ (one.winning_axis.data, more.winning_axis.data);
  }
}

TEST (SymmetryOracle, HasTheValuesOfTheEquationsByHand)
{
  // Two halves of a right-angled roof 2 cm wide: normals at 45 degrees to the line between the means, both means alike.
  const double s = std::sqrt (0.5);
  oracle::Half left, right;
  left.add ({-0.01, 0, 1.005}, {-s, 0, -s});
  right.add ({0.01, 0, 1.005}, {s, 0, -s});
  const oracle::ReflectivePlane plane{{0, 0, 1}, {1, 0, 0}};
  EXPECT_DOUBLE_EQ (oracle::distanceDifference (right, left, plane), 0.0);
  EXPECT_DOUBLE_EQ (oracle::depthDifference (right, left), 0.0);
  EXPECT_NEAR (oracle::coplanarity (right, left), 1.0, 1e-12);
  // alpha = 45 and 135 degrees: (1 - cos 180) (1 - cos 90) = 2.
  EXPECT_NEAR (oracle::normalOpposition (right, left), 2.0, 1e-12);
  EXPECT_NEAR (oracle::reflectiveSymmetry (right, left, plane, 1000.0), 2.0, 1e-12);
  // One mean 2 mm farther away and 3 mm farther out: exp (-2 - 3) in millimetres; the line tilts.
  oracle::Half out;
  out.add ({0.013, 0, 1.007}, {s, 0, -s});
  EXPECT_NEAR (oracle::distanceDifference (out, left, plane), 0.003, 1e-12);
  EXPECT_NEAR (oracle::depthDifference (out, left), 0.002, 1e-12);
  const double tilt = std::atan2 (0.002, 0.023), quarter = std::acos (-1.0) / 4.0;
  const double difference = std::cos (quarter + tilt) - std::cos (3 * quarter + tilt);
  EXPECT_NEAR (oracle::reflectiveSymmetry (out, left, plane, 1000.0), std::exp (-5.0) * difference * difference, 1e-12);
  // A line along the edge is perpendicular to the plane of the normals: omega_1 is |+-y x x| = 1 still, and 0 for a
  // line along their cross product.
  oracle::Half above, below;
  above.add ({0, 0.01, 1}, {s, 0, -s});
  below.add ({0, -0.01, 1}, {-s, 0, -s});
  EXPECT_NEAR (oracle::coplanarity (above, below), 0.0, 1e-12);
  // Opposite normals along the line have the maximum of 4, equal ones 0.
  oracle::Half outward1, outward2;
  outward1.add ({0.01, 0, 1}, {1, 0, 0});
  outward2.add ({-0.01, 0, 1}, {-1, 0, 0});
  EXPECT_NEAR (oracle::normalOpposition (outward1, outward2), 4.0, 1e-12);
  outward2.normal = {1, 0, 0};
  EXPECT_NEAR (oracle::normalOpposition (outward1, outward2), 0.0, 1e-12);
}
