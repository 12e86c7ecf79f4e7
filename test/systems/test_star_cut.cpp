// SPDX-License-Identifier: BSD-3-Clause
#include "drawings.h"
#include "systems/star_cut.h"

#include <gtest/gtest.h>

namespace pcl_attention
{
namespace
{

using drawings::draw;
using drawings::drawRectangle;
using drawings::Mask;
using drawings::overlap;
using drawings::paint;

constexpr int width = 160, height = 120;
const Eigen::Vector3f red (0.7f, 0.2f, 0.2f), grey (0.5f, 0.5f, 0.5f);

/** \brief A rectangle near the border. */
Mask
frame ()
{
  return (draw (width, height, [] (int x, int y) {
    return (((x == 10 || x == width - 11) && y >= 8 && y < height - 8) ||
            ((y == 8 || y == height - 9) && x >= 10 && x < width - 10));
  }));
}

TEST (SegmentFromStrokes, aTexturedSquare)
{
  const Mask square = drawRectangle (width, height, 50, 30, 110, 90);
  ColorImage colors = paint (square, red, grey);
  for (int row = 30; row < 90; ++row) // a checkerboard of red and white
    for (int column = 50; column < 110; ++column)
      if ((row / 6 + column / 6) % 2)
        colors (column, row) = Eigen::Vector3f (0.9f, 0.88f, 0.85f);
  const Mask stroke = drawRectangle (width, height, 60, 58, 100, 62);
  EXPECT_GT (overlap (segmentFromStrokes (colors, stroke, frame ()), square), 0.97);
}

TEST (SegmentFromStrokes, aStarWithAStroke)
{
  const Mask star = draw (width, height, [] (int x, int y) {
    const double angle = std::atan2 (y - 60, x - 80), radius = std::hypot (x - 80, y - 60);
    return (radius < 28 + 14 * std::cos (5 * angle));
  });
  const Mask stroke = drawRectangle (width, height, 76, 50, 84, 70);
  EXPECT_GT (overlap (segmentFromStrokes (paint (star, red, grey), stroke, frame ()), star), 0.97);
}

TEST (SegmentFromStrokes, whatNoStrokeReachesInsideTheObjectIsLeftOut)
{
  const Mask left = drawRectangle (width, height, 25, 40, 65, 80),
             right = drawRectangle (width, height, 104, 50, 124, 70);
  const Mask both = draw (width, height, [&] (int x, int y) { return (left (x, y) || right (x, y)); });
  const ColorImage colors = paint (both, red, grey);
  const Mask stroke = drawRectangle (width, height, 35, 58, 55, 62);
  EXPECT_GT (overlap (segmentFromStrokes (colors, stroke, frame ()), left), 0.97);
  // The colours alone cannot tell.
  StarCutParameters parameters;
  parameters.star_constraint = false;
  EXPECT_GT (overlap (segmentFromStrokes (colors, stroke, frame (), parameters), both), 0.97);
}

TEST (SegmentFromStrokes, theResultHasTheImagesSize)
{
  const Mask square = drawRectangle (width, height, 51, 31, 110, 90);
  const Mask stroke = drawRectangle (width, height, 60, 58, 100, 62);
  for (const int reduction : {1, 3, 4})
  {
    StarCutParameters parameters;
    parameters.reduction = reduction;
    const Mask mask = segmentFromStrokes (paint (square, red, grey), stroke, frame (), parameters);
    ASSERT_EQ (mask.width, width);
    ASSERT_EQ (mask.height, height);
    EXPECT_GT (overlap (mask, square), 0.94) << reduction;
  }
}

TEST (SegmentFromStrokes, oneColorEverywhere)
{
  const ColorImage colors (width, height, red);
  const Mask stroke = drawRectangle (width, height, 60, 58, 100, 62);
  const Mask mask = segmentFromStrokes (colors, stroke, frame ());
  EXPECT_EQ (mask (80, 60), 1);
  EXPECT_EQ (mask (10, 60), 0);
}

} // namespace
} // namespace pcl_attention
