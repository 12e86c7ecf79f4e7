// SPDX-License-Identifier: BSD-3-Clause
// The viewer without its window: what it computes, selects, shows and saves.
#include "../apps/files.h"
#include "layers.h"
#include "overview_image.h"
#include "scene_renderer.h"
#include "scene_sequence.h"
#include "segment_writer.h"
#include "viewer_files.h"
#include "viewer_model.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/io/png_io.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

using namespace pcl_attention;

namespace
{

pcl::PointCloud<pcl::PointXYZRGBL>::Ptr
rendered (std::uint64_t seed)
{
  SceneDescription description = makeScene (SceneKind::clutter, seed);
  description.camera = description.camera.resized (320, 240);
  return (renderScene (description, seed));
}

ViewerScenePtr
labelledScene (std::uint64_t seed)
{
  const auto labelled = rendered (seed);
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
  pcl::copyPointCloud (*labelled, *cloud);
  return (
      makeViewerScene (makeSceneOf (cloud, "scene" + std::to_string (seed), true),
                       std::make_shared<const GroundTruth> (makeGroundTruth (*labelled, GroundTruthKind::objects))));
}

/** \brief A viewer that has opened a scene. */
class Viewer : public testing::Test
{
protected:
  static ViewerScenePtr
  scene ()
  {
    static const ViewerScenePtr result = labelledScene (6);
    return (result);
  }

  AttentionWorker worker_{2};
  ViewerModel model_{presetParameters ("default")};
  test::TemporaryFolder folder_;

  void
  SetUp () override
  {
    open ([] { return (scene ()); });
    ASSERT_GE (model_.segments ().size (), 5u);
  }

  void
  open (const std::function<ViewerScenePtr ()>& load)
  {
    AttentionRequest request = model_.request ();
    request.load = load;
    worker_.submit (std::move (request));
    model_.setResults (worker_.wait ());
  }

  bool
  compute ()
  {
    worker_.submit (model_.request ());
    return (model_.setResults (worker_.wait ()));
  }

