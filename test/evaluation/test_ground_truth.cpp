// SPDX-License-Identifier: BSD-3-Clause
#include "cases.h"

namespace pcl_attention
{
namespace
{

const std::vector<int> labels{20, 20, 21, 1,  //
                              20, 20, 21, 19, //
                              30, 30, 1,  1,  //
                              -1, 0,  1,  1};

TEST (GroundTruth, objectsAreLabelsDividedByTen)
{
  const GroundTruth truth = test::truthOf (4, labels, GroundTruthKind::objects);
  ASSERT_EQ (truth.regions.size (), 2u);
  EXPECT_EQ (truth.regions[0].label, 2u);
  EXPECT_EQ (truth.regions[0].pixels, 6u); // without the point that has label 20 and no coordinates
  EXPECT_EQ (truth.regions[1].label, 3u);
  EXPECT_EQ (truth.regions[1].pixels, 2u);
  const std::vector<int> expected{0, 0, 0, -1, 0, 0, 0, -1, 1, 1, -1, -1, -3, -2, -1, -1};
  EXPECT_EQ (truth.region_of, expected);
}

TEST (GroundTruth, partsAreRawLabels)
{
  const GroundTruth truth = test::truthOf (4, labels, GroundTruthKind::parts);
  ASSERT_EQ (truth.regions.size (), 3u);
  EXPECT_EQ (truth.regions[0].label, 20u);
  EXPECT_EQ (truth.regions[0].pixels, 4u);
  EXPECT_EQ (truth.regions[1].label, 21u);
  EXPECT_EQ (truth.regions[1].pixels, 2u);
  EXPECT_EQ (truth.regions[2].label, 30u);
}

TEST (GroundTruth, theCentreIsThePixelOfTheRegionClosestToItsMean)
{
  const GroundTruth truth = test::truthOf (4, labels);
  // mean (1, 0.5): (1, 0) and (1, 1) are as close, the first is taken
  EXPECT_EQ (truth.regions[0].center_column, 1);
  EXPECT_EQ (truth.regions[0].center_row, 0);

  // a ring around its mean (1, 1), which is not its own: all four neighbours of it are as close, the first is taken
  const GroundTruth bent = test::truthOf (3, {20, 20, 20, 20, 1, 20, 20, 20, 20});
  EXPECT_EQ (bent.regions[0].center_column, 1);
  EXPECT_EQ (bent.regions[0].center_row, 0);
}

TEST (GroundTruth, anyNonFiniteCoordinateMakesAPointInvalid)
{
  auto cloud = test::cloudOf (3, {20, 20, 20});
  cloud[0].x = std::numeric_limits<float>::quiet_NaN ();
  cloud[1].y = std::numeric_limits<float>::infinity ();
  const GroundTruth truth = makeGroundTruth (cloud, GroundTruthKind::objects);
  EXPECT_EQ (truth.region_of, (std::vector<int>{-3, -3, 0}));
  EXPECT_EQ (truth.regions[0].pixels, 1u);
}

TEST (GroundTruth, aSceneWithoutObjectsHasNoRegion)
{
  EXPECT_TRUE (test::truthOf (2, {1, 19, 0, -1}).regions.empty ());
}

TEST (GroundTruth, anEmptyCloudIsRefused)
{
  EXPECT_THROW (makeGroundTruth ({}, GroundTruthKind::objects), std::invalid_argument);
}

} // namespace
} // namespace pcl_attention
