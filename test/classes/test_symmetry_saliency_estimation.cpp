// SPDX-License-Identifier: BSD-3-Clause
#include "clouds.h"
#include <pcl/segmentation/symmetry_saliency_estimation.h>

#include <functional>

namespace
{

class SymmetrySaliency : public testing::Test
{
protected:
  void
  SetUp () override
  {
    estimation.setInputCloud (sceneCloud ());
  }

  pcl::SymmetrySaliencyEstimation<PointT> estimation;
  pcl::PointCloud<pcl::Intensity> saliency;
};

} // namespace

TEST_F (SymmetrySaliency, IsBetweenZeroAndOne)
{
  ASSERT_TRUE (estimation.compute (saliency));
  ASSERT_EQ (saliency.width, 320u);
  ASSERT_EQ (saliency.height, 240u);
  float maximum = 0.0f;
  for (std::size_t index = 0; index < saliency.size (); ++index)
  {
    const float value = saliency[index].intensity;
    ASSERT_GE (value, 0.0f);
    maximum = std::max (maximum, value);
    ASSERT_TRUE (value == 0.0f || pcl::isFinite ((*sceneCloud ())[index])) << "saliency in a hole";
  }
  EXPECT_EQ (maximum, 1.0f);
  EXPECT_GT (estimation.getMaximum (), 0.0f);
}

TEST_F (SymmetrySaliency, KeepsTheHeader)
{
  const Cloud::Ptr cloud (new Cloud (*sceneCloud ()));
  cloud->header.frame_id = "camera";
  estimation.setInputCloud (cloud);
  ASSERT_TRUE (estimation.compute (saliency));
  EXPECT_EQ (saliency.header.frame_id, "camera");
}

TEST_F (SymmetrySaliency, GivesEveryLevelInItsOwnSize)
{
  estimation.setNumberOfLevels (3);
  ASSERT_TRUE (estimation.compute (saliency));
  for (int level = 1; level <= 3; ++level)
  {
    const pcl::PointCloud<pcl::Intensity> map = estimation.getLevelMap (level);
    EXPECT_EQ (map.width, 320u >> (level - 1));
    EXPECT_EQ (map.height, 240u >> (level - 1));
    const bool anything =
        std::any_of (map.begin (), map.end (), [] (const pcl::Intensity& value) { return (value.intensity > 0.0f); });
    EXPECT_TRUE (anything);
  }
  for (const int level : {0, 4, -1})
  {
    const std::string errors = errorsOf ([&] { EXPECT_TRUE (estimation.getLevelMap (level).empty ()); });
    EXPECT_TRUE (contains (errors, "There is no level " + std::to_string (level) + ": they are 1 to 3."));
  }
}

TEST_F (SymmetrySaliency, TellsLevelAndPlaneWhereThereIsSaliency)
{
  ASSERT_TRUE (estimation.compute (saliency));
  const pcl::PointCloud<pcl::Label> plane = estimation.getWinningPlane (), level = estimation.getWinningLevel ();
  ASSERT_EQ (plane.size (), saliency.size ());
  ASSERT_EQ (level.size (), saliency.size ());
  for (std::size_t index = 0; index < saliency.size (); ++index)
  {
    const bool salient = saliency[index].intensity > 0.0f;
    ASSERT_EQ (level[index].label > 0, salient);
    ASSERT_LE (level[index].label, 4u);
    ASSERT_LE (plane[index].label, 3u);
    ASSERT_TRUE (salient || plane[index].label == 0u);
  }
}

TEST_F (SymmetrySaliency, HasNoStaleResults)
{
  const auto expectNone = [this] {
    EXPECT_TRUE (estimation.getLevelMap (1).empty ());
    EXPECT_TRUE (estimation.getWinningPlane ().empty ());
    EXPECT_TRUE (estimation.getWinningLevel ().empty ());
    EXPECT_EQ (estimation.getMaximum (), 0.0f);
  };
  expectNone ();
  ASSERT_TRUE (estimation.compute (saliency));
  EXPECT_FALSE (estimation.getLevelMap (1).empty ());
  estimation.setInputCloud (renderCloud (pcl_attention::SceneKind::boxes, 1, 64, 48));
  expectNone ();
  ASSERT_TRUE (estimation.compute (saliency));
  estimation.setBlurRadius (3);
  expectNone ();
}