  static const Knob&
  knob (const std::string& parameter)
  {
    return (*std::find_if (knobs ().begin (), knobs ().end (),
                           [&] (const Knob& candidate) { return (candidate.parameter == parameter); }));
  }
};

TEST_F (Viewer, findsWhatTheProgramFinds)
{
  const SceneSegments expected = segmentScene (scene ()->scene, AttentionParameters (), 1);
  const SceneSegments found = model_.sceneSegments ();
  ASSERT_EQ (found.segments.size (), expected.segments.size ());
  for (std::size_t k = 0; k < found.segments.size (); ++k)
    EXPECT_EQ (found.segments[k].indices, expected.segments[k].indices);
  EXPECT_EQ (segmentsJson (found), segmentsJson (expected));
  EXPECT_EQ (found.extracted_points, expected.extracted_points);
  EXPECT_EQ (found.patches, expected.patches);
}

TEST_F (Viewer, stepsThroughTheObjectsAndBack)
{
  const int count = static_cast<int> (model_.segments ().size ());
  EXPECT_EQ (model_.selected (), nullptr);
  for (int rank = 1; rank <= count; ++rank)
  {
    model_.selectNext (1);
    ASSERT_NE (model_.selected (), nullptr);
    EXPECT_EQ (model_.selected ()->rank, rank);
    EXPECT_EQ (model_.objectText ().find ("Object " + std::to_string (rank) + " of " + std::to_string (count)), 0u);
  }
  model_.selectNext (1);
  EXPECT_EQ (model_.selected (), nullptr);
  model_.selectNext (-1);
  EXPECT_EQ (model_.selected ()->rank, count);
}

TEST_F (Viewer, stepsThroughTheGrowthOfAnObject)
{
  model_.stepNext (1); // selects the first object
  ASSERT_NE (model_.selected (), nullptr);
  const AttentionSegment segment = *model_.selected ();
  ASSERT_FALSE (segment.steps.empty ());
  EXPECT_EQ (model_.step (), 0);
  EXPECT_EQ (model_.growth ().step, nullptr);
  std::vector<int> patches = model_.growth ().patches;
  ASSERT_FALSE (patches.empty ());
  EXPECT_EQ (patches.front (), segment.patches.front ());
  for (std::size_t k = 0; k < segment.steps.size (); ++k)
  {
    model_.stepNext (1);
    const GrowthState state = model_.growth ();
    ASSERT_NE (state.step, nullptr);
    EXPECT_EQ (state.patches, patches);
    EXPECT_EQ (state.step->patch, segment.steps[k].patch);
    const bool accepted = segment.steps[k].refused_by == GrowthConstraint::none;
    EXPECT_NE (model_.objectText ().find (accepted ? " accepted" : " refused by "), std::string::npos);
    if (accepted)
      patches.push_back (state.step->patch);

    // The patch that is tried has the colour of its fate, the object the third one.
    const Image<Color> picture = paintView (model_, View::patches);
    const PlanarPatches& all = *model_.results ().patches;
    const Color& tried = picture[all.patches[state.step->patch - 1].pixels.front ()];
    EXPECT_GT (tried[accepted ? 1 : 0], tried[accepted ? 0 : 1]);
    const Color& grown = picture[all.patches[state.patches.front () - 1].pixels.front ()];
    EXPECT_GT (grown[2], grown[0]);
  }
  model_.stepNext (1);
  EXPECT_EQ (model_.step (), -1) << "the whole object";
  model_.stepNext (-1);
  EXPECT_EQ (model_.step (), static_cast<int> (segment.steps.size ()));
}

TEST_F (Viewer, showsNoGrowthWhileTheObjectsAreFoundAnew)
{
  model_.stepNext (1);
  const AttentionResultsPtr whole = std::make_shared<const AttentionResults> (model_.results ());
  AttentionResults begun = *whole; // as the worker publishes it once the saliency has changed
  begun.segments.clear ();
  begun.complete = false;
  model_.setResults (std::make_shared<const AttentionResults> (begun));
  EXPECT_EQ (model_.selected (), nullptr);
  EXPECT_EQ (model_.step (), -1);
  EXPECT_EQ (titleOf (model_, View::patches), "Patches");
  EXPECT_TRUE (legendOf (model_, View::patches).empty ());
  model_.setResults (whole);
  EXPECT_EQ (model_.step (), 0) << "the object is there again, and its growth";
}

TEST (ViewerTexts, sayByWhichConstraintAndHowMuch)
{
  const auto step = [] (GrowthConstraint constraint, float value, float limit) {
    return (describeStep (GrowthStep{7, constraint, value, limit}));
  };
  EXPECT_EQ (step (GrowthConstraint::none, 0.0021f, 0.005f), "Patch 7 accepted\ncompactness 2.1 mm, under 5.0 mm");
  EXPECT_EQ (step (GrowthConstraint::compactness, 0.0072f, 0.005f),
             "Patch 7 refused by compactness\n7.2 mm, under 5.0 mm: 2.2 mm too much");
  EXPECT_EQ (step (GrowthConstraint::connection, 0.32f, 0.5f),
             "Patch 7 refused by connection\n32 % connected, 50 % needed");
  EXPECT_EQ (step (GrowthConstraint::convexity, -0.45f, -0.2f),
             "Patch 7 refused by convexity\n-0.45, at least -0.20: short by 0.25");
  EXPECT_EQ (step (GrowthConstraint::convexity, 0.93f, 0.5f),
             "Patch 7 refused by convexity\n0.93, at most 0.50 at the rim of an inside");
  EXPECT_EQ (step (GrowthConstraint::color, 0.61f, 0.42f),
             "Patch 7 refused by colour\n0.61 from the object, 0.42 from the rest");
  EXPECT_EQ (step (GrowthConstraint::support, 1.0f, 0.0f),
             "Patch 7 refused by support\nit belongs to a plane of the background");
}

TEST_F (Viewer, aKnobChangesTheObjectsAndOnlyWhatDependsOnIt)
{
  const AttentionResults before = model_.results ();
  const std::vector<std::uint32_t> labels_before = segmentLabels (scene ()->scene, model_.segments ());
  EXPECT_EQ (model_.knobText (knob ("compactness_threshold")), "5.0 mm");
  EXPECT_FALSE (model_.setKnob (knob ("compactness_threshold"), 0.0051)) << "the same value of the raster";
  EXPECT_TRUE (model_.setKnob (knob ("compactness_threshold"), 0.0001)) << "the lowest of the raster";
  EXPECT_EQ (model_.knobText (knob ("compactness_threshold")), "0.0 mm");
  compute ();
  EXPECT_EQ (model_.results ().saliency, before.saliency) << "the very same maps";
  EXPECT_EQ (model_.results ().patches, before.patches);
  EXPECT_EQ (model_.results ().normals, before.normals);
  EXPECT_NE (segmentLabels (scene ()->scene, model_.segments ()), labels_before);

  EXPECT_TRUE (model_.setKnob (knob ("levels"), 2.0));
  compute ();
  EXPECT_NE (model_.results ().saliency, before.saliency);
  EXPECT_EQ (model_.results ().saliency->levels.size (), 2u);
  EXPECT_EQ (model_.results ().patches, before.patches);

  model_.resetParameters ();
  compute ();
  ASSERT_EQ (model_.results ().segments.size (), before.segments.size ());
  for (std::size_t k = 0; k < before.segments.size (); ++k)
    EXPECT_EQ (model_.results ().segments[k].indices, before.segments[k].indices);
}

TEST_F (Viewer, theWayOfAttentionIsAKnobAndItsMapIsShown)
{
  const AttentionResults before = model_.results ();
  const auto saliencyPicture = [this] { return (paintView (model_, View::saliency).data); };
  const std::vector<Color> picture = saliencyPicture ();
  EXPECT_TRUE (model_.setKnob (knob ("strategy"), 2.0));
  EXPECT_EQ (model_.knobText (knob ("strategy")), "image winner take all");
  compute ();
  for (const AttentionPoint& point : model_.results ().attention_points->points)
    EXPECT_EQ (point.kind, AttentionPointKind::winner);
  EXPECT_EQ (model_.results ().saliency, before.saliency) << "the very same maps";
  EXPECT_NE (saliencyPicture (), picture);
  EXPECT_EQ (titleOf (model_, View::saliency), "Saliency of the colours");
  EXPECT_EQ (titleOf (model_, View::points), "Fixations");
  ASSERT_EQ (legendOf (model_, View::points).size (), 1u);

  EXPECT_TRUE (model_.setKnob (knob ("strategy"), 1.0));
  compute ();
  EXPECT_EQ (titleOf (model_, View::saliency), "Saliency") << "winners of the map of the normals' symmetry";
  EXPECT_EQ (saliencyPicture (), picture);

  model_.resetParameters ();
  compute ();
  EXPECT_EQ (titleOf (model_, View::points), "Skeletons and fixations");
  EXPECT_EQ (legendOf (model_, View::points).size (), 2u);
  EXPECT_EQ (model_.segments ().size (), before.segments.size ());
}

TEST_F (Viewer, everyKnobIsAParameterOfTheTable)
{
  for (const Knob& each : knobs ())
  {
    EXPECT_TRUE (model_.setKnob (each, each.low) || model_.setKnob (each, each.high)) << each.parameter;
    EXPECT_EQ (validate (model_.parameters ().values), "");
    EXPECT_FALSE (model_.knobText (each).empty ());
  }
}

TEST_F (Viewer, segmentsFromTheUsersFixationAndTakesItBack)
{
  const AttentionSegment third = model_.segments ()[2];
  const std::size_t count = model_.segments ().size ();
  const pcl::index_t pixel = third.indices[third.indices.size () / 2];
  model_.addFixation (pixel % 320, pixel / 320);
  EXPECT_TRUE (compute ());
  ASSERT_EQ (model_.segments ().size (), count + 1);
  ASSERT_NE (model_.selected (), nullptr);
  EXPECT_EQ (model_.selected ()->rank, static_cast<int> (count) + 1);
  EXPECT_EQ (model_.selected ()->attention_point.kind, AttentionPointKind::user);
  EXPECT_TRUE (std::binary_search (model_.selected ()->indices.begin (), model_.selected ()->indices.end (), pixel));
  EXPECT_GE (model_.score (count), 0.5);

  // It follows the knobs, and is forgotten with its scene.
  model_.setKnob (knob ("levels"), 3.0);
  compute ();
  EXPECT_EQ (model_.segments ().back ().attention_point.kind, AttentionPointKind::user);
  EXPECT_TRUE (model_.undoFixation ());
  compute ();
  EXPECT_EQ (model_.segments ().size (), model_.results ().segments.size ());
  EXPECT_FALSE (model_.undoFixation ());
}

TEST_F (Viewer, saysWhenThereIsNoObjectAtAFixation)
{
  // A hole that is wider than what is looked at around a fixation.
  constexpr int column = 30, row = 200, radius = 15;
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB> (*scene ()->scene.cloud));
  for (int y = row - radius; y <= row + radius; ++y)
    for (int x = column - radius; x <= column + radius; ++x)
      (*cloud) (x, y).x = std::numeric_limits<float>::quiet_NaN ();
  open ([cloud] { return (makeViewerScene (makeSceneOf (cloud, "hole", true))); });
  EXPECT_TRUE (model_.results ().scores.empty ()) << "no labels";
  const std::size_t count = model_.segments ().size ();
  model_.addFixation (column, row);
  EXPECT_FALSE (compute ());
  EXPECT_TRUE (model_.ownFixations ().empty ());
  EXPECT_EQ (model_.segments ().size (), count);
}

