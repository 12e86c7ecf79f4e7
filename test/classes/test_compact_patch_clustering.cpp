// SPDX-License-Identifier: BSD-3-Clause
#include "clouds.h"
#include <pcl/segmentation/compact_patch_clustering.h>
#include <pcl/segmentation/planar_patch_extraction.h>

namespace
{

using Labels = pcl::PointCloud<pcl::Label>;

class Clustering : public testing::Test
{
protected:
  void
  SetUp () override
  {
    clustering.setInputCloud (sceneCloud ());
  }

  std::vector<pcl::AttentionSegment>
  segment ()
  {
    std::vector<pcl::AttentionSegment> segments (2);
    EXPECT_TRUE (clustering.segment (segments));
    return (segments);
  }

  void
  expectError (const std::string& message)
  {
    std::vector<pcl::AttentionSegment> segments (2);
    const std::string errors = errorsOf ([&] { EXPECT_FALSE (clustering.segment (segments)); });
    EXPECT_TRUE (segments.empty ());
    EXPECT_TRUE (contains (errors, "[pcl::CompactPatchClustering::segment] " + message));
  }

  /** \brief The scene's patches as labels. */
  static Labels::Ptr
  scenePatches (const pcl_attention::PatchParameters& parameters = {})
  {
    pcl::PlanarPatchExtraction<PointT> extraction;
    extraction.setParameters (parameters);
    extraction.setInputCloud (sceneCloud ());
    std::vector<pcl::PointIndices> patches;
    EXPECT_TRUE (extraction.extract (patches));
    return (Labels::Ptr (new Labels (extraction.getLabels ())));
  }

  /** \brief Fixations on the scene's objects. */
  static std::vector<pcl::AttentionPoint>
  scenePoints ()
  {
    pcl::CompactPatchClustering<PointT> other;
    other.setInputCloud (sceneCloud ());
    std::vector<pcl::AttentionSegment> segments;
    errorsOf ([&] { EXPECT_TRUE (other.segment (segments)); });
    std::vector<pcl::AttentionPoint> points;
    for (const pcl::AttentionSegment& segment : segments)
      points.push_back (segment.attention_point);
    EXPECT_GE (points.size (), 3u);
    return (points);
  }

  pcl::CompactPatchClustering<PointT> clustering;
};

} // namespace

TEST_F (Clustering, GrowsASegmentFromEveryPointInTheirOrder)
{
  std::vector<pcl::AttentionPoint> points = scenePoints ();
  std::reverse (points.begin (), points.end ());
  points.push_back (points.front ());
  clustering.setAttentionPoints (points);
  const std::vector<pcl::AttentionSegment> segments = segment ();
  ASSERT_EQ (segments.size (), points.size ());
  for (std::size_t k = 0; k < segments.size (); ++k)
  {
    EXPECT_EQ (segments[k].rank, static_cast<int> (k) + 1);
    EXPECT_EQ (segments[k].attention_point.column, points[k].column);
    EXPECT_EQ (segments[k].attention_point.row, points[k].row);
    EXPECT_FALSE (segments[k].indices.empty ());
    EXPECT_TRUE (std::is_sorted (segments[k].indices.begin (), segments[k].indices.end ()));
  }
  EXPECT_EQ (segments.front ().indices, segments.back ().indices) << "the same point again";
}

TEST_F (Clustering, GrowsFromOnePoint)
{
  const std::vector<pcl::AttentionPoint> points = scenePoints ();
  clustering.setAttentionPoints (points);
  const std::vector<pcl::AttentionSegment> segments = segment ();
  ASSERT_EQ (segments.size (), points.size ());
  pcl::CompactPatchClustering<PointT> other;
  other.setInputCloud (sceneCloud ());
  for (std::size_t k = 0; k < points.size (); ++k)
  {
    pcl::AttentionSegment one;
    ASSERT_TRUE (other.segment (points[k], one));
    EXPECT_EQ (one.rank, 0);
    one.rank = segments[k].rank;
    expectSame (one, segments[k]);
  }
}

