// SPDX-License-Identifier: BSD-3-Clause
#include "scene_renderer.h"
#include "solids.h"

#include <gtest/gtest.h>

#include <map>
#include <ostream>

namespace pcl_attention
{

/** \brief For GoogleTest's messages. */
void
PrintTo (SceneKind kind, std::ostream* stream)
{
  *stream << sceneKindName (kind);
}

} // namespace pcl_attention

using namespace pcl_attention;
using Eigen::Vector3d;

namespace
{

SceneDescription
exactScene (SceneKind kind, std::uint64_t seed)
{
  SceneDescription scene = makeScene (kind, seed);
  scene.camera = scene.camera.resized (320, 240);
  scene.noise.level = 0.0;
  return (scene);
}

std::vector<SceneObject>
allObjects (const SceneDescription& scene)
{
  std::vector<SceneObject> all = scene.supports;
  all.insert (all.end (), scene.objects.begin (), scene.objects.end ());
  return (all);
}

const SceneObject&
objectOf (const std::vector<SceneObject>& objects, std::uint32_t label)
{
  const std::uint32_t own = label < scene_label::first_object ? label : label / 10 * 10;
  for (const SceneObject& object : objects)
    if (object.label == own)
      return (object);
  throw std::runtime_error ("no object has label " + std::to_string (label));
}

class EveryKind : public testing::TestWithParam<SceneKind>
{
};

std::string
nameOf (const testing::TestParamInfo<SceneKind>& info)
{
  return (sceneKindName (info.param));
}

} // namespace

TEST_P (EveryKind, PointsLieOnTheSurfaceOfTheObjectTheirLabelNames)
{
  for (std::uint64_t seed = 0; seed < 6; ++seed)
  {
    const SceneDescription scene = exactScene (GetParam (), seed);
    const auto objects = allObjects (scene);
    const auto cloud = renderScene (scene);
    ASSERT_EQ (cloud->size (), 320U * 240U);
    double worst = 0.0;
    for (const auto& point : *cloud)
    {
      ASSERT_TRUE (std::isfinite (point.z));
      const SceneObject& object = objectOf (objects, point.label);
      const Vector3d world = scene.camera.pose * point.getVector3fMap ().cast<double> ();
      worst = std::max (worst, std::abs (solids::distance (object, object.pose.inverse () * world)));
    }
    EXPECT_LT (worst, 1e-5) << "seed " << seed;
  }
}

TEST_P (EveryKind, NothingStandsBetweenCameraAndPoint)
{
  const SceneDescription scene = exactScene (GetParam (), 7);
  const auto objects = allObjects (scene);
  const auto cloud = renderScene (scene);
  for (std::size_t i = 0; i < cloud->size (); i += 13)
    for (double share = 0.5; share < 0.999; share += 0.004)
    {
      const Vector3d world = scene.camera.pose * (share * (*cloud)[i].getVector3fMap ().cast<double> ());
      for (const SceneObject& object : objects)
      {
        if (object.shape == SceneShape::plane)
          continue;
        ASSERT_GT (solids::distance (object, object.pose.inverse () * world), -1e-5) << "pixel " << i;
      }
    }
}

TEST_P (EveryKind, PointsLieOnTheRayOfTheirPixel)
{
  const SceneDescription scene = makeScene (GetParam (), 3);
  const auto cloud = renderScene (scene);
  int valid = 0;
  for (int row = 0; row < scene.camera.height; ++row)
    for (int column = 0; column < scene.camera.width; ++column)
    {
      const auto& point = cloud->at (column, row);
      if (!std::isfinite (point.z))
        continue;
      ++valid;
      ASSERT_NEAR (point.x * 525.0 / point.z + 319.5, column, 1e-3);
      ASSERT_NEAR (point.y * 525.0 / point.z + 239.5, row, 1e-3);
    }
  EXPECT_GT (valid, 640 * 480 * 8 / 10);
}

TEST_P (EveryKind, LabelsFollowTheScheme)
{
  for (std::uint64_t seed = 0; seed < 4; ++seed)
  {
    SceneDescription scene = makeScene (GetParam (), seed);
    scene.camera = scene.camera.resized (320, 240);
    for (std::size_t i = 0; i < scene.objects.size (); ++i)
      EXPECT_EQ (scene.objects[i].label, 20 + 10 * i);
    const auto cloud = renderScene (scene, seed);
    EXPECT_FALSE (cloud->is_dense);
    for (const auto& point : *cloud)
    {
      ASSERT_EQ (point.label == 0, !std::isfinite (point.x));
      ASSERT_TRUE (point.label <= 4 || (point.label >= 20 && point.label < 20 + 10 * scene.objects.size ()))
          << point.label;
    }
  }
}

