// SPDX-License-Identifier: BSD-3-Clause
// What AttentionPipeline keeps when parameters change, and what not.
#include "scene_renderer.h"
#include <pcl_attention/core/parameters.h>
#include <pcl_attention/core/pipeline.h>

#include <gtest/gtest.h>
#include <pcl/segmentation/impl/organized_cloud.hpp>

#include <algorithm>
#include <set>

using namespace pcl_attention;

namespace
{

OrganizedCloud
renderedCloud ()
{
  SceneDescription description = makeScene (SceneKind::clutter, 6);
  description.camera = description.camera.resized (160, 120);
  return (gather (*renderScene (description, 6), nullptr));
}

std::vector<AttentionSegment>
allSegments (AttentionPipeline& pipeline)
{
  std::vector<AttentionSegment> segments;
  AttentionSegment segment;
  while (pipeline.next (segment))
    segments.push_back (segment);
  return (segments);
}

void
expectSame (const std::vector<AttentionSegment>& a, const std::vector<AttentionSegment>& b, const std::string& what)
{
  ASSERT_EQ (a.size (), b.size ()) << what;
  for (std::size_t k = 0; k < a.size (); ++k)
  {
    EXPECT_EQ (a[k].rank, b[k].rank) << what;
    EXPECT_EQ (a[k].indices, b[k].indices) << what;
    EXPECT_EQ (a[k].attention_point.column, b[k].attention_point.column) << what;
    EXPECT_EQ (a[k].attention_point.row, b[k].attention_point.row) << what;
    EXPECT_EQ (a[k].patches, b[k].patches) << what;
  }
}

/** \brief Three strips of a bowl, of which any two that touch are compact, but not all three: the middle one, of 40 columns, goes with
  * the first it meets.
  * \param[in] left_columns of the left strip, 1 to 80; the right one has 140 */
void
startWithStrips (int left_columns, AttentionPipeline& pipeline)
{
  constexpr int height = 100, middle = 80, right = 120, width = 260;
  constexpr float focal_length = 525.0f;
  pcl::PointCloud<pcl::PointXYZ> points (width, height);
  PlanarPatches patches;
  patches.labels.assign (width, height, 0);
  patches.patches.resize (3);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      const float beside = static_cast<float> (std::max ({0, middle - column, column - right}));
      const float z = 1.0f - 0.1f * beside / focal_length;
      points (column, row) = {(static_cast<float> (column) - 0.5f * width) * z / focal_length,
                              (static_cast<float> (row) - 0.5f * height) * z / focal_length, z};
      if (column < middle - left_columns)
        continue;
      const int label = column < middle ? 1 : column < right ? 2 : 3;
      patches.labels (column, row) = label;
      patches.patches[label - 1].pixels.push_back (row * width + column);
    }
  AttentionParameters parameters;
  parameters.clustering.minimum_convexity = -2.0f;
  parameters.clustering.compactness_noise = 0.0f;
  parameters.clustering.join_hollows = parameters.clustering.join_handles = parameters.clustering.join_occluded = false;
  parameters.clustering.stay_off_support = false;
  parameters.segmentation.coverage = false;
  parameters.segmentation.fixation_margin = 0;
  parameters.segmentation.full_size = 0.1f;
  pipeline.start (gather (points, nullptr), Eigen::Isometry3f::Identity (), parameters, 1);
  pipeline.setPatches (std::move (patches));
}

/** \brief Fixations on strips, ranked by saliency and size, as the user's own points would not be. */
AttentionPoints
pointsOnStrips (const std::vector<std::pair<int, float>>& columns_and_saliencies)
{
  AttentionPoints fixations;
  for (const auto& [column, saliency] : columns_and_saliencies)
  {
    AttentionPoint point;
    point.column = column;
    point.row = 50;
    point.saliency = saliency;
    point.kind = AttentionPointKind::coverage;
    fixations.points.push_back (point);
  }
  return (fixations);
}

/** \brief The segments at a point in each of the strips. */
std::vector<AttentionSegment>
segmentsOfStrips (int left_columns)
{
  AttentionPipeline pipeline;
  startWithStrips (left_columns, pipeline);
  pipeline.setAttentionPoints (pointsOnStrips ({{100, 0.9f}, {70, 0.8f}, {180, 0.7f}}));
  return (allSegments (pipeline));
}

