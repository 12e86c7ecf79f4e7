// SPDX-License-Identifier: BSD-3-Clause
#include "drawings.h"
#include "systems/graph_cut.h"
#include "systems/polar_cut.h"

#include <gtest/gtest.h>

namespace pcl_attention
{
namespace
{

using drawings::drawDisc;
using drawings::Mask;
using drawings::overlap;

constexpr int width = 160, height = 120;

/** \brief Circles around one middle, a pixel wide. */
void
drawCircle (EdgeMap& edges, double column, double row, double radius, float strength)
{
  for (int y = 0; y < edges.strength.height; ++y)
    for (int x = 0; x < edges.strength.width; ++x)
      if (std::abs (std::hypot (x - column, y - row) - radius) <= 0.71)
      {
        edges.strength (x, y) = strength;
        edges.direction (x, y) = static_cast<float> (std::atan2 (y - row, x - column) + M_PI_2);
      }
}

EdgeMap
noEdges ()
{
  return {Image<float> (width, height, 0.0f), Image<float> (width, height, 0.0f)};
}

/** \brief The same cut in the image itself: a pixel of the contour costs the same wherever it is. */
Mask
cutInTheImage (const EdgeMap& edges, int column, int row)
{
  const PolarCutParameters parameters;
  GraphCut cut (width * height);
  const auto connect = [&] (int first, int second) {
    const float mean = 0.5f * (edges.strength[first] + edges.strength[second]);
    const double cost =
        mean < parameters.empty_strength ? parameters.empty_cost : std::exp (-parameters.steepness * mean);
    cut.connect (first, second, cost, cost);
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
    {
      const int pixel = y * width + x;
      if (x + 1 < width)
        connect (pixel, pixel + 1);
      if (y + 1 < height)
        connect (pixel, pixel + width);
      if (x == 0 || y == 0 || x + 1 == width || y + 1 == height)
        cut.tieToOutside (pixel, parameters.tie_cost);
    }
  cut.tieToInside (row * width + column, parameters.tie_cost);
  Mask mask (width, height);
  mask.data = cut.solve ();
  return (mask);
}

TEST (SegmentAround, aDiscSeenFromInside)
{
  EdgeMap edges = noEdges ();
  drawCircle (edges, 80, 60, 40, 0.8f);
  const Mask disc = drawDisc (width, height, 80, 60, 40);
  for (const auto& fixation : {std::pair (80, 60), std::pair (60, 70), std::pair (105, 45), std::pair (80, 25)})
    EXPECT_GT (overlap (segmentAround (edges, fixation.first, fixation.second), disc), 0.96)
        << fixation.first << ", " << fixation.second;
}

TEST (SegmentAround, aLargeContourIsAsCheapAsASmallOne)
{
  EdgeMap edges = noEdges ();
  drawCircle (edges, 80, 60, 5, 0.5f);
  drawCircle (edges, 80, 60, 50, 0.53f);
  // In the image the small circle is cheaper for being short, although it is weaker.
  ASSERT_GT (overlap (cutInTheImage (edges, 80, 60), drawDisc (width, height, 80, 60, 5)), 0.8);
  EXPECT_GT (overlap (segmentAround (edges, 80, 60), drawDisc (width, height, 80, 60, 50)), 0.96);
}

TEST (SegmentAround, theStrongerOfTwoContoursWins)
{
  EdgeMap edges = noEdges ();
  drawCircle (edges, 80, 60, 20, 0.6f);
  drawCircle (edges, 80, 60, 50, 0.4f);
  EXPECT_GT (overlap (segmentAround (edges, 80, 60), drawDisc (width, height, 80, 60, 20)), 0.95);
}

TEST (SegmentAround, smallGapsAreClosed)
{
  EdgeMap edges = noEdges ();
  drawCircle (edges, 80, 60, 20, 0.6f);
  drawCircle (edges, 80, 60, 50, 0.6f);
  for (int row = 58; row <= 60; ++row) // of the inner circle three pixels on either side
    for (int column = 55; column < 105; ++column)
      edges.strength (column, row) = 0;
  // The outer circle has no gap, but a gap that is closed is no reason to prefer it: either is right.
  const Mask mask = segmentAround (edges, 80, 60);
  EXPECT_GT (std::max (overlap (mask, drawDisc (width, height, 80, 60, 20)),
                       overlap (mask, drawDisc (width, height, 80, 60, 50))),
             0.95);
  // Without another contour there is nothing but the one with gaps.
  EdgeMap alone = noEdges ();
  drawCircle (alone, 80, 60, 20, 0.6f);
  for (int row = 58; row <= 60; ++row)
    for (int column = 55; column < 105; ++column)
      alone.strength (column, row) = 0;
  EXPECT_GT (overlap (segmentAround (alone, 80, 60), drawDisc (width, height, 80, 60, 20)), 0.95);
}

TEST (SegmentAround, withoutContourTheImageIsTheRegion)
{
  const Mask all (width, height, 1);
  EXPECT_GT (overlap (segmentAround (noEdges (), 80, 60), all), 0.97);
  EXPECT_GT (overlap (segmentAround (noEdges (), 5, 5), all), 0.97);
  EXPECT_GT (overlap (segmentAround (noEdges (), width - 1, 30), all), 0.97);
}

TEST (SegmentAround, aPaintedDisc)
{
  const Mask disc = drawDisc (width, height, 70, 60, 35);
  const ColorImage colors = drawings::paint (disc, {0.7f, 0.3f, 0.2f}, {0.6f, 0.55f, 0.45f});
  EXPECT_GT (overlap (segmentAround (detectColorEdges (colors), 75, 55), disc), 0.95);
}

} // namespace
} // namespace pcl_attention
