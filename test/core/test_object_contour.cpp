// SPDX-License-Identifier: BSD-3-Clause
// Contours that follow colours, on squares whose pixels are known.
#include "shapes.h"
#include <pcl_attention/core/object_contour.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

using namespace pcl_attention;
using shapes::Frame;

namespace
{

constexpr int columns = 100, rows = 80;
constexpr std::array<int, 3> red{180, 40, 30}, blue{40, 60, 170};

/** \brief The pixels of a square in the middle of the image. \param[in] less how far it is smaller on every side */
pcl::Indices
square (int less)
{
  pcl::Indices indices;
  for (int row = 20 + less; row < 60 - less; ++row)
    for (int column = 30 + less; column < 70 - less; ++column)
      indices.push_back (row * columns + column);
  return (indices);
}

/** \brief A plane a metre away, blue around a square. */
Frame
scene (const std::array<int, 3>& of_square)
{
  Frame frame = shapes::emptyFrame (columns, rows);
  for (auto* channel : {&frame.cloud.red, &frame.cloud.green, &frame.cloud.blue})
    channel->assign (frame.cloud.size (), 0);
  const auto paint = [&frame] (std::size_t i, const std::array<int, 3>& color, int noise) {
    frame.cloud.red[i] = static_cast<std::uint8_t> (color[0] + noise);
    frame.cloud.green[i] = static_cast<std::uint8_t> (color[1] + noise);
    frame.cloud.blue[i] = static_cast<std::uint8_t> (color[2] + noise);
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
    {
      const std::size_t i = frame.index (column, row);
      frame.set (i, {0.002 * (column - 50), 0.002 * (row - 40), 1.0}, {0, 0, -1});
      paint (i, blue, (column * 7 + row * 3) % 9);
    }
  for (const pcl::index_t i : square (0))
    paint (i, of_square, (i * 5) % 9);
  return (frame);
}

using MoveContour = void (const pcl_attention::OrganizedCloud&, int, int, pcl::Indices&);

/** \brief Of one thread, which two agree with. */
pcl::Indices
moved (MoveContour& move, const Frame& frame, const pcl::Indices& indices, int width)
{
  pcl::Indices result = indices, of_two_threads = indices;
  move (frame.cloud, width, 1, result);
  move (frame.cloud, width, 2, of_two_threads);
  EXPECT_EQ (of_two_threads, result);
  return (result);
}

pcl::Indices
extended (const Frame& frame, const pcl::Indices& indices, int width = 3)
{
  return (moved (extendToColors, frame, indices, width));
}

pcl::Indices
fitted (const Frame& frame, const pcl::Indices& indices, int width = 6)
{
  return (moved (fitToColors, frame, indices, width));
}

} // namespace

TEST (ObjectContour, followsTheColours)
{
  const Frame frame = scene (red);
  for (const int less : {0, 1, 3})
    EXPECT_EQ (extended (frame, square (less)), square (0)) << less;
}

TEST (ObjectContour, movesNoFartherThanItsWidth)
{
  const Frame frame = scene (red);
  EXPECT_EQ (extended (frame, square (4), 3), square (1));
  EXPECT_EQ (extended (frame, square (4), 4), square (0));
}

TEST (ObjectContour, staysWhereColoursTellNothing)
{
  EXPECT_EQ (extended (scene (blue), square (2)), square (2));
  EXPECT_EQ (extended (scene (red), square (2), 0), square (2)) << "of no width";
  Frame frame = scene (red);
  for (auto* channel : {&frame.cloud.red, &frame.cloud.green, &frame.cloud.blue})
    channel->clear ();
  EXPECT_EQ (extended (frame, square (2)), square (2)) << "of no colours";
  EXPECT_EQ (extended (scene (red), {}), pcl::Indices ());
}

TEST (ObjectContour, takesNothingOfADifferentColour)
{
  // The object is smaller than the red square by two pixels, whose rim is green.
  Frame frame = scene (red);
  for (const pcl::index_t i : square (0))
    if (const pcl::Indices inner = square (2); !std::binary_search (inner.begin (), inner.end (), i))
      frame.cloud.red[i] = 20, frame.cloud.green[i] = 200, frame.cloud.blue[i] = 20;
  EXPECT_EQ (extended (frame, square (2)), square (2));
}

TEST (ObjectContour, neverCrossesAJumpOrAHole)
{
  Frame frame = scene (red);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < 32; ++column)
      frame.cloud.z[frame.index (column, row)] += 0.03f;
  for (const int column : {66, 67})
    for (int row = 0; row < rows; ++row)
      frame.cloud.valid[frame.index (column, row)] = 0;
  pcl::Indices expected;
  for (const pcl::index_t i : square (0))
    if (i % columns >= 32 && i % columns < 66)
      expected.push_back (i);
  pcl::Indices known;
  for (const pcl::index_t i : square (2))
    if (i % columns < 66)
      known.push_back (i);
  EXPECT_EQ (extended (frame, known), expected);
}

TEST (ObjectContour, endsAtTheImage)
{
  Frame frame = scene (red);
  pcl::Indices corner, expected;
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 50; ++column)
    {
      const auto i = static_cast<pcl::index_t> (frame.index (column, row));
      frame.cloud.red[i] = 200, frame.cloud.green[i] = 190, frame.cloud.blue[i] = 20;
      expected.push_back (i);
      if (row < 38 && column < 48)
        corner.push_back (i);
    }
  EXPECT_EQ (extended (frame, corner), expected);
}

TEST (ObjectContour, isFittedToColoursFromBothSidesAndAcrossJumps)
{
  Frame frame = scene (red);
  // The depth of the object goes on for five pixels around it on one side, and ends five too early on the other.
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      if (column < 25 || column >= 65)
        frame.cloud.z[frame.index (column, row)] += 0.2f;
  pcl::Indices displaced;
  for (const pcl::index_t i : square (0))
    displaced.push_back (i - 5);
  EXPECT_EQ (fitted (frame, displaced), square (0));
  for (const int less : {-5, -2, 0, 3, 5})
    EXPECT_EQ (fitted (frame, square (less)), square (0)) << less;
}

TEST (ObjectContour, isFittedNoFartherThanItsWidth)
{
  const Frame frame = scene (red);
  EXPECT_EQ (fitted (frame, square (8), 6), square (2));
  EXPECT_EQ (fitted (frame, square (-6), 5), square (-1));
}

TEST (ObjectContour, isFittedNowhereWhereColoursTellNothing)
{
  EXPECT_EQ (fitted (scene (blue), square (2)), square (2));
  EXPECT_EQ (fitted (scene (red), square (2), 0), square (2)) << "of no width";
  EXPECT_EQ (fitted (scene (red), {}), pcl::Indices ());
  Frame frame = scene (red);
  for (auto* channel : {&frame.cloud.red, &frame.cloud.green, &frame.cloud.blue})
    channel->clear ();
  EXPECT_EQ (fitted (frame, square (-2)), square (-2)) << "of no colours";
}

TEST (ObjectContour, hasNoPointWithoutDepth)
{
  Frame frame = scene (red);
  pcl::Indices expected;
  for (const pcl::index_t i : square (0))
    if (i % columns == 31)
      frame.cloud.valid[i] = 0;
    else if (i % columns > 31)
      expected.push_back (i);
  EXPECT_EQ (fitted (frame, square (3)), expected);
}
