// SPDX-License-Identifier: BSD-3-Clause
#include "clouds.h"
#include <pcl/segmentation/attention_point_extraction.h>
#include <pcl/segmentation/attention_segmentation.h>
#include <pcl/segmentation/compact_patch_clustering.h>
#include <pcl/segmentation/planar_patch_extraction.h>
#include <pcl/segmentation/impl/organized_cloud.hpp>
#include <pcl/segmentation/symmetry_saliency_estimation.h>

namespace
{

class Segmentation : public testing::Test
{
protected:
  void
  SetUp () override
  {
    segmentation.setInputCloud (sceneCloud ());
  }

  std::vector<pcl::AttentionSegment>
  segment ()
  {
    std::vector<pcl::AttentionSegment> segments (2);
    EXPECT_TRUE (segmentation.segment (segments));
    return (segments);
  }

  void
  expectError (const std::string& message)
  {
    std::vector<pcl::AttentionSegment> segments (2);
    const std::string errors = errorsOf ([&] { EXPECT_FALSE (segmentation.segment (segments)); });
    EXPECT_TRUE (segments.empty ());
    EXPECT_TRUE (contains (errors, "[pcl::AttentionSegmentation::segment] " + message));
  }

  /** \brief Every point gives its segment, and nothing else does. */
  static pcl_attention::AttentionParameters
  pointByPoint ()
  {
    pcl_attention::AttentionParameters parameters;
    parameters.segmentation.prefer_supported = false;
    parameters.segmentation.inhibition_of_return = false;
    parameters.segmentation.fixation_margin = 0;
    parameters.segmentation.coverage = false;
    parameters.segmentation.minimum_segment_size = 1;
    parameters.segmentation.minimum_certain_area = 0.0f;
    return (parameters);
  }

  pcl::AttentionSegmentation<PointT> segmentation;
};

} // namespace

TEST_F (Segmentation, GivesOneObjectAfterTheOther)
{
  const std::vector<pcl::AttentionSegment> all = segment ();
  ASSERT_GE (all.size (), 3u);
  pcl::AttentionSegmentation<PointT> other;
  other.setInputCloud (sceneCloud ());
  std::vector<pcl::AttentionSegment> sequence;
  pcl::AttentionSegment next;
  while (other.segmentNext (next))
    sequence.push_back (next);
  expectSame (sequence, all);
  EXPECT_TRUE (next.indices.empty ()) << "cleared at the end";
  EXPECT_FALSE (other.segmentNext (next)) << "the end stays the end";
  other.setInputCloud (sceneCloud ());
  ASSERT_TRUE (other.segmentNext (next)) << "a frame starts afresh";
  expectSame (next, all.front ());
}

TEST_F (Segmentation, LetsSmallSegmentsWaitForLargeOnes)
{
  // Larger than any object, so that every segment's weight is below 1.
  constexpr float full_size = 10.0f;
  pcl_attention::AttentionParameters parameters;
  parameters.segmentation.prefer_supported = false;
  parameters.segmentation.full_size = full_size;
  segmentation.setParameters (parameters);
  const std::vector<pcl::AttentionSegment> segments = segment ();
  ASSERT_GE (segments.size (), 3u);
  const pcl_attention::OrganizedCloud& cloud = segmentation.getPipeline ()->cloud ();
  const float focal_length = pcl_attention::estimateFocalLength (cloud);
  std::vector<float> priorities;
  bool by_saliency_alone = true;
  for (const pcl::AttentionSegment& object : segments)
  {
    double area = 0.0;
    for (const pcl::index_t index : object.indices)
      area += std::pow (cloud.z[index] / focal_length, 2);
    by_saliency_alone &= object.rank == 1 || object.attention_point.saliency <= segments[object.rank - 2].attention_point.saliency;
    priorities.push_back (static_cast<float> ((0.1 + object.attention_point.saliency) * area));
  }
  for (std::size_t k = 1; k < priorities.size (); ++k)
    EXPECT_LE (priorities[k], priorities[k - 1] * 1.0001f) << k;
  EXPECT_FALSE (by_saliency_alone) << "the scene shows nothing";

  parameters.segmentation.full_size = 0.0f;
  segmentation.setParameters (parameters);
  float before = std::numeric_limits<float>::max ();
  for (const pcl::AttentionSegment& object : segment ())
  {
    EXPECT_LE (object.attention_point.saliency, before);
    before = object.attention_point.saliency;
  }
}

