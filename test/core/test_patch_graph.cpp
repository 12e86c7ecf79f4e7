// SPDX-License-Identifier: BSD-3-Clause
// Borders between patches, counted by hand on tiny images.
#include "shapes.h"
#include <pcl_attention/core/patch_graph.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace pcl_attention;
using Eigen::Vector3d;
using shapes::Frame;

namespace
{

/** \brief Labels drawn as digits, '.' is none. */
Image<int>
labels (const std::vector<std::string>& rows)
{
  Image<int> image (static_cast<int> (rows.front ().size ()), static_cast<int> (rows.size ()), 0);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      image (column, row) = rows[row][column] == '.' ? 0 : rows[row][column] - '0';
  return (image);
}

/** \brief Points 1 mm apart in x and y, at a depth of their column, normals from its slope towards the viewer. */
template <typename Depth>
Frame
relief (int width, int height, const Depth& depth)
{
  Frame frame = shapes::emptyFrame (width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      const double slope = (depth (column + 1e-3) - depth (column - 1e-3)) / 2e-6; // dz / dx, x in metres
      frame.set (frame.index (column, row), {0.001 * (column - width / 2), 0.001 * (row - height / 2), depth (column)},
                 Vector3d (slope, 0, -1).normalized ());
    }
  return (frame);
}

Frame
flat (int width, int height)
{
  return (relief (width, height, [] (double) { return (1.0); }));
}

PatchGraph
graphOf (const Frame& frame, const Image<int>& image, int count,
         const PatchGraphParameters& parameters = PatchGraphParameters ())
{
  return (buildPatchGraph (frame.cloud, estimateSensor (frame.cloud), frame.normals, image, count, parameters));
}

/** \brief Every pair of 8-neighbours of the two labels, counted once. */
int
neighboringPairs (const Image<int>& image, int first, int second)
{
  int pairs = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      for (int r = row - 1; r <= row + 1; ++r)
        for (int c = column - 1; c <= column + 1; ++c)
          pairs += image (column, row) == first && image.contains (c, r) && image (c, r) == second;
  return (pairs);
}

/** \brief For every pixel of a label, its 8 neighbours that are not of the label. */
int
contourPairs (const Image<int>& image, int label)
{
  int pairs = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      for (int r = row - 1; r <= row + 1; ++r)
        for (int c = column - 1; c <= column + 1; ++c)
          pairs += image (column, row) == label && !(image.contains (c, r) && image (c, r) == label);
  return (pairs);
}

} // namespace

TEST (PatchGraph, CountsTheBorderOfTwoPatchesByHand)
{
  // 3 pairs along the rows and 2 along either diagonal.
  const Image<int> image = labels ({"1122", "1122", "1122"});
  const PatchGraph graph = graphOf (flat (4, 3), image, 2);
  const PatchBorder border = graph.border (1, 2);
  EXPECT_EQ (border.pairs, 7);
  EXPECT_EQ (border.connected, 7);
  EXPECT_EQ (border.first_in_front + border.second_in_front, 0);
  EXPECT_EQ (border.connectedShare (), 1.0f);
  EXPECT_EQ (graph.neighbors, (std::vector<std::vector<int>>{{}, {2}, {1}}));
  // Per label: 3 rows, 2 columns and 4 + 4 diagonals, each entered and left once.
  EXPECT_EQ (graph.perimeter, (std::vector<int>{0, 26, 26}));
  // All but the two inner pixels of each, which are (1, 1) and (2, 1).
}

TEST (PatchGraph, CountsBordersAndPerimetersLikeANaiveScan)
{
  std::mt19937 random (1);
  std::uniform_int_distribution<int> label (0, 5);
  PatchGraphParameters parameters;
  parameters.maximum_gap = 0;
  for (int round = 0; round < 30; ++round)
  {
    const int width = 5 + round, height = 34 - round;
    Image<int> image (width, height, 0);
    // Blocks of 3 pixels, so that there are insides as well.
    for (int row = 0; row < height; row += 3)
      for (int column = 0; column < width; column += 3)
      {
        const int value = label (random);
        for (int r = row; r < std::min (height, row + 3); ++r)
          for (int c = column; c < std::min (width, column + 3); ++c)
            image (c, r) = value;
      }
    const PatchGraph graph = graphOf (flat (width, height), image, 5, parameters);
    for (int a = 1; a <= 5; ++a)
    {
      EXPECT_EQ (graph.perimeter[a], contourPairs (image, a));
      for (int b = 1; b <= 5; ++b)
        if (a != b)
        {
          EXPECT_EQ (graph.border (a, b).pairs, neighboringPairs (image, a, b));
          const bool listed = std::count (graph.neighbors[a].begin (), graph.neighbors[a].end (), b) == 1;
          EXPECT_EQ (listed, graph.border (a, b).pairs > 0);
        }
    }
  }
}

