// SPDX-License-Identifier: BSD-3-Clause
// The plane that objects stand on, what stands over it, and the patches cut along it, on scenes of steps seen from above.
#include "shapes.h"
#include <pcl_attention/core/planar_patches.h>
#include <pcl_attention/core/supporting_plane.h>

#include <gtest/gtest.h>

#include <random>

using namespace pcl_attention;
using Eigen::Vector3d;

namespace
{

constexpr int width = 160, height = 120;

/** \brief A rectangle of pixels, the last column and row included. */
struct Rectangle
{
  int left, top, right, bottom;

  bool
  contains (int column, int row) const
  {
    return (column >= left && column <= right && row >= top && row <= bottom);
  }

  std::size_t
  pixels () const
  {
    return (static_cast<std::size_t> (right - left + 1) * (bottom - top + 1));
  }
};

constexpr Rectangle middle{60, 40, 99, 79};

/** \brief A level surface seen from above with a level rectangle of another height; patches 1 and 2. */
struct Step
{
  shapes::Frame frame = shapes::emptyFrame (width, height);
  PlanarPatches patches;

  Step (double depth, const Rectangle& rectangle, double depth_of_rectangle, double focal_length = 120.0)
  {
    const shapes::Camera camera{width, height, focal_length};
    patches.labels.assign (width, height, 1);
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
      {
        const bool inside = rectangle.contains (column, row);
        frame.set (frame.index (column, row), camera.ray (column, row) * (inside ? depth_of_rectangle : depth), {0, 0, -1});
        if (inside)
          patches.labels (column, row) = 2;
      }
    describePatches (frame.cloud, patches);
  }

  std::vector<SupportingPlane>
  planes () const
  {
    const std::vector<PyramidLevel> coarser = coarserLevels (frame.cloud, frame.normals, supportLevels (width), 1);
    return (findSupportingPlanes (frame.cloud, estimateSensor (frame.cloud), frame.normals, coarser, SupportParameters ()));
  }

  /** \brief The surface around the rectangle is measured, but no plane. */
  void
  roughenSurroundings ()
  {
    std::mt19937 random (1);
    std::uniform_real_distribution<double> factor (0.95, 1.05);
    for (std::size_t index = 0; index < frame.cloud.size (); ++index)
    {
      if (patches.labels[index] == 1)
        frame.set (index, frame.point (index) * factor (random), {0, 0, -1});
      patches.labels[index] -= 1;
    }
    describePatches (frame.cloud, patches);
  }
};

} // namespace

TEST (SupportingPlanes, ATableWithABoxIsTheTable)
{
  const Step scene (1.0, middle, 0.9);
  const std::vector<SupportingPlane> planes = scene.planes ();
  ASSERT_EQ (planes.size (), 1u) << "the box's top is surrounded by what is lower";
  const SupportingPlane& table = planes.front ();
  EXPECT_TRUE (table.supports_objects);
  EXPECT_LT ((table.coefficients - Eigen::Vector4f (0, 0, -1, 1)).norm (), 1e-4f);
  EXPECT_EQ (table.indices, scene.patches.patches[0].pixels);
  EXPECT_EQ (table.confidence, 1.0f) << "nothing is below";
}

TEST (SupportingPlanes, HaveTheAreaOfTheirPixels)
{
  // A pixel covers (1 / 120 m)^2 of a level surface at a metre, however slanted its ray: by 40 degrees in the corners.
  const std::vector<SupportingPlane> planes = Step (1.0, middle, 0.9, 120.0).planes ();
  ASSERT_EQ (planes.size (), 1u);
  const double area = static_cast<double> (width * height - middle.pixels ()) / (120.0 * 120.0);
  EXPECT_NEAR (planes.front ().area, area, 0.001 * area);
}

TEST (SupportingPlanes, WhatIsSurroundedByLowerThingsSupportsNothing)
{
  // 0.67 m^2, but inside the image: no wall and no floor.
  Step platform (1.0, {8, 8, 151, 111}, 0.8);
  platform.roughenSurroundings ();
  EXPECT_TRUE (platform.planes ().empty ());

  // As large and up to the border: background, but nothing to stand on.
  Step stage (1.0, {0, 20, 159, 99}, 0.8);
  stage.roughenSurroundings ();
  const std::vector<SupportingPlane> planes = stage.planes ();
  ASSERT_EQ (planes.size (), 1u);
  EXPECT_FALSE (planes.front ().supports_objects);
  EXPECT_LT (planes.front ().confidence, 0.1f);
  EXPECT_EQ (planes.front ().indices, stage.patches.patches[0].pixels);
}

