// SPDX-License-Identifier: BSD-3-Clause
// What lies within the outline of some pixels, against triangles told by the sides of their edges.
#include "../../src/core/image_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

using namespace pcl_attention;

namespace
{

constexpr int width = 40, height = 30;

using Place = std::array<int, 2>;

RowSpans
outlineOf (const std::vector<Place>& places)
{
  pcl::Indices pixels;
  for (const auto& [column, row] : places)
    pixels.push_back (row * width + column);
  std::sort (pixels.begin (), pixels.end ());
  const RowSpans rows = rowsOf (pixels, width);
  return (convexOutline ({&rows}));
}

/** \brief Twice the signed area of a triangle. */
int
area (const Place& a, const Place& b, const Place& c)
{
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

} // namespace

TEST (ImageOutline, OfATriangleHoldsWhatNoEdgeHasOnItsOtherSide)
{
  std::mt19937 generator (1);
  std::uniform_int_distribution<int> column_of (0, width - 1), row_of (0, height - 1);
  for (int round = 0; round < 300; ++round)
  {
    std::array<Place, 3> corners;
    for (Place& corner : corners)
      corner = {column_of (generator), row_of (generator)};
    const int all = area (corners[0], corners[1], corners[2]);
    if (all == 0)
      continue;
    const RowSpans outline = outlineOf ({corners.begin (), corners.end ()});
    for (int row = -1; row <= height; ++row)
      for (int column = -1; column <= width; ++column)
      {
        const Place place{column, row};
        bool inside = true;
        for (int k = 0; k < 3; ++k)
          inside = inside && (all > 0 ? 1 : -1) * area (corners[k], corners[(k + 1) % 3], place) >= 0;
        ASSERT_EQ (outline.contains (column, row), inside) << column << ", " << row << ", round " << round;
      }
  }
}

TEST (ImageOutline, SpansTheGapsBetweenAllThatItIsOf)
{
  // A square of 2 x 2 pixels at the left end of row 3 and one pixel at the right end of row 8.
  const RowSpans square = rowsOf ({3 * width, 3 * width + 1, 4 * width, 4 * width + 1}, width), pixel = rowsOf ({8 * width + 11}, width);
  const RowSpans outline = convexOutline ({&square, &pixel});
  EXPECT_EQ (outline.first_row, 3);
  // The edges go from (1, 3) to (11, 8), 2 columns a row, and from (0, 4) to (11, 8), 2.75 columns a row.
  const std::vector<std::pair<int, int>> expected{{0, 2}, {0, 4}, {3, 6}, {6, 8}, {9, 10}, {11, 12}};
  EXPECT_EQ (outline.columns, expected);
}

TEST (ImageOutline, OfNothingOrALineHoldsNothing)
{
  EXPECT_TRUE (convexOutline ({}).columns.empty ());
  EXPECT_TRUE (outlineOf ({}).columns.empty ());
  EXPECT_TRUE (outlineOf ({{5, 5}}).columns.empty ());
  EXPECT_TRUE (outlineOf ({{5, 5}, {6, 5}, {9, 5}}).columns.empty ());
  EXPECT_TRUE (outlineOf ({{5, 5}, {6, 7}, {7, 9}}).columns.empty ());
}

TEST (RowsOf, ReachFromTheFirstToTheLastPixelOfARow)
{
  const RowSpans rows = rowsOf ({2 * width + 4, 2 * width + 5, 2 * width + 9, 4 * width}, width);
  EXPECT_EQ (rows.first_row, 2);
  const std::vector<std::pair<int, int>> expected{{4, 10}, {0, 0}, {0, 1}};
  EXPECT_EQ (rows.columns, expected);
  EXPECT_FALSE (rows.contains (3, 2));
  EXPECT_TRUE (rows.contains (7, 2));
  EXPECT_FALSE (rows.contains (0, 3));
  EXPECT_FALSE (rows.contains (0, 5));
}