TEST_F (Segmentation, GivesSegmentsOfTheSmallestSizeAndNoneBelow)
{
  std::size_t smallest = std::numeric_limits<std::size_t>::max ();
  const auto segmentsOfAtLeast = [&] (std::size_t size) {
    pcl_attention::AttentionParameters parameters = pointByPoint ();
    parameters.clustering.contour_width = 0; // the size is judged before
    parameters.segmentation.minimum_segment_size = static_cast<int> (size);
    segmentation.setParameters (parameters);
    const std::vector<pcl::AttentionSegment> segments = segment ();
    smallest = std::numeric_limits<std::size_t>::max ();
    for (const pcl::AttentionSegment& object : segments)
      smallest = std::min (smallest, object.indices.size ());
    return (segments.size ());
  };
  const std::size_t all = segmentsOfAtLeast (1), size = smallest;
  EXPECT_EQ (segmentsOfAtLeast (size), all);
  EXPECT_LT (segmentsOfAtLeast (size + 1), all);
  EXPECT_GT (smallest, size);
}

TEST_F (Segmentation, GivesNoSegmentsOfLessCertainAreaThanAskedFor)
{
  const pcl_attention::OrganizedCloud cloud = pcl_attention::gather (*sceneCloud (), nullptr);
  const float focal_length = pcl_attention::estimateFocalLength (cloud);
  const auto certainArea = [&] (const pcl::AttentionSegment& object) {
    float area = 0.0f;
    for (const pcl::index_t index : object.indices)
      area += cloud.z[index] * cloud.z[index] / (focal_length * focal_length);
    return (area * object.confidence);
  };
  pcl_attention::AttentionParameters parameters = pointByPoint ();
  parameters.clustering.contour_width = 0; // the area is judged before
  const auto segmentsOfAtLeast = [&] (float area) {
    parameters.segmentation.minimum_certain_area = area;
    segmentation.setParameters (parameters);
    return (segment ());
  };
  std::vector<float> areas;
  for (const pcl::AttentionSegment& object : segmentsOfAtLeast (0.0f))
    areas.push_back (certainArea (object));
  ASSERT_GE (areas.size (), 3u);
  std::sort (areas.begin (), areas.end ());
  const float limit = areas[areas.size () / 2];
  const auto expected = [&] (float least) {
    return (static_cast<std::size_t> (areas.end () - std::lower_bound (areas.begin (), areas.end (), least)));
  };
  EXPECT_EQ (segmentsOfAtLeast (0.999f * limit).size (), expected (0.999f * limit));
  EXPECT_EQ (segmentsOfAtLeast (1.001f * limit).size (), expected (1.001f * limit));
  EXPECT_LT (expected (1.001f * limit), areas.size ());
  parameters.visiblePieces ();
  EXPECT_EQ (parameters.segmentation.minimum_certain_area, 0.0f);
  EXPECT_FALSE (parameters.clustering.joinsPieces ());
}

TEST_F (Segmentation, LooksAtTheLargestPatchesFirstWhereNothingIsSalient)
{
  pcl_attention::AttentionParameters parameters;
  parameters.saliency.saliency_floor = 4.0f; // the most there can be
  parameters.segmentation.prefer_supported = false;
  parameters.segmentation.full_size = 0.0f;
  parameters.segmentation.fixation_margin = 0;
  segmentation.setParameters (parameters);
  const std::vector<pcl::AttentionSegment> segments = segment ();
  ASSERT_GE (segments.size (), 3u);
  const pcl_attention::PlanarPatches& patches = segmentation.getPipeline ()->patches ();
  std::size_t before = std::numeric_limits<std::size_t>::max (), different = 0;
  for (const pcl::AttentionSegment& object : segments)
  {
    ASSERT_EQ (object.attention_point.kind, pcl_attention::AttentionPointKind::coverage);
    const int label = patches.labels (object.attention_point.column, object.attention_point.row);
    ASSERT_GT (label, 0);
    const std::size_t size = patches.patches[label - 1].pixels.size ();
    EXPECT_LE (size, before);
    different += size < before;
    before = size;
  }
  EXPECT_GE (different, 3u);
}

TEST_F (Segmentation, GivesAllObjectsAlsoAfterSome)
{
  const std::vector<pcl::AttentionSegment> all = segment ();
  pcl::AttentionSegment next;
  segmentation.setInputCloud (sceneCloud ());
  ASSERT_TRUE (segmentation.segmentNext (next));
  expectSame (segment (), all);
}

