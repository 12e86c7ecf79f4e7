// SPDX-License-Identifier: BSD-3-Clause
#include "clouds.h"
#include <pcl/segmentation/attention_point_extraction.h>

namespace
{

using Map = pcl::PointCloud<pcl::Intensity>;

class PointExtraction : public testing::Test
{
protected:
  void
  SetUp () override
  {
    extraction.setInputCloud (cloud);
  }

  void
  expectError (const std::string& message)
  {
    std::vector<pcl::AttentionPoint> points (2);
    const std::string errors = errorsOf ([&] { EXPECT_FALSE (extraction.extract (points)); });
    EXPECT_TRUE (points.empty ());
    EXPECT_TRUE (contains (errors, "[pcl::AttentionPointExtraction::extract] " + message));
  }

  std::vector<pcl::AttentionPoint>
  extractFrom (const Map::ConstPtr& map)
  {
    extraction.setSaliency (map);
    std::vector<pcl::AttentionPoint> points (2);
    EXPECT_TRUE (extraction.extract (points));
    return (points);
  }

  const Cloud::Ptr cloud = filledCloud (100, 80, 0.0f, 0.0f, 1.0f);
  pcl::AttentionPointExtraction<PointT> extraction;
};

/** \brief A faint cross above, a bright one below, and a faint line at the lower right. */
Map::Ptr
threeComponents ()
{
  const Map::Ptr map = crossMap (100, 80, 30, 20, 0.5f), bright = crossMap (100, 80, 50, 60, 1.0f);
  for (std::size_t index = 0; index < map->size (); ++index)
    (*map)[index].intensity += (*bright)[index].intensity;
  for (int column = 90; column < 96; ++column)
    map->at (column, 75).intensity = 0.12f;
  return (map);
}

} // namespace

TEST_F (PointExtraction, FindsTheJunctionOfACross)
{
  const std::vector<pcl::AttentionPoint> points = extractFrom (crossMap (100, 80, 40, 30));
  ASSERT_EQ (points.size (), 1u);
  EXPECT_EQ (points[0].kind, pcl_attention::AttentionPointKind::junction);
  EXPECT_NEAR (points[0].column, 40, 1);
  EXPECT_NEAR (points[0].row, 30, 1);
  EXPECT_EQ (points[0].saliency, 1.0f);
  EXPECT_EQ (points[0].component, 1);
}

TEST_F (PointExtraction, FindsTheMiddleOfALine)
{
  const Map::Ptr map (new Map (100, 80, pcl::Intensity (0.0f)));
  for (int column = 20; column <= 60; ++column)
    map->at (column, 50).intensity = 0.7f;
  const std::vector<pcl::AttentionPoint> points = extractFrom (map);
  ASSERT_EQ (points.size (), 1u);
  EXPECT_EQ (points[0].kind, pcl_attention::AttentionPointKind::midpoint);
  EXPECT_NEAR (points[0].column, 40, 1);
  EXPECT_EQ (points[0].row, 50);
}

TEST_F (PointExtraction, DescribesItsComponents)
{
  extraction.setComponentThreshold (0.2f);
  const std::vector<pcl::AttentionPoint> points = extractFrom (threeComponents ());
  ASSERT_EQ (points.size (), 2u) << "one is under theta_sal";
  EXPECT_EQ (points[0].component, 2) << "the brightest comes first";
  EXPECT_EQ (points[1].component, 1);

  const pcl::PointCloud<pcl::Label> components = extraction.getComponents ();
  ASSERT_EQ (components.width, 100u);
  ASSERT_EQ (components.height, 80u);
  EXPECT_EQ (components.at (30, 20).label, 1u);
  EXPECT_EQ (components.at (50, 60).label, 2u);
  EXPECT_EQ (components.at (92, 75).label, 3u);
  EXPECT_EQ (components.at (0, 0).label, 0u);

  const std::vector<float> means = extraction.getMeanSaliency ();
  ASSERT_EQ (means.size (), 3u);
  EXPECT_FLOAT_EQ (means[0], 0.5f);
  EXPECT_FLOAT_EQ (means[1], 1.0f);
  EXPECT_FLOAT_EQ (means[2], 0.12f);
}

