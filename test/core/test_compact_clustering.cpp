// SPDX-License-Identifier: BSD-3-Clause
// Paper IV-B: growing an object from patches, on clouds made up for one constraint at a time.
#include "shapes.h"
#include <pcl_attention/core/pipeline.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace pcl_attention;
using Eigen::Vector3d;
using shapes::Frame;

namespace
{

struct Color
{
  std::uint8_t red, green, blue;
};

constexpr Color red{200, 20, 20}, green{20, 200, 20}, blue{20, 20, 200}, grey{120, 120, 120};

bool
growAt (const AttentionPoint& point, CompactClustering& clustering, AttentionSegment& segment)
{
  return (clustering.grow (point, clustering.initialPatches (point), segment));
}

/** \brief A frame with patches given by hand. */
struct Case
{
  Frame frame;
  PlanarPatches patches;
  PatchGraph graph;

  Case (Frame made, Image<int> labels) : frame (std::move (made))
  {
    patches.labels = std::move (labels);
    describePatches (frame.cloud, patches);
    graph = buildPatchGraph (frame.cloud, estimateSensor (frame.cloud), frame.normals, patches.labels, static_cast<int> (patches.patches.size ()),
                             PatchGraphParameters ());
  }

  void
  paint (const std::vector<Color>& color_of_label)
  {
    for (const int label : patches.labels.data)
    {
      frame.cloud.red.push_back (color_of_label[label].red);
      frame.cloud.green.push_back (color_of_label[label].green);
      frame.cloud.blue.push_back (color_of_label[label].blue);
    }
  }

  AttentionSegment
  grow (int column, int row, const ClusteringParameters& parameters, std::vector<std::uint8_t> support = {}) const
  {
    CompactClustering clustering (frame.cloud, estimateSensor (frame.cloud), frame.normals, patches, graph, support, parameters);
    AttentionPoint point;
    point.column = column;
    point.row = row;
    AttentionSegment segment;
    EXPECT_TRUE (growAt (point, clustering, segment));
    return (segment);
  }
};

/** \brief The paper's constraints alone, from the one patch at the point. */
ClusteringParameters
plain ()
{
  ClusteringParameters parameters = AttentionParameters::paper ().clustering;
  parameters.color_constraint = ColorConstraint::off;
  parameters.initial_radius = 0;
  return (parameters);
}

std::vector<int>
sorted (std::vector<int> labels)
{
  std::sort (labels.begin (), labels.end ());
  return (labels);
}

/** \brief A plane 64 by 48 pixels large with three squares of 12 by 12 pixels in a row: 1 and 2 touch, 3 touches 2; 4
 * is the rest. */
Case
squaresOnAPlane ()
{
  Image<int> labels (64, 48, 4);
  for (int row = 18; row < 30; ++row)
    for (int column = 10; column < 46; ++column)
      labels (column, row) = 1 + (column - 10) / 12;
  return (Case (shapes::look (shapes::plane ({0, 0, 0.8}, {0, 0, -1})), labels));
}

/** \brief Points 1 mm apart in x and y, so that no side of a hull is seen edge-on; both halves are patches, 1 and 2.
 * \param[in] depth of x, metres
 * \param[in] slope dz / dx of either half */
template <typename Depth>
Case
twoSides (const Depth& depth, double slope1, double slope2)
{
  Frame frame = shapes::emptyFrame (64, 48);
  Image<int> labels (64, 48, 1);
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column)
    {
      const double x = 0.001 * (column - 31.5);
      labels (column, row) = column < 32 ? 1 : 2;
      frame.set (frame.index (column, row), {x, 0.001 * (row - 23.5), depth (x)},
                 Vector3d (column < 32 ? slope1 : slope2, 0, -1).normalized ());
    }
  return (Case (frame, labels));
}

/** \brief A valley with sides of 45 degrees, 32 mm wide each. */
Case
valley ()
{
  return (twoSides ([] (double x) { return (0.8 - std::abs (x)); }, 1.0, -1.0));
}

const GrowthStep*
stepOf (const AttentionSegment& segment, int label)
{
  for (const GrowthStep& step : segment.steps)
    if (step.patch == label)
      return (&step);
  return (nullptr);
}

} // namespace

// A rectangle of m x n pixels has 2 m contour pairs along the rows, 2 n along the columns and 2 (m + n - 1) in either diagonal:
// 6 (m + n) - 4.
TEST (CompactClustering, IsConfidentWhereTheDepthJumps)
{
  Frame frame = shapes::emptyFrame (64, 48);
  Image<int> labels (64, 48, 2);
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column)
    {
      const bool in_front = column >= 20 && column < 40 && row >= 14 && row < 34;
      labels (column, row) = in_front ? 1 : 2;
      frame.set (frame.index (column, row), {0.001 * (column - 31.5), 0.001 * (row - 23.5), in_front ? 0.6 : 0.8}, {0, 0, -1});
    }
  const Case scene (frame, labels);
  const AttentionSegment square = scene.grow (30, 24, plain ()), rest = scene.grow (5, 5, plain ());
  ASSERT_EQ (square.patches, std::vector<int>{1});
  EXPECT_EQ (square.confidence, 1.0f);
  ASSERT_EQ (rest.patches, std::vector<int>{2});
  const double occluded = 12 * 20 - 4, at_image_border = 6 * (64 + 48) - 4, pixels = 64 * 48 - 20 * 20;
  EXPECT_FLOAT_EQ (rest.confidence, static_cast<float> (std::exp (-2 * (0.25 * occluded + at_image_border) / pixels)));
}

TEST (CompactClustering, DoubtsAContourWithAConnectedNeighbor)
{
  ClusteringParameters parameters = plain ();
  parameters.minimum_convexity = 1.0f; // more than a plane has
  const AttentionSegment segment = squaresOnAPlane ().grow (15, 24, parameters);
  ASSERT_EQ (segment.patches, std::vector<int>{1});
  EXPECT_FLOAT_EQ (segment.confidence, static_cast<float> (std::exp (-2.0 * (12 * 12 - 4) / (12 * 12))));
}