TEST_F (Segmentation, IsNotDisturbedByAQuestion)
{
  const std::vector<pcl::AttentionSegment> all = segment ();
  ASSERT_GE (all.size (), 3u);
  segmentation.setInputCloud (sceneCloud ());
  for (std::size_t k = 0; k < all.size (); ++k)
  {
    const pcl::AttentionPoint& last = all[all.size () - 1 - k].attention_point;
    pcl::AttentionSegment asked, again, next;
    EXPECT_TRUE (segmentation.segmentAt (last.column, last.row, asked));
    EXPECT_EQ (asked.attention_point.kind, pcl_attention::AttentionPointKind::user);
    ASSERT_TRUE (segmentation.segmentNext (next));
    expectSame (next, all[k]);
    EXPECT_TRUE (segmentation.segmentAt (last.column, last.row, again));
    expectSame (asked, again);
  }
}

TEST_F (Segmentation, AnswersQuestionsOutsideTheImage)
{
  for (const auto& [column, row] : {std::pair<int, int>{-1, 5}, {320, 5}, {5, -1}, {5, 240}})
  {
    pcl::AttentionSegment segment;
    segment.indices = {1, 2, 3};
    bool found = true;
    const std::string errors = errorsOf ([&, c = column, r = row] { found = segmentation.segmentAt (c, r, segment); });
    EXPECT_FALSE (found);
    EXPECT_TRUE (segment.indices.empty ());
    EXPECT_TRUE (contains (errors, "[pcl::AttentionSegmentation::segmentAt] The pixel (" + std::to_string (column)));
  }
}

TEST_F (Segmentation, ReportsErrorsOneByOneToo)
{
  segmentation.setInputCloud (nullptr);
  pcl::AttentionSegment segment;
  segment.indices = {1, 2, 3};
  std::string errors = errorsOf ([&] { EXPECT_FALSE (segmentation.segmentNext (segment)); });
  EXPECT_TRUE (contains (errors, "[pcl::AttentionSegmentation::segmentNext] No input cloud"));
  EXPECT_TRUE (segment.indices.empty ());
  errors = errorsOf ([&] { EXPECT_TRUE (segmentation.getSupportingPlanes ().empty ()); });
  EXPECT_TRUE (contains (errors, "[pcl::AttentionSegmentation::getSupportingPlanes] No input cloud"));
  EXPECT_EQ (segmentation.getPipeline (), nullptr);
}

TEST_F (Segmentation, ForgetsTheFrameWhenAnythingIsSet)
{
  EXPECT_EQ (segmentation.getPipeline (), nullptr);
  segment ();
  EXPECT_NE (segmentation.getPipeline (), nullptr);
  segmentation.setInputCloud (renderCloud (pcl_attention::SceneKind::boxes, 1, 64, 48));
  EXPECT_EQ (segmentation.getPipeline (), nullptr);
  segment ();
  segmentation.setParameters (pcl_attention::AttentionParameters::paper ());
  EXPECT_EQ (segmentation.getPipeline (), nullptr);
}

