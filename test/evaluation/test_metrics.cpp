// SPDX-License-Identifier: BSD-3-Clause
// Every metric on one 4x4 scene, worked out by hand.
#include "cases.h"
#include "evaluation/metrics.h"

#include <cmath>

namespace pcl_attention
{
namespace
{

using test::predictionOf;
using test::segmentAt;

// pixels: 0 1 2 | 3     object 2: 0 1 2 4 5 6 (parts 20: 0 1 4 5, 21: 2 6); object 3: 8 9
//         4 5 6 | 7     12 has no coordinates, 13 no label
//         8 9 | 10 11
//        12 13 | 14 15
const std::vector<int> labels{20, 20, 21, 1,  //
                              20, 20, 21, 19, //
                              30, 30, 1,  1,  //
                              -1, 0,  1,  1};

ScenePrediction
fiveSegments ()
{
  return (predictionOf (4, 4,
                        {segmentAt (3, 0, {8, 9}, .1),              // on the support, its mask is object 3
                         segmentAt (0, 0, {0, 1, 4, 5, 8, 12}, .5), // on object 2, 5 valid pixels, 4 of them right
                         segmentAt (2, 1, {2, 6, 3}, .2),           // on object 2, 2 of 3 right
                         segmentAt (2, 0, {0, 1, 2, 4, 5, 6}, .9),  // exactly object 2
                         segmentAt (0, 3, {12})}));                 // on a point without coordinates
}

TEST (OverlapOf, isPrecisionRecallAndTheirHarmonicMean)
{
  const Overlap overlap = overlapOf (4, 5, 6);
  EXPECT_DOUBLE_EQ (overlap.precision, .8);
  EXPECT_DOUBLE_EQ (overlap.recall, 4. / 6);
  EXPECT_DOUBLE_EQ (overlap.f, 8. / 11);
  EXPECT_EQ (overlapOf (0, 0, 6).f, 0);
  EXPECT_EQ (overlapOf (0, 5, 0).f, 0);
}

TEST (ScoreScene, segments)
{
  const SceneScore score = scoreScene (test::truthOf (4, labels), fiveSegments ());
  ASSERT_EQ (score.segments.size (), 5u);
  EXPECT_EQ (score.segments[0].region, GroundTruth::support);
  EXPECT_EQ (score.segments[0].overlap.f, 0); // however well its mask fits another object
  EXPECT_EQ (score.segments[1].rank, 2);
  EXPECT_EQ (score.segments[1].region, 0);
  EXPECT_DOUBLE_EQ (score.segments[1].overlap.precision, 4. / 5);
  EXPECT_DOUBLE_EQ (score.segments[1].overlap.recall, 4. / 6);
  EXPECT_DOUBLE_EQ (score.segments[1].overlap.f, 8. / 11);
  EXPECT_DOUBLE_EQ (score.segments[2].overlap.f, 4. / 9);
  EXPECT_DOUBLE_EQ (score.segments[3].overlap.f, 1);
  EXPECT_EQ (score.segments[4].region, GroundTruth::invalid);
  EXPECT_EQ (score.segments[4].overlap.f, 0);
}

TEST (ScoreScene, objects)
{
  const SceneScore score = scoreScene (test::truthOf (4, labels), fiveSegments ());
  ASSERT_EQ (score.regions.size (), 2u);
  const RegionScore& attended = score.regions[0];
  EXPECT_TRUE (attended.attended ());
  EXPECT_EQ (attended.points, 3);
  EXPECT_EQ (attended.first_rank, 2);
  EXPECT_DOUBLE_EQ (attended.first.f, 8. / 11);
  EXPECT_DOUBLE_EQ (attended.best.f, 1);
  EXPECT_DOUBLE_EQ (attended.all_f, (8. / 11 + 4. / 9 + 1) / 3);
  EXPECT_DOUBLE_EQ (attended.best_of_scene_f, 1);
  EXPECT_DOUBLE_EQ (attended.center_f,
                    .8); // centre pixel 1, in the label image the 4 valid pixels of the second segment

  const RegionScore& unattended = score.regions[1];
  EXPECT_FALSE (unattended.attended ());
  EXPECT_EQ (unattended.points, 0);
  EXPECT_EQ (unattended.first.f, 0);
  EXPECT_EQ (unattended.best.f, 0);
  EXPECT_EQ (unattended.all_f, 0);
  EXPECT_DOUBLE_EQ (unattended.best_of_scene_f, 1);
  EXPECT_DOUBLE_EQ (unattended.center_f, 1);
}

TEST (ScoreScene, parts)
{
  const SceneScore score = scoreScene (test::truthOf (4, labels, GroundTruthKind::parts), fiveSegments ());
  EXPECT_EQ (score.kind, GroundTruthKind::parts);
  ASSERT_EQ (score.regions.size (), 3u);
  EXPECT_DOUBLE_EQ (score.regions[0].first.f, 8. / 9); // part 20: all 4 in a mask of 5
  EXPECT_EQ (score.regions[1].first_rank, 3);          // part 21
  EXPECT_DOUBLE_EQ (score.regions[1].first.f, 4. / 5);
  EXPECT_DOUBLE_EQ (score.regions[1].all_f, (4. / 5 + 2. * 2 / (6 + 2)) / 2);
  EXPECT_EQ (score.regions[2].first_rank, 0);
}

TEST (ScoreScene, anEmptyMaskScoresNothing)
{
  const SceneScore score = scoreScene (test::truthOf (4, labels), predictionOf (4, 4, {segmentAt (0, 0, {})}));
  EXPECT_TRUE (score.regions[0].attended ());
  EXPECT_EQ (score.regions[0].first.f, 0);
  EXPECT_EQ (score.regions[0].best.f, 0);
}

TEST (ScoreScene, aPointOnAnUnlabelledPixelAttendsNothing)
{
  const SceneScore score = scoreScene (test::truthOf (4, labels), predictionOf (4, 4, {segmentAt (1, 3, {13})}));
  EXPECT_EQ (score.segments[0].region, GroundTruth::unlabelled);
  EXPECT_EQ (summarize ("", score.kind, {score}).points_on_invalid, 1);
}

TEST (ScoreScene, refusesWhatDoesNotFitTheImage)
{
  const GroundTruth truth = test::truthOf (4, labels);
  EXPECT_THROW (scoreScene (truth, predictionOf (4, 3, {})), std::invalid_argument);
  EXPECT_THROW (scoreScene (truth, predictionOf (4, 4, {segmentAt (4, 0, {})})), std::invalid_argument);
  EXPECT_THROW (scoreScene (truth, predictionOf (4, 4, {segmentAt (0, -1, {})})), std::invalid_argument);
  ScenePrediction prediction = fiveSegments ();
  prediction.segments[0].mask.push_back (16);
  EXPECT_THROW (scoreScene (truth, prediction), std::invalid_argument);
  prediction = fiveSegments ();
  prediction.labels.pop_back ();
  EXPECT_THROW (scoreScene (truth, prediction), std::invalid_argument);
}

TEST (LabelImage, theFirstSegmentThatClaimsAPixelHasIt)
{
  const std::vector<std::uint32_t> expected{2, 2, 3, 3, 2, 2, 3, 0, 1, 1, 0, 0, 2, 0, 0, 0};
  EXPECT_EQ (fiveSegments ().labels, expected);
}

TEST (LabelImage, overlapMatchesSegmentsAndObjectsOneToOne)
{
  // {8 9} - object 3: F 1; {0 1 4 5} - object 2: F .8; {2 3 6} - object 2: F 4/9, has no partner
  const Overlap overlap = scoreScene (test::truthOf (4, labels), fiveSegments ()).overlap;
  EXPECT_DOUBLE_EQ (overlap.precision, 6. / 9);
  EXPECT_DOUBLE_EQ (overlap.recall, 6. / 8);
  EXPECT_DOUBLE_EQ (overlap.f, 12. / 17);
}

TEST (LabelImage, overlapIgnoresPixelsWithoutCoordinatesAndTheNumbersOfTheLabels)
{
  const GroundTruth truth = test::truthOf (4, labels);
  EXPECT_DOUBLE_EQ (labelImageOverlap (truth, {7, 7, 7, 0, 7, 7, 7, 0, 4000000000u, 4000000000u, 0, 0, 5, 0, 0, 0}).f,
                    1);
}

TEST (LabelImage, overlapFollowsTheConventionForNothing)
{
  const std::vector<std::uint32_t> nothing (4, 0), something{1, 1, 0, 0};
  const GroundTruth empty = test::truthOf (2, {1, 1, 1, 1}), one = test::truthOf (2, {20, 20, 1, 1});
  EXPECT_EQ (labelImageOverlap (empty, nothing).f, 1);
  EXPECT_EQ (labelImageOverlap (one, nothing).precision, 1);
  EXPECT_EQ (labelImageOverlap (one, nothing).recall, 0);
  EXPECT_EQ (labelImageOverlap (one, nothing).f, 0);
  EXPECT_EQ (labelImageOverlap (empty, something).precision, 0);
  EXPECT_EQ (labelImageOverlap (empty, something).recall, 1);
  EXPECT_EQ (labelImageOverlap (empty, something).f, 0);
}

TEST (LabelImage, isAPredictionWithoutAttentionPoints)
{
  const ScenePrediction prediction = predictionOfLabels (4, 4, fiveSegments ().labels);
  ASSERT_EQ (prediction.segments.size (), 3u);
  EXPECT_EQ (prediction.segments[2].mask, (pcl::Indices{2, 3, 6}));
  const SceneScore score = scoreScene (test::truthOf (4, labels), prediction);
  EXPECT_TRUE (score.segments.empty ());
  EXPECT_FALSE (score.regions[0].attended ());
  EXPECT_DOUBLE_EQ (score.regions[0].best_of_scene_f, .8);
  EXPECT_DOUBLE_EQ (score.regions[0].center_f, .8);
  EXPECT_DOUBLE_EQ (score.overlap.f, 12. / 17);
}

TEST (Summarize, oneScene)
{
  const SceneScore score = scoreScene (test::truthOf (4, labels), fiveSegments ());
  const Summary summary = summarize ("group", GroundTruthKind::objects, {score});
  EXPECT_EQ (summary.group, "group");
  EXPECT_EQ (summary.scenes, 1u);
  EXPECT_EQ (summary.objects, 2u);
  EXPECT_EQ (summary.attended, 1u);
  EXPECT_EQ (summary.points, 5u);
  EXPECT_DOUBLE_EQ (summary.attended_first.mean, 8. / 11);
  EXPECT_DOUBLE_EQ (summary.attended_first.deviation, 0);
  EXPECT_DOUBLE_EQ (summary.attended_best.mean, 1);
  EXPECT_DOUBLE_EQ (summary.attended_all.mean, (8. / 11 + 4. / 9 + 1) / 3);
  EXPECT_DOUBLE_EQ (summary.strict_first.mean, 4. / 11);
  EXPECT_DOUBLE_EQ (summary.strict_first.deviation, 4. / 11);
  EXPECT_DOUBLE_EQ (summary.strict_best.mean, .5);
  EXPECT_DOUBLE_EQ (summary.strict_all.mean, (8. / 11 + 4. / 9 + 1) / 6);
  EXPECT_DOUBLE_EQ (summary.best_of_scene.mean, 1);
  EXPECT_DOUBLE_EQ (summary.center.mean, .9);
  EXPECT_DOUBLE_EQ (summary.center.deviation, .1);
  EXPECT_DOUBLE_EQ (summary.coverage, .5);
  EXPECT_DOUBLE_EQ (summary.points_per_scene, 5);
  EXPECT_DOUBLE_EQ (summary.points_per_object, 3);
  EXPECT_DOUBLE_EQ (summary.points_on_objects, 3. / 5);
  EXPECT_DOUBLE_EQ (summary.points_on_support, 1. / 5);
  EXPECT_DOUBLE_EQ (summary.points_on_invalid, 1. / 5);
  EXPECT_DOUBLE_EQ (summary.points_duplicate, 2. / 5);
  EXPECT_DOUBLE_EQ (summary.overlap.f, 12. / 17);
  // confidences .1 .5 .2 .9 have the order of the F values 0 8/11 4/9 1; the fifth has none
  EXPECT_DOUBLE_EQ (summary.confidence_correlation, 1);
}

TEST (Summarize, countsTheFifthAndTheTenthPoint)
{
  const GroundTruth truth = test::truthOf (3, {20, 30, 1});
  std::vector<PredictedSegment> segments (10, segmentAt (2, 0, {}));
  segments[4] = segmentAt (0, 0, {0});
  segments[9] = segmentAt (1, 0, {1});
  const Summary summary =
      summarize ("", GroundTruthKind::objects, {scoreScene (truth, predictionOf (3, 1, std::move (segments)))});
  EXPECT_DOUBLE_EQ (summary.hits_within_5, 1. / 2);
  EXPECT_DOUBLE_EQ (summary.hits_within_10, 1);
}

TEST (Summarize, hitsWithinTheFirstPoints)
{
  // three objects of one pixel, attended by the points of rank 2, 6 and 11; all others fall on the support
  const GroundTruth truth = test::truthOf (4, {20, 30, 40, 1});
  std::vector<PredictedSegment> segments (11, segmentAt (3, 0, {}));
  segments[1] = segmentAt (0, 0, {0});
  segments[5] = segmentAt (1, 0, {1});
  segments[10] = segmentAt (2, 0, {2});
  const Summary summary =
      summarize ("", GroundTruthKind::objects, {scoreScene (truth, predictionOf (4, 1, std::move (segments)))});
  EXPECT_DOUBLE_EQ (summary.coverage, 1);
  EXPECT_DOUBLE_EQ (summary.hits_within_5, 1. / 3);
  EXPECT_DOUBLE_EQ (summary.hits_within_10, 2. / 3);
  EXPECT_DOUBLE_EQ (summary.hits_within_objects, 1. / 3); // the first three points
  EXPECT_DOUBLE_EQ (summary.points_per_scene, 11);
  EXPECT_DOUBLE_EQ (summary.points_on_support, 8. / 11);
}

TEST (Summarize, nothingToAverageIsNotANumber)
{
  const Summary summary = summarize ("", GroundTruthKind::objects,
                                     {scoreScene (test::truthOf (2, {1, 1, 0, -1}), predictionOf (2, 2, {}))});
  EXPECT_EQ (summary.objects, 0u);
  EXPECT_TRUE (std::isnan (summary.attended_first.mean));
  EXPECT_TRUE (std::isnan (summary.strict_first.mean));
  EXPECT_TRUE (std::isnan (summary.coverage));
  EXPECT_TRUE (std::isnan (summary.points_on_support));
  EXPECT_TRUE (std::isnan (summary.confidence_correlation));
  EXPECT_EQ (summary.points_per_scene, 0);
  EXPECT_EQ (summary.overlap.f, 1);
}

TEST (Summarize, overallAndByCategory)
{
  SceneScore good = scoreScene (test::truthOf (2, {20, 20, 1, 1}), predictionOf (2, 2, {segmentAt (0, 0, {0, 1})}));
  SceneScore bad = scoreScene (test::truthOf (2, {20, 20, 1, 1}), predictionOf (2, 2, {segmentAt (0, 1, {2, 3})}));
  SceneScore other = good;
  good.category = "good";
  bad.category = "bad";
  other.kind = GroundTruthKind::parts;
  const auto summaries = summarizeByCategory (GroundTruthKind::objects, {good, bad, other});
  ASSERT_EQ (summaries.size (), 3u);
  EXPECT_EQ (summaries[0].group, "overall");
  EXPECT_EQ (summaries[0].scenes, 2u);
  EXPECT_DOUBLE_EQ (summaries[0].strict_first.mean, .5);
  EXPECT_DOUBLE_EQ (summaries[0].overlap.f, .5);
  EXPECT_EQ (summaries[1].group, "good");
  EXPECT_DOUBLE_EQ (summaries[1].strict_first.mean, 1);
  EXPECT_EQ (summaries[2].group, "bad");
  EXPECT_DOUBLE_EQ (summaries[2].strict_first.mean, 0);
  EXPECT_EQ (summarizeByCategory (GroundTruthKind::parts, {good, bad, other}).size (), 1u);
}

} // namespace
} // namespace pcl_attention