TEST (SupportingPlanes, AShelfAtTheBorderIsTooSmallForAWall)
{
  // 0.14 m^2 and a sixth of the points.
  const std::vector<SupportingPlane> planes = Step (1.0, {0, 50, 159, 69}, 0.8).planes ();
  ASSERT_EQ (planes.size (), 1u);
  EXPECT_TRUE (planes.front ().supports_objects);
  EXPECT_NEAR (planes.front ().coefficients[3], 1.0f, 1e-4f) << "the table under it";
}

TEST (SupportingPlanes, AWallBehindATableIsNotWhatTheTableStandsOn)
{
  // A table through (0, 0.1, 1) that faces up and ends 1.2 m away, 5 cm over it the top of a box; under its far edge a wall goes on
  // down, 1.3 m away.
  const Vector3d up (0, -0.8, -0.6), towards_viewer (0, 0, -1);
  shapes::Frame scene = shapes::emptyFrame (width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      const Vector3d ray ((column - 79.5) / 120.0, (row - 59.5) / 120.0, 1.0);
      const double rise = middle.contains (column, row - 25) ? 0.05 : 0.0;
      const double depth = (up.dot (Vector3d (0, 0.1, 1)) + rise) / up.dot (ray);
      const bool is_table = depth > 0.0 && depth < 1.2;
      scene.set (scene.index (column, row), ray * (is_table ? depth : 1.3), is_table ? up : towards_viewer);
    }
  const std::vector<SupportingPlane> planes = findSupportingPlanes (scene.cloud, estimateSensor (scene.cloud), scene.normals, {}, SupportParameters ());
  ASSERT_FALSE (planes.empty ());
  EXPECT_TRUE (planes.front ().supports_objects);
  EXPECT_NEAR (planes.front ().coefficients[1], -0.8f, 0.02f);
  EXPECT_EQ (planes.front ().confidence, 1.0f);
}

TEST (SupportingPlanes, LeaveOutSpecksOfThemInAHole)
{
  // The box's depth is missing but for some pixels as far as the table: seven by seven, and nine by nine.
  Step scene (1.0, middle, 0.9);
  constexpr Rectangle speck{64, 44, 70, 50}, piece{80, 60, 88, 68};
  const shapes::Camera camera{width, height, 120.0};
  pcl::Indices expected;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      const std::size_t index = scene.frame.index (column, row);
      if (speck.contains (column, row) || piece.contains (column, row))
        scene.frame.set (index, camera.ray (column, row), {0, 0, -1});
      else if (middle.contains (column, row))
        scene.frame.cloud.valid[index] = scene.frame.normals.valid[index] = 0;
      if (piece.contains (column, row) || !middle.contains (column, row))
        expected.push_back (static_cast<pcl::index_t> (index));
    }
  const std::vector<SupportingPlane> planes = scene.planes ();
  ASSERT_EQ (planes.size (), 1u);
  EXPECT_EQ (planes.front ().indices, expected);
}

TEST (SupportingPlanes, AFloorIsSeenBetweenTheThingsOnIt)
{
  // Four boxes of different heights hide all of it but strips of .012 m^2 each, less than a plane has that is seen well.
  Step scene (0.6, middle, 0.6);
  const shapes::Camera camera{width, height, 120.0};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      const bool is_between = column % 40 >= 34 && row >= 20 && row < 100;
      const double depth = is_between ? 0.6 : 0.5 - 0.03 * (column / 40);
      scene.frame.set (scene.frame.index (column, row), camera.ray (column, row) * depth, {0, 0, -1});
    }
  const std::vector<SupportingPlane> planes = scene.planes ();
  ASSERT_FALSE (planes.empty ());
  EXPECT_TRUE (planes.front ().supports_objects);
  EXPECT_LT ((planes.front ().coefficients - Eigen::Vector4f (0, 0, -1, 0.6f)).norm (), 1e-3f);
  EXPECT_EQ (planes.front ().ends, std::vector<std::uint8_t> (planes.front ().outline.size (), 0)) << "boxes hide whether it goes on";
}

