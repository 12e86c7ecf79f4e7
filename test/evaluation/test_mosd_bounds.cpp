// SPDX-License-Identifier: BSD-3-Clause
// Bounds known from mOSD's learn scenes: what exact masks score on their own ground truth, and on the other one.
#include "cases.h"
#include "evaluation/metrics.h"

#include <algorithm>
#include <map>

namespace pcl_attention
{
namespace
{

std::string
learnFolder ()
{
  const char* data = std::getenv ("PCL_ATTENTION_DATA");
  return (std::string (data && *data ? data : PCL_ATTENTION_DATA) + "/mosd_learn");
}

/** \brief Exact masks of a ground truth, the largest first. Each has its attention point on the largest of the parts it
 * covers, which is the best a single point can do on either ground truth. */
ScenePrediction
exactMasks (const GroundTruth& truth, const GroundTruth& parts)
{
  std::vector<PredictedSegment> segments (truth.regions.size ());
  std::vector<std::size_t> largest_part (truth.regions.size (), 0);
  for (std::size_t pixel = 0; pixel < truth.region_of.size (); ++pixel)
  {
    if (truth.region_of[pixel] < 0)
      continue;
    const int region = truth.region_of[pixel];
    const Region& part = parts.regions[parts.region_of[pixel]];
    segments[region].mask.push_back (static_cast<pcl::index_t> (pixel));
    if (part.pixels > largest_part[region])
    {
      largest_part[region] = part.pixels;
      segments[region].column = part.center_column;
      segments[region].row = part.center_row;
    }
  }
  std::stable_sort (segments.begin (), segments.end (),
                    [] (const auto& a, const auto& b) { return (a.mask.size () > b.mask.size ()); });
  return (test::predictionOf (truth.width, truth.height, std::move (segments)));
}

struct Scores
{
  std::vector<SceneScore> objects_on_objects, parts_on_parts, parts_on_objects, objects_on_parts;
};

class MosdBounds : public testing::Test
{
protected:
  static Scores scores_;

  static void
  SetUpTestSuite ()
  {
    if (!std::filesystem::is_directory (learnFolder ()))
      return;
    for (const std::string& path : listScenes ({learnFolder ()}))
    {
      const LabelledScene scene = loadLabelledScene (path);
      const GroundTruth objects = makeGroundTruth (*scene.cloud, GroundTruthKind::objects);
      const GroundTruth parts = makeGroundTruth (*scene.cloud, GroundTruthKind::parts);
      const ScenePrediction exact_objects = exactMasks (objects, parts), exact_parts = exactMasks (parts, parts);
      scores_.objects_on_objects.push_back (scoreScene (objects, exact_objects));
      scores_.parts_on_parts.push_back (scoreScene (parts, exact_parts));
      scores_.parts_on_objects.push_back (scoreScene (objects, exact_parts));
      scores_.objects_on_parts.push_back (scoreScene (parts, exact_objects));
      scores_.objects_on_objects.back ().category = scene.category;
    }
  }

  void
  SetUp () override
  {
    if (scores_.objects_on_objects.empty ())
      GTEST_SKIP () << "no labelled scenes in " << learnFolder () << " (set PCL_ATTENTION_DATA)";
  }
};

Scores MosdBounds::scores_;

TEST_F (MosdBounds, exactMasksArePerfectOnTheirOwnGroundTruth)
{
  for (const auto* scores : {&scores_.objects_on_objects, &scores_.parts_on_parts})
  {
    const Summary summary = summarize ("", scores->front ().kind, *scores);
    EXPECT_EQ (summary.attended, summary.objects);
    EXPECT_DOUBLE_EQ (summary.strict_first.mean, 1);
    EXPECT_DOUBLE_EQ (summary.strict_first.deviation, 0);
    EXPECT_DOUBLE_EQ (summary.strict_best.mean, 1);
    EXPECT_DOUBLE_EQ (summary.strict_all.mean, 1);
    EXPECT_DOUBLE_EQ (summary.best_of_scene.mean, 1);
    EXPECT_DOUBLE_EQ (summary.center.mean, 1);
    EXPECT_DOUBLE_EQ (summary.overlap.f, 1);
    EXPECT_DOUBLE_EQ (summary.hits_within_objects, 1);
    EXPECT_DOUBLE_EQ (summary.points_on_objects, 1);
    EXPECT_DOUBLE_EQ (summary.points_duplicate, 0);
  }
}

TEST_F (MosdBounds, theScenesAreThoseOfTheFacts)
{
  EXPECT_EQ (summarize ("", GroundTruthKind::objects, scores_.objects_on_objects).objects, 112u);
  EXPECT_EQ (summarize ("", GroundTruthKind::parts, scores_.parts_on_parts).objects, 147u);
  std::map<std::string, int> scenes_of_category;
  for (const SceneScore& scene : scores_.objects_on_objects)
    ++scenes_of_category[scene.category];
  const std::map<std::string, int> expected{{"boxes", 17}, {"stacked", 8}, {"occluded", 8}, {"cylindric", 12}};
  EXPECT_EQ (scenes_of_category, expected);
}

TEST_F (MosdBounds, exactPartsReachTheKnownBoundOnObjects)
{
  const Summary summary = summarize ("", GroundTruthKind::objects, scores_.parts_on_objects);
  EXPECT_NEAR (summary.strict_first.mean, .957, .0005);
  EXPECT_NEAR (summary.overlap.f, .949, .0005);
}

TEST_F (MosdBounds, exactObjectsReachTheKnownBoundOnParts)
{
  const Summary summary = summarize ("", GroundTruthKind::parts, scores_.objects_on_parts);
  EXPECT_NEAR (summary.strict_first.mean, .73, .005);  // one point an object: 112 of 147 parts attended
  EXPECT_NEAR (summary.best_of_scene.mean, .81, .005); // every part is in the mask of its object
}

} // namespace
} // namespace pcl_attention