TEST_F (SymmetrySaliency, SetsEveryParameter)
{
  estimation.setWindowRadius (2);
  estimation.setNumberOfLevels (3);
  estimation.setMaximumColumns (200);
  estimation.setDistanceScale (500.0f);
  estimation.setConvexityGate (false);
  estimation.setBlurRadius (1);
  estimation.setLevelThreshold (0.2f);
  estimation.setNormalizeLevels (false);
  estimation.setSaliencyFloor (0.1f);
  const pcl_attention::SaliencyParameters& parameters = estimation.getParameters ();
  EXPECT_EQ (parameters.window_radius, 2);
  EXPECT_EQ (parameters.levels, 3);
  EXPECT_EQ (parameters.maximum_columns, 200);
  EXPECT_EQ (parameters.distance_scale, 500.0f);
  EXPECT_FALSE (parameters.convexity_gate);
  EXPECT_EQ (parameters.blur_radius, 1);
  EXPECT_EQ (parameters.level_threshold, 0.2f);
  EXPECT_FALSE (parameters.normalize_levels);
  EXPECT_EQ (parameters.saliency_floor, 0.1f);
  EXPECT_EQ (estimation.getWindowRadius (), 2);
  EXPECT_EQ (estimation.getNumberOfLevels (), 3);
  EXPECT_EQ (estimation.getMaximumColumns (), 200);
  EXPECT_EQ (estimation.getDistanceScale (), 500.0f);
  EXPECT_FALSE (estimation.getConvexityGate ());
  EXPECT_EQ (estimation.getBlurRadius (), 1);
  EXPECT_EQ (estimation.getLevelThreshold (), 0.2f);
  EXPECT_FALSE (estimation.getNormalizeLevels ());
  EXPECT_EQ (estimation.getSaliencyFloor (), 0.1f);
}

TEST_F (SymmetrySaliency, TakesEffectOfItsParameters)
{
  ASSERT_TRUE (estimation.compute (saliency));
  const pcl::PointCloud<pcl::Intensity> standard = saliency;
  const auto isDifferent = [&] {
    EXPECT_TRUE (estimation.compute (saliency));
    return (
        !std::equal (saliency.begin (), saliency.end (), standard.begin (),
                     [] (const pcl::Intensity& a, const pcl::Intensity& b) { return (a.intensity == b.intensity); }));
  };
  EXPECT_FALSE (isDifferent ());
  const pcl_attention::SaliencyParameters defaults;
  const std::vector<std::function<void (pcl_attention::SaliencyParameters&)>> changes{
      [] (auto& p) { p.window_radius = 4; },        [] (auto& p) { p.levels = 2; },
      [] (auto& p) { p.maximum_columns = 160; },
      [] (auto& p) { p.distance_scale = 10.0f; },   [] (auto& p) { p.convexity_gate = false; },
      [] (auto& p) { p.blur_radius = 0; },          [] (auto& p) { p.level_threshold = 0.5f; },
      [] (auto& p) { p.normalize_levels = false; }, [] (auto& p) { p.saliency_floor = 1.0f; }};
  for (std::size_t index = 0; index < changes.size (); ++index)
  {
    pcl_attention::SaliencyParameters parameters = defaults;
    changes[index](parameters);
    estimation.setParameters (parameters);
    EXPECT_TRUE (isDifferent ()) << "change " << index;
  }
}

TEST_F (SymmetrySaliency, UsesTheNormalsItIsGiven)
{
  // Normals that are all alike know no symmetry.
  estimation.setInputNormals (
      pcl::PointCloud<pcl::Normal>::Ptr (new pcl::PointCloud<pcl::Normal> (320, 240, pcl::Normal (0.0f, 0.0f, -1.0f))));
  ASSERT_TRUE (estimation.compute (saliency));
  EXPECT_EQ (estimation.getMaximum (), 0.0f);
}

TEST_F (SymmetrySaliency, EstimatesNormalsWithTheGivenSettings)
{
  ASSERT_TRUE (estimation.compute (saliency));
  const float maximum = estimation.getMaximum ();
  pcl_attention::NormalParameters parameters;
  parameters.radius = 2;
  estimation.setNormalParameters (parameters);
  EXPECT_EQ (estimation.getNormalParameters ().radius, 2);
  ASSERT_TRUE (estimation.compute (saliency));
  EXPECT_NE (estimation.getMaximum (), maximum);
}