TEST_F (PointExtraction, GivesASkeletonForEveryValidComponent)
{
  extraction.setComponentThreshold (0.2f);
  const std::vector<pcl::AttentionPoint> points = extractFrom (threeComponents ());
  const std::vector<pcl::PointIndices> skeletons = extraction.getSkeletons ();
  const pcl::PointCloud<pcl::Label> components = extraction.getComponents ();
  ASSERT_EQ (skeletons.size (), 2u);
  for (std::size_t k = 0; k < skeletons.size (); ++k)
  {
    ASSERT_GT (skeletons[k].indices.size (), 20u);
    for (const pcl::index_t index : skeletons[k].indices)
      EXPECT_EQ (components[index].label, k + 1);
  }
  ASSERT_EQ (points.size (), 2u);
  for (const pcl::AttentionPoint& point : points)
  {
    const pcl::Indices& line = skeletons[point.component - 1].indices;
    EXPECT_TRUE (std::binary_search (line.begin (), line.end (), indexOf (point, *cloud)));
  }
}

TEST_F (PointExtraction, UsesItsThresholds)
{
  extraction.setComponentThreshold (0.6f);
  EXPECT_EQ (extractFrom (threeComponents ()).size (), 1u);
  extraction.setComponentThreshold (0.1f);
  extraction.setPixelThreshold (0.6f);
  EXPECT_EQ (extractFrom (threeComponents ()).size (), 1u);
  EXPECT_EQ (extraction.getMeanSaliency ().size (), 1u);
  extraction.setPixelThreshold (0.0f);
  EXPECT_EQ (extractFrom (threeComponents ()).size (), 3u);
  extraction.setMinimumSkeletonLength (10);
  EXPECT_EQ (extractFrom (threeComponents ()).size (), 2u);
}

TEST_F (PointExtraction, TakesAllJunctionsOrOne)
{
  const Map::Ptr map = crossMap (100, 80, 40, 40), other = crossMap (100, 80, 60, 40);
  for (std::size_t index = 0; index < map->size (); ++index)
    (*map)[index].intensity = std::max ((*map)[index].intensity, (*other)[index].intensity);
  EXPECT_EQ (extractFrom (map).size (), 2u);
  extraction.setAllJunctions (false);
  EXPECT_EQ (extractFrom (map).size (), 1u);
  extraction.setAllJunctions (true);
  extraction.setJunctionMergeRadius (50.0f);
  EXPECT_EQ (extractFrom (map).size (), 1u);
}

TEST_F (PointExtraction, LooksOnlyWhereThereAreValidPoints)
{
  for (int row = 20; row <= 40; ++row)
    for (int column = 35; column <= 45; ++column)
      cloud->at (column, row).z = nan_value;
  const std::vector<pcl::AttentionPoint> points = extractFrom (crossMap (100, 80, 40, 30));
  ASSERT_EQ (points.size (), 1u);
  EXPECT_TRUE (pcl::isFinite (cloud->at (points[0].column, points[0].row)));
}

TEST_F (PointExtraction, NeedsASaliencyMap)
{
  expectError ("No saliency map: call setSaliency first");
  EXPECT_EQ (extractFrom (crossMap (100, 80, 40, 30)).size (), 1u);
  extraction.setSaliency (nullptr);
  expectError ("No saliency map: call setSaliency first");
}

TEST_F (PointExtraction, RefusesAMapOfAnotherSize)
{
  extraction.setSaliency (crossMap (80, 100, 40, 30));
  expectError ("The saliency map is 80 x 100 with 8000 values, but the input cloud is 100 x 80");
  const Map::Ptr map (new Map (100, 80));
  map->points.resize (100);
  extraction.setSaliency (map);
  expectError ("The saliency map is 100 x 80 with 100 values");
}

TEST_F (PointExtraction, TakesUnknownSaliencyForNone)
{
  const Map::Ptr map = crossMap (100, 80, 40, 30);
  const std::vector<pcl::AttentionPoint> before = extractFrom (map);
  for (pcl::Intensity& value : *map)
    if (value.intensity == 0.0f)
      value.intensity = nan_value;
  const std::vector<pcl::AttentionPoint> after = extractFrom (map);
  ASSERT_EQ (after.size (), 1u);
  EXPECT_EQ (indexOf (after[0], *cloud), indexOf (before[0], *cloud));
  EXPECT_TRUE (extractFrom (Map::Ptr (new Map (100, 80, pcl::Intensity (nan_value)))).empty ());
  EXPECT_TRUE (extractFrom (Map::Ptr (new Map (100, 80, pcl::Intensity (0.0f)))).empty ());
}