TEST_F (Segmentation, IsTheChainOfTheFourClasses)
{
  // By hand ...
  pcl::SymmetrySaliencyEstimation<PointT> estimation;
  estimation.setInputCloud (sceneCloud ());
  const pcl::PointCloud<pcl::Intensity>::Ptr saliency (new pcl::PointCloud<pcl::Intensity>);
  ASSERT_TRUE (estimation.compute (*saliency));

  pcl::AttentionPointExtraction<PointT> point_extraction;
  point_extraction.setInputCloud (sceneCloud ());
  point_extraction.setSaliency (saliency);
  std::vector<pcl::AttentionPoint> points;
  ASSERT_TRUE (point_extraction.extract (points));

  // Given patches are cut along the table's plane, others are grown beside it: what is small is left over at another time.
  pcl_attention::AttentionParameters parameters = pointByPoint ();
  parameters.patches.minimum_size = 9;

  pcl::PlanarPatchExtraction<PointT> patch_extraction;
  patch_extraction.setInputCloud (sceneCloud ());
  patch_extraction.setParameters (parameters.patches);
  std::vector<pcl::PointIndices> patches;
  ASSERT_TRUE (patch_extraction.extract (patches));

  pcl::CompactPatchClustering<PointT> clustering;
  clustering.setInputCloud (sceneCloud ());
  clustering.setPatchParameters (parameters.patches);
  clustering.setPatches (
      pcl::PointCloud<pcl::Label>::Ptr (new pcl::PointCloud<pcl::Label> (patch_extraction.getLabels ())));
  clustering.setAttentionPoints (points);
  std::vector<pcl::AttentionSegment> by_hand;
  errorsOf ([&] { ASSERT_TRUE (clustering.segment (by_hand)); });

  // ... and at once.
  segmentation.setParameters (parameters);
  const std::vector<pcl::AttentionSegment> at_once = segment ();
  pcl_attention::AttentionPipeline& pipeline = *segmentation.getPipeline ();
  ASSERT_EQ (pipeline.saliency ().saliency.size (), saliency->size ());
  for (std::size_t index = 0; index < saliency->size (); ++index)
    ASSERT_EQ (pipeline.saliency ().saliency[index], (*saliency)[index].intensity);
  ASSERT_EQ (pipeline.attentionPoints ().points.size (), points.size ());
  for (std::size_t k = 0; k < points.size (); ++k)
  {
    EXPECT_EQ (pipeline.attentionPoints ().points[k].column, points[k].column);
    EXPECT_EQ (pipeline.attentionPoints ().points[k].row, points[k].row);
  }
  ASSERT_EQ (at_once.size (), by_hand.size ());
  for (std::size_t k = 0; k < at_once.size (); ++k)
  {
    EXPECT_EQ (at_once[k].indices, by_hand[k].indices);
    EXPECT_EQ (at_once[k].rank, by_hand[k].rank);
    EXPECT_EQ (at_once[k].box.center, by_hand[k].box.center);
    EXPECT_EQ (at_once[k].box.size, by_hand[k].box.size);
    EXPECT_EQ (at_once[k].compactness, by_hand[k].compactness);
    EXPECT_EQ (at_once[k].attention_point.saliency, by_hand[k].attention_point.saliency);
  }
}

TEST_F (Segmentation, MovesWithCloudAndSensor)
{
  const std::vector<pcl::AttentionSegment> still = segment ();
  const std::vector<pcl::SupportingPlane> still_planes = segmentation.getSupportingPlanes ();
  const Eigen::Isometry3f motion = someMotion ();
  segmentation.setInputCloud (moved (*sceneCloud (), motion));
  const std::vector<pcl::AttentionSegment> after = segment ();
  const std::vector<pcl::SupportingPlane> planes = segmentation.getSupportingPlanes ();
  ASSERT_EQ (after.size (), still.size ());
  const auto movedPlane = [&] (const Eigen::Vector4f& plane) {
    Eigen::Vector4f result;
    result << motion.linear () * plane.head<3> (),
        plane[3] - (motion.linear () * plane.head<3> ()).dot (motion.translation ());
    return (result);
  };
  for (std::size_t k = 0; k < still.size (); ++k)
  {
    EXPECT_GT (overlap (still[k].indices, after[k].indices), 0.98);
    EXPECT_LT ((movedPlane (still[k].plane) - after[k].plane).norm (), 0.05f);
    EXPECT_LT ((motion * still[k].box.center - after[k].box.center).norm (), 0.005f);
    EXPECT_LT ((still[k].box.size - after[k].box.size).norm (), 0.01f);
    const Eigen::Vector3f axis = motion.linear () * still[k].box.orientation.toRotationMatrix ().col (0);
    EXPECT_GT (std::abs (axis.dot (after[k].box.orientation.toRotationMatrix ().col (0))), 0.999f);
  }
  ASSERT_EQ (planes.size (), still_planes.size ());
  for (std::size_t k = 0; k < planes.size (); ++k)
    EXPECT_LT ((movedPlane (still_planes[k].coefficients) - planes[k].coefficients).norm (), 0.01f);
}