TEST_F (Viewer, scoresTheObjectsAgainstTheLabels)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < model_.segments ().size (); ++k)
    sum += model_.score (k);
  EXPECT_GT (sum / static_cast<double> (model_.segments ().size ()), 0.8);
  EXPECT_NE (model_.sceneText ().find ("mean F"), std::string::npos);

  model_.switches.errors = true;
  const Image<Color> picture = paintView (model_, View::segments);
  const std::vector<std::uint32_t> labels = segmentLabels (scene ()->scene, model_.segments ());
  const GroundTruth& truth = *scene ()->truth;
  for (std::size_t i = 0; i < picture.size (); ++i)
  {
    const Color& color = picture[i];
    if (truth.region_of[i] >= 0 && labels[i] == 0)
    {
      ASSERT_EQ (color, (Color{80, 140, 255})) << "missed";
    }
    else if (truth.region_of[i] == GroundTruth::support && labels[i] > 0)
    {
      ASSERT_EQ (color, (Color{240, 60, 60})) << "wrong";
    }
    else if (truth.region_of[i] == GroundTruth::support)
    {
      ASSERT_EQ (color[0], color[1]) << "nothing to say";
    }
  }
}

TEST_F (Viewer, paintsEachLayerWhereItBelongs)
{
  const AttentionResults& results = model_.results ();
  const std::size_t top = static_cast<std::size_t> (
      std::max_element (results.saliency->saliency.data.begin (), results.saliency->saliency.data.end ()) -
      results.saliency->saliency.data.begin ());
  EXPECT_EQ (paintView (model_, View::saliency)[top], saliencyColor (1.0f));
  EXPECT_EQ (paintView (model_, View::color).data, scene ()->background.data);

  const Image<Color> segments = paintView (model_, View::segments);
  const pcl::index_t inside = model_.segments ()[0].indices[0];
  EXPECT_NE (segments[inside], scene ()->background[inside]);

  const Overlay outline = overlayOf (model_, View::segments);
  ASSERT_FALSE (outline.pixels.empty ());
  for (std::size_t k = 0; k < outline.pixels.size (); ++k)
  {
    const bool belongs =
        std::any_of (model_.segments ().begin (), model_.segments ().end (), [&] (const AttentionSegment& segment) {
          return (segmentColor (segment.rank) == outline.colors[k] &&
                  std::binary_search (segment.indices.begin (), segment.indices.end (), outline.pixels[k]));
        });
    ASSERT_TRUE (belongs);
  }
  model_.switches.outlines = false;
  EXPECT_TRUE (overlayOf (model_, View::segments).pixels.empty ());

  // Borders of patches are green where they are convex, red where they are concave.
  EXPECT_TRUE (overlayOf (model_, View::patches).pixels.empty ());
  model_.switches.convexity = true;
  const Overlay borders = overlayOf (model_, View::patches);
  const Image<int>& labels = results.patches->labels;
  int judged = 0;
  for (std::size_t k = 0; k < borders.pixels.size (); ++k)
  {
    const int label = labels[borders.pixels[k]], right = labels[borders.pixels[k] + 1];
    if (right == 0 || right == label || labels[borders.pixels[k] + labels.width] != label)
      continue;
    const PatchBorder border = results.patch_graph->border (label, right);
    if (border.connectedShare () < 0.5f || std::abs (border.convexity ()) < 0.3f)
      continue;
    ++judged;
    ASSERT_EQ (borders.colors[k][1] > borders.colors[k][0], border.convexity () > 0.0f);
  }
  EXPECT_GT (judged, 10);

  const std::vector<FixationMark> marks = fixationMarks (model_, View::points, false);
  ASSERT_EQ (marks.size (), model_.segments ().size ());
  EXPECT_EQ (marks[2].text, "3");
  EXPECT_EQ (marks[2].column, model_.segments ()[2].attention_point.column);
  EXPECT_EQ (fixationMarks (model_, View::segments, true)[0].text.find ("1  F "), 0u);
  EXPECT_TRUE (fixationMarks (model_, View::color, false).empty ());

  model_.switches.normals = true;
  EXPECT_NE (paintView (model_, View::color).data, scene ()->background.data);
  EXPECT_EQ (titleOf (model_, View::color), "Normals");
  model_.nextSaliencyLevel ();
  EXPECT_EQ (titleOf (model_, View::saliency), "Saliency, level 1");
  for (std::size_t level = 1; level <= results.saliency->levels.size (); ++level)
    model_.nextSaliencyLevel ();
  EXPECT_EQ (model_.saliencyLevel (), 0) << "after the coarsest level the sum";
}