TEST (CompactClustering, JoinsEverythingOnAPlane)
{
  const AttentionSegment segment = squaresOnAPlane ().grow (15, 24, plain ());
  EXPECT_EQ (sorted (segment.patches), (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ (segment.patches.front (), 1);
  EXPECT_EQ (segment.indices.size (), 64u * 48u);
  EXPECT_EQ (segment.growth_end, GrowthConstraint::none);
  EXPECT_EQ (segment.compactness, 0.0f);
  EXPECT_EQ (segment.steps.size (), 3u);
  for (const GrowthStep& step : segment.steps)
    EXPECT_EQ (step.refused_by, GrowthConstraint::none);
  // Of the patch at the point: z = 0.8, towards the viewer.
  EXPECT_NEAR (segment.plane[2], -1.0f, 1e-4f);
  EXPECT_NEAR (segment.plane[3], 0.8f, 1e-4f);
}

TEST (CompactClustering, NearerObjectTakesTheObjectsColours)
{
  // Red, red and blue squares on grey.
  Case scene = squaresOnAPlane ();
  scene.paint ({grey, red, red, blue, grey});
  ClusteringParameters parameters = plain ();
  parameters.color_constraint = ColorConstraint::nearer_object;
  const AttentionSegment segment = scene.grow (15, 24, parameters);
  EXPECT_EQ (sorted (segment.patches), (std::vector<int>{1, 2}));
  ASSERT_NE (stepOf (segment, 4), nullptr);
  // Grey is as far from red as can be, and at most half of what is outside is not grey.
  EXPECT_EQ (stepOf (segment, 4)->refused_by, GrowthConstraint::color);
  EXPECT_NEAR (stepOf (segment, 4)->value, 1.0f, 1e-6f);
  EXPECT_LT (stepOf (segment, 4)->limit, 0.5f);
  EXPECT_EQ (segment.growth_end, GrowthConstraint::color);
}

TEST (CompactClustering, AsPrintedTakesTheBackgroundsColours)
{
  Case scene = squaresOnAPlane ();
  scene.paint ({grey, red, red, blue, grey});
  ClusteringParameters parameters = plain ();
  parameters.color_constraint = ColorConstraint::as_printed;
  const AttentionSegment segment = scene.grow (15, 24, parameters);
  // CS_out < CS_in: the grey rest is far from the red object and near the outside.
  ASSERT_FALSE (segment.steps.empty ());
  EXPECT_EQ (segment.steps.front ().patch, 4); // the longest border
  EXPECT_EQ (segment.steps.front ().refused_by, GrowthConstraint::none);
  // And alone with the red neighbour, nothing is added: CS_in is 0.
  Image<int> two (64, 48, 0);
  for (int row = 18; row < 30; ++row)
    for (int column = 10; column < 34; ++column)
      two (column, row) = 1 + (column - 10) / 12;
  Case pair (shapes::look (shapes::plane ({0, 0, 0.8}, {0, 0, -1})), two);
  pair.paint ({grey, red, red});
  const AttentionSegment alone = pair.grow (15, 24, parameters);
  EXPECT_EQ (alone.patches, (std::vector<int>{1}));
  EXPECT_EQ (alone.growth_end, GrowthConstraint::color);
  ASSERT_NE (stepOf (alone, 2), nullptr);
  EXPECT_EQ (stepOf (alone, 2)->value, 0.0f);
  EXPECT_GT (stepOf (alone, 2)->limit, 0.5f);
}

TEST (CompactClustering, NotObjectLiesOutsideTwiceTheObjectsArea)
{
  // Around 12x12 red pixels, two green rings make 16x16 = 256; the next ring of 68 blue pixels loses the 32 that are
  // missing to twice 144. What is left are 36 blue and 64 * 48 - 18 * 18 grey pixels, which are patch 2.
  Image<int> labels (64, 48, 2);
  std::vector<Color> colors (labels.size (), grey);
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column)
    {
      const int ring = std::max ({20 - column, column - 31, 18 - row, row - 29});
      if (ring > 3)
        continue;
      labels (column, row) = ring <= 0 ? 1 : 0;
      colors[static_cast<std::size_t> (row) * 64 + column] = ring <= 0 ? red : (ring <= 2 ? green : blue);
    }
  Case scene (shapes::look (shapes::plane ({0, 0, 0.8}, {0, 0, -1})), labels);
  for (const Color& color : colors)
  {
    scene.frame.cloud.red.push_back (color.red);
    scene.frame.cloud.green.push_back (color.green);
    scene.frame.cloud.blue.push_back (color.blue);
  }
  ClusteringParameters parameters = plain ();
  parameters.color_constraint = ColorConstraint::nearer_object;
  const AttentionSegment segment = scene.grow (25, 24, parameters);
  ASSERT_EQ (segment.steps.size (), 1u);
  EXPECT_EQ (segment.steps[0].refused_by, GrowthConstraint::color);
  EXPECT_NEAR (segment.steps[0].value, 1.0f, 1e-6f);
  // Chi-square of the shares (b, 1 - b) and (0, 1) is b / (2 - b).
  const double share = 36.0 / (36.0 + 64.0 * 48.0 - 18.0 * 18.0);
  EXPECT_NEAR (segment.steps[0].limit, share / (2.0 - share), 1e-5);
}

TEST (CompactClustering, WithoutColourTheConstraintHolds)
{
  ClusteringParameters parameters = plain ();
  parameters.color_constraint = ColorConstraint::nearer_object;
  EXPECT_EQ (squaresOnAPlane ().grow (15, 24, parameters).patches.size (), 4u);
}

TEST (CompactClustering, CompactnessRefusesTheOtherSideOfAValley)
{
  // The visible face of a valley's hull is its mouth, between the outermost points, 31.5 mm before the crease. Points x
  // mm from the middle lie 31.5 - x mm behind it; the mean of x = 0.5, 1.5 ... 31.5 is 16.
  const double kappa = 0.0155;
  const Case scene = valley ();
  const AttentionSegment segment = scene.grow (10, 24, plain ());
  EXPECT_EQ (segment.patches, (std::vector<int>{1}));
  EXPECT_EQ (segment.growth_end, GrowthConstraint::compactness);
  ASSERT_EQ (segment.steps.size (), 1u);
  EXPECT_EQ (segment.steps[0].patch, 2);
  EXPECT_EQ (segment.steps[0].refused_by, GrowthConstraint::compactness);
  EXPECT_FLOAT_EQ (segment.steps[0].limit, 0.005f);
  EXPECT_NEAR (segment.steps[0].value, kappa, 0.03 * kappa); // of 100 points a side

  // Just under and over theta_com.
  ClusteringParameters parameters = plain ();
  parameters.compactness_threshold = static_cast<float> (0.96 * kappa);
  EXPECT_EQ (scene.grow (10, 24, parameters).patches.size (), 1u);
  parameters.compactness_threshold = static_cast<float> (1.04 * kappa);
  const AttentionSegment both = scene.grow (10, 24, parameters);
  EXPECT_EQ (sorted (both.patches), (std::vector<int>{1, 2}));
  EXPECT_NEAR (both.compactness, kappa, 0.03 * kappa);
}

TEST (CompactClustering, ARoofIsCompact)
{
  const Case scene = twoSides ([] (double x) { return (0.8 + std::abs (x)); }, -1.0, 1.0);
  const AttentionSegment segment = scene.grow (10, 24, plain ());
  EXPECT_EQ (segment.patches, (std::vector<int>{1, 2}));
  EXPECT_LT (segment.compactness, 1e-5f);
}

TEST (CompactClustering, TheNotObjectFollowsTheGrownObject)
{
  // 1 and the large 2 are red, 3 is more red than grey, 4 grey. Beside {1, 2} all is grey; beside 1 alone half would be red, too
  // like 3.
  Image<int> labels (64, 48, 4);
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 42; ++column)
      if (column < 30)
        labels (column, row) = column >= 5 && column < 17 && row >= 18 && row < 30 ? 1 : 2;
      else if (row >= 10 && row < 38)
        labels (column, row) = 3;
  Case scene (shapes::look (shapes::plane ({0, 0, 0.8}, {0, 0, -1})), labels);
  scene.paint ({grey, red, red, red, grey});
  for (std::size_t index = 0; index < labels.size (); ++index)
    if (labels[index] == 3 && index % 5 < 2)
    {
      scene.frame.cloud.red[index] = grey.red;
      scene.frame.cloud.green[index] = grey.green;
      scene.frame.cloud.blue[index] = grey.blue;
    }
  ClusteringParameters parameters = plain ();
  parameters.color_constraint = ColorConstraint::nearer_object;
  EXPECT_EQ (sorted (scene.grow (10, 24, parameters).patches), (std::vector<int>{1, 2, 3}));
}

