// SPDX-License-Identifier: BSD-3-Clause
// What every system has in common, on a rendered scene.
#include "scene_renderer.h"
#include "systems/attention_system.h"

#include <gtest/gtest.h>
#include <pcl/common/io.h>

#include <algorithm>
#include <map>
#include <set>

namespace pcl_attention
{
namespace
{

using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;

struct Scene
{
  Cloud::Ptr cloud{new Cloud};
  std::vector<std::uint32_t> objects; // per pixel, 0 or the label over 10
};

/** \brief One box of one colour in a quarter of VGA. */
const Scene&
oneBox ()
{
  static const Scene scene = [] {
    SceneDescription description = makeScene (SceneKind::single_box, 4);
    description.camera = description.camera.resized (320, 240);
    description.objects[0].material = SceneMaterial{ScenePattern::plain, {0.7, 0.2, 0.15}};
    const auto labelled = renderScene (description, 4);
    Scene result;
    pcl::copyPointCloud (*labelled, *result.cloud);
    for (const auto& point : *labelled)
      result.objects.push_back (point.label >= scene_label::first_object && std::isfinite (point.z) ? point.label / 10
                                                                                                    : 0);
    return (result);
  }();
  return (scene);
}

class EverySystem : public testing::TestWithParam<std::string>
{
protected:
  EverySystem () { settings_.maximum_fixations = settings_.simple_objects.maximum_fixations = 8; }

  /** \brief Of the one box; made once a system. */
  const std::vector<AttentionSegment>&
  segments () const
  {
    static std::map<std::string, std::vector<AttentionSegment>> of_system;
    const auto made = of_system.find (GetParam ());
    if (made != of_system.end ())
      return (made->second);
    return (of_system[GetParam ()] = makeSystem (GetParam (), settings_)->segment (oneBox ().cloud));
  }

  SystemSettings settings_; // a few fixations show it all
};

TEST_P (EverySystem, findsTheOnlyObject)
{
  const Scene& scene = oneBox ();
  ASSERT_FALSE (segments ().empty ());
  std::size_t of_object = 0;
  for (const std::uint32_t object : scene.objects)
    of_object += object > 0;
  double best = 0;
  for (const AttentionSegment& segment : segments ())
  {
    std::size_t common = 0;
    for (const pcl::index_t index : segment.indices)
      common += scene.objects[index] > 0;
    best = std::max (best, 2.0 * common / (segment.indices.size () + of_object));
  }
  EXPECT_GT (best, 0.8);
}

TEST_P (EverySystem, givesSegmentsInOrder)
{
  const Scene& scene = oneBox ();
  for (std::size_t i = 0; i < segments ().size (); ++i)
  {
    const AttentionSegment& segment = segments ()[i];
    EXPECT_EQ (segment.rank, static_cast<int> (i) + 1);
    EXPECT_FALSE (segment.indices.empty ());
    EXPECT_TRUE (std::is_sorted (segment.indices.begin (), segment.indices.end ()));
    EXPECT_EQ (std::set<int> (segment.indices.begin (), segment.indices.end ()).size (), segment.indices.size ());
    EXPECT_LT (static_cast<std::size_t> (segment.indices.back ()), scene.cloud->size ());
    for (const pcl::index_t index : segment.indices)
      ASSERT_TRUE (std::isfinite ((*scene.cloud)[index].z));
    EXPECT_GE (segment.attention_point.column, 0);
    EXPECT_GE (segment.attention_point.row, 0);
    EXPECT_LT (segment.attention_point.column, 320);
    EXPECT_LT (segment.attention_point.row, 240);
  }
}

TEST_P (EverySystem, doesNotDependOnTheNumberOfThreads)
{
  settings_.threads = 3;
  const auto three = makeSystem (GetParam (), settings_)->segment (oneBox ().cloud);
  ASSERT_EQ (segments ().size (), three.size ());
  for (std::size_t i = 0; i < three.size (); ++i)
    EXPECT_EQ (segments ()[i].indices, three[i].indices);
}

TEST_P (EverySystem, saysWhatIsWrongWithACloud)
{
  const auto system = makeSystem (GetParam ());
  const Cloud::Ptr row (new Cloud (100, 1));
  EXPECT_THROW (system->segment (row), std::runtime_error);
  EXPECT_THROW (system->segment (Cloud::Ptr (new Cloud)), std::runtime_error);
}

TEST_P (EverySystem, findsNothingWithoutDepth)
{
  const Cloud::Ptr blind (new Cloud (64, 48, pcl::PointXYZRGB (NAN, NAN, NAN, 100, 100, 100)));
  EXPECT_TRUE (makeSystem (GetParam ())->segment (blind).empty ());
}

INSTANTIATE_TEST_SUITE_P (Systems, EverySystem, testing::ValuesIn (systemNames ()), [] (const auto& system) {
  std::string name = system.param;
  std::replace (name.begin (), name.end (), '+', '_');
  return (name);
});

TEST (MakeSystem, anUnknownNameIsAnErrorThatNamesThoseThereAre)
{
  try
  {
    makeSystem ("M12");
    FAIL ();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE (std::string (error.what ()).find ("\"M12\""), std::string::npos);
    for (const std::string& name : systemNames ())
      EXPECT_NE (std::string (error.what ()).find (name), std::string::npos);
  }
}

TEST (MakeSystem, fixationsOverTheLimitAreNotSegmented)
{
  SystemSettings settings;
  settings.maximum_fixations = 1;
  const auto all = makeSystem ("M09+TJ3D")->segment (oneBox ().cloud);
  const auto first = makeSystem ("M09+TJ3D", settings)->segment (oneBox ().cloud);
  ASSERT_EQ (first.size (), 1u);
  EXPECT_EQ (first[0].indices, all[0].indices);
}

} // namespace
} // namespace pcl_attention