TEST_F (Viewer, savesTheObjectTheResultsAndTheParameters)
{
  EXPECT_THROW (saveSelectedObject (model_, folder_ / "out"), std::runtime_error);
  model_.selectNext (1);
  pcl::PointCloud<pcl::PointXYZRGB> object;
  ASSERT_EQ (pcl::io::loadPCDFile (saveSelectedObject (model_, folder_ / "out"), object), 0);
  ASSERT_EQ (object.size (), model_.selected ()->indices.size ());
  const pcl::PointXYZRGB& expected = (*scene ()->scene.cloud)[model_.selected ()->indices.front ()];
  EXPECT_EQ (object[0].x, expected.x);
  EXPECT_EQ (object[0].z, expected.z);
  EXPECT_EQ (object[0].r, expected.r);

  model_.setKnob (knob ("compactness_threshold"), 0.008);
  compute ();
  const std::string results = saveResults (model_, folder_ / "out");
  const nlohmann::json summary = nlohmann::json::parse (test::readText (results + "/summary.json"));
  EXPECT_EQ (summary["parameters"]["compactness_threshold"], 0.008);
  EXPECT_EQ (summary["counts"]["segments"], model_.segments ().size ());
  EXPECT_EQ (test::namesIn (results).count (maskFileName (static_cast<int> (model_.segments ().size ()))), 1u);

  const std::string parameters = saveParameters (model_, folder_ / "out");
  EXPECT_EQ (nlohmann::json::parse (test::readText (parameters)), summary["parameters"]) << "what the program reads";
  model_.resetParameters ();
  model_.loadParameters (parameters);
  EXPECT_EQ (model_.knobText (knob ("compactness_threshold")), "8.0 mm");
  test::writeText (folder_ / "bad.json", R"({"levels": 99})");
  EXPECT_THROW (model_.loadParameters (folder_ / "bad.json"), std::runtime_error);
  EXPECT_EQ (model_.knobText (knob ("compactness_threshold")), "8.0 mm");

  EXPECT_EQ (unusedPath (folder_ / "out", "view", "png"), folder_ / "out/view_0001.png");
  savePicture (scene ()->background, folder_ / "out/view_0001.png");
  EXPECT_EQ (unusedPath (folder_ / "out", "view", "png"), folder_ / "out/view_0002.png");
  EXPECT_THROW (savePicture (scene ()->background, folder_ / "none/view.png"), std::runtime_error);
}