TEST (CompactClustering, AHandleIsThinAndLooksLikeItsObject)
{
  // A quarter of the pixels, which hang on the object alone; of a square of n pixels a side the width is taken for a third.
  const auto patchesWith = [] (double pixel_width, const Color& color) {
    Frame frame = shapes::emptyFrame (64, 48);
    Image<int> labels (64, 48, 0);
    for (int row = 4; row < 40; ++row)
      for (int column = 4; column < 56; ++column)
      {
        const int label = column < 40 ? 1 : row < 20 ? 2 : 0;
        if (label == 0)
          continue;
        labels (column, row) = label;
        frame.set (frame.index (column, row), {pixel_width * (column - 31.5), pixel_width * (row - 23.5), 0.8}, {0, 0, -1});
      }
    ClusteringParameters parameters = plain ();
    parameters.minimum_convexity = 1.0f; // nothing grows
    parameters.join_handles = true;
    Case made (frame, labels);
    made.paint ({grey, red, color});
    return (sorted (made.grow (20, 20, parameters).patches));
  };
  EXPECT_EQ (patchesWith (0.003, red), (std::vector<int>{1, 2}));
  EXPECT_EQ (patchesWith (0.005, red), (std::vector<int>{1}));
  EXPECT_EQ (patchesWith (0.003, green), (std::vector<int>{1}));
}

TEST (CompactClustering, WhatBelongsToALargerPieceIsNoPartOfAHandle)
{
  // 1 grows over 2, but not over 3, most of whose border with it is a step in depth; 3 alone would grow over 2 and be too large for
  // a handle of 4, which it meets in a concave border.
  Frame frame = shapes::emptyFrame (96, 48);
  Image<int> labels (96, 48, 0);
  const Vector3d ahead (0, 0, -1), turned = Vector3d (-1, -1, -1).normalized ();
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 96; ++column)
    {
      const bool left = column < 20;
      const int label = column >= 50 || (row >= 40 && !left) ? 4 : row >= 40 ? 0 : row < 24 ? 1 : left ? 2 : 3;
      labels (column, row) = label;
      frame.set (frame.index (column, row), {0.002 * (column - 47.5), 0.002 * (row - 23.5), label == 1 && !left ? 0.9 : 0.8},
                 label == 4 ? turned : ahead);
    }
  ClusteringParameters parameters;
  parameters.compactness_threshold = 1.0f;
  parameters.join_hollows = parameters.join_occluded = parameters.recognize_hollows = false;
  const Case scene (frame, labels);
  EXPECT_EQ (sorted (scene.grow (80, 24, parameters).patches), (std::vector<int>{3, 4}));
  EXPECT_EQ (sorted (scene.grow (10, 10, parameters).patches), (std::vector<int>{1, 2}));
}

TEST (CompactClustering, CompactnessHasToBeBelowTheThreshold)
{
  ClusteringParameters parameters = plain ();
  parameters.compactness_threshold = 0.0f; // what everything on a plane has
  EXPECT_EQ (squaresOnAPlane ().grow (15, 24, parameters).patches, std::vector<int>{1});
}

TEST (CompactClustering, CompactnessRefusesAPatchFarBehind)
{
  // Both sides face the viewer, the second one is 10 cm farther away. The visible faces are the near side and the one
  // that runs from its right edge (-0.5, 0) to the right edge of the far side (31.5, 100): its unit normal is (100,
  // -32) / 105, and the far points (x, 100) lie (31.5 - x) * 100 / 105 mm from it; the mean over x = 0.5 ... 31.5
  // is 14.76 mm, over both sides half of that.
  const Case scene = twoSides ([] (double x) { return (x < 0.0 ? 0.8 : 0.9); }, 0.0, 0.0);
  const double kappa = 0.5 * 15.5e-3 * 100.0 / std::hypot (100.0, 32.0);
  ClusteringParameters parameters = plain ();
  const AttentionSegment segment = scene.grow (20, 24, parameters);
  EXPECT_EQ (segment.patches, (std::vector<int>{1}));
  EXPECT_EQ (segment.growth_end, GrowthConstraint::compactness);
  ASSERT_EQ (segment.steps.size (), 1u);
  EXPECT_NEAR (segment.steps[0].value, kappa, 0.05 * kappa);
  // Asked for a connection in 3D, that is what refuses it.
  parameters.minimum_connection = 0.5f;
  const AttentionSegment connected = scene.grow (20, 24, parameters);
  EXPECT_EQ (connected.patches, (std::vector<int>{1}));
  EXPECT_EQ (connected.growth_end, GrowthConstraint::connection);
  ASSERT_EQ (connected.steps.size (), 1u);
  EXPECT_EQ (connected.steps[0].value, 0.0f);
  EXPECT_EQ (connected.steps[0].limit, 0.5f);
}