TEST_F (Segmentation, UsesTheSaliencyItIsGiven)
{
  const std::vector<pcl::AttentionSegment> own = segment ();
  const pcl::AttentionPoint target = own.back ().attention_point;
  pcl_attention::AttentionParameters parameters;
  parameters.segmentation.coverage = false;
  parameters.segmentation.fixation_margin = 0;
  segmentation.setParameters (parameters);
  segmentation.setSaliency (crossMap (320, 240, target.column, target.row));
  const std::vector<pcl::AttentionSegment> segments = segment ();
  ASSERT_EQ (segments.size (), 1u);
  EXPECT_NEAR (segments[0].attention_point.column, target.column, 1);
  EXPECT_NEAR (segments[0].attention_point.row, target.row, 1);
  EXPECT_EQ (segments[0].attention_point.saliency, 1.0f);

  segmentation.setSaliency (pcl::PointCloud<pcl::Intensity>::Ptr (new pcl::PointCloud<pcl::Intensity> (10, 10)));
  expectError ("The saliency map is 10 x 10 with 100 values, but the input cloud is 320 x 240");
  const pcl::PointCloud<pcl::Intensity>::Ptr negative = crossMap (320, 240, 100, 100);
  negative->at (1, 2).intensity = -1.0f;
  segmentation.setSaliency (negative);
  expectError ("The saliency at column 1, row 2 is -1.000000");
  segmentation.setSaliency (nullptr);
  segmentation.setParameters ({});
  expectSame (segment (), own);
}

TEST_F (Segmentation, UsesThePointsItIsGiven)
{
  const std::vector<pcl::AttentionSegment> own = segment ();
  ASSERT_GE (own.size (), 2u);
  segmentation.setParameters (pointByPoint ());
  const std::vector<pcl::AttentionPoint> points{own[1].attention_point, own[0].attention_point};
  segmentation.setAttentionPoints (points);
  const std::vector<pcl::AttentionSegment> segments = segment ();
  ASSERT_EQ (segments.size (), 2u);
  for (std::size_t k = 0; k < 2; ++k)
  {
    EXPECT_EQ (segments[k].attention_point.column, points[k].column);
    EXPECT_EQ (segments[k].attention_point.row, points[k].row);
    EXPECT_TRUE (std::binary_search (segments[k].indices.begin (), segments[k].indices.end (),
                                     indexOf (points[k], *sceneCloud ())));
  }
  segmentation.setAttentionPoints ({});
  EXPECT_TRUE (segment ().empty ());
  segmentation.setAttentionPoints ({pointAt (320, 0)});
  expectError ("The pixel (320, 0) lies outside the input cloud of 320 x 240 points");
  segmentation.clearAttentionPoints ();
  segmentation.setParameters ({});
  expectSame (segment (), own);
}

TEST_F (Segmentation, MovesAFixationAtTheContourInside)
{
  const pcl::AttentionSegment object = segment ().front ();
  const auto isMember = [&] (int column, int row) {
    return (std::binary_search (object.indices.begin (), object.indices.end (), row * 320 + column));
  };
  // Where the first row of the object begins.
  const int column = object.indices.front () % 320, row = object.indices.front () / 320;
  ASSERT_GE (row, 1);
  ASSERT_FALSE (isMember (column, row - 1));
  for (const int margin : {0, 1, 2, 5})
  {
    segmentation.setAttentionPoints ({pointAt (column, row)});
    pcl_attention::AttentionParameters parameters;
    parameters.segmentation.coverage = false;
    parameters.segmentation.fixation_margin = margin;
    segmentation.setParameters (parameters);
    const std::vector<pcl::AttentionSegment> segments = segment ();
    ASSERT_EQ (segments.size (), 1u);
    ASSERT_EQ (segments[0].indices, object.indices);
    const pcl::AttentionPoint& moved = segments[0].attention_point;
    if (margin <= 1) // it is in the first row of the object already
    {
      EXPECT_EQ (std::make_pair (moved.column, moved.row), std::make_pair (column, row));
    }
    for (int r = moved.row - margin + 1; r < moved.row + margin; ++r)
      for (int c = moved.column - margin + 1; c < moved.column + margin; ++c)
        EXPECT_TRUE (isMember (c, r)) << "margin " << margin << ": " << c << ", " << r;
    // No farther than it takes: what lies twice the margin deep is deep enough.
    EXPECT_LE (std::hypot (moved.column - column, moved.row - row), 4.0 * margin);
  }
}

TEST_F (Segmentation, GivesNoObjectTwiceThatIsReachedFromBesideIt)
{
  const pcl::AttentionSegment object = segment ().front ();
  // Beside the contour there is no object, but one within reach.
  const int column = object.indices.front () % 320, row = object.indices.front () / 320 - 2;
  segmentation.setAttentionPoints ({object.attention_point, pointAt (column, row)});
  pcl_attention::AttentionParameters parameters = pointByPoint ();
  segmentation.setParameters (parameters);
  const std::vector<pcl::AttentionSegment> both = segment ();
  ASSERT_EQ (both.size (), 2u);
  ASSERT_GT (overlap (both[0].indices, both[1].indices), 0.9);
  parameters.segmentation.inhibition_of_return = true;
  segmentation.setParameters (parameters);
  EXPECT_EQ (segment ().size (), 1u);
}