TEST_F (Viewer, aSceneThatCannotBeReadLeavesTheOneBefore)
{
  model_.selectNext (1);
  open ([this] { return (readViewerScene (folder_ / "missing.pcd", {})); });
  EXPECT_NE (model_.results ().error.find ("missing.pcd: no such file"), std::string::npos);
  EXPECT_EQ (model_.results ().scene, scene ());
  EXPECT_NE (model_.selected (), nullptr);
  open ([] { return (labelledScene (7)); });
  EXPECT_EQ (model_.results ().error, "");
  EXPECT_NE (model_.results ().scene, scene ());
  EXPECT_EQ (model_.selected (), nullptr);
  EXPECT_TRUE (model_.results ().complete);
}

TEST_F (Viewer, ofWaitingRequestsOnlyTheNewestIsComputed)
{
  for (const double threshold : {0.001, 0.002, 0.003, 0.004, 0.006, 0.007})
  {
    model_.setKnob (knob ("compactness_threshold"), threshold);
    worker_.submit (model_.request ());
  }
  const AttentionResultsPtr results = worker_.wait ();
  EXPECT_TRUE (results->complete);
  EXPECT_FLOAT_EQ (results->parameters.clustering.compactness_threshold, 0.007f);
  EXPECT_FALSE (worker_.isBusy ());
}

