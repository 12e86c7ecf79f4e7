// SPDX-License-Identifier: BSD-3-Clause
// What the symmetry of known shapes must be, from geometry alone (paper III-A).
#include "shapes.h"
#include <pcl_attention/core/symmetry.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl_attention;
using Eigen::Vector3d;
using shapes::Camera;
using shapes::Frame;

namespace
{

Image<float>
symmetryOf (const Frame& frame, const SaliencyParameters& parameters = SaliencyParameters ())
{
  SymmetryMap map;
  computeSymmetry (frame.cloud, frame.normals, parameters, 1, map);
  return (map.symmetry);
}

/** \brief The same points with normals fitted to them. */
Frame
withFittedNormals (Frame frame)
{
  NormalImage fitted;
  estimateNormals (frame.cloud, NormalParameters (), 1, fitted);
  frame.normals = fitted;
  return (frame);
}

float
largest (const Image<float>& map)
{
  return (*std::max_element (map.data.begin (), map.data.end ()));
}

std::vector<Vector3d>
tilts ()
{
  std::vector<Vector3d> normals;
  for (const double angle : {0.0, 0.3, 0.8, 1.2})
    for (const double direction : {0.0, 0.7, 1.6, 3.0, 4.5})
      normals.emplace_back (std::sin (angle) * std::cos (direction), std::sin (angle) * std::sin (direction),
                            -std::cos (angle));
  return (normals);
}

} // namespace

TEST (SymmetryOfShapes, APlaneOfAnyTiltHasNone)
{
  for (const Vector3d& normal : tilts ())
  {
    SCOPED_TRACE (normal.transpose ());
    const Frame frame = shapes::look (shapes::plane ({0, 0, 0.9}, normal));
    for (const bool gate : {true, false})
    {
      SaliencyParameters parameters;
      parameters.convexity_gate = gate;
      EXPECT_EQ (largest (symmetryOf (frame, parameters)), 0.0f);
    }
    EXPECT_LT (largest (symmetryOf (withFittedNormals (frame))), 1e-6f);
  }
}

TEST (SymmetryOfShapes, AValleyHasNoneBehindTheGate)
{
  for (const double slope : {0.2, 0.5, 0.785, 1.0})
  {
    SCOPED_TRACE (slope);
    const Frame frame = shapes::look (shapes::valley (0.8, slope));
    EXPECT_EQ (largest (symmetryOf (frame)), 0.0f);
    SaliencyParameters open;
    open.convexity_gate = false;
    EXPECT_GT (largest (symmetryOf (frame, open)), 0.1f);
  }
}

TEST (SymmetryOfShapes, AValleyWithFittedNormalsHasNextToNoneBehindTheGate)
{
  // Steeper ones are cut by the depth gate of the normals, whose windows then end at the crease.
  for (const double slope : {0.2, 0.5, 0.785})
  {
    SCOPED_TRACE (slope);
    EXPECT_LT (largest (symmetryOf (withFittedNormals (shapes::look (shapes::valley (0.8, slope))))), 1e-5f);
  }
}

TEST (SymmetryOfShapes, ARoofHasItsMaximumOnItsEdge)
{
  for (const double slope : {0.3, 0.5, 0.785})
    for (const bool fitted : {false, true})
    {
      SCOPED_TRACE (::testing::Message () << slope << (fitted ? " fitted" : " exact"));
      // An odd width puts a column of pixels on the edge.
      Frame frame = shapes::look (shapes::roof (0.8, slope), {65, 48});
      if (fitted)
        frame = withFittedNormals (frame);
      const Image<float> map = symmetryOf (frame);
      for (int row = 8; row < 40; ++row)
      {
        int best = 0;
        for (int column = 0; column < 65; ++column)
          if (map (column, row) > map (best, row))
            best = column;
        EXPECT_NEAR (best, 32, 1) << "row " << row;
        EXPECT_GT (map (best, row), 0.0f);
        // Beyond the reach of window and normals there is plane on both sides.
        for (int column = 0; column < 65; ++column)
          if (std::abs (column - 32) > 8)
          {
            EXPECT_LT (map (column, row), 1e-6f) << column << " " << row;
          }
      }
    }
}

TEST (SymmetryOfShapes, ARoofHasTheValueOfItsAngle)
{
  // On the edge both means are mirror images: omega_1 = 1, no differences, omega_2 = (2 sin slope)^2 for l along x.
  // The centre column is no part of N (p), so the mean normals are those of the planes.
  for (const double slope : {0.2, 0.5, 0.785})
  {
    SCOPED_TRACE (slope);
    const Image<float> map = symmetryOf (shapes::look (shapes::roof (0.8, slope), {65, 47}));
    EXPECT_NEAR (map (32, 23), 4.0 * std::sin (slope) * std::sin (slope), 1e-3);
  }
}

TEST (SymmetryOfShapes, ACylinderHasItsMaximumOnItsAxis)
{
  const Camera camera{101, 60};
  for (const double offset : {0.0, 0.01})
  {
    SCOPED_TRACE (offset);
    const Frame frame = shapes::look (shapes::cylinder ({offset, 0, 0.85}, {0, 1, 0}, 0.05), camera);
    const Image<float> map = symmetryOf (frame);
    // The line of the surface nearest to the viewer: towards the eye from the axis.
    const double x = offset - 0.05 * offset / std::hypot (offset, 0.85),
                 z = 0.85 - 0.05 * 0.85 / std::hypot (offset, 0.85);
    const double expected = 50.0 + 525.0 * x / z;
    for (int row = 5; row < 55; ++row)
    {
      int best = 0;
      for (int column = 0; column < camera.width; ++column)
        if (map (column, row) > map (best, row))
          best = column;
      EXPECT_NEAR (best, expected, 1.0) << "row " << row;
      EXPECT_GT (map (best, row), 0.0f);
    }
  }
}