TEST (CompactClustering, TheFlatFloorOfAHollowMayBeAPieceOfItsOwn)
{
  // A floor on the left and a wall that rises from it by 30 degrees: the convexity is -2 sin (15 degrees) = -.52, within what a hollow
  // may have. The wall is bent along the crease by 4 mm, the depth has noise of half a millimetre.
  const auto patchesFrom = [] (int column, double bend_of_floor, const std::function<void (ClusteringParameters&)>& change) {
    std::mt19937 random (1);
    std::normal_distribution<double> noise (0.0, 0.0005);
    Frame frame = shapes::emptyFrame (64, 48);
    Image<int> labels (64, 48, 1);
    const double slope = std::tan (3.14159265358979 / 6.0);
    for (int row = 0; row < 48; ++row)
      for (int at = 0; at < 64; ++at)
      {
        const double x = 0.001 * (at - 31.5), y = 0.001 * (row - 23.5), bend = (x < 0.0 ? bend_of_floor : 0.004) * std::cos (200.0 * y);
        labels (at, row) = x < 0.0 ? 1 : 2;
        frame.set (frame.index (at, row), {x, y, 0.8 - slope * std::max (0.0, x) + bend + noise (random)},
                   Vector3d (x < 0.0 ? 0.0 : -slope, 0, -1).normalized ());
      }
    ClusteringParameters parameters = plain ();
    parameters.minimum_convexity = -0.2f;
    parameters.compactness_threshold = 0.1f;
    parameters.compactness_noise = 2.5f;
    parameters.recognize_hollows = true;
    parameters.minimum_hollowness = -0.5f;
    parameters.separate_floors = false;
    change (parameters);
    return (sorted (Case (frame, labels).grow (column, 24, parameters).patches));
  };
  const auto separate = [] (ClusteringParameters& parameters) { parameters.separate_floors = true; };
  const std::vector<int> both{1, 2};
  EXPECT_EQ (patchesFrom (50, 0.0, [] (ClusteringParameters&) {}), both);
  EXPECT_EQ (patchesFrom (50, 0.0, separate), (std::vector<int>{2}));
  EXPECT_EQ (patchesFrom (10, 0.0, separate), (std::vector<int>{1}));
  // Three millimetres are 2.1 standard deviations more than the noise allows a plane.
  EXPECT_EQ (patchesFrom (50, 0.003, separate), both);
  EXPECT_EQ (patchesFrom (10, 0.003, separate), both);
  EXPECT_EQ (patchesFrom (50, 0.0, [&] (ClusteringParameters& parameters) {
    separate (parameters);
    parameters.certain_size = 2000;
  }), both) << "too small to tell";
  EXPECT_EQ (patchesFrom (50, 0.0, [&] (ClusteringParameters& parameters) {
    separate (parameters);
    parameters.minimum_convexity = -0.6f;
  }), both) << "no crease that other patches would not be joined over";
}

TEST (CompactClustering, AnInsideEndsWhereItTurnsOverItsRim)
{
  // Half a pipe on the left, whose normals lean inwards by up to 43 degrees; on the right it falls away by 60 degrees.
  Frame frame = shapes::emptyFrame (64, 48);
  Image<int> labels (64, 48, 1);
  const double slope = std::tan (3.14159265358979 / 3.0);
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column)
    {
      const double x = 0.001 * (column - 31.5), y = 0.001 * (row - 23.5);
      const bool behind = x > 0.0;
      labels (column, row) = behind ? 2 : 1;
      frame.set (frame.index (column, row), {x, y, 0.8 - 20.0 * y * y + (behind ? slope * x : 0.0)},
                 Vector3d (behind ? slope : 0.0, behind ? 0.0 : -40.0 * y, -1).normalized ());
    }
  const Case scene (frame, labels);
  ClusteringParameters parameters = plain ();
  parameters.minimum_convexity = -0.2f;
  parameters.compactness_threshold = 0.1f;
  parameters.recognize_hollows = true;
  const auto patchesFrom = [&] (int column) { return (sorted (scene.grow (column, 24, parameters).patches)); };
  const std::vector<int> both{1, 2};
  const AttentionSegment inside = scene.grow (10, 24, parameters);
  EXPECT_EQ (inside.patches, std::vector<int>{1});
  EXPECT_EQ (inside.growth_end, GrowthConstraint::convexity);
  ASSERT_EQ (inside.steps.size (), 1u);
  EXPECT_GT (inside.steps[0].value, inside.steps[0].limit);
  EXPECT_EQ (inside.steps[0].limit, 0.5f);
  EXPECT_EQ (patchesFrom (50), std::vector<int>{2});
  parameters.certain_size = 2000;
  EXPECT_EQ (patchesFrom (10), both) << "1536 pixels are too few to tell";
  parameters.certain_size = 200;
  parameters.rim_convexity = 2.0f;
  EXPECT_EQ (patchesFrom (10), both);
  parameters.rim_convexity = 0.5f;
  parameters.recognize_hollows = false;
  EXPECT_EQ (patchesFrom (10), both);
}

TEST (CompactClustering, OtherColoursHaveToBeConnectedOverMore)
{
  // Two patches that meet over 6 rows; below, one of another surface 20 cm behind lies between them. Pairs across a border of n pixels
  // are n and 2 (n - 1) diagonal ones: 16 of the two patches, 148 and 160 of them and the third one, with a corner each. 16 / 164 = .098
  // of the shorter outline are connected.
  const auto patchesOf = [] (int columns, const std::vector<Color>& colors, float color_contact) {
    Frame frame = shapes::emptyFrame (160, 48);
    Image<int> labels (160, 48, 0);
    for (int row = 0; row < 48; ++row)
      for (int column = 0; column < 92 + columns; ++column)
      {
        const bool between = row >= 6 && column >= 72 && column < 92;
        labels (column, row) = between ? 3 : column < 80 ? 1 : 2;
        frame.set (frame.index (column, row), {0.001 * (column - 79.5), 0.001 * (row - 23.5), between ? 1.0 : 0.8}, {0, 0, -1});
      }
    Case scene (frame, labels);
    scene.paint (colors);
    ClusteringParameters parameters = plain ();
    parameters.minimum_connection = 0.5f;
    parameters.color_contact = color_contact;
    return (sorted (scene.grow (10, 24, parameters).patches));
  };
  const std::vector<int> both{1, 2}, apart{1};
  const std::vector<Color> alike{grey, red, red, grey}, different{grey, red, blue, grey};
  EXPECT_EQ (patchesOf (20, different, 0.15f), apart);
  EXPECT_EQ (patchesOf (20, different, 0.10f), apart);
  EXPECT_EQ (patchesOf (20, different, 0.09f), both);
  EXPECT_EQ (patchesOf (20, alike, 0.15f), both);
  // 14 columns make 14 * 42 + 26 * 6 = 744 pixels of 3504, 13 columns 696: less than a fifth.
  EXPECT_EQ (patchesOf (14, different, 0.15f), apart);
  EXPECT_EQ (patchesOf (13, different, 0.15f), both);
}