TEST_F (Viewer, keepsWhatARequestHadComputedWhenItWasGivenUp)
{
  // Wherever the second request comes into the first, its scene cannot be read and the same is to be computed.
  for (int delay = 0; delay < 60; delay += 2)
  {
    const bool odd = delay / 2 % 2 == 1;
    AttentionRequest request = model_.request ();
    request.parameters.saliency.levels = odd ? 3 : 2;
    request.parameters.patches.minimum_size = odd ? 400 : 10;
    AttentionRequest next = request;
    worker_.submit (std::move (request));
    std::this_thread::sleep_for (std::chrono::milliseconds (delay));
    next.load = [this] { return (readViewerScene (folder_ / "missing.pcd", {})); };
    worker_.submit (std::move (next));
    const AttentionResultsPtr results = worker_.wait ();
    ASSERT_EQ (results->saliency->levels.size (), odd ? 3u : 2u) << "after " << delay;
    const auto patches = static_cast<int> (results->patches->patches.size ());
    for (const auto& border : results->patch_graph->borders)
      ASSERT_LE (border.first.second, patches) << "after " << delay;
  }
}

TEST_F (Viewer, knowsOwnFixationsByTheirSceneAndPlace)
{
  const pcl::index_t first = model_.segments ()[1].indices.front (), second = model_.segments ()[2].indices.front ();
  model_.addFixation (first % 320, first / 320);
  AttentionRequest request = model_.request ();
  request.load = [] { return (labelledScene (7)); };
  worker_.submit (std::move (request));
  EXPECT_TRUE (worker_.wait ()->own_segments.empty ()) << "it lies in the scene before";
  EXPECT_TRUE (model_.setResults (worker_.results ()));
  EXPECT_TRUE (model_.ownFixations ().empty ());

  open ([] { return (scene ()); });
  model_.addFixation (first % 320, first / 320);
  worker_.submit (model_.request ());
  AttentionResults older = *worker_.wait ();
  ASSERT_EQ (older.own_segments.size (), 1u);
  older.own_segments[0].indices.clear ();
  model_.undoFixation ();
  model_.addFixation (second % 320, second / 320);
  EXPECT_TRUE (model_.setResults (std::make_shared<const AttentionResults> (older)));
  ASSERT_EQ (model_.ownFixations ().size (), 1u) << "nothing is known of it yet";
  EXPECT_TRUE (compute ());
  ASSERT_NE (model_.selected (), nullptr);
  EXPECT_TRUE (std::binary_search (model_.selected ()->indices.begin (), model_.selected ()->indices.end (), second));

  // Where another scene cannot be read, they stay.
  open ([this] { return (readViewerScene (folder_ / "missing.pcd", {})); });
  EXPECT_EQ (model_.segments ().back ().attention_point.kind, AttentionPointKind::user);
}