TEST (PatchGraph, AStepInDepthIsNotConnectedAndTheNearerPatchIsInFront)
{
  const Image<int> image = labels ({"1122", "1122", "1122"});
  const Frame left_near = relief (4, 3, [] (double column) { return (column < 1.5 ? 1.0 : 1.05); });
  const PatchBorder border = graphOf (left_near, image, 2).border (1, 2);
  EXPECT_EQ (border.pairs, 7);
  EXPECT_EQ (border.connected, 0);
  EXPECT_EQ (border.first_in_front, 7);
  EXPECT_EQ (border.second_in_front, 0);
  EXPECT_EQ (border.convexity_pairs, 0);
  const Frame right_near = relief (4, 3, [] (double column) { return (column < 1.5 ? 1.05 : 1.0); });
  EXPECT_EQ (graphOf (right_near, image, 2).border (1, 2).second_in_front, 7);
  // 5 cm are connected if one asks for it.
  PatchGraphParameters wide;
  wide.connection_distance = 0.06f;
  EXPECT_EQ (graphOf (left_near, image, 2, wide).border (1, 2).connected, 7);
}

TEST (PatchGraph, ABorderSeenFromTheOtherPatchIsReversed)
{
  const Image<int> image = labels ({"1122", "1122", "1122"});
  // The upper row is connected, the others are not.
  Frame frame = flat (4, 3);
  for (int row = 1; row < 3; ++row)
    for (int column = 2; column < 4; ++column)
      frame.cloud.z[frame.index (column, row)] = 1.2f;
  const PatchGraph graph = graphOf (frame, image, 2);
  const PatchBorder one = graph.border (1, 2), two = graph.border (2, 1);
  EXPECT_EQ (one.connected, 2); // (1,0)-(2,0) and (1,1)-(2,0)
  EXPECT_EQ (one.first_in_front, 5);
  EXPECT_EQ (two.second_in_front, 5);
  EXPECT_EQ (two.first_in_front, 0);
  EXPECT_EQ (two.pairs, one.pairs);
  EXPECT_EQ (two.connected, one.connected);
  EXPECT_EQ (two.convexity_sum, one.convexity_sum);
  EXPECT_EQ (graph.border (1, 1).pairs, 0);
  PatchBorder sum = one;
  sum += one.reversed ();
  EXPECT_EQ (sum.pairs, 14);
  EXPECT_EQ (sum.first_in_front, 5);
  EXPECT_EQ (sum.second_in_front, 5);
}

TEST (PatchGraph, ARoofIsConvexAValleyConcaveAPlaneNeither)
{
  Image<int> image (24, 1, 1);
  for (int column = 12; column < 24; ++column)
    image (column, 0) = 2;
  for (const double slope : {0.3, 1.0, 2.0})
  {
    // The edge lies between the columns 11 and 12. With slopes -s and s towards the viewer the normals differ by
    // 2 s / sqrt (1 + s^2) along x, which is the direction from one side to the other.
    const double expected = 2.0 * slope / std::sqrt (1.0 + slope * slope);
    const PatchBorder roof =
        graphOf (relief (24, 1, [=] (double c) { return (1.0 + 0.001 * slope * std::abs (c - 11.5)); }), image, 2)
            .border (1, 2);
    EXPECT_EQ (roof.convexity_pairs, 1);
    EXPECT_NEAR (roof.convexity (), expected, 1e-4);
    const PatchBorder valley =
        graphOf (relief (24, 1, [=] (double c) { return (1.0 - 0.001 * slope * std::abs (c - 11.5)); }), image, 2)
            .border (1, 2);
    EXPECT_NEAR (valley.convexity (), -expected, 1e-4);
    const PatchBorder plane =
        graphOf (relief (24, 1, [=] (double c) { return (1.0 + 0.001 * slope * c); }), image, 2).border (1, 2);
    EXPECT_EQ (plane.convexity_pairs, 1);
    EXPECT_NEAR (plane.convexity (), 0.0, 1e-5);
    EXPECT_EQ (plane.connected, 1);
  }
}