TEST_F (Clustering, SaysHowManyPointsItSkips)
{
  const Cloud::Ptr cloud (new Cloud (*sceneCloud ()));
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 40; ++column)
      cloud->at (column, row).getVector3fMap ().setConstant (nan_value);
  clustering.setInputCloud (cloud);
  std::vector<pcl::AttentionPoint> points = scenePoints ();
  points.resize (1);
  points.insert (points.begin (), {pointAt (5, 5), pointAt (10, 20)});
  clustering.setAttentionPoints (points);
  std::vector<pcl::AttentionSegment> segments;
  const std::string errors = errorsOf ([&] { segments = segment (); });
  EXPECT_TRUE (contains (errors, "[pcl::CompactPatchClustering::segment] 2 of 3 attention points skipped"));
  ASSERT_EQ (segments.size (), 1u);
  EXPECT_EQ (segments[0].rank, 1);

  pcl::AttentionSegment one;
  one.indices = {1, 2, 3};
  EXPECT_FALSE (clustering.segment (pointAt (5, 5), one));
  EXPECT_TRUE (one.indices.empty ());
}

TEST_F (Clustering, TakesNoPointsForAnAnswer)
{
  const std::size_t extracted = segment ().size ();
  clustering.setAttentionPoints ({});
  EXPECT_TRUE (segment ().empty ());
  clustering.clearAttentionPoints ();
  EXPECT_EQ (segment ().size (), extracted);
}

TEST_F (Clustering, RefusesPointsOutsideTheImage)
{
  for (const auto& [column, row] : {std::pair<int, int>{-1, 5}, {320, 5}, {5, -1}, {5, 240}})
  {
    const std::string message = "The pixel (" + std::to_string (column) + ", " + std::to_string (row) +
                                ") lies outside the input cloud of 320 x 240 points";
    clustering.setAttentionPoints ({pointAt (100, 100), pointAt (column, row)});
    expectError (message);
    clustering.clearAttentionPoints ();
    pcl::AttentionSegment one;
    one.indices = {1, 2, 3};
    const std::string errors = errorsOf ([&, point = pointAt (column, row)] { EXPECT_FALSE (clustering.segment (point, one)); });
    EXPECT_TRUE (contains (errors, message));
    EXPECT_TRUE (one.indices.empty ());
  }
}

TEST_F (Clustering, RefusesPointsOfUnknownSaliency)
{
  pcl::AttentionPoint point = pointAt (100, 100);
  point.saliency = nan_value;
  clustering.setAttentionPoints ({point});
  expectError ("The saliency of the attention point at (100, 100) is not finite");
}

TEST_F (Clustering, RefusesPatchesOfAnotherSize)
{
  clustering.setPatches (Labels::Ptr (new Labels (240, 320)));
  expectError ("The image of patch labels is 240 x 320 with 76800 values, but the input cloud is 320 x 240");
  clustering.setPatches (nullptr);
  EXPECT_FALSE (segment ().empty ());
}

TEST_F (Clustering, SegmentsJustThePatchItIsGiven)
{
  const pcl::AttentionPoint point = scenePoints ().front ();
  const Labels::Ptr labels (new Labels (320, 240));
  pcl::Indices rectangle;
  for (int row = point.row - 6; row <= point.row + 6; ++row)
    for (int column = point.column - 8; column <= point.column + 8; ++column)
    {
      labels->at (column, row).label = 42;
      if (pcl::isFinite (sceneCloud ()->at (column, row)))
        rectangle.push_back (row * 320 + column);
    }
  pcl_attention::ClusteringParameters parameters;
  parameters.stay_off_support = false;
  parameters.contour_width = 0;
  clustering.setParameters (parameters);
  EXPECT_FALSE (clustering.getParameters ().stay_off_support);
  clustering.setPatches (labels);
  clustering.setAttentionPoints ({point});
  const std::vector<pcl::AttentionSegment> segments = segment ();
  ASSERT_EQ (segments.size (), 1u);
  EXPECT_EQ (segments[0].indices, rectangle);
  EXPECT_EQ (segments[0].patches, std::vector<int>{42});
}

TEST_F (Clustering, DropsLabelsOfMaskedPoints)
{
  const Labels::Ptr labels = scenePatches ();
  for (pcl::Label& label : *labels)
    label.label += 1;
  const pcl::IndicesPtr indices = middleIndices (*sceneCloud ());
  clustering.setPatches (labels);
  clustering.setIndices (indices);
  const std::vector<pcl::AttentionSegment> segments = segment ();
  EXPECT_FALSE (segments.empty ());
  for (const pcl::AttentionSegment& segment : segments)
    EXPECT_TRUE (std::includes (indices->begin (), indices->end (), segment.indices.begin (), segment.indices.end ()));
}