TEST (Pipeline, changedParametersGiveWhatAFreshStartGives)
{
  const OrganizedCloud cloud = renderedCloud ();
  const Eigen::Isometry3f pose = Eigen::Isometry3f::Identity ();
  AttentionPipeline changed;
  changed.start (OrganizedCloud (cloud), pose, AttentionParameters (), 2);
  const std::vector<AttentionSegment> before = allSegments (changed);
  ASSERT_FALSE (before.empty ());
  int differing = 0;
  for (const auto& [name, value] : {std::pair<std::string, double> ("normal_radius", 2),
                                    {"window_radius", 2},
                                    {"levels", 2},
                                    {"component_threshold", 0.3},
                                    {"patch_maximum_angle", 0.2},
                                    {"border_connection_distance", 0.03},
                                    {"support_minimum_area", 0.5},
                                    {"stay_off_support", 0},
                                    {"compactness_threshold", 0.0005},
                                    {"minimum_convexity", 0.5},
                                    {"coverage", 0},
                                    {"inhibition_of_return", 0}})
  {
    AttentionParameters parameters;
    const auto& table = parameterTable ();
    const auto row = std::find_if (table.begin (), table.end (),
                                   [name = name] (const ParameterDescription& r) { return (r.name == name); });
    ASSERT_NE (row, table.end ()) << name;
    row->set (parameters, value);
    AttentionPipeline fresh;
    fresh.start (OrganizedCloud (cloud), pose, parameters, 2);
    const std::vector<AttentionSegment> expected = allSegments (fresh);
    changed.changeParameters (parameters);
    expectSame (allSegments (changed), expected, name);
    differing += expected.size () != before.size ();
  }
  EXPECT_GT (differing, 2) << "parameters that change nothing show nothing";
  changed.changeParameters (AttentionParameters ());
  expectSame (allSegments (changed), before, "and back");
}

TEST (Pipeline, keepsTheStagesThatDoNotDependOnAChange)
{
  AttentionPipeline pipeline;
  AttentionParameters parameters;
  pipeline.start (renderedCloud (), Eigen::Isometry3f::Identity (), parameters, 2);
  allSegments (pipeline);
  const StageTimes first = pipeline.times ();

  parameters.clustering.compactness_threshold = 0.002f;
  pipeline.changeParameters (parameters);
  EXPECT_EQ (pipeline.times ().segmentation, 0.0);
  allSegments (pipeline);
  EXPECT_EQ (pipeline.times ().normals, first.normals);
  EXPECT_EQ (pipeline.times ().saliency, first.saliency);
  EXPECT_EQ (pipeline.times ().attention_points, first.attention_points);
  EXPECT_EQ (pipeline.times ().patches, first.patches);

  parameters.image_symmetry.levels = 2;
  pipeline.changeParameters (parameters);
  EXPECT_EQ (pipeline.times ().attention_points, 0.0);
  allSegments (pipeline);
  EXPECT_EQ (pipeline.times ().saliency, first.saliency);

  parameters.saliency.levels = 3;
  pipeline.changeParameters (parameters);
  EXPECT_EQ (pipeline.times ().saliency, 0.0);
  EXPECT_EQ (pipeline.times ().attention_points, 0.0);
  allSegments (pipeline);
  EXPECT_EQ (pipeline.times ().normals, first.normals);
  EXPECT_EQ (pipeline.times ().patches, first.patches);

  parameters.normals.radius = 3;
  pipeline.changeParameters (parameters);
  EXPECT_EQ (pipeline.times ().total (), 0.0);
}

TEST (Pipeline, keepsAllButTheAttentionPointsWhenAskedForSomething)
{
  AttentionPipeline pipeline;
  pipeline.start (renderedCloud (), Eigen::Isometry3f::Identity (), AttentionParameters (), 2);
  allSegments (pipeline);
  const StageTimes first = pipeline.times ();
  EXPECT_GT (first.attention_points, 0.0);

  AttentionPrior prior;
  prior.distance = ValueRange{0.0f, 1.0f};
  pipeline.setPrior (std::move (prior));
  EXPECT_EQ (pipeline.times ().attention_points, 0.0);
  EXPECT_EQ (pipeline.times ().segmentation, 0.0);
  EXPECT_EQ (pipeline.times ().total (), first.normals + first.saliency + first.patches);
  allSegments (pipeline);
  EXPECT_GT (pipeline.times ().attention_points, 0.0);
}