TEST_F (Segmentation, KeepsTheOrderOfThePointsItIsGiven)
{
  // Also with prefer_supported, which would look at what stands on the table before the table itself.
  const std::vector<pcl::AttentionSegment> own = segment ();
  const std::vector<pcl::SupportingPlane> planes = segmentation.getSupportingPlanes ();
  ASSERT_FALSE (own.empty ());
  ASSERT_FALSE (planes.empty ());
  ASSERT_TRUE (planes.front ().supports_objects);
  const pcl::index_t on_table = planes.front ().indices[planes.front ().indices.size () / 2];
  const std::vector<pcl::AttentionPoint> points{pointAt (on_table % 320, on_table / 320), own[0].attention_point};
  pcl_attention::AttentionParameters parameters = pointByPoint ();
  parameters.segmentation.prefer_supported = true;
  parameters.clustering.stay_off_support = false;
  segmentation.setParameters (parameters);
  segmentation.setAttentionPoints (points);
  const std::vector<pcl::AttentionSegment> segments = segment ();
  ASSERT_EQ (segments.size (), 2u);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_EQ (indexOf (segments[k].attention_point, *sceneCloud ()), indexOf (points[k], *sceneCloud ()));
}

TEST_F (Segmentation, UsesThePatchesItIsGiven)
{
  const std::vector<pcl::AttentionSegment> own = segment ();
  const pcl::AttentionPoint point = own.front ().attention_point;
  const pcl::PointCloud<pcl::Label>::Ptr labels (new pcl::PointCloud<pcl::Label> (320, 240));
  for (int row = point.row - 6; row <= point.row + 6; ++row)
    for (int column = point.column - 8; column <= point.column + 8; ++column)
      labels->at (column, row).label = 0x80000001u;
  pcl_attention::AttentionParameters parameters = pointByPoint ();
  parameters.clustering.stay_off_support = false;
  parameters.clustering.contour_width = 0;
  segmentation.setParameters (parameters);
  segmentation.setPatches (labels);
  segmentation.setAttentionPoints ({point});
  const std::vector<pcl::AttentionSegment> segments = segment ();
  ASSERT_EQ (segments.size (), 1u);
  ASSERT_EQ (segments[0].patches.size (), 1u);
  EXPECT_EQ (static_cast<std::uint32_t> (segments[0].patches[0]), 0x80000001u);
  for (const pcl::index_t index : segments[0].indices)
    EXPECT_NE ((*labels)[index].label, 0u);
  pcl::AttentionSegment asked;
  ASSERT_TRUE (segmentation.segmentAt (point.column, point.row, asked));
  EXPECT_EQ (asked.patches, segments[0].patches);

  labels->points.resize (10);
  labels->width = 10;
  labels->height = 1;
  expectError ("The image of patch labels is 10 x 1 with 10 values, but the input cloud is 320 x 240");
  segmentation.setPatches (nullptr);
  segmentation.clearAttentionPoints ();
  segmentation.setParameters ({});
  expectSame (segment (), own);
}

TEST_F (Segmentation, UsesTheNormalsItIsGiven)
{
  const std::vector<pcl::AttentionSegment> own = segment ();
  const pcl_attention::NormalImage estimated = segmentation.getPipeline ()->normals ();
  const pcl::PointCloud<pcl::Normal>::Ptr normals (new pcl::PointCloud<pcl::Normal> (320, 240));
  for (std::size_t index = 0; index < normals->size (); ++index)
  {
    // Turned away and of another length, as they may come from elsewhere.
    (*normals)[index].getNormalVector3fMap () =
        -2.0f * Eigen::Vector3f (estimated.x[index], estimated.y[index], estimated.z[index]);
    (*normals)[index].curvature = estimated.curvature[index];
    if (!estimated.valid[index])
      (*normals)[index].getNormalVector3fMap ().setConstant (nan_value);
  }
  segmentation.setInputNormals (normals);
  const std::vector<pcl::AttentionSegment> segments = segment ();
  ASSERT_EQ (segments.size (), own.size ());
  for (std::size_t k = 0; k < own.size (); ++k)
    EXPECT_GT (overlap (segments[k].indices, own[k].indices), 0.98);

  *normals = pcl::PointCloud<pcl::Normal> (320, 240, pcl::Normal (nan_value, nan_value, nan_value));
  EXPECT_TRUE (segment ().empty ());
}