TEST_F (Viewer, endsInTheMiddleOfAComputation)
{
  for (int round = 0; round < 3; ++round)
  {
    AttentionWorker worker (2);
    AttentionRequest request = model_.request ();
    request.load = [] { return (scene ()); };
    worker.submit (std::move (request));
    std::this_thread::sleep_for (std::chrono::milliseconds (10 * round));
  }
}

TEST (ViewerScenes, readsLabelsWhereThereAreSome)
{
  const test::TemporaryFolder folder;
  const auto labelled = rendered (1);
  pcl::io::savePCDFileBinaryCompressed (folder / "labelled.pcd", *labelled);
  EXPECT_NE (readViewerScene (folder / "labelled.pcd", {})->truth, nullptr);
  pcl::PointCloud<pcl::PointXYZ> bare;
  pcl::copyPointCloud (*labelled, bare);
  pcl::io::savePCDFileBinaryCompressed (folder / "bare.pcd", bare);
  const ViewerScenePtr scene = readViewerScene (folder / "bare.pcd", {});
  EXPECT_EQ (scene->truth, nullptr);
  EXPECT_FALSE (scene->cloud.hasColor ());
  EXPECT_NEAR (scene->focal_length, 262.5f, 5.0f);
}

TEST (ViewerScenes, saysNothingOfLabelsInOtherFiles)
{
  const test::TemporaryFolder folder;
  pcl::PLYWriter ().write (folder / "labelled.ply", *rendered (1), true, false);
  const ViewerScenePtr scene = readViewerScene (folder / "labelled.ply", {});
  EXPECT_EQ (scene->truth, nullptr);
  EXPECT_EQ (scene->scene.notes, std::vector<std::string> ());
}

TEST (ViewerScenes, doesNotTakeLabelsWhosePointsAreOrganizedAnew)
{
  const test::TemporaryFolder folder;
  const auto labelled = rendered (1);
  labelled->width *= labelled->height;
  labelled->height = 1;
  pcl::io::savePCDFileBinary (folder / "labelled.pcd", *labelled);
  SceneOptions options;
  options.camera = readDepthCamera ("262.5,262.5,159.5,119.5,320,240");
  EXPECT_EQ (readViewerScene (folder / "labelled.pcd", options)->truth, nullptr);
  options.camera = DepthCamera ();
  options.image_width = 320;
  EXPECT_EQ (readViewerScene (folder / "labelled.pcd", options)->cloud.height, 240);
}