TEST (CompactClustering, FlatHalvesOfAnInsideAreOneUnlessTheyMeetSquarely)
{
  // Both sides are flat, so that neither surrounds anything. Together they do: of a point the part of the way to the middle that is along
  // the normal is 16 mm sin (slope), the way itself some 20 mm.
  const auto patchesOf = [] (double degrees, const std::vector<Color>& colors, const std::function<void (ClusteringParameters&)>& change) {
    const double slope = std::tan (degrees * 3.14159265358979 / 180.0);
    Case sides = twoSides ([slope] (double x) { return (0.8 - slope * std::abs (x)); }, slope, -slope);
    sides.paint (colors);
    ClusteringParameters parameters = plain ();
    parameters.minimum_convexity = -0.2f;
    parameters.color_convexity = 0.3f;
    parameters.compactness_threshold = 0.1f;
    parameters.recognize_hollows = parameters.join_hollows = true;
    change (parameters);
    return (sides.grow (15, 24, parameters).patches);
  };
  const auto nothing = [] (ClusteringParameters&) {};
  const std::vector<int> one{1, 2}, apart{1};
  const std::vector<Color> alike{grey, red, red}, different{grey, red, blue};
  EXPECT_EQ (patchesOf (25, alike, nothing), one);
  EXPECT_EQ (patchesOf (45, alike, nothing), apart) << "a box before a wall";
  EXPECT_EQ (patchesOf (25, different, nothing), apart);
  EXPECT_EQ (patchesOf (25, alike, [] (ClusteringParameters& p) { p.join_hollows = false; }), apart) << "visible pieces";
  EXPECT_EQ (patchesOf (25, alike, [] (ClusteringParameters& p) { p.recognize_hollows = false; }), apart);
  EXPECT_EQ (patchesOf (25, alike, [] (ClusteringParameters& p) { p.certain_size = 2000; }), apart) << "1536 pixels each";
  EXPECT_EQ (patchesOf (12, alike, [] (ClusteringParameters& p) { p.minimum_convexity = 0.0f; }), apart) << "a dent";
}

TEST (CompactClustering, NoiseWidensTheCompactnessLimit)
{
  const Case sides = valley ();
  ClusteringParameters parameters = plain ();
  parameters.compactness_noise = 3.0f;
  const float noise = estimateDepthNoise (sides.frame.cloud), depth = sides.patches.patches[1].centroid.z ();
  ASSERT_GT (noise, 0.0f);
  const AttentionSegment segment = sides.grow (10, 24, parameters);
  const GrowthStep* const step = stepOf (segment, 2);
  ASSERT_TRUE (step);
  EXPECT_NEAR (step->limit, parameters.compactness_threshold + 3.0f * noise * depth * depth, 1e-7f);
}

TEST (CompactClustering, TheFloorSeenThroughTheMouthOfAHollowBelongsToIt)
{
  // A plate from above: a ring that rises outwards; its floor is level with the table and a patch with it.
  Frame frame = shapes::emptyFrame (64, 48);
  Image<int> labels (64, 48, 1);
  int floor = 0, ring = 0;
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column)
    {
      const double x = 0.002 * (column - 31.5), y = 0.002 * (row - 23.5), radius = std::hypot (x, y);
      const bool rises = radius >= 0.02 && radius <= 0.04;
      const double z = rises ? 0.8 - 0.5 * (radius - 0.02) : 0.8;
      const Vector3d normal = rises ? Vector3d (-0.5 * x / radius, -0.5 * y / radius, -1) : Vector3d (0, 0, -1);
      frame.set (frame.index (column, row), {x, y, z}, normal.normalized ());
      if (rises)
        labels (column, row) = 2;
      ring += rises;
      floor += radius < 0.02;
    }
  const Case plate (frame, labels);
  ClusteringParameters parameters;
  const std::vector<std::uint8_t> support{0, 1, 0};
  EXPECT_EQ (plate.grow (31, 8, parameters, support).indices.size (), static_cast<std::size_t> (ring + floor));
  parameters.visiblePieces ();
  EXPECT_EQ (plate.grow (31, 8, parameters, support).indices.size (), static_cast<std::size_t> (ring));
}

TEST (CompactClustering, WhatIsSeenBesideTheHandleOfAHollowIsNotItsFloor)
{
  // A bowl from above with a bent handle at the height of its rim: the hull of both goes over 100 pixels of table and more.
  // What is flat beside them tells that there is no noise.
  Frame frame = shapes::emptyFrame (192, 48);
  Image<int> labels (192, 48, 1);
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 192; ++column)
    {
      const double x = 0.002 * (column - 31.5), y = 0.002 * (row - 23.5), radius = std::hypot (x, y);
      const bool rises = radius >= 0.02 && radius <= 0.04;
      const bool handle = radius > 0.04 && column > 31 && column < 61 && ((row >= 20 && row < 28) || (column >= 57 && row >= 20));
      const double z = rises ? 0.8 - 1.5 * (radius - 0.02) : handle ? 0.77 : 0.8;
      const Vector3d normal = rises ? Vector3d (-1.5 * x / radius, -1.5 * y / radius, -1) : Vector3d (0, 0, -1);
      frame.set (frame.index (column, row), {x, y, z}, normal.normalized ());
      labels (column, row) = rises ? 2 : handle ? 3 : 1;
    }
  const Case bowl (frame, labels);
  ClusteringParameters parameters;
  parameters.minimum_convexity = 1.0f; // nothing grows
  const std::vector<std::uint8_t> support{0, 1, 0, 0};
  const AttentionSegment segment = bowl.grow (31, 8, parameters, support);
  ASSERT_EQ (segment.patches, (std::vector<int>{2, 3}));
  std::size_t floor = 0;
  for (const pcl::index_t index : segment.indices)
    floor += labels[index] == 1;
  EXPECT_EQ (floor, static_cast<std::size_t> (std::count_if (segment.indices.begin (), segment.indices.end (), [&] (pcl::index_t index) {
    return (labels[index] == 1 && std::hypot (index % 192 - 31.5, index / 192 - 23.5) < 10.0);
  })));
  EXPECT_GT (floor, 250u);
}