TEST_F (PointExtraction, RefusesNegativeAndInfiniteSaliency)
{
  const Map::Ptr map = crossMap (100, 80, 40, 30);
  map->at (7, 3).intensity = -0.5f;
  extraction.setSaliency (map);
  expectError ("The saliency at column 7, row 3 is -0.500000: give finite values from 0 up");
  map->at (7, 3).intensity = std::numeric_limits<float>::infinity ();
  expectError ("The saliency at column 7, row 3 is inf: give finite values from 0 up");
}

TEST_F (PointExtraction, KeepsTheUnitsOfTheMap)
{
  const std::vector<pcl::AttentionPoint> points = extractFrom (crossMap (100, 80, 40, 30, 255.0f));
  ASSERT_EQ (points.size (), 1u);
  EXPECT_EQ (points[0].saliency, 255.0f);
}

TEST_F (PointExtraction, RefusesAStrategyThatDoesNotExist)
{
  extraction.setSaliency (crossMap (100, 80, 40, 30));
  extraction.setStrategy (static_cast<pcl_attention::AttentionStrategy> (99));
  expectError ("Bad parameter: strategy is 99, but must be one of");
}

TEST_F (PointExtraction, HasNoStaleResults)
{
  extractFrom (crossMap (100, 80, 40, 30));
  EXPECT_FALSE (extraction.getComponents ().empty ());
  extraction.setInputCloud (filledCloud (64, 48, 0.0f, 0.0f, 1.0f));
  EXPECT_TRUE (extraction.getComponents ().empty ());
  EXPECT_TRUE (extraction.getSkeletons ().empty ());
  EXPECT_TRUE (extraction.getMeanSaliency ().empty ());
  expectError ("The saliency map is 100 x 80");
  EXPECT_TRUE (extraction.getComponents ().empty ());
}

TEST_F (PointExtraction, SetsEveryParameter)
{
  extraction.setStrategy (pcl_attention::AttentionStrategy::symmetry_lines);
  extraction.setPixelThreshold (0.3f);
  extraction.setComponentThreshold (0.4f);
  extraction.setAllJunctions (false);
  extraction.setJunctionMergeRadius (5.0f);
  extraction.setMinimumSkeletonLength (6);
  extraction.setWinnerCellSize (7);
  extraction.setInhibitionWidth (0.8f);
  EXPECT_EQ (extraction.getStrategy (), pcl_attention::AttentionStrategy::symmetry_lines);
  EXPECT_EQ (extraction.getPixelThreshold (), 0.3f);
  EXPECT_EQ (extraction.getComponentThreshold (), 0.4f);
  EXPECT_FALSE (extraction.getAllJunctions ());
  EXPECT_EQ (extraction.getJunctionMergeRadius (), 5.0f);
  EXPECT_EQ (extraction.getMinimumSkeletonLength (), 6);
  EXPECT_EQ (extraction.getWinnerCellSize (), 7);
  EXPECT_EQ (extraction.getInhibitionWidth (), 0.8f);
}

TEST_F (PointExtraction, PutsWhatIsAskedForFirst)
{
  const Map::Ptr map = crossMap (100, 80, 25, 20);
  const Map::Ptr faint = crossMap (100, 80, 75, 60, 0.05f);
  for (std::size_t index = 0; index < map->size (); ++index)
    (*map)[index].intensity += (*faint)[index].intensity;
  ASSERT_EQ (extractFrom (map).size (), 1u);
  pcl_attention::AttentionPrior prior;
  prior.region = pcl_attention::PixelRegion{50, 40, 50, 40};
  extraction.setAttentionPrior (prior);
  const std::vector<pcl::AttentionPoint> points = extractFrom (map);
  ASSERT_EQ (points.size (), 2u);
  EXPECT_NEAR (points[0].column, 75, 1);
  EXPECT_NEAR (points[1].column, 25, 1);
  EXPECT_LT (points[1].weight, points[0].weight);
}