TEST (SupportingPlanes, HaveTheOutlineOfTheirLargePieces)
{
  // A table up to column 120, and beside it a seat as high, with the floor between but for a bridge two pixels wide.
  Step scene (1.0, middle, 0.9);
  const shapes::Camera camera{width, height, 120.0};
  for (int row = 0; row < height; ++row)
    for (int column = 121; column < width; ++column)
    {
      const bool is_seat = column > 130 && row < 30, is_bridge = row == 10 || row == 11;
      scene.frame.set (scene.frame.index (column, row), camera.ray (column, row) * (is_seat || is_bridge ? 1.0 : 1.6), {0, 0, -1});
    }
  const std::vector<SupportingPlane> planes = scene.planes ();
  ASSERT_FALSE (planes.empty ());
  const SupportingPlane& table = planes.front ();
  EXPECT_TRUE (std::binary_search (table.indices.begin (), table.indices.end (), 10 * width + 140)) << "the seat is of its plane";
  ASSERT_GE (table.outline.size (), 4u);
  ASSERT_EQ (table.ends.size (), table.outline.size ());
  // The middles of the image's outermost pixels, and to the right the edge but for what is nearer to it than the points looked at.
  constexpr double left = -79.5 / 120.0, right = (120.0 - 79.5) / 120.0, top = -59.5 / 120.0, bottom = 59.5 / 120.0;
  Eigen::Array3f lowest = table.outline.front (), highest = lowest;
  for (std::size_t i = 0; i < table.outline.size (); ++i)
  {
    const Eigen::Vector3f& corner = table.outline[i];
    lowest = lowest.min (corner.array ());
    highest = highest.max (corner.array ());
    const Eigen::Vector3f edge = table.outline[(i + 1) % table.outline.size ()] - corner;
    if (edge.norm () > 0.1f)
    {
      EXPECT_EQ (table.ends[i], corner.x () > 0.3f && (corner + edge).x () > 0.3f) << "from " << corner.transpose ();
    }
  }
  EXPECT_NEAR (lowest.x (), left, 1e-4);
  EXPECT_LE (highest.x (), right + 1e-4);
  EXPECT_GE (highest.x (), right - 2.0 / 120.0);
  EXPECT_NEAR (lowest.y (), top, 1e-4);
  EXPECT_NEAR (highest.y (), bottom, 1e-4);
  EXPECT_NEAR (lowest.z (), 1.0, 1e-4);
  EXPECT_NEAR (highest.z (), 1.0, 1e-4);
}

TEST (SupportingPlanes, HaveAnOutlineAlsoWhereTheyAreFullOfHoles)
{
  // Every pixel is a hole or next to one, those at the border are holes.
  Step scene (1.0, middle, 0.9);
  constexpr Rectangle within{1, 1, width - 2, height - 2};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      if ((column + 2 * row) % 5 == 0 || !within.contains (column, row))
      {
        const std::size_t index = scene.frame.index (column, row);
        scene.frame.cloud.valid[index] = scene.frame.normals.valid[index] = 0;
      }
  const std::vector<SupportingPlane> planes = scene.planes ();
  ASSERT_FALSE (planes.empty ());
  EXPECT_TRUE (planes.front ().supports_objects);
  EXPECT_TRUE (standsOn (planes.front (), {0.0f, 0.0f, 0.9f}));
}

TEST (LiesBeside, IsByItsFootOnThePlane)
{
  // A triangle, counter-clockwise as seen from above, on a plane that leans 3 up on 4 along.
  SupportingPlane plane;
  plane.coefficients << 0.0f, -0.8f, -0.6f, 1.0f;
  const Eigen::Vector3f normal = plane.coefficients.head<3> (), origin = -normal, along (0.0f, -0.6f, 0.8f), across (1.0f, 0.0f, 0.0f);
  ASSERT_GT (normal.dot (across.cross (along)), 0.0f);
  plane.outline = {origin, origin + across, origin + along};
  plane.ends = {1, 1, 0};
  const auto isBeside = [&] (float x, float y, float above, float margin) {
    return (liesBeside (plane, origin + x * across + y * along + above * normal, margin));
  };
  EXPECT_FALSE (isBeside (0.3f, 0.3f, 0.0f, 0.0f));
  EXPECT_FALSE (isBeside (0.3f, 0.3f, 2.0f, 0.0f)) << "however high";
  EXPECT_TRUE (isBeside (0.3f, -0.1f, 2.0f, 0.0f));
  EXPECT_TRUE (isBeside (0.3f, -0.11f, 0.1f, 0.1f));
  EXPECT_FALSE (isBeside (0.3f, -0.09f, 0.1f, 0.1f)) << "within the margin";
  EXPECT_TRUE (isBeside (0.55f, 0.55f, 0.0f, 0.0f)) << "beyond the slanted edge";
  EXPECT_FALSE (isBeside (-0.5f, 0.3f, 0.0f, 0.0f)) << "the plane may go on there";
  plane.outline.clear ();
  plane.ends.clear ();
  EXPECT_FALSE (isBeside (9.0f, 9.0f, 0.0f, 0.0f)) << "nothing is known of where it ends";
}