TEST (SymmetryOfShapes, ASphereHasTheSymmetryOfItsCurvatureAtItsNearestPoint)
{
  // There normals are offsets from the axis of view over the radius, and any axis across it may be the principal one:
  // with the mean offset m of either half along the axis, omega_2 = (2 m / radius)^2, and all other factors are 1.
  const double radius = 0.035, pixel = 0.765 / 525.0;
  double low = 4.0, high = 0.0;
  for (int degree = 0; degree < 180; ++degree)
  {
    const double angle = degree * std::acos (-1.0) / 180.0;
    double x = 0.0, y = 0.0;
    int count = 0;
    for (const int r : {-3, -2, -1, 1, 2, 3})
      for (const int c : {-3, -2, -1, 1, 2, 3})
        if (c * std::cos (angle) + r * std::sin (angle) > 1e-9)
        {
          x += c;
          y += r;
          ++count;
        }
    const double value = 4.0 * (x * x + y * y) * pixel * pixel / (count * count * radius * radius);
    low = std::min (low, value);
    high = std::max (high, value);
  }
  const Image<float> map = symmetryOf (shapes::look (shapes::sphere ({0, 0, 0.8}, radius), {81, 61}));
  EXPECT_GT (map (40, 30), 0.97 * low);
  EXPECT_LT (map (40, 30), 1.03 * high);
  // Off that point the depths of the halves differ: along the ray through the middle, no other point of the row or
  // column has more until the rim comes into the window.
  for (int step = 1; step < 12; ++step)
    for (const auto& [column, row] :
         std::vector<std::pair<int, int>>{{40 + step, 30}, {40 - step, 30}, {40, 30 + step}, {40, 30 - step}})
      EXPECT_LT (map (column, row), 1.05 * high);
}

TEST (SymmetryOfShapes, InsideOfASphereHasNoneBehindTheGate)
{
  // The far side of a hollow sphere: mirror the outside in depth.
  Frame frame = shapes::look (shapes::sphere ({0, 0, 0.8}, 0.2));
  for (std::size_t index = 0; index < frame.cloud.size (); ++index)
    if (frame.cloud.valid[index])
    {
      const Vector3d p = frame.point (index), n = frame.normal (index);
      frame.set (index, {p.x (), p.y (), 1.6 - p.z ()}, {-n.x (), -n.y (), n.z ()});
    }
  EXPECT_EQ (largest (symmetryOf (frame)), 0.0f);
}

TEST (SymmetryOfShapes, TheMirroredCloudHasTheMirroredSymmetry)
{
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const int width : {64, 63})
    {
      const Frame frame = shapes::hills (seed, {width, 48});
      const Image<float> map = symmetryOf (frame), mirror = symmetryOf (shapes::mirrored (frame));
      int different = 0;
      for (int row = 0; row < map.height; ++row)
        for (int column = 0; column < width; ++column)
          different += std::abs (map (column, row) - mirror (width - 1 - column, row)) > 1e-5f;
      EXPECT_EQ (different, 0) << "seed " << seed << " width " << width;
    }
}

TEST (SymmetryOfShapes, InvalidMarginsChangeNothing)
{
  Frame frame = shapes::hills (3);
  shapes::punchHoles (frame, 2, 0.1);
  const Image<float> map = symmetryOf (frame);
  for (const auto& [left, top] : std::vector<std::pair<int, int>>{{1, 2}, {3, 0}, {4, 5}})
  {
    const Image<float> larger = symmetryOf (shapes::withMargins (frame, left, top, 7, 3));
    for (int row = 0; row < map.height; ++row)
      for (int column = 0; column < map.width; ++column)
        ASSERT_EQ (larger (column + left, row + top), map (column, row)) << column << " " << row;
    EXPECT_EQ (larger (0, top + 1), 0.0f);
  }
}

TEST (SymmetryOfShapes, WhatIsWrittenInInvalidPointsDoesNotMatter)
{
  Frame frame = shapes::hills (5);
  shapes::punchHoles (frame, 4, 0.1);
  const Image<float> map = symmetryOf (frame);
  for (std::size_t index = 0; index < frame.cloud.size (); ++index)
    if (!frame.cloud.valid[index])
    {
      frame.cloud.x[index] = frame.cloud.z[index] = frame.normals.y[index] = std::numeric_limits<float>::quiet_NaN ();
      frame.normals.x[index] = std::numeric_limits<float>::infinity ();
    }
  EXPECT_EQ (symmetryOf (frame).data, map.data);
}

TEST (SymmetryOfShapes, ScalingTheUnitsAgainstTheSizeChangesNothing)
{
  // Twice the size in half the units: every term of eq. 3 is the same.
  Frame frame = shapes::hills (6);
  const Image<float> map = symmetryOf (frame);
  for (std::size_t index = 0; index < frame.cloud.size (); ++index)
    frame.set (index, 2.0 * frame.point (index), frame.normal (index));
  SaliencyParameters half;
  half.distance_scale = 500.0f;
  EXPECT_EQ (symmetryOf (frame, half).data, map.data);
}