TEST (Pipeline, visitsPointsInTheUsersOrder)
{
  AttentionParameters parameters;
  parameters.segmentation.coverage = false;
  parameters.segmentation.fixation_margin = 0;
  parameters.clustering.stay_off_support = false; // so that the table gives a segment
  AttentionPipeline pipeline;
  pipeline.start (renderedCloud (), Eigen::Isometry3f::Identity (), parameters, 0);
  ASSERT_TRUE (parameters.segmentation.prefer_supported);
  const std::vector<AttentionSegment> plain = allSegments (pipeline);
  ASSERT_GT (plain.size (), 2u);

  // The last one first, before all one of the table.
  const SupportingPlane table = pipeline.supportingPlanes ().front ();
  ASSERT_TRUE (table.supports_objects);
  AttentionPoints points;
  for (const AttentionSegment& segment : plain)
    points.points.insert (points.points.begin (), segment.attention_point);
  AttentionPoint on_table;
  on_table.column = table.indices.front () % pipeline.cloud ().width;
  on_table.row = table.indices.front () / pipeline.cloud ().width;
  points.points.insert (points.points.begin (), on_table);
  for (std::size_t k = 0; k < points.points.size (); ++k)
    points.points[k].weight = k % 2 == 0 ? 0.1f : 1.0f; // of an earlier prior
  const std::vector<AttentionPoint> order = points.points;
  pipeline.changeParameters (parameters);
  pipeline.setAttentionPoints (std::move (points));
  std::size_t place = 0;
  const std::vector<AttentionSegment> segments = allSegments (pipeline);
  ASSERT_GT (segments.size (), 2u);
  EXPECT_EQ (segments.front ().attention_point.column, on_table.column);
  EXPECT_EQ (segments.front ().attention_point.row, on_table.row);
  for (const AttentionSegment& segment : segments)
  {
    const auto isAt = [&] (const AttentionPoint& point) {
      return (point.column == segment.attention_point.column && point.row == segment.attention_point.row);
    };
    const auto found = std::find_if (order.begin () + static_cast<std::ptrdiff_t> (place), order.end (), isAt);
    ASSERT_NE (found, order.end ()) << "rank " << segment.rank;
    place = static_cast<std::size_t> (found - order.begin ()) + 1;
  }
}

namespace
{

SceneObject
boxAt (const Eigen::Vector3d& size, const Eigen::Vector3d& center, std::uint32_t label)
{
  SceneObject box;
  box.size = size;
  box.pose.translation () = center;
  box.label = label;
  return (box);
}

/** \brief A table with boxes 20 and 40 on it, over a floor, and box 30 somewhere; 20 and 30 are salient, 40 is not. */
struct TableScene
{
  SceneDescription scene;

  explicit TableScene (const SceneObject& other)
  {
    SceneObject floor;
    floor.shape = SceneShape::plane;
    floor.pose.translation ().z () = -0.5;
    floor.label = scene_label::floor;
    scene.supports = {boxAt ({1.4, 1.2, 0.03}, {-0.2, 0.0, -0.015}, scene_label::table), floor};
    scene.objects = {boxAt ({0.15, 0.15, 0.15}, {0.15, 0.0, 0.075}, 20), other, boxAt ({0.15, 0.15, 0.15}, {-0.2, 0.1, 0.075}, 40)};
    scene.camera = scene.camera.resized (320, 240);
    scene.camera.lookAt ({0.4, -0.7, 0.8}, {0.25, 0.0, 0.0});
    scene.world_frame = true; // planes are in the frame of the cloud, points in the sensor's
  }

  /** \brief Labels of the objects that are found.
    * \param[in] ask for anything up to ten metres away */
  std::set<std::uint32_t>
  labelsFound (bool ignore_surroundings, bool ask = false) const
  {
    const auto rendered = renderScene (scene, 1);
    Image<float> saliency (320, 240, 0.0f); // a bar in the middle of the two boxes
    for (const std::uint32_t label : {20u, 30u})
    {
      int count = 0, columns = 0, rows = 0;
      for (std::size_t index = 0; index < rendered->size (); ++index)
        if ((*rendered)[index].label == label)
        {
          ++count;
          columns += static_cast<int> (index % 320);
          rows += static_cast<int> (index / 320);
        }
      EXPECT_GT (count, 500) << label;
      for (int step = -4; step <= 4; ++step)
        saliency (columns / std::max (1, count) + step, rows / std::max (1, count)) = 1.0f;
    }
    AttentionParameters parameters;
    parameters.segmentation.ignore_surroundings = ignore_surroundings;
    AttentionPipeline pipeline;
    pipeline.start (gather (*rendered, nullptr), sensorPose (*rendered), parameters, 1);
    pipeline.setSaliency (std::move (saliency));
    if (ask)
    {
      AttentionPrior prior;
      prior.distance = ValueRange{0.0f, 10.0f};
      pipeline.setPrior (std::move (prior));
    }
    EXPECT_TRUE (!pipeline.supportingPlanes ().empty () && pipeline.supportingPlanes ().front ().supports_objects);
    std::set<std::uint32_t> labels;
    for (const AttentionSegment& segment : allSegments (pipeline))
      labels.insert (rendered->at (segment.attention_point.column, segment.attention_point.row).label / 10 * 10);
    return (labels);
  }
};

} // namespace