TEST_F (Segmentation, FindsNothingOnABareWall)
{
  segmentation.setInputCloud (renderCloud (pcl_attention::SceneKind::wall, 5));
  EXPECT_TRUE (segment ().empty ());
}

TEST_F (Segmentation, NamesTheParameterThatIsOutOfRange)
{
  pcl_attention::AttentionParameters parameters;
  parameters.patches.maximum_distance = nan_value;
  segmentation.setParameters (parameters);
  expectError ("Bad parameter: patch_maximum_distance is nan, but must be a number from 1e-05 to 1 m.");
}

TEST_F (Segmentation, IsTheSameWhereEverythingIsAskedFor)
{
  const std::vector<pcl::AttentionSegment> plain = segment ();
  pcl_attention::AttentionPrior prior;
  prior.map.assign (320, 240, 1.0f);
  segmentation.setAttentionPrior (prior);
  expectSame (segment (), plain);
}

TEST_F (Segmentation, GivesWhatIsAskedForFirstAndNothingLess)
{
  const std::vector<pcl::AttentionSegment> plain = segment ();
  ASSERT_GE (plain.size (), 3u);
  for (const pcl::AttentionSegment& asked : plain)
  {
    pcl_attention::AttentionPrior prior;
    prior.map.assign (320, 240, 0.0f);
    for (const pcl::index_t index : asked.indices)
      prior.map[index] = 1.0f;
    segmentation.setAttentionPrior (prior);
    const std::vector<pcl::AttentionSegment> objects = segment ();
    ASSERT_EQ (objects.size (), plain.size ());
    EXPECT_GT (overlap (objects.front ().indices, asked.indices), 0.9) << asked.rank;
  }
  segmentation.setAttentionPrior ({});
  expectSame (segment (), plain);
}

TEST_F (Segmentation, TakesAnotherPriorOnTheSameFrame)
{
  segment ();
  const pcl_attention::AttentionPipeline* pipeline = segmentation.getPipeline ();
  ASSERT_TRUE (pipeline);
  const double normals = pipeline->times ().normals;
  pcl_attention::AttentionPrior prior;
  prior.region = pcl_attention::PixelRegion{160, 0, 160, 240};
  segmentation.setAttentionPrior (prior);
  pcl::AttentionSegment first, fresh;
  ASSERT_TRUE (segmentation.segmentNext (first));
  EXPECT_EQ (segmentation.getPipeline ()->times ().normals, normals) << "the frame's normals were made again";
  pcl::AttentionSegmentation<PointT> other;
  other.setInputCloud (sceneCloud ());
  other.setAttentionPrior (prior);
  ASSERT_TRUE (other.segmentNext (fresh));
  expectSame (first, fresh);
  EXPECT_GE (first.attention_point.column, 160);
}

TEST_F (Segmentation, RefusesAPriorThatDoesNotFit)
{
  pcl_attention::AttentionPrior prior;
  prior.map.assign (10, 10, 1.0f);
  segmentation.setAttentionPrior (prior);
  expectError ("Bad prior: the map of the prior is 10 x 10, but the cloud is 320 x 240");
  prior = pcl_attention::AttentionPrior ();
  prior.distance = pcl_attention::ValueRange{2.0f, 1.0f};
  segmentation.setAttentionPrior (prior);
  expectError ("Bad prior: the distance of the prior");
  segmentation.setAttentionPrior ({});
  EXPECT_FALSE (segment ().empty ());

  pcl::AttentionSegmentation<pcl::PointXYZ> colorless;
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);
  pcl::copyPointCloud (*sceneCloud (), *cloud);
  colorless.setInputCloud (cloud);
  prior = pcl_attention::AttentionPrior ();
  prior.color = {255, 0, 0};
  colorless.setAttentionPrior (prior);
  pcl::AttentionSegment none;
  EXPECT_TRUE (contains (errorsOf ([&] { EXPECT_FALSE (colorless.segmentNext (none)); }), "the cloud has none"));
}

