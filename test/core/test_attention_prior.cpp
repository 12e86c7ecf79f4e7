// SPDX-License-Identifier: BSD-3-Clause
// What is asked for: weights by hand.
#include <pcl_attention/core/attention_prior.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace pcl_attention;

namespace
{

/** \brief 4 x 2 pixels: patch 1 in the two columns on the left, patch 2 right of it, none in the last column. */
struct Scene
{
  OrganizedCloud cloud;
  PlanarPatches patches;
  std::vector<int> pieces{0, 1, 2};

  Scene ()
  {
    cloud.reset (4, 2);
    cloud.red.assign (8, 200);
    cloud.green.assign (8, 30);
    cloud.blue.assign (8, 30);
    patches.labels.assign (4, 2, 0);
    patches.patches.resize (2);
    for (int index = 0; index < 8; ++index)
    {
      const int column = index % 4, row = index / 4;
      cloud.x[index] = 0.1f * static_cast<float> (column);
      cloud.y[index] = 0.01f * static_cast<float> (row);
      cloud.z[index] = 1.0f;
      cloud.valid[index] = 1;
      patches.labels[index] = column < 2 ? 1 : column == 2 ? 2 : 0;
      if (patches.labels[index] > 0)
        patches.patches[patches.labels[index] - 1].pixels.push_back (index);
    }
  }

  Image<float>
  weights (const AttentionPrior& prior, const Eigen::Isometry3f& pose = Eigen::Isometry3f::Identity ()) const
  {
    return (priorWeights (cloud, patches, pieces, pose, prior));
  }
};

std::vector<float>
firstRow (const Image<float>& image)
{
  return {image.data.begin (), image.data.begin () + image.width};
}

using Row = std::vector<float>;

} // namespace

TEST (PriorWeights, OfAMapAreTheMeansOfPiecesAndTheFloorElsewhere)
{
  AttentionPrior prior;
  prior.map.assign (4, 2, 0.0f);
  prior.map.data = {1.0f, 0.5f, 0.0f, 0.25f, 0.5f, 0.0f, 0.0f, 0.0f};
  // Patch 1: (1 + .5 + .5 + 0) / 4. The last column has no piece and keeps its own.
  EXPECT_EQ (Scene ().weights (prior).data, (Row{0.5f, 0.5f, 0.01f, 0.25f, 0.5f, 0.5f, 0.01f, 0.01f}));
  prior.floor = 0.3f;
  EXPECT_EQ (firstRow (Scene ().weights (prior)), (Row{0.5f, 0.5f, 0.3f, 0.3f}));
}

TEST (PriorWeights, AreExactlyOneWhereAllIsAskedFor)
{
  AttentionPrior prior;
  prior.map.assign (4, 2, 1.0f);
  prior.region = PixelRegion{0, 0, 4, 2};
  prior.distance = ValueRange{0.0f, 10.0f};
  EXPECT_EQ (Scene ().weights (prior).data, Row (8, 1.0f));
}

TEST (PriorWeights, OfARegionAreTheShareOfThePieceInIt)
{
  AttentionPrior prior;
  prior.region = PixelRegion{1, -5, 2, 6}; // row 0, columns 1 and 2
  EXPECT_EQ (Scene ().weights (prior).data, (Row{0.25f, 0.25f, 0.5f, 0.01f, 0.25f, 0.25f, 0.5f, 0.01f}));
}

TEST (PriorWeights, OfADistanceAreFromTheViewpoint)
{
  AttentionPrior prior;
  // sqrt (1 + .01) = 1.005 at column 1, sqrt (1 + .04) = 1.0198 at column 2
  prior.distance = ValueRange{1.003f, 1.015f};
  EXPECT_EQ (firstRow (Scene ().weights (prior)), (Row{0.5f, 0.5f, 0.01f, 0.01f}));
}

TEST (PriorWeights, OfABoxAreInTheFrameOfTheCloud)
{
  AttentionPrior prior;
  prior.box = Eigen::AlignedBox3f (Eigen::Vector3f (0.15f, -1.0f, 0.9f), Eigen::Vector3f (0.25f, 1.0f, 1.1f));
  EXPECT_EQ (firstRow (Scene ().weights (prior)), (Row{0.01f, 0.01f, 1.0f, 0.01f}));
  Eigen::Isometry3f pose = Eigen::Isometry3f::Identity ();
  pose.translation ().x () = 0.1f;
  EXPECT_EQ (firstRow (Scene ().weights (prior, pose)), (Row{0.5f, 0.5f, 0.01f, 0.01f}));
}