TEST (CompactClustering, TheInsideOfAHollowAndItsWallMeetInARimThatIsPlane)
{
  // A dish from above, 80 mm wide, and the wall that falls off around it: two patches that meet in a circle. Bent like a saddle the
  // circle is no rim: a x^2 - a y^2 is 25 mm cos 2 phi there, which lies 25 / sqrt (2) = 18 mm off its plane. What is flat beside them
  // tells that there is no noise. A wall that goes round a small part of the circle may be anything that stands there.
  const auto patchesOf = [] (double saddle, double part_with_wall = 1.0) {
    Frame frame = shapes::emptyFrame (192, 64);
    Image<int> labels (192, 64, 0);
    for (int row = 0; row < 64; ++row)
      for (int column = 0; column < 192; ++column)
      {
        const double x = 0.002 * (column - 31.5), y = 0.002 * (row - 31.5), radius = std::hypot (x, y), rim = 0.04;
        frame.set (frame.index (column, row), {x, y, 0.9}, {0, 0, -1});
        const bool inside = radius < rim;
        if (radius > 0.06 || (!inside && std::abs (std::atan2 (x, -y)) > part_with_wall * 3.14159265358979))
          continue;
        const double slope = inside ? -20.0 * radius : 2.0; // dz / d radius
        const double z = inside ? 0.8 + 10.0 * (rim * rim - radius * radius) : 0.8 + 2.0 * (radius - rim);
        labels (column, row) = inside ? 1 : 2;
        frame.set (frame.index (column, row), {x, y, z + saddle * (x * x - y * y) / (rim * rim)},
                   Vector3d (slope * x / radius, slope * y / radius, -1.0).normalized ());
      }
    ClusteringParameters parameters;
    parameters.join_handles = false;
    return (sorted (Case (frame, labels).grow (31, 31, parameters).patches));
  };
  EXPECT_EQ (patchesOf (0.0), (std::vector<int>{1, 2}));
  EXPECT_EQ (patchesOf (0.025), (std::vector<int>{1}));
  EXPECT_EQ (patchesOf (0.0, 0.13), (std::vector<int>{1, 2}));
  EXPECT_EQ (patchesOf (0.0, 0.06), (std::vector<int>{1}));
}

/** \brief A dish from above with a bar across its middle, and the wall that falls off around it.
  *
  * The left half of the inside is patch 1, the right one 2, the bar 3 and the wall 4. What is flat beside them tells that there is no
  * noise. */
struct DishWithBar
{
  double bar_depth{0.8};           /**< of the bar, metres; the rim is at 0.8 */
  double between{0.0};             /**< from one dish to another if there are two, with a narrow bar between them, metres */
  double part_with_wall{1.0};      /**< of the circle, around the side that is nearest to the camera's lower edge */
  double curvature{25.0};          /**< the inside is curvature r^2 deeper at the middle than at the radius r, 1 / metres */
  Color right{red};                /**< of the right half; all else is red */

  /** \brief Patches of the object that grows where nothing grows over borders.
    * \param[in] at_wall below the bar instead of in the left half */
  std::vector<int>
  patches (const std::function<void (ClusteringParameters&)>& change = {}, bool at_wall = false) const
  {
    constexpr double rim = 0.04;
    Frame frame = shapes::emptyFrame (256, 64);
    Image<int> labels (256, 64, 0);
    for (int row = 0; row < 64; ++row)
      for (int column = 0; column < 256; ++column)
      {
        const int index = frame.index (column, row);
        const double x = 0.002 * (column - 50.5), y = 0.002 * (row - 31.5);
        frame.set (index, {x, y, 0.9}, {0, 0, -1});
        const bool is_bar = std::abs (x) < (between > 0.0 ? 0.008 : 0.02) && std::abs (y) <= rim;
        const double from_middle = x - std::copysign (0.5 * between, x), radius = std::hypot (from_middle, y);
        const bool is_inside = radius < rim, is_wall = radius < 0.055 && std::abs (std::atan2 (x, y)) <= part_with_wall * 3.15;
        if (is_bar)
          frame.set (index, {x, y, bar_depth}, {0, 0, -1});
        else if (is_inside || is_wall)
        {
          const double slope = is_inside ? -2.0 * curvature * radius : 2.0; // dz / d radius
          const double z = 0.8 + (is_inside ? curvature * (rim * rim - radius * radius) : 2.0 * (radius - rim));
          frame.set (index, {x, y, z}, Vector3d (slope * from_middle / radius, slope * y / radius, -1.0).normalized ());
        }
        labels (column, row) = is_bar ? 3 : is_inside ? (x < 0.0 ? 1 : 2) : is_wall ? 4 : 0;
      }
    ClusteringParameters parameters;
    parameters.minimum_convexity = 3.0f; // nothing grows
    parameters.join_handles = parameters.join_occluded = false;
    if (change)
      change (parameters);
    Case dish (frame, labels);
    dish.paint ({grey, red, right, red, red});
    const Pixel point = at_wall ? Pixel{50, 54} : Pixel{40 - static_cast<int> (250 * between), 31};
    return (sorted (dish.grow (point.column, point.row, parameters).patches));
  }

  /** \brief Whether the right half is found from the left one. */
  bool
  isOne () const
  {
    const std::vector<int> found = patches ();
    return (std::count (found.begin (), found.end (), 2) > 0);
  }
};

TEST (CompactClustering, WhatStandsInAHollowPartsItsInside)
{
  EXPECT_EQ (DishWithBar ().patches (), (std::vector<int>{1, 2, 4}));
  EXPECT_EQ (DishWithBar ().patches ([] (ClusteringParameters& p) { p.join_hollows = false; }), (std::vector<int>{1}));
  DishWithBar bar_looks_out;
  bar_looks_out.bar_depth = 0.75;
  EXPECT_EQ (bar_looks_out.patches (), (std::vector<int>{1, 2, 4}));
}