TEST_F (Segmentation, KeepsTheOrderOfGivenPointsWhateverIsAskedFor)
{
  std::vector<pcl::AttentionPoint> points;
  for (const pcl::AttentionSegment& object : segment ())
    points.insert (points.begin (), object.attention_point);
  segmentation.setAttentionPoints (points);
  const std::vector<pcl::AttentionSegment> plain = segment ();
  pcl_attention::AttentionPrior prior;
  prior.region = pcl_attention::PixelRegion{160, 0, 160, 240};
  segmentation.setAttentionPrior (prior);
  expectSame (segment (), plain);
  // One that does not fit is refused only when it is of use.
  prior.region = pcl_attention::PixelRegion{999, 0, 1, 1};
  segmentation.setAttentionPrior (prior);
  expectSame (segment (), plain);
  segmentation.clearAttentionPoints ();
  expectError ("Bad prior: the region of the prior");
}

TEST_F (Segmentation, GivesClustersAndLabelsAsOtherSegmentersDo)
{
  const std::vector<pcl::AttentionSegment> objects = segment ();
  std::vector<pcl::PointIndices> clusters (1);
  ASSERT_TRUE (segmentation.extract (clusters));
  ASSERT_EQ (clusters.size (), objects.size ());
  for (std::size_t index = 0; index < objects.size (); ++index)
    EXPECT_EQ (clusters[index].indices, objects[index].indices);

  pcl::PointCloud<pcl::PointXYZRGBL> labeled;
  ASSERT_TRUE (segmentation.segment (labeled, clusters));
  ASSERT_EQ (labeled.width, sceneCloud ()->width);
  ASSERT_EQ (labeled.height, sceneCloud ()->height);
  std::vector<std::uint32_t> expected (labeled.size (), 0);
  for (auto object = objects.rbegin (); object != objects.rend (); ++object)
    for (const pcl::index_t index : object->indices)
      expected[index] = static_cast<std::uint32_t> (object->rank);
  for (std::size_t index = 0; index < labeled.size (); ++index)
  {
    ASSERT_EQ (labeled[index].label, expected[index]);
    ASSERT_EQ (labeled[index].rgba, (*sceneCloud ())[index].rgba);
  }

  pcl::PointCloud<pcl::Label> labels;
  ASSERT_TRUE (segmentation.segment (labels, clusters));
  for (std::size_t index = 0; index < labels.size (); ++index)
    ASSERT_EQ (labels[index].label, expected[index]);
}

TEST_F (Segmentation, ClearsClustersAndLabelsOnAnError)
{
  segmentation.setInputCloud (nullptr);
  std::vector<pcl::PointIndices> clusters (1);
  pcl::PointCloud<pcl::Label> labels (2, 2);
  errorsOf ([&] { EXPECT_FALSE (segmentation.segment (labels, clusters)); });
  EXPECT_TRUE (clusters.empty ());
  EXPECT_TRUE (labels.empty ());
  pcl::PointIndices inliers;
  pcl::ModelCoefficients coefficients;
  inliers.indices.push_back (1);
  errorsOf ([&] { EXPECT_FALSE (segmentation.getSupportingPlane (inliers, coefficients)); });
  EXPECT_TRUE (inliers.indices.empty ());
}

TEST_F (Segmentation, GivesTheSupportingPlaneAsASampleConsensusModel)
{
  pcl::PointIndices inliers;
  pcl::ModelCoefficients coefficients;
  ASSERT_TRUE (segmentation.getSupportingPlane (inliers, coefficients));
  const std::vector<pcl::SupportingPlane> planes = segmentation.getSupportingPlanes ();
  EXPECT_EQ (inliers.indices, planes.front ().indices);
  ASSERT_EQ (coefficients.values.size (), 4u);
  double sum = 0.0;
  for (const pcl::index_t index : inliers.indices)
    sum += std::abs (Eigen::Map<const Eigen::Vector4f> (coefficients.values.data ())
                         .dot ((*sceneCloud ())[index].getVector3fMap ().homogeneous ()));
  EXPECT_LT (sum / static_cast<double> (inliers.indices.size ()), 0.005) << "metres";

  segmentation.setInputCloud (filledCloud (64, 48, nan_value, nan_value, nan_value));
  EXPECT_FALSE (segmentation.getSupportingPlane (inliers, coefficients));
  EXPECT_TRUE (inliers.indices.empty () && coefficients.values.empty ());
}