INSTANTIATE_TEST_SUITE_P (Scenes, EveryKind, testing::ValuesIn (allSceneKinds ()), nameOf);

TEST (SceneGeometry, EverySurfaceOfABowlAndAMugIsSeen)
{
  for (const SceneShape shape : {SceneShape::bowl, SceneShape::mug})
  {
    SceneDescription scene;
    scene.noise.level = 0.0;
    SceneObject object;
    object.shape = shape;
    object.size = shape == SceneShape::bowl ? Vector3d (0.2, 0.2, 0.08) : Vector3d (0.09, 0.09, 0.1);
    scene.objects.push_back (object);
    std::map<std::string, int> pixels;
    for (const double height : {0.5, -0.5})
    {
      scene.camera.lookAt ({0.1, -0.4, height}, {0, 0, 0});
      const auto rendered = renderScene (scene);
      for (const auto& point : *rendered)
      {
        if (point.label == 0)
          continue;
        const Vector3d p = scene.camera.pose * point.getVector3fMap ().cast<double> ();
        const double radius = p.head<2> ().norm (), half_height = 0.5 * object.size.z ();
        if (std::abs (p.z () - half_height) < 1e-6)
          ++pixels["rim"];
        else if (std::abs (p.z () + half_height) < 1e-6)
          ++pixels["foot"];
        else if (radius > 0.5 * object.size.x () + 1e-5)
          ++pixels["handle"];
        else if (shape == SceneShape::mug)
          ++pixels[radius > 0.045 - 1e-5 ? "outside" : "inside"];
        else // outer and inner sphere of a bowl are 4 mm apart
        {
          const double outer = object.bowlCenter () + 0.5 * (object.size.z () + object.wall_thickness);
          const double from_center = (p - Vector3d (0, 0, object.bowlCenter ())).norm ();
          ++pixels[std::abs (from_center - outer) < 1e-5 ? "outside" : "inside"];
          EXPECT_LT (std::min (outer - from_center, from_center - outer + 0.004), 1e-5);
        }
      }
    }
    for (const char* part : {"rim", "foot", "inside", "outside"})
      EXPECT_GT (pixels[part], 50) << part;
    EXPECT_EQ (pixels["handle"] > 50, shape == SceneShape::mug);
  }
}

TEST (SceneGeometry, ObjectsDoNotPenetrateAnything)
{
  for (const SceneKind kind : allSceneKinds ())
    for (std::uint64_t seed = 0; seed < 15; ++seed)
    {
      const SceneDescription scene = makeScene (kind, seed);
      for (const SceneObject& object : scene.objects)
      {
        const Eigen::AlignedBox3d bounds = object.bounds ();
        constexpr int steps = 24;
        for (int i = 0; i < steps * steps * steps; ++i)
        {
          const Vector3d share (i % steps, i / steps % steps, i / (steps * steps)); // reaches the faces of the box
          const Vector3d local = bounds.min () + (share / (steps - 1.0)).cwiseProduct (bounds.sizes ());
          if (solids::distance (object, local) > 0.0)
            continue;
          const Vector3d world = object.pose * local;
          ASSERT_GT (world.z (), -1e-9) << "in the table";
          for (const SceneObject& other : scene.objects)
          {
            if (other.label == object.label)
              continue;
            ASSERT_GT (solids::distance (other, other.pose.inverse () * world), -1e-6)
                << sceneKindName (kind) << " seed " << seed << ": " << object.label << " in " << other.label;
          }
        }
      }
    }
}

TEST (SceneGeometry, ObjectsRestOnTheTableOnABoxOrInABowl)
{
  for (const SceneKind kind : allSceneKinds ())
    for (std::uint64_t seed = 0; seed < 30; ++seed)
    {
      const SceneDescription scene = makeScene (kind, seed);
      for (const SceneObject& object : scene.objects)
      {
        const double axis = std::abs (object.pose.linear () (2, 2));
        const double half_height = 0.5 * (axis > 0.5 ? object.size.z () : object.size.x ());
        const Vector3d center = object.pose.translation ();
        const double bottom = center.z () - half_height;
        bool rests = std::abs (bottom) < 1e-9;
        // In a bowl a sphere touches the bottom, a cylinder with its edge and a box with its corners the round wall.
        const Vector3d touching (object.shape == SceneShape::sphere ? 0.0 : 0.5 * object.size.x (),
                                 object.shape == SceneShape::box ? 0.5 * object.size.y () : 0.0, -0.5 * object.size.z ());
        for (const SceneObject& other : scene.objects)
          rests |= other.shape == SceneShape::bowl && other.label != object.label &&
                   std::abs (solids::distance (other, other.pose.inverse () * (object.pose * touching))) < 1e-9;
        for (const SceneObject& other : scene.objects)
          rests |=
              other.shape == SceneShape::box &&
              std::abs (solids::distance (other, other.pose.inverse () * Vector3d (center.x (), center.y (), bottom))) <
                  1e-9;
        EXPECT_TRUE (rests) << sceneKindName (kind) << " seed " << seed << ": " << object.label;
      }
    }
}