TEST (PriorWeights, OfASizeFallWithTheSquareOfTheRatioOfLengths)
{
  const Scene scene;
  EXPECT_NEAR (longestSide (scene.cloud, {0, 1, 2, 3}), 0.3f, 1e-6);
  EXPECT_EQ (longestSide (scene.cloud, {}), 0.0f);
  AttentionPrior prior;
  // Piece 1 is sqrt (.1^2 + .01^2) long at most, along its first axis; piece 2 has two points 1 cm apart.
  prior.size = ValueRange{0.09f, 0.12f};
  Image<float> weights = scene.weights (prior);
  EXPECT_EQ (weights[0], 1.0f);
  EXPECT_NEAR (weights[2], std::pow (0.01f / 0.09f, 2.0f), 1e-5);
  EXPECT_EQ (weights[3], 0.01f) << "what is no piece has no size";
  prior.size = ValueRange{0.0f, 0.05f};
  weights = scene.weights (prior);
  EXPECT_NEAR (weights[0], std::pow (0.05f / longestSide (scene.cloud, {0, 1, 4, 5}), 2.0f), 1e-5);
  EXPECT_EQ (weights[2], 1.0f);
}

TEST (PriorWeights, OfAColourAreHowAlikeItIs)
{
  EXPECT_EQ (colorSimilarity ({10, 20, 30}, {10, 20, 30}, 20.0f), 1.0f);
  // Black and white differ by 100 in lightness alone, which counts half: 1 / (1 + (50 / 20)^2).
  EXPECT_NEAR (colorSimilarity ({0, 0, 0}, {255, 255, 255}, 20.0f), 1.0 / 7.25, 1e-3);
  EXPECT_NEAR (colorSimilarity ({0, 0, 0}, {255, 255, 255}, 50.0f), 0.5, 1e-3);
  Scene scene;
  scene.cloud.blue[2] = scene.cloud.blue[6] = 200;
  AttentionPrior prior;
  prior.color = {200, 30, 30};
  const Image<float> weights = scene.weights (prior);
  EXPECT_EQ (weights[0], 1.0f);
  EXPECT_EQ (weights[2], colorSimilarity ({200, 30, 30}, {200, 30, 200}, prior.color_tolerance));
  EXPECT_LT (weights[2], 0.1f);
}

TEST (PriorWeights, OfAnExemplarAreBySquaredChiSquareOfThePiece)
{
  Scene scene;
  scene.cloud.blue[2] = scene.cloud.blue[6] = 200;
  AttentionPrior prior;
  prior.color_exemplar.emplace ();
  prior.color_exemplar->add (colorBin (200, 30, 30), 3.0f);
  EXPECT_EQ (firstRow (scene.weights (prior)), (Row{1.0f, 1.0f, 0.01f, 0.01f}));
  // Shares (1, 0) and (1/2, 1/2): chi-square 1/2 (1/4 / (3/2) + 1/2) = 1/3, and (0, 1) the same.
  prior.color_exemplar->add (colorBin (200, 30, 200), 3.0f);
  EXPECT_NEAR (scene.weights (prior)[0], 4.0 / 9.0, 1e-5);
  EXPECT_NEAR (scene.weights (prior)[2], 4.0 / 9.0, 1e-5);
}

TEST (PriorWeights, OfSeveralPartsMultiply)
{
  AttentionPrior prior;
  prior.map.assign (4, 2, 0.5f);
  prior.region = PixelRegion{0, 0, 1, 2};
  EXPECT_EQ (firstRow (Scene ().weights (prior)), (Row{0.25f, 0.25f, 0.01f, 0.01f}));
}

TEST (GroupPatches, JoinsWhatIsConnectedWithoutACrease)
{
  PlanarPatches patches;
  patches.patches.resize (5);
  PatchGraph graph;
  const auto border = [&] (int first, int second, int connected, double convexity) {
    PatchBorder& added = graph.borders[{first, second}];
    added.pairs = 100;
    added.connected = connected;
    added.convexity_pairs = 10;
    added.convexity_sum = 10 * convexity;
  };
  border (1, 2, 90, 0.5);  // a box's edge
  border (2, 3, 90, -0.8); // a crease
  border (3, 4, 10, 0.5);  // a step in depth
  border (4, 5, 90, 0.5);
  EXPECT_EQ (groupPatches (patches, graph, {}), (std::vector<int>{0, 1, 1, 2, 3, 3}));
  EXPECT_EQ (groupPatches (patches, graph, {0, 0, 0, 0, 0, 1}), (std::vector<int>{0, 1, 1, 2, 3, 0}));
}

TEST (WeightedAttentionPoints, AreThoseOfTheMapUnderEqualWeights)
{
  Image<float> saliency (60, 40, 0.0f);
  for (int column = 5; column < 20; ++column)
    saliency (column, 10) = 0.9f;
  for (int column = 30; column < 50; ++column)
    saliency (column, 30) = 0.3f;
  const std::vector<std::uint8_t> valid (saliency.size (), 1);
  AttentionPoints plain, weighted;
  extractAttentionPoints (saliency, valid, {}, plain);
  extractAttentionPoints (saliency, Image<float> (60, 40, 1.0f), valid, {}, weighted);
  ASSERT_EQ (plain.points.size (), 2u);
  ASSERT_EQ (weighted.points.size (), 2u);
  for (int k = 0; k < 2; ++k)
  {
    EXPECT_EQ (weighted.points[k].column, plain.points[k].column);
    EXPECT_EQ (weighted.points[k].row, plain.points[k].row);
    EXPECT_EQ (weighted.points[k].saliency, plain.points[k].saliency);
    EXPECT_EQ (weighted.points[k].point_saliency, plain.points[k].point_saliency);
    EXPECT_EQ (weighted.points[k].component, plain.points[k].component);
    EXPECT_EQ (weighted.points[k].weight, 1.0f);
  }
}