TEST (Pipeline, ignoresWhatLiesBelowTheTableUnlessSomethingIsAskedFor)
{
  // In the corner of two tables, whose common outline goes round it.
  TableScene scene (boxAt ({0.2, 0.2, 0.1}, {0.7, 0.0, -0.45}, 30));
  scene.scene.supports.push_back (boxAt ({0.4, 0.4, 0.03}, {0.7, 0.4, -0.015}, scene_label::table));
  EXPECT_EQ (scene.labelsFound (true), (std::set<std::uint32_t>{20, 40}));
  EXPECT_EQ (scene.labelsFound (false).count (30), 1u);
  EXPECT_EQ (scene.labelsFound (true, true).count (30), 1u);
}

TEST (Pipeline, ignoresWhatStandsBesideTheTableUnlessSomethingIsAskedFor)
{
  // On a stool as high as the table, 10 cm beside it.
  TableScene scene (boxAt ({0.15, 0.15, 0.15}, {0.7, 0.0, 0.075}, 30));
  scene.scene.supports.push_back (boxAt ({0.2, 0.2, 0.03}, {0.7, 0.0, -0.015}, scene_label::table));
  EXPECT_EQ (scene.labelsFound (true), (std::set<std::uint32_t>{20, 40}));
  EXPECT_EQ (scene.labelsFound (false).count (30), 1u);
  EXPECT_EQ (scene.labelsFound (true, true).count (30), 1u);
}

TEST (Pipeline, ignoresNothingThatHidesWhetherTheTableGoesOn)
{
  // Close to the camera, in the corner of the image.
  const TableScene scene (boxAt ({0.15, 0.15, 0.4}, {0.45, -0.45, 0.2}, 30));
  EXPECT_EQ (scene.labelsFound (true).count (30), 1u);
}

TEST (Pipeline, comesBackToPointsOfASegmentThatIsNotGivenOut)
{
  // The middle and the left strip wait, as the right and the middle are larger, which then takes the point of the first.
  const std::vector<AttentionSegment> segments = segmentsOfStrips (80);
  ASSERT_EQ (segments.size (), 2u);
  EXPECT_EQ (segments[0].attention_point.column, 180);
  EXPECT_EQ (segments[0].patches, (std::vector<int>{3, 2}));
  EXPECT_EQ (segments[1].attention_point.column, 70);
  EXPECT_EQ (segments[1].patches, (std::vector<int>{1, 2}));
}

TEST (Pipeline, dropsWhatIsByMoreThanHalfOfEarlierSegments)
{
  // The left strip's segment has the 40 columns of the middle one, which the right strip's has already.
  EXPECT_EQ (segmentsOfStrips (40).size (), 2u);
  const std::vector<AttentionSegment> segments = segmentsOfStrips (39);
  ASSERT_EQ (segments.size (), 1u);
  EXPECT_EQ (segments[0].patches, (std::vector<int>{3, 2}));
}

TEST (Pipeline, findsWithOtherPointsWhatWasDroppedBefore)
{
  AttentionPipeline pipeline;
  startWithStrips (39, pipeline);
  pipeline.setAttentionPoints (pointsOnStrips ({{100, 0.9f}, {70, 0.8f}, {180, 0.7f}}));
  EXPECT_EQ (allSegments (pipeline).size (), 1u); // as above
  pipeline.setPrior (AttentionPrior ()); // begins again
  pipeline.setAttentionPoints (pointsOnStrips ({{70, 0.8f}}));
  const std::vector<AttentionSegment> segments = allSegments (pipeline);
  ASSERT_EQ (segments.size (), 1u);
  EXPECT_EQ (segments[0].patches, (std::vector<int>{1, 2}));
}

TEST (Pipeline, takesTheMaximumOfAGivenSaliency)
{
  AttentionPipeline pipeline;
  pipeline.start (renderedCloud (), Eigen::Isometry3f::Identity (), AttentionParameters (), 1);
  Image<float> map (160, 120, 0.5f);
  map (20, 10) = 3.0f;
  pipeline.setSaliency (std::move (map));
  EXPECT_EQ (pipeline.saliency ().maximum, 3.0f);
  EXPECT_EQ (pipeline.saliency ().saliency (20, 10), 3.0f);
  EXPECT_EQ (pipeline.winningSymmetry ().level.size (), std::size_t{160} * 120);
  EXPECT_EQ (pipeline.winningSymmetry ().plane.size (), std::size_t{160} * 120);
}

} // namespace