TEST_F (Clustering, ExtractsTheSamePatchesItWouldBeGiven)
{
  const std::vector<pcl::AttentionPoint> points = scenePoints ();
  clustering.setAttentionPoints (points);
  // Given patches are cut along the table's plane, others are grown beside it: what is small is left over at another time.
  pcl_attention::PatchParameters parameters;
  parameters.minimum_size = 9;
  clustering.setPatchParameters (parameters);
  const std::vector<pcl::AttentionSegment> extracted = segment ();
  clustering.setPatches (scenePatches (parameters));
  const std::vector<pcl::AttentionSegment> given = segment ();
  ASSERT_EQ (given.size (), extracted.size ());
  for (std::size_t k = 0; k < given.size (); ++k)
    EXPECT_EQ (given[k].indices, extracted[k].indices);
}

TEST_F (Clustering, NamesPatchesByTheLabelsItWasGiven)
{
  clustering.setAttentionPoints (scenePoints ());
  const Labels::Ptr labels = scenePatches (), renamed (new Labels (*labels));
  // Spread over all values a label can have, in the same order.
  const auto name = [] (std::uint32_t label) { return (label == 0 ? 0 : 4294967295u - (1000u - label) * 3000000u); };
  for (pcl::Label& label : *renamed)
    label.label = name (label.label);
  clustering.setPatches (labels);
  const std::vector<pcl::AttentionSegment> plain = segment ();
  clustering.setPatches (renamed);
  const std::vector<pcl::AttentionSegment> spread = segment ();
  ASSERT_EQ (spread.size (), plain.size ());
  for (std::size_t k = 0; k < plain.size (); ++k)
  {
    EXPECT_EQ (spread[k].indices, plain[k].indices);
    ASSERT_EQ (spread[k].patches.size (), plain[k].patches.size ());
    for (std::size_t patch = 0; patch < plain[k].patches.size (); ++patch)
    {
      const auto label = static_cast<std::uint32_t> (spread[k].patches[patch]);
      EXPECT_EQ (label, name (static_cast<std::uint32_t> (plain[k].patches[patch])));
    }
    ASSERT_EQ (spread[k].steps.size (), plain[k].steps.size ());
    for (std::size_t step = 0; step < plain[k].steps.size (); ++step)
      EXPECT_EQ (static_cast<std::uint32_t> (spread[k].steps[step].patch),
                 name (static_cast<std::uint32_t> (plain[k].steps[step].patch)));
  }
}

TEST_F (Clustering, SurvivesAPatchForEveryPoint)
{
  const Cloud::Ptr cloud = renderCloud (pcl_attention::SceneKind::single_box, 1, 40, 30);
  const Labels::Ptr labels (new Labels (40, 30));
  for (std::size_t index = 0; index < labels->size (); ++index)
    (*labels)[index].label = static_cast<std::uint32_t> ((index * 2654435761u) % 4294967296u);
  clustering.setInputCloud (cloud);
  clustering.setPatches (labels);
  clustering.setAttentionPoints ({pointAt (20, 15)});
  segment ();
}

TEST_F (Clustering, UsesItsParameters)
{
  clustering.setAttentionPoints (scenePoints ());
  const auto pixels = [this] {
    std::size_t sum = 0;
    for (const pcl::AttentionSegment& segment : segment ())
      sum += segment.indices.size ();
    return (sum);
  };
  const std::size_t standard = pixels ();
  pcl_attention::ClusteringParameters parameters;
  parameters.compactness_threshold = 0.0f;
  parameters.visiblePieces ();
  clustering.setParameters (parameters);
  EXPECT_LT (pixels (), standard);
  clustering.setParameters ({});
  pcl_attention::PatchParameters patches;
  patches.minimum_size = 2000;
  patches.reassign_distance = 0.0f;
  clustering.setPatchParameters (patches);
  std::size_t fewer = 0;
  errorsOf ([&] { fewer = pixels (); });
  EXPECT_LT (fewer, standard);
}