TEST (WeightedAttentionPoints, FindWhatIsTooFaintWithoutAndLoseNothing)
{
  Image<float> saliency (60, 40, 0.0f), weights (60, 40, 0.01f);
  for (int column = 5; column < 20; ++column)
    saliency (column, 10) = 1.0f;
  for (int column = 30; column < 50; ++column)
    saliency (column, 30) = 0.05f; // under the pixel threshold
  for (int row = 20; row < 40; ++row)
    for (int column = 0; column < 60; ++column)
      weights (column, row) = 1.0f;
  const std::vector<std::uint8_t> valid (saliency.size (), 1);
  AttentionPoints plain, weighted;
  extractAttentionPoints (saliency, valid, {}, plain);
  ASSERT_EQ (plain.points.size (), 1u);
  extractAttentionPoints (saliency, weights, valid, {}, weighted);
  ASSERT_EQ (weighted.points.size (), 2u);
  EXPECT_EQ (weighted.points[0].row, 30);
  EXPECT_FLOAT_EQ (weighted.points[0].saliency, 0.05f);
  EXPECT_EQ (weighted.points[1].row, 10);
  EXPECT_FLOAT_EQ (weighted.points[1].saliency, 0.01f);
  EXPECT_EQ (weighted.points[1].weight, 0.01f);
}

TEST (SortByWeight, LeavesTheOrderWithinAStep)
{
  std::vector<AttentionPoint> points (6);
  const float weights[] = {0.3f, 0.75f, 1.0f, 0.01f, 0.6f, 0.72f};
  for (int k = 0; k < 6; ++k)
  {
    points[k].column = k;
    points[k].weight = weights[k];
  }
  sortByWeight (points);
  std::vector<int> order;
  for (const AttentionPoint& point : points)
    order.push_back (point.column);
  EXPECT_EQ (order, (std::vector<int>{1, 2, 5, 4, 0, 3}));
}

TEST (ValidatePrior, SaysWhatIsWrong)
{
  const auto problem = [] (const AttentionPrior& prior, bool has_color = true) { return (validate (prior, 4, 2, has_color)); };
  EXPECT_EQ (problem (AttentionPrior ()), "");
  EXPECT_TRUE (AttentionPrior ().empty ());
  AttentionPrior prior;
  prior.map.assign (3, 2, 1.0f);
  EXPECT_NE (problem (prior).find ("3 x 2, but the cloud is 4 x 2"), std::string::npos);
  for (const float bad : {-0.1f, 1.1f, std::numeric_limits<float>::quiet_NaN ()})
  {
    prior.map.assign (4, 2, bad);
    EXPECT_NE (problem (prior).find ("from 0 to 1"), std::string::npos) << bad;
  }
  prior = AttentionPrior ();
  prior.color = {1, 2, 3};
  EXPECT_EQ (problem (prior), "");
  EXPECT_NE (problem (prior, false).find ("colour"), std::string::npos);
  prior.color_tolerance = 0.0f;
  EXPECT_NE (problem (prior).find ("tolerance"), std::string::npos);
  prior = AttentionPrior ();
  prior.color_exemplar.emplace ();
  EXPECT_NE (problem (prior).find ("no pixels"), std::string::npos);
  prior = AttentionPrior ();
  for (const ValueRange& bad : {ValueRange{0.2f, 0.1f}, ValueRange{-1.0f, 0.1f},
                                ValueRange{std::numeric_limits<float>::quiet_NaN (), 1.0f}})
  {
    prior.size = bad;
    EXPECT_NE (problem (prior).find ("the size of the prior"), std::string::npos);
    prior.size.reset ();
    prior.distance = bad;
    EXPECT_NE (problem (prior).find ("the distance of the prior"), std::string::npos);
    prior.distance.reset ();
  }
  for (const PixelRegion& bad : {PixelRegion{0, 0, 0, 1}, PixelRegion{4, 0, 1, 1}, PixelRegion{-3, 0, 3, 1}, PixelRegion{0, 2, 1, 1}})
  {
    prior.region = bad;
    EXPECT_NE (problem (prior).find ("the region of the prior"), std::string::npos);
  }
  prior = AttentionPrior ();
  prior.box.emplace ();
  EXPECT_NE (problem (prior).find ("box"), std::string::npos);
  prior = AttentionPrior ();
  prior.floor = 0.0f;
  EXPECT_NE (problem (prior).find ("floor"), std::string::npos);
}
