// SPDX-License-Identifier: BSD-3-Clause
// What the presets reach on mOSD's learn scenes. The bounds are the project's goals, not what the code happens to give.
#include "evaluation/labelled_scene.h"
#include "score.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace pcl_attention;

namespace
{

std::string
learnFolder ()
{
  const char* data = std::getenv ("PCL_ATTENTION_DATA");
  return (std::string (data && *data ? data : PCL_ATTENTION_DATA) + "/mosd_learn");
}

Summary
scoreLearn (const AttentionParameters& parameters, GroundTruthKind kind)
{
  std::vector<SceneScore> scores;
  for (const std::string& path : listScenes ({learnFolder ()}))
    scores.push_back (test::score (loadLabelledScene (path).cloud, parameters, kind));
  return (summarize ("learn", kind, scores));
}

class LabelledScenes : public testing::Test
{
protected:
  void
  SetUp () override
  {
    if (!std::filesystem::is_directory (learnFolder ()))
      GTEST_SKIP () << "no labelled scenes in " << learnFolder () << " (set PCL_ATTENTION_DATA)";
  }
};

TEST_F (LabelledScenes, theDefaultFindsWholeObjects)
{
  const Summary summary = scoreLearn (AttentionParameters (), GroundTruthKind::objects);
  EXPECT_EQ (summary.objects, 112u);
  EXPECT_GE (summary.strict_first.mean, 0.93);
  EXPECT_GE (summary.overlap.f, 0.92);
}

TEST_F (LabelledScenes, withoutJoinsVisiblePartsAreFound)
{
  AttentionParameters parameters;
  parameters.visiblePieces ();
  const Summary summary = scoreLearn (parameters, GroundTruthKind::parts);
  EXPECT_GE (summary.strict_first.mean, 0.90);
}

TEST_F (LabelledScenes, thePaperReachesItsFigures)
{
  const Summary summary = scoreLearn (AttentionParameters::paper (), GroundTruthKind::objects);
  EXPECT_GE (summary.attended_first.mean, 0.88);
  EXPECT_GE (summary.attended, 105u);
}

} // namespace