TEST (ViewerScenes, readsDepthImagesAndSurvivesThoseThatAreCut)
{
  const test::TemporaryFolder folder;
  constexpr int width = 64, height = 48;
  std::vector<unsigned short> depth (width * height);
  std::vector<unsigned char> color (3 * depth.size ());
  for (std::size_t i = 0; i < depth.size (); ++i)
  {
    depth[i] = static_cast<unsigned short> (1000 + i * 7919 % 50);
    color[3 * i] = static_cast<unsigned char> (i * 31 % 251);
  }
  const std::string depth_file = folder / "depth.png", color_file = folder / "color.png";
  pcl::io::saveShortPNGFile (depth_file, depth.data (), width, height, 1);
  pcl::io::saveCharPNGFile (color_file, color.data (), width, height, 3);
  SceneOptions options;
  options.camera = readDepthCamera ("60,60,31.5,23.5");
  options.color = color_file;
  const ViewerScenePtr scene = readViewerScene (depth_file, options);
  EXPECT_EQ (scene->cloud.width, width);
  EXPECT_EQ (scene->background (40, 20)[0], color[3 * (20 * width + 40)]);
  for (const std::string& file : {color_file, depth_file})
  {
    const std::string whole = test::readText (file);
    test::writeText (file, whole.substr (0, whole.size () / 2));
    try
    {
      readViewerScene (depth_file, options);
      FAIL () << file << " is cut";
    }
    catch (const std::runtime_error& error)
    {
      const std::string message = error.what ();
      EXPECT_EQ (message.find (depth_file + ": "), 0u) << message;
      EXPECT_NE (message.find ("damaged: "), std::string::npos) << message;
    }
    test::writeText (file, whole);
  }
}

TEST (ViewerScenes, playsASequenceAndCountsWhatItDrops)
{
  const test::TemporaryFolder folder;
  std::vector<std::string> files;
  for (int k = 0; k < 3; ++k)
  {
    files.push_back (folder / ("frame" + std::to_string (k) + ".pcd"));
    pcl::io::savePCDFileBinary (files.back (), test::wallBefore<pcl::PointXYZRGB> (32, 24, 1.0f + 0.1f * k));
  }
  SceneSequence scenes (files, {}, 100.0f);
  EXPECT_EQ (scenes.size (), 3u);
  EXPECT_NEAR (scenes.move (1) ()->cloud.z[0], 1.1f, 1e-6f);
  EXPECT_NEAR (scenes.move (-2) ()->cloud.z[0], 1.2f, 1e-6f);
  EXPECT_EQ (scenes.takeFrame (), nullptr);
  scenes.play (true);
  EXPECT_TRUE (scenes.isPlaying ());
  std::function<ViewerScenePtr ()> first;
  const auto patience = std::chrono::steady_clock::now () + std::chrono::seconds (20);
  while (!first && std::chrono::steady_clock::now () < patience)
    first = scenes.takeFrame ();
  ASSERT_TRUE (first);
  EXPECT_EQ (first ()->cloud.width, 32);
  // Whoever does not take the frames loses them, and is told.
  while (scenes.droppedFrames () < 3 && std::chrono::steady_clock::now () < patience)
    std::this_thread::sleep_for (std::chrono::milliseconds (5));
  EXPECT_GE (scenes.droppedFrames (), 3u);
  EXPECT_TRUE (scenes.takeFrame ());
  EXPECT_EQ (scenes.takenFrames (), 2u);
  scenes.play (false);
  EXPECT_FALSE (scenes.isPlaying ());

  test::writeText (folder / "bad.pcd", "nonsense");
  SceneSequence damaged ({folder / "bad.pcd", files[0]}, {}, 10.0f);
  damaged.play (true);
  std::function<ViewerScenePtr ()> bad;
  while (!bad && std::chrono::steady_clock::now () < patience)
    bad = damaged.takeFrame ();
  ASSERT_TRUE (bad);
  EXPECT_THROW (bad (), std::runtime_error);
  SceneSequence single ({files[0]}, {}, 10.0f);
  EXPECT_THROW (single.play (true), std::runtime_error);
}

} // namespace