TEST (PatchGraph, ConvexityAlongTheDiagonalsIsByHand)
{
  Image<int> image (24, 20, 1);
  for (int row = 0; row < 20; ++row)
    for (int column = 12; column < 24; ++column)
      image (column, row) = 2;
  const Frame frame = relief (24, 20, [] (double c) { return (1.0 + 0.001 * std::abs (c - 11.5)); });
  const PatchBorder border = graphOf (frame, image, 2).border (1, 2);
  EXPECT_EQ (border.pairs, 20 + 19 + 19);
  EXPECT_EQ (border.convexity_pairs, border.pairs);
  // The normals differ by sqrt (2) along x. Along a row D is x; along a diagonal it goes n = i + j + 1 pixels across
  // and as many up or down, i and j being the steps inside either side, 6 or fewer at the image's border, and j - i
  // pixels in depth.
  double sum = 20 * std::sqrt (2.0);
  for (int row = 0; row < 19; ++row)
  {
    const int i = std::min (6, row), j = std::min (6, 18 - row), n = i + j + 1;
    sum += 2 * std::sqrt (2.0) * n / std::sqrt (2.0 * n * n + (j - i) * (j - i));
  }
  EXPECT_NEAR (border.convexity_sum, sum, 1e-3);
}

TEST (PatchGraph, NarrowImagesAreSteppedThroughLikeFlatOnes)
{
  for (const int width : {1, 2, 3})
  {
    // The same points as rows and as columns.
    const Frame lying = relief (24, width, [] (double c) { return (1.0 + 0.001 * std::abs (c - 11.5)); });
    Frame standing = shapes::emptyFrame (width, 24);
    Image<int> lying_labels (24, width, 1), standing_labels (width, 24, 1);
    for (int row = 0; row < 24; ++row)
      for (int column = 0; column < width; ++column)
      {
        const std::size_t source = lying.index (row, column);
        standing.set (standing.index (column, row), lying.point (source), lying.normal (source));
        lying_labels (row, column) = standing_labels (column, row) = row < 12 ? 1 : 2;
      }
    const PatchBorder expected = graphOf (lying, lying_labels, 2).border (1, 2);
    const PatchBorder border = graphOf (standing, standing_labels, 2).border (1, 2);
    EXPECT_GT (expected.convexity_pairs, 0);
    EXPECT_EQ (border.pairs, expected.pairs) << width;
    EXPECT_EQ (border.convexity_pairs, expected.convexity_pairs) << width;
    EXPECT_NEAR (border.convexity_sum, expected.convexity_sum, 1e-9) << width;
  }
}

TEST (PatchGraph, BordersReachOverGapsUpToTheirLimit)
{
  PatchGraphParameters parameters;
  parameters.maximum_gap = 2;
  const auto pairsOver = [&] (const std::string& row) {
    const Image<int> image = labels ({row});
    return (graphOf (flat (image.width, 1), image, 3, parameters).border (1, 2).pairs);
  };
  EXPECT_EQ (pairsOver ("11122"), 1);
  EXPECT_EQ (pairsOver ("11.22"), 1);
  EXPECT_EQ (pairsOver ("11..22"), 1);
  EXPECT_EQ (pairsOver ("11...22"), 0);
  // Not through another patch, and not around the end of a row.
  EXPECT_EQ (pairsOver ("11322"), 0);
  EXPECT_EQ (graphOf (flat (2, 2), labels ({".1", "2."}), 2, parameters).border (1, 2).pairs, 1);
  const Image<int> rows = labels ({"..1", "2..", "..."});
  parameters.maximum_gap = 0;
  EXPECT_EQ (graphOf (flat (3, 3), rows, 2, parameters).border (1, 2).pairs, 0);
}

TEST (PatchGraph, AGapCountsToThePerimeterOfBothSides)
{
  const Image<int> image = labels ({"1..2"});
  const PatchGraph graph = graphOf (flat (4, 1), image, 2);
  EXPECT_EQ (graph.border (1, 2).pairs, 1);
  // A single pixel has 8 neighbours.
  EXPECT_EQ (graph.perimeter, (std::vector<int>{0, 8, 8}));
}

TEST (PatchGraph, AGapLeavesRoomForThePixelsItHides)
{
  // 5 pixels of 1 mm in between: 6 mm apart, beyond the 1 mm of connection_distance, unless every pixel of the gap adds
  // its width.
  const Image<int> image = labels ({"111.....222", "111.....222"});
  PatchGraphParameters parameters;
  parameters.connection_distance = 0.002f;
  parameters.gap_slack = 0.0f;
  const Frame frame = flat (11, 2);
  EXPECT_EQ (graphOf (frame, image, 2, parameters).border (1, 2).connected, 0);
  parameters.gap_slack = 1.5f;
  // 2 mm + 1.5 * 5 * 1 mm
  EXPECT_EQ (graphOf (frame, image, 2, parameters).border (1, 2).connected, 2);
  parameters.gap_slack = 0.7f;
  // 2 mm + 0.7 * 5 mm is less than 6 mm
  EXPECT_EQ (graphOf (frame, image, 2, parameters).border (1, 2).connected, 0);
}