TEST (CompactClustering, HalvesOfAnInsideAreDeep)
{
  DishWithBar dish;
  dish.part_with_wall = 0.0;
  EXPECT_EQ (dish.patches (), (std::vector<int>{1, 2}));
  dish.curvature = 3.0; // two pieces of what is nearly a plate: anything may lie between
  EXPECT_FALSE (dish.isOne ());
}

TEST (CompactClustering, HalvesOfAnInsideLookAlike)
{
  DishWithBar dish;
  dish.part_with_wall = 0.0;
  EXPECT_EQ (dish.patches (), (std::vector<int>{1, 2}));
  dish.right = blue;
  EXPECT_FALSE (dish.isOne ());
}

TEST (CompactClustering, InsidesBesideEachOtherHaveNoCommonMiddle)
{
  DishWithBar apart;
  apart.part_with_wall = 0.0;
  apart.between = 0.1;
  EXPECT_FALSE (apart.isOne ());
}

TEST (CompactClustering, AWallGoesOnBeforeWhatStandsInTheHollow)
{
  // It touches the inside over 4 mm of the circle on either side of the bar, which it hides.
  DishWithBar short_wall;
  short_wall.bar_depth = 0.815;
  short_wall.part_with_wall = 0.2;
  EXPECT_EQ (short_wall.patches (), (std::vector<int>{1, 2, 4}));
  EXPECT_EQ (short_wall.patches ({}, true), (std::vector<int>{1, 2, 4}));
  short_wall.bar_depth = 0.78; // now the bar hides what may stand anywhere behind it
  EXPECT_EQ (short_wall.patches (), (std::vector<int>{1, 2}));
}

