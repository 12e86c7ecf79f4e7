// SPDX-License-Identifier: BSD-3-Clause
#include "drawings.h"
#include "systems/simple_objects.h"

#include <gtest/gtest.h>

namespace pcl_attention
{
namespace
{

using drawings::draw;
using drawings::drawDisc;
using drawings::drawRectangle;
using drawings::Mask;
using drawings::overlap;

constexpr int width = 160, height = 120;
constexpr float focal_length = 525.0f;

/** \brief A surface by the depth of every pixel. */
template <typename DepthAt>
OrganizedCloud
surface (const DepthAt& depth_at)
{
  OrganizedCloud cloud;
  cloud.reset (width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      const std::size_t i = static_cast<std::size_t> (row) * width + column;
      const float z = depth_at (column, row);
      if (z <= 0)
        continue;
      cloud.valid[i] = 1;
      cloud.x[i] = (column - width / 2) * z / focal_length;
      cloud.y[i] = (row - height / 2) * z / focal_length;
      cloud.z[i] = z;
    }
  return (cloud);
}

/** \brief What a mask shows is at 0.9 m, the wall behind it at 1.1 m. */
OrganizedCloud
beforeAWall (const Mask& mask)
{
  return (surface ([&] (int column, int row) { return (mask (column, row) ? 0.9f : 1.1f); }));
}

EdgeMap
noEdges ()
{
  return {Image<float> (width, height, 0.0f), Image<float> (width, height, 0.0f)};
}

std::vector<SimpleObject>
find (const OrganizedCloud& cloud, const std::vector<SupportingPlane>& planes = {})
{
  return (findSimpleObjects (findOwnedBoundaries (cloud, planes, {}), noEdges ()));
}

TEST (OwnedBoundaries, theNearerSideOwnsAStep)
{
  const Mask square = drawRectangle (width, height, 50, 30, 110, 90);
  const OwnedBoundaries boundaries = findOwnedBoundaries (beforeAWall (square), {}, {});
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      const bool is_edge = square (column, row) && (column == 50 || column == 109 || row == 30 || row == 89);
      EXPECT_EQ (boundaries.boundary (column, row) != 0, is_edge) << column << ", " << row;
      if (is_edge)
      {
        EXPECT_GT (boundaries.inward (column, row).dot (Eigen::Vector2f (79.5f - column, 59.5f - row)), 0.0f);
      }
    }
}

TEST (OwnedBoundaries, aShadowBesideAnObjectBelongsToWhatIsBehind)
{
  const Mask square = drawRectangle (width, height, 50, 30, 110, 90);
  const OwnedBoundaries boundaries =
      findOwnedBoundaries (surface ([&] (int column, int row) {
                             return (square (column, row) ? 0.9f : column >= 40 && column < 50 ? 0.0f : 1.1f);
                           }),
                           {}, {});
  EXPECT_EQ (boundaries.depth (45, 60), 1.1f);
  EXPECT_EQ (boundaries.boundary (50, 60), 1);
  EXPECT_EQ (boundaries.boundary (39, 60), 0);
}

TEST (SimpleObjects, anObjectInFrontOfATable)
{
  const Mask disc = drawDisc (width, height, 90, 55, 30);
  const std::vector<SimpleObject> objects = find (beforeAWall (disc));
  ASSERT_EQ (objects.size (), 1u);
  EXPECT_GT (overlap (objects[0].mask, disc), 0.95);
  EXPECT_GT (objects[0].owned_share, 0.9f);
  EXPECT_NEAR (objects[0].fixation.column, 90, 5);
  EXPECT_NEAR (objects[0].fixation.row, 55, 5);
}

TEST (SimpleObjects, whatTouchesTheTableEndsAtTheContact)
{
  // Seen from 45 degrees above, the table's depth decreases downwards; the object's front is upright and meets it at
  // row 90.
  const float camera_height = 0.8f, slope = std::sqrt (0.5f);
  const auto table = [&] (int row) { return (camera_height / (slope * (1 + (row - height / 2) / focal_length))); };
  const Mask object = drawRectangle (width, height, 60, 50, 100, 90);
  const float foot = table (90);
  const auto front = [&] (int row) { // of the vertical plane through the foot
    const float foot_ray = (90 - height / 2) / focal_length, ray = (row - height / 2) / focal_length;
    return (foot * (1 - foot_ray) / (1 - ray));
  };
  const OrganizedCloud cloud =
      surface ([&] (int column, int row) { return (object (column, row) ? front (row) : table (row)); });
  SupportingPlane plane;
  plane.coefficients = Eigen::Vector4f (0, -slope, -slope, camera_height);
  const std::vector<SimpleObject> objects = find (cloud, {plane});
  ASSERT_EQ (objects.size (), 1u);
  EXPECT_GT (overlap (objects[0].mask, object), 0.9);
  // Depth alone sees no end at the foot.
  const OwnedBoundaries without_table = findOwnedBoundaries (cloud, {}, {}),
                        with_table = findOwnedBoundaries (cloud, {plane}, {});
  int without = 0, with = 0;
  for (int column = 65; column < 95; ++column)
    for (int row = 82; row < 92; ++row)
    {
      without += without_table.boundary (column, row);
      with += with_table.boundary (column, row);
      if (with_table.boundary (column, row))
      {
        EXPECT_LT (with_table.inward (column, row).y (), 0.0f);
      }
    }
  EXPECT_EQ (without, 0);
  EXPECT_GE (with, 30);
}

TEST (SimpleObjects, aHoleIsNone)
{
  // Its boundary is closed all around, but it is the wall's.
  const Mask hole = drawDisc (width, height, 80, 60, 25);
  const std::vector<SimpleObject> objects =
      find (surface ([&] (int column, int row) { return (hole (column, row) ? 1.1f : 0.9f); }));
  for (const SimpleObject& object : objects)
    EXPECT_LT (overlap (object.mask, hole), 0.5);
}

TEST (SimpleObjects, twoObjectsAreTwo)
{
  const Mask first = drawDisc (width, height, 45, 60, 22), second = drawDisc (width, height, 115, 60, 28);
  const Mask both = draw (width, height, [&] (int x, int y) { return (first (x, y) || second (x, y)); });
  const std::vector<SimpleObject> objects = find (beforeAWall (both));
  ASSERT_EQ (objects.size (), 2u);
  for (const Mask& disc : {first, second})
    EXPECT_GT (std::max (overlap (objects[0].mask, disc), overlap (objects[1].mask, disc)), 0.95);
}

TEST (SimpleObjects, anOccluderIsFoundInFrontOfWhatItCovers)
{
  const Mask near = drawDisc (width, height, 80, 80, 20), far = drawRectangle (width, height, 40, 25, 120, 85);
  double best = 0;
  for (const SimpleObject& object : find (surface ([&] (int column, int row) {
         return (near (column, row) ? 0.8f : far (column, row) ? 0.95f : 1.1f);
       })))
    best = std::max (best, overlap (object.mask, near));
  EXPECT_GT (best, 0.95);
}

TEST (SimpleObjects, threadsChangeNothing)
{
  const OwnedBoundaries boundaries = findOwnedBoundaries (beforeAWall (drawDisc (width, height, 90, 55, 30)), {}, {});
  const auto one = findSimpleObjects (boundaries, noEdges (), {}, 1),
             three = findSimpleObjects (boundaries, noEdges (), {}, 3);
  ASSERT_EQ (one.size (), three.size ());
  for (std::size_t i = 0; i < one.size (); ++i)
    EXPECT_EQ (one[i].mask.data, three[i].mask.data);
}

} // namespace
} // namespace pcl_attention
