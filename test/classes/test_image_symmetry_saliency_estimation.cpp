// SPDX-License-Identifier: BSD-3-Clause
#include "clouds.h"
#include <pcl/segmentation/attention_point_extraction.h>
#include <pcl/segmentation/attention_segmentation.h>
#include <pcl/segmentation/image_symmetry_saliency_estimation.h>
#include <pcl/segmentation/symmetry_saliency_estimation.h>

#include <algorithm>

namespace
{

pcl::PointCloud<pcl::Intensity>
imageSaliency (const Cloud::ConstPtr& cloud)
{
  pcl::ImageSymmetrySaliencyEstimation<PointT> estimation;
  estimation.setInputCloud (cloud);
  pcl::PointCloud<pcl::Intensity> saliency;
  EXPECT_TRUE (estimation.compute (saliency));
  return (saliency);
}

} // namespace

TEST (ImageSymmetrySaliency, isOfTheCloudsSizeAndLooksAtColorsAlone)
{
  const pcl::PointCloud<pcl::Intensity> saliency = imageSaliency (sceneCloud ());
  ASSERT_EQ (saliency.width, sceneCloud ()->width);
  ASSERT_EQ (saliency.height, sceneCloud ()->height);
  float maximum = 0.0f;
  for (const pcl::Intensity& value : saliency)
    maximum = std::max (maximum, value.intensity);
  EXPECT_EQ (maximum, 1.0f);
  const Cloud::Ptr flat (new Cloud (*sceneCloud ()));
  for (PointT& point : *flat)
    point.getVector3fMap () = Eigen::Vector3f (0.0f, 0.0f, 1.0f);
  const pcl::PointCloud<pcl::Intensity> same = imageSaliency (flat);
  for (std::size_t index = 0; index < saliency.size (); ++index)
    ASSERT_EQ (saliency[index].intensity, same[index].intensity);
}

TEST (ImageSymmetrySaliency, needsColors)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ> (64, 48));
  pcl::ImageSymmetrySaliencyEstimation<pcl::PointXYZ> estimation;
  estimation.setInputCloud (cloud);
  pcl::PointCloud<pcl::Intensity> saliency (3, 1);
  const std::string errors = errorsOf ([&] { EXPECT_FALSE (estimation.compute (saliency)); });
  EXPECT_TRUE (contains (errors, "[pcl::ImageSymmetrySaliencyEstimation::compute] The points have no colour."));
  EXPECT_TRUE (saliency.empty ());

  pcl::AttentionSegmentation<pcl::PointXYZ> segmentation;
  pcl_attention::AttentionParameters parameters;
  parameters.attention_points.strategy = pcl_attention::AttentionStrategy::image_winner_take_all;
  segmentation.setParameters (parameters);
  segmentation.setInputCloud (cloud);
  std::vector<pcl::AttentionSegment> segments;
  const std::string refusal = errorsOf ([&] { EXPECT_FALSE (segmentation.segment (segments)); });
  EXPECT_TRUE (contains (refusal, "strategy is image_winner_take_all, which looks at colours, but the points have none"));
}

TEST (ImageSymmetrySaliency, refusesARingWithoutPixels)
{
  pcl::ImageSymmetrySaliencyEstimation<PointT> estimation;
  estimation.setInputCloud (sceneCloud ());
  pcl_attention::ImageSymmetryParameters parameters;
  parameters.inner_radius = 18;
  estimation.setParameters (parameters);
  EXPECT_EQ (estimation.getParameters ().inner_radius, 18);
  pcl::PointCloud<pcl::Intensity> saliency;
  const std::string errors = errorsOf ([&] { EXPECT_FALSE (estimation.compute (saliency)); });
  EXPECT_TRUE (contains (errors, "image_inner_radius is 18, but must not exceed image_outer_radius, which is 17"));
}

TEST (AttentionStrategies, winOnTheMapOfTheirOwn)
{
  pcl::AttentionPointExtraction<PointT> extraction;
  extraction.setInputCloud (sceneCloud ());
  extraction.setStrategy (pcl_attention::AttentionStrategy::image_winner_take_all);
  std::vector<pcl::AttentionPoint> of_image, of_map;
  ASSERT_TRUE (extraction.extract (of_image));
  ASSERT_FALSE (of_image.empty ());
  const auto map = pcl::make_shared<pcl::PointCloud<pcl::Intensity>> (imageSaliency (sceneCloud ()));
  extraction.setStrategy (pcl_attention::AttentionStrategy::winner_take_all);
  extraction.setSaliency (map);
  ASSERT_TRUE (extraction.extract (of_map));
  ASSERT_EQ (of_map.size (), of_image.size ());
  for (std::size_t i = 0; i < of_map.size (); ++i)
  {
    EXPECT_EQ (of_map[i].column, of_image[i].column);
    EXPECT_EQ (of_map[i].row, of_image[i].row);
    EXPECT_EQ (of_map[i].kind, pcl_attention::AttentionPointKind::winner);
  }
}

TEST (AttentionStrategies, keepTheOrderOfTheWinners)
{
  pcl_attention::AttentionParameters parameters = pcl_attention::AttentionParameters::paper ();
  parameters.attention_points.strategy = pcl_attention::AttentionStrategy::winner_take_all;
  pcl::AttentionSegmentation<PointT> segmentation (parameters);
  segmentation.setInputCloud (sceneCloud ());
  std::vector<pcl::AttentionSegment> segments;
  ASSERT_TRUE (segmentation.segment (segments));
  ASSERT_FALSE (segments.empty ());
  for (const pcl::AttentionSegment& segment : segments)
    EXPECT_EQ (segment.attention_point.kind, pcl_attention::AttentionPointKind::winner);

  pcl::SymmetrySaliencyEstimation<PointT> estimation;
  estimation.setInputCloud (sceneCloud ());
  estimation.setParameters (parameters.saliency);
  estimation.setNormalParameters (parameters.normals);
  const auto saliency = pcl::make_shared<pcl::PointCloud<pcl::Intensity>> ();
  ASSERT_TRUE (estimation.compute (*saliency));
  pcl::AttentionPointExtraction<PointT> extraction;
  extraction.setInputCloud (sceneCloud ());
  extraction.setSaliency (saliency);
  extraction.setStrategy (pcl_attention::AttentionStrategy::winner_take_all);
  std::vector<pcl::AttentionPoint> winners;
  ASSERT_TRUE (extraction.extract (winners));
  auto winner = winners.begin ();
  for (const pcl::AttentionSegment& segment : segments)
  {
    winner = std::find_if (winner, winners.end (), [&] (const pcl::AttentionPoint& point) {
      return (point.column == segment.attention_point.column && point.row == segment.attention_point.row);
    });
    ASSERT_NE (winner, winners.end ());
  }
}