TEST (PatchGraph, NoiseConnectsWhatItParts)
{
  // A step of 10 mm; a row of 1 m in which every other point is 5 mm nearer: sigma = 5 mm * 1.4826 * sqrt (4 / 6), about.
  const auto connected = [] (double ripple, float connection_noise) {
    Frame frame = relief (60, 40, [=] (double column) { return (column < 30 ? 1.0 : 1.01); });
    std::mt19937 random (1);
    std::normal_distribution<double> gauss (0.0, ripple);
    for (std::size_t index = 0; index < frame.cloud.size (); ++index)
      frame.set (index, frame.point (index) * (1.0 + gauss (random)), {0, 0, -1});
    Image<int> image (60, 40, 1);
    for (int row = 0; row < 40; ++row)
      for (int column = 30; column < 60; ++column)
        image (column, row) = 2;
    PatchGraphParameters parameters;
    parameters.connection_noise = connection_noise;
    return (graphOf (frame, image, 2, parameters).border (1, 2).connectedShare ());
  };
  EXPECT_EQ (connected (1e-5, 3.0f), 0.0f) << "10 mm are more than 6 mm";
  EXPECT_LT (connected (0.005, 0.0f), 0.4f);
  EXPECT_GT (connected (0.005, 3.0f), 0.9f) << "6 mm and three times 5 mm";
}

TEST (PatchGraph, KnowsThePointsOnEitherSideOfABorder)
{
  const Image<int> image = labels ({"12", "12"});
  PatchGraphParameters parameters;
  // Level and connected: two pairs along the rows, one along either diagonal.
  Frame frame = flat (2, 2);
  BorderPoints points = graphOf (frame, image, 2, parameters).borderPoints (1, 2);
  EXPECT_EQ (points.first_connected.count, 4);
  EXPECT_EQ (points.second_connected.count, 4);
  EXPECT_EQ (points.first_in_front.count + points.second_in_front.count, 0);
  EXPECT_NEAR (points.first_connected.sum.x (), -0.004, 1e-9) << "four times the column at x = -1 mm";
  EXPECT_NEAR (points.second_connected.sum.x (), 0.0, 1e-9);
  // The second one is a step nearer, and in front.
  frame = relief (2, 2, [] (double column) { return (column < 0.5 ? 1.0 : 0.9); });
  points = graphOf (frame, image, 2, parameters).borderPoints (1, 2);
  EXPECT_EQ (points.first_connected.count, 0);
  EXPECT_EQ (points.first_in_front.count, 0);
  EXPECT_EQ (points.second_in_front.count, 4);
  EXPECT_NEAR (points.second_in_front.sum.z (), 4 * 0.9, 1e-6);
  EXPECT_EQ (graphOf (frame, image, 2, parameters).borderPoints (2, 1).first_in_front.count, 4) << "seen from the other side";
  EXPECT_EQ (PatchGraph ().borderPoints (1, 2).first_connected.count, 0);
}

TEST (PointMoments, TellHowFarPointsLieOffAPlane)
{
  PointMoments moments;
  EXPECT_EQ (moments.flatness (), 0.0);
  EXPECT_EQ (moments.fromPlane ({0, 0, 1}, {0, 0, 0}), std::make_pair (0.0, 0.0));
  // Two above and two below the plane z = 1, at the corners of a square.
  for (const Eigen::Vector3f& point : {Eigen::Vector3f (0, 0, 1.01f), {1, 1, 1.01f}, {1, 0, 0.99f}, {0, 1, 0.99f}})
    moments.add (point);
  EXPECT_NEAR (moments.flatness (), 0.01, 1e-6);
  const auto [distance, spread] = moments.fromPlane ({0, 0, -1}, {5, 5, 1.5f});
  EXPECT_NEAR (distance, 0.5, 1e-6);
  EXPECT_NEAR (spread, 0.01, 1e-6);
  PointMoments twice = moments;
  twice += moments;
  EXPECT_EQ (twice.count, 8);
  EXPECT_NEAR (twice.flatness (), moments.flatness (), 1e-9);
}

TEST (PatchGraph, OfNothingIsEmpty)
{
  const PatchGraph graph = graphOf (flat (5, 4), Image<int> (5, 4, 0), 0);
  EXPECT_TRUE (graph.borders.empty ());
  EXPECT_EQ (graph.perimeter, (std::vector<int>{0}));
  EXPECT_EQ (graph.border (1, 2).pairs, 0);
  EXPECT_EQ (graph.border (1, 2).connectedShare (), 0.0f);
  EXPECT_EQ (graph.border (1, 2).convexity (), 0.0f);
}