TEST (StandsOn, IsAboveThePlaneUpToHalfAMetreWithTheFootOnIt)
{
  SupportingPlane plane;
  plane.coefficients << 0, 0, -1, 1;
  EXPECT_FALSE (standsOn (plane, {0.0f, 0.0f, 0.9f})) << "nothing is known of where it is";
  constexpr float side = 0.1625f;
  plane.outline = {{-side, -side, 1.0f}, {-side, side, 1.0f}, {side, side, 1.0f}, {side, -side, 1.0f}};
  const auto isOver = [&] (float x, float y, float z) { return (standsOn (plane, {x, y, z})); };
  EXPECT_TRUE (isOver (0.0f, 0.0f, 0.9f));
  EXPECT_TRUE (isOver (0.0f, 0.0f, 0.51f));
  EXPECT_FALSE (isOver (0.0f, 0.0f, 0.49f)) << "higher than half a metre";
  EXPECT_FALSE (isOver (0.0f, 0.0f, 1.1f)) << "below";
  EXPECT_FALSE (isOver (0.0f, 0.0f, 1.001f)) << "just below";
  // The outline is 5 cm wider than the points.
  EXPECT_TRUE (isOver (0.21f, 0.0f, 0.9f));
  EXPECT_FALSE (isOver (0.22f, 0.0f, 0.9f));
  EXPECT_TRUE (isOver (0.0f, -0.21f, 0.9f));
  EXPECT_FALSE (isOver (0.0f, -0.22f, 0.9f));
}

TEST (CutAlongPlanes, LeavesThePiecesOfEachPatch)
{
  // Patches 1 and 2 lie side by side, a background plane crosses both, and patch 3 is but a corner of two pixels.
  Step scene (1.0, {80, 0, 159, 119}, 1.0);
  scene.patches.labels (0, 0) = scene.patches.labels (1, 0) = 3;
  describePatches (scene.frame.cloud, scene.patches);
  SupportingPlane plane;
  for (int row = 50; row < 60; ++row)
    for (int column = 0; column < width; ++column)
      plane.indices.push_back (row * width + column);
  PatchParameters parameters;
  parameters.minimum_size = 3;
  parameters.reassign_distance = 0.0f;
  const std::vector<std::uint8_t> is_background = cutAlongPlanes (scene.frame.cloud, {plane}, parameters, scene.patches);
  EXPECT_EQ (is_background, (std::vector<std::uint8_t>{0, 1, 0, 0, 0, 0}));
  ASSERT_EQ (scene.patches.patches.size (), 5u);
  const Image<int>& labels = scene.patches.labels;
  EXPECT_EQ (scene.patches.patches[0].pixels, plane.indices);
  // In the order of the old ones: above and below the plane of patch 1, then of patch 2.
  EXPECT_EQ (labels (79, 0), 2);
  EXPECT_EQ (labels (0, 119), 3);
  EXPECT_EQ (labels (80, 0), 4);
  EXPECT_EQ (labels (159, 119), 5);
  EXPECT_EQ (labels (0, 0), 0) << "too small to be a patch";
  EXPECT_EQ (scene.patches.patches[1].pixels.size (), 50u * 80u - 2u);
  EXPECT_EQ (scene.patches.patches[2].pixels.size (), 60u * 80u);
  EXPECT_EQ (scene.patches.patches[3].pixels.size (), 50u * 80u);
  EXPECT_EQ (scene.patches.patches[4].pixels.size (), 60u * 80u);
}