TEST (SceneGeometry, SeparateObjectsAreAloneAndWhollyInTheImage)
{
  for (std::uint64_t seed = 0; seed < 5; ++seed)
  {
    const SceneDescription scene = exactScene (SceneKind::separate, seed);
    ASSERT_GE (scene.objects.size (), 5U);
    const auto together = renderScene (scene);
    for (const SceneObject& object : scene.objects)
    {
      SceneDescription alone = scene;
      alone.objects = {object};
      const auto cloud = renderScene (alone);
      int pixels = 0;
      for (std::size_t i = 0; i < cloud->size (); ++i)
      {
        ASSERT_EQ ((*cloud)[i].label == object.label, (*together)[i].label == object.label);
        pixels += (*cloud)[i].label == object.label;
      }
      EXPECT_GT (pixels, 60);
    }
    for (int column = 0; column < 320; ++column)
      EXPECT_LT (std::max (together->at (column, 0).label, together->at (column, 239).label), 20U);
    for (int row = 0; row < 240; ++row)
      EXPECT_LT (std::max (together->at (0, row).label, together->at (319, row).label), 20U);
  }
}

TEST (SceneGeometry, KindsHoldWhatTheyPromise)
{
  int split = 0, on_top = 0, touching_scenes = 0;
  std::map<SceneShape, int> shapes;
  for (std::uint64_t seed = 0; seed < 10; ++seed)
  {
    for (const SceneKind kind : {SceneKind::empty_table, SceneKind::wall, SceneKind::corner})
      EXPECT_TRUE (makeScene (kind, seed, 5).objects.empty ());
    EXPECT_EQ (makeScene (SceneKind::single_mug, seed, 5).objects.size (), 1U);
    EXPECT_EQ (makeScene (SceneKind::clutter, seed, 4).objects.size (), 4U);
    EXPECT_GT (makeScene (SceneKind::clutter, seed, 40).objects.size (), 20U);
    for (const auto& object : makeScene (SceneKind::boxes, seed).objects)
      EXPECT_EQ (object.shape, SceneShape::box);
    for (const auto& object : makeScene (SceneKind::cylinders, seed).objects)
      EXPECT_NE (object.shape, SceneShape::box);
    for (const auto& object : makeScene (SceneKind::stacked, seed).objects)
      on_top += object.pose.translation ().z () > 0.5 * object.size.z () + 1e-6;
    const SceneDescription filled = makeScene (SceneKind::filled, seed, 2);
    ASSERT_EQ (filled.objects.size (), 2U);
    EXPECT_EQ (filled.objects[0].shape, SceneShape::bowl);
    EXPECT_EQ (filled.objects[0].pose.translation ().head<2> (), filled.objects[1].pose.translation ().head<2> ());
    for (const auto& object : makeScene (SceneKind::clutter, seed).objects)
      ++shapes[object.shape];
    const SceneDescription clutter = exactScene (SceneKind::clutter, seed);
    const auto cloud = renderScene (clutter);
    bool touches = false;
    for (int row = 0; row < 240; ++row)
      for (int column = 1; column < 320; ++column)
      {
        const auto &a = cloud->at (column - 1, row), &b = cloud->at (column, row);
        touches |= a.label >= 20 && b.label >= 20 && a.label / 10 != b.label / 10;
      }
    touching_scenes += touches;
    std::map<std::uint32_t, int> pieces;
    const auto rendered = renderScene (exactScene (SceneKind::occluded, seed));
    for (const auto& point : *rendered)
      if (point.label % 10 == 1 && point.label >= 20)
        ++pieces[point.label];
    split += static_cast<int> (pieces.size ());
  }
  EXPECT_GE (split, 10);           // of about 35 pairs
  EXPECT_GE (on_top, 20);          // of about 75 boxes
  EXPECT_EQ (touching_scenes, 10); // objects that meet in the image
  EXPECT_EQ (shapes.size (), 5U);
}

TEST (SceneGeometry, NamesOfKindsGoBothWays)
{
  EXPECT_EQ (allSceneKinds ().size (), 15U);
  for (const SceneKind kind : allSceneKinds ())
    EXPECT_EQ (sceneKindFromName (sceneKindName (kind)), kind);
  EXPECT_EQ (sceneKindName (SceneKind::empty_table), "empty_table");
  EXPECT_EQ (sceneKindName (SceneKind::single_mug), "single_mug");
  EXPECT_FALSE (sceneKindFromName ("Clutter").has_value ());
}