TEST (CompactClustering, WhatGoesOnBehindAnOccluderHasNoSideSetBack)
{
  // A bar before a front that bends back below a ridge; on the right of the bar the ridge is farther down, so that the fronts are in
  // one plane and the slopes under them 20 / sqrt (2) = 14 mm apart.
  const auto patchesOf = [] (double shift, int certain_size) {
    Frame frame = shapes::emptyFrame (160, 48);
    Image<int> labels (160, 48, 0);
    for (int row = 0; row < 48; ++row)
      for (int column = 0; column < 160; ++column)
      {
        const double x = 0.002 * (column - 79.5), y = 0.002 * (row - 23.5), below = y - (column < 30 ? 0.0 : shift);
        const bool is_bar = column >= 24 && column < 36, is_slope = below > 0.0;
        labels (column, row) = is_bar ? 5 : (column < 30 ? 1 : 3) + is_slope;
        frame.set (frame.index (column, row), {x, y, is_bar ? 0.7 : 0.8 + std::max (0.0, below)},
                   Vector3d (0.0, is_slope && !is_bar ? 1.0 : 0.0, -1.0).normalized ());
      }
    ClusteringParameters parameters;
    parameters.compactness_threshold = 1.0f;
    parameters.join_handles = parameters.join_hollows = false;
    parameters.certain_size = certain_size;
    return (sorted (Case (frame, labels).grow (10, 10, parameters).patches));
  };
  EXPECT_EQ (patchesOf (0.0, 576), (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ (patchesOf (0.02, 200), (std::vector<int>{1, 2}));
  // On the left both have 24 * 24 pixels.
  EXPECT_EQ (patchesOf (0.0, 577), (std::vector<int>{1, 2})) << "too small to show a face that goes on";
}

TEST (CompactClustering, NoiseMayTurnTheEndsOfAFaceBehindAnOccluder)
{
  // A bar before a face of which the ends, 172 mm apart, are turned by so many degrees to either side: at 4 each lies 12 mm off the
  // plane of the other, but none off the plane between them.
  const auto patchesOf = [] (double degrees, double set_back) {
    Frame frame = shapes::emptyFrame (160, 48);
    Image<int> labels (160, 48, 0);
    const double slope = std::tan (degrees * 0.0174533);
    for (int row = 0; row < 48; ++row)
      for (int column = 0; column < 160; ++column)
      {
        const double x = 0.002 * (column - 79.5), y = 0.002 * (row - 23.5), side = column < 80 ? 1.0 : -1.0;
        const bool is_bar = column >= 74 && column < 86;
        labels (column, row) = is_bar ? 3 : column < 80 ? 1 : 2;
        const double z = 0.8 + side * slope * (x + side * 0.086) + (column < 80 ? 0.0 : set_back);
        frame.set (frame.index (column, row), {x, y, is_bar ? 0.7 : z}, Vector3d (is_bar ? 0.0 : side * slope, 0, -1).normalized ());
      }
    ClusteringParameters parameters;
    parameters.compactness_threshold = 1.0f;
    parameters.join_handles = parameters.join_hollows = false;
    return (sorted (Case (frame, labels).grow (10, 10, parameters).patches));
  };
  EXPECT_EQ (patchesOf (4.0, 0.0), (std::vector<int>{1, 2}));
  EXPECT_EQ (patchesOf (-4.0, 0.0), (std::vector<int>{1, 2}));
  EXPECT_EQ (patchesOf (4.0, 0.014), (std::vector<int>{1}));
}

TEST (CompactClustering, OfOtherColorsBehindAnOccluderTwoFacesMustGoOn)
{
  // A bar before a box of two colours, of whose top and front both go on, or before two boxes whose tops alone are in one plane.
  // Left of the bar its shadow is wider than borders are found across.
  constexpr int shadow = 14;
  ASSERT_GT (shadow, PatchGraphParameters ().maximum_gap);
  const auto patchesOf = [] (bool has_front, const Color& color) {
    Frame frame = shapes::emptyFrame (160, 48);
    Image<int> labels (160, 48, 0);
    for (int row = 0; row < 48; ++row)
      for (int column = 0; column < 160; ++column)
      {
        const double x = 0.002 * (column - 79.5), y = 0.002 * (row - 23.5);
        const bool is_bar = column >= 74 && column < 86, is_front = has_front && y > 0.0;
        if (column < 74 && column >= 74 - shadow)
          continue;
        labels (column, row) = is_bar ? 5 : (column < 80 ? 1 : 3) + is_front;
        frame.set (frame.index (column, row), {x, y, is_bar ? 0.7 : is_front ? 0.8 + 2.0 * y : 0.8},
                   Vector3d (0.0, is_front && !is_bar ? 2.0 : 0.0, -1.0).normalized ());
      }
    Case made (frame, labels);
    made.paint ({grey, red, red, color, color, blue});
    ClusteringParameters parameters;
    parameters.compactness_threshold = 1.0f;
    parameters.join_handles = parameters.join_hollows = false;
    return (sorted (made.grow (10, 10, parameters).patches));
  };
  EXPECT_EQ (patchesOf (true, green), (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ (patchesOf (false, green), (std::vector<int>{1}));
  EXPECT_EQ (patchesOf (false, red), (std::vector<int>{1, 3}));
}

TEST (CompactClustering, OtherColorsHaveToBeMoreCompact)
{
  const auto firstStep = [] (const Color& color, const ClusteringParameters& parameters) {
    Case sides = valley ();
    sides.paint ({grey, red, color});
    const AttentionSegment segment = sides.grow (10, 24, parameters);
    EXPECT_FALSE (segment.steps.empty ());
    return (segment.steps.empty () ? GrowthStep () : segment.steps.front ());
  };
  ClusteringParameters parameters = plain ();
  parameters.compactness_threshold = 0.02f; // of which the valley has .0155
  parameters.color_compactness = 0.5f;
  EXPECT_EQ (firstStep (red, parameters).refused_by, GrowthConstraint::none);
  EXPECT_EQ (firstStep (green, parameters).refused_by, GrowthConstraint::compactness);
  EXPECT_FLOAT_EQ (firstStep (green, parameters).limit, 0.01f);
  parameters.color_compactness = 0.0f;
  EXPECT_EQ (firstStep (green, parameters).refused_by, GrowthConstraint::none);
}

TEST (CompactClustering, ConvexityRefusesAConcaveBorder)
{
  ClusteringParameters parameters = plain ();
  parameters.compactness_threshold = 1.0f;
  EXPECT_EQ (valley ().grow (10, 24, parameters).patches.size (), 2u);
  parameters.minimum_convexity = -0.2f;
  const AttentionSegment segment = valley ().grow (10, 24, parameters);
  EXPECT_EQ (segment.patches, (std::vector<int>{1}));
  EXPECT_EQ (segment.growth_end, GrowthConstraint::convexity);
  ASSERT_EQ (segment.steps.size (), 1u);
  // 45 degrees each: normals differ by sqrt (2) across, less along the diagonals.
  EXPECT_LT (segment.steps[0].value, -0.9f);
  EXPECT_GE (segment.steps[0].value, -1.42f);
}

TEST (CompactClustering, StaysOffTheSupport)
{
  ClusteringParameters parameters = plain ();
  parameters.stay_off_support = true;
  const AttentionSegment segment = squaresOnAPlane ().grow (15, 24, parameters, {0, 0, 0, 0, 1});
  EXPECT_EQ (sorted (segment.patches), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ (segment.growth_end, GrowthConstraint::support);
  ASSERT_NE (stepOf (segment, 4), nullptr);
  EXPECT_EQ (stepOf (segment, 4)->refused_by, GrowthConstraint::support);
}

TEST (CompactClustering, StartsWithThePatchesAroundThePoint)
{
  // In the valley, 3 pixels from the crease.
  ClusteringParameters parameters = plain ();
  parameters.initial_radius = 5;
  const AttentionSegment both = valley ().grow (29, 24, parameters);
  EXPECT_EQ (both.patches, (std::vector<int>{1, 2}));
  EXPECT_TRUE (both.steps.empty ());
  parameters.initial_radius = 2;
  EXPECT_EQ (valley ().grow (29, 24, parameters).patches, (std::vector<int>{1}));
  // The safe start leaves out what is concave.
  parameters.initial_radius = 5;
  parameters.initial_patches = InitialPatches::connected;
  EXPECT_EQ (valley ().grow (29, 24, parameters).patches, (std::vector<int>{1}));
}

TEST (CompactClustering, FindsNothingWhereThereIsNoPatch)
{
  Image<int> labels (64, 48, 0);
  for (int row = 20; row < 30; ++row)
    for (int column = 30; column < 40; ++column)
      labels (column, row) = 1;
  const Case scene (shapes::look (shapes::plane ({0, 0, 0.8}, {0, 0, -1})), labels);
  ClusteringParameters parameters = plain ();
  parameters.initial_radius = 5;
  CompactClustering clustering (scene.frame.cloud, estimateSensor (scene.frame.cloud), scene.frame.normals, scene.patches, scene.graph, {}, parameters);
  AttentionPoint point;
  AttentionSegment segment;
  point.column = 24; // 6 pixels beside the patch
  point.row = 25;
  EXPECT_FALSE (growAt (point, clustering, segment));
  EXPECT_TRUE (segment.indices.empty ());
  point.column = 25;
  EXPECT_TRUE (growAt (point, clustering, segment));
  EXPECT_EQ (segment.indices.size (), 100u);
  EXPECT_TRUE (std::is_sorted (segment.indices.begin (), segment.indices.end ()));
  // A radius, not a square: 4 pixels left of its corner and 4 above are too far, 3 and 4 are not.
  point.column = 26;
  point.row = 16;
  EXPECT_FALSE (growAt (point, clustering, segment));
  point.column = 27;
  EXPECT_TRUE (growAt (point, clustering, segment));
}

TEST (CompactClustering, GivesTheSameFromTheSamePointAgain)
{
  const Case scene = valley ();
  CompactClustering clustering (scene.frame.cloud, estimateSensor (scene.frame.cloud), scene.frame.normals, scene.patches, scene.graph, {},
                                ClusteringParameters ());
  AttentionPoint point;
  point.column = 10;
  point.row = 24;
  AttentionSegment first, other, again;
  ASSERT_TRUE (growAt (point, clustering, first));
  point.column = 50;
  ASSERT_TRUE (growAt (point, clustering, other));
  point.column = 10;
  ASSERT_TRUE (growAt (point, clustering, again));
  EXPECT_EQ (first.indices, again.indices);
  EXPECT_EQ (first.compactness, again.compactness);
  EXPECT_NE (first.indices, other.indices);
}

TEST (GrowthConstraints, HaveNames)
{
  EXPECT_STREQ (toString (GrowthConstraint::none), "none");
  EXPECT_STREQ (toString (GrowthConstraint::connection), "connection");
  EXPECT_STREQ (toString (GrowthConstraint::convexity), "convexity");
  EXPECT_STREQ (toString (GrowthConstraint::color), "color");
  EXPECT_STREQ (toString (GrowthConstraint::compactness), "compactness");
  EXPECT_STREQ (toString (GrowthConstraint::support), "support");
}
