// SPDX-License-Identifier: BSD-3-Clause
// Paper IV-A: clustering of normals into planar patches.
#include "shapes.h"
#include <pcl_attention/core/planar_patches.h>

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

using namespace pcl_attention;
using Eigen::Vector3d;
using Eigen::Vector3f;
using shapes::Frame;

namespace
{

PlanarPatches
patchesOf (const Frame& frame, const PatchParameters& parameters = PatchParameters (), int threads = 1)
{
  PlanarPatches result;
  extractPlanarPatches (frame.cloud, frame.normals, parameters, result, threads);
  return (result);
}

/** \brief Label image, pixel lists and descriptors against each other and against a singular value decomposition. */
void
expectConsistent (const Frame& frame, const PlanarPatches& patches)
{
  ASSERT_EQ (patches.labels.size (), frame.cloud.size ());
  std::size_t listed = 0;
  for (std::size_t k = 0; k < patches.patches.size (); ++k)
  {
    const PlanarPatch& patch = patches.patches[k];
    listed += patch.pixels.size ();
    ASSERT_FALSE (patch.pixels.empty ());
    EXPECT_TRUE (std::is_sorted (patch.pixels.begin (), patch.pixels.end ()));
    Eigen::MatrixXd points (3, patch.pixels.size ());
    for (std::size_t i = 0; i < patch.pixels.size (); ++i)
    {
      EXPECT_EQ (patches.labels[patch.pixels[i]], static_cast<int> (k) + 1);
      EXPECT_TRUE (frame.cloud.valid[patch.pixels[i]]);
      points.col (i) = frame.point (patch.pixels[i]);
    }
    const Vector3d mean = points.rowwise ().mean ();
    EXPECT_LT ((mean - patch.centroid.cast<double> ()).norm (), 1e-6);
    if (patch.pixels.size () > 3000)
      continue; // the decomposition takes too long
    points.colwise () -= mean;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd (points, Eigen::ComputeThinU);
    const Vector3d normal = svd.matrixU ().col (2), size = svd.singularValues () / std::sqrt (patch.pixels.size ());
    EXPECT_NEAR (patch.rms, size[2], 1e-6);
    EXPECT_NEAR (patch.normal.norm (), 1.0f, 1e-5f);
    EXPECT_LE (patch.normal.dot (patch.centroid), 0.0f);
    if (size[1] > 3.0 * size[2])
    {
      EXPECT_GT (std::abs (normal.dot (patch.normal.cast<double> ())), 0.9999);
    }
  }
  EXPECT_EQ (listed, static_cast<std::size_t> (std::count_if (patches.labels.data.begin (), patches.labels.data.end (),
                                                              [] (int label) { return (label > 0); })));
}

/** \brief A rendered box with the exact normal of every pixel, and the side (1..6) each lies on; 7 the table. */
struct BoxScene
{
  Frame frame;
  Image<int> side;

  explicit BoxScene (std::uint64_t seed)
  {
    SceneDescription scene = makeScene (SceneKind::single_box, seed);
    scene.camera = scene.camera.resized (320, 240);
    scene.noise.level = 0.0;
    const auto cloud = renderScene (scene, seed);
    const SceneObject& box = scene.objects.front ();
    frame.cloud = gather (*cloud, nullptr);
    frame.normals.reset (frame.cloud.size ());
    side.assign (320, 240, 0);
    const Eigen::Isometry3d to_camera = scene.camera.pose.inverse (), to_box = box.pose.inverse () * scene.camera.pose;
    for (std::size_t index = 0; index < frame.cloud.size (); ++index)
    {
      if (!frame.cloud.valid[index])
        continue;
      const Vector3d point = frame.point (index);
      Vector3d normal;
      if ((*cloud)[index].label >= scene_label::first_object)
      {
        const Vector3d relative = (to_box * point).cwiseQuotient (0.5 * box.size);
        int axis;
        relative.cwiseAbs ().maxCoeff (&axis);
        const double sign = relative[axis] > 0.0 ? 1.0 : -1.0;
        side[index] = 1 + 2 * axis + (sign > 0.0);
        normal = to_camera.linear () * box.pose.linear () * (sign * Vector3d::Unit (axis));
      }
      else if ((*cloud)[index].label == scene_label::table)
      {
        side[index] = 7;
        normal = to_camera.linear () * Vector3d::UnitZ ();
      }
      else
      {
        frame.invalidate (index);
        continue;
      }
      frame.set (index, point, normal);
    }
  }

  /** \brief Whether another side, or nothing, lies within some pixels. */
  bool
  isNearEdge (int column, int row, int distance) const
  {
    for (int r = row - distance; r <= row + distance; ++r)
      for (int c = column - distance; c <= column + distance; ++c)
        if (!side.contains (c, r) || side (c, r) != side (column, row))
          return (true);
    return (false);
  }
};

/** \brief A strip whose normals turn steadily from left to right, on one plane, the seed being at its left end. */
Frame
turningStrip (int width, double angle_per_column)
{
  Frame frame = shapes::emptyFrame (width, 4);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < width; ++column)
    {
      const double angle = angle_per_column * column - 0.7;
      frame.set (frame.index (column, row), {0.001 * column, 0.001 * row, 1.0},
                 {std::sin (angle), 0, -std::cos (angle)});
      frame.normals.curvature[frame.index (column, row)] = 1e-4f * static_cast<float> (column + 1);
    }
  return (frame);
}

int
lengthOf (const PlanarPatches& patches, int label)
{
  int length = 0;
  for (int column = 0; column < patches.labels.width; ++column)
    length += patches.labels (column, 1) == label;
  return (length);
}

} // namespace

TEST (PlanarPatches, OfABoxAreItsVisibleSides)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const PlaneModel model : {PlaneModel::initial, PlaneModel::running})
    {
      SCOPED_TRACE (::testing::Message ()
                    << "seed " << seed << (model == PlaneModel::running ? " running" : " initial"));
      const BoxScene scene (seed);
      PatchParameters parameters;
      parameters.plane_model = model;
      parameters.reassign_distance = 0.0f;
      const PlanarPatches patches = patchesOf (scene.frame, parameters);
      expectConsistent (scene.frame, patches);
      std::map<int, std::set<int>> sides_of_patch, patches_inside_side;
      for (int row = 0; row < 240; ++row)
        for (int column = 0; column < 320; ++column)
        {
          const int side = scene.side (column, row), label = patches.labels (column, row);
          if (side == 0)
            continue;
          if (label > 0)
            sides_of_patch[label].insert (side);
          if (!scene.isNearEdge (column, row, 2))
          {
            EXPECT_GT (label, 0) << column << " " << row;
            patches_inside_side[side].insert (label);
          }
        }
      for (const auto& [label, sides] : sides_of_patch)
        EXPECT_EQ (sides.size (), 1u) << "patch " << label << " spans two sides";
      EXPECT_GE (patches_inside_side.size (), 3u); // the table and two sides at least
      for (const auto& [side, labels] : patches_inside_side)
        if (side < 7)
        {
          EXPECT_EQ (labels.size (), 1u) << "side " << side;
        }
      for (const PlanarPatch& patch : patches.patches)
        EXPECT_LT (patch.rms, 1e-5f);
    }
}

TEST (PlanarPatches, TakeEveryPointOfABoxButForItsEdges)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    SCOPED_TRACE (seed);
    const BoxScene scene (seed);
    const PlanarPatches patches = patchesOf (scene.frame);
    expectConsistent (scene.frame, patches);
    int foreign = 0, pixels = 0;
    std::map<int, std::map<int, int>> sides_of_patch;
    for (int row = 0; row < 240; ++row)
      for (int column = 0; column < 320; ++column)
      {
        const int side = scene.side (column, row), label = patches.labels (column, row);
        if (side > 0 && label == 0)
        {
          EXPECT_TRUE (scene.isNearEdge (column, row, 2)) << column << " " << row;
        }
        if (side > 0 && label > 0)
          ++sides_of_patch[label][side];
      }
    // Slivers of a side that are too small for a patch of their own have joined their neighbours.
    for (const auto& [label, sides] : sides_of_patch)
    {
      int most = 0;
      for (const auto& [side, count] : sides)
      {
        pixels += count;
        foreign += count;
        most = std::max (most, count);
      }
      foreign -= most;
    }
    EXPECT_LT (foreign, 0.003 * pixels);
  }
}

TEST (PlanarPatches, WithFittedNormalsStayOnOneSideAwayFromTheEdges)
{
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    SCOPED_TRACE (seed);
    BoxScene scene (seed);
    estimateNormals (scene.frame.cloud, NormalParameters (), 1, scene.frame.normals);
    const PlanarPatches patches = patchesOf (scene.frame);
    expectConsistent (scene.frame, patches);
    std::map<int, std::set<int>> sides_of_patch;
    int left_over = 0;
    for (int row = 0; row < 240; ++row)
      for (int column = 0; column < 320; ++column)
        if (scene.side (column, row) && !scene.isNearEdge (column, row, NormalParameters ().radius + 1))
        {
          if (patches.labels (column, row))
            sides_of_patch[patches.labels (column, row)].insert (scene.side (column, row));
          else
            ++left_over;
        }
    EXPECT_EQ (left_over, 0);
    for (const auto& [label, sides] : sides_of_patch)
      EXPECT_EQ (sides.size (), 1u) << "patch " << label;
  }
}

TEST (PlanarPatches, TheInitialPlaneStopsAtItsAngleTheRunningOneFollows)
{
  // 0.02 radians a column, half a radian allowed: the seed's plane takes 25 columns after itself. The mean of n columns
  // looks half way between them, and takes the next one while 0.02 * n / 2 is allowed: 50 columns, give or take the one
  // at the limit.
  const Frame frame = turningStrip (80, 0.02);
  PatchParameters parameters;
  parameters.maximum_distance = parameters.maximum_step = 1.0f;
  parameters.reassign_distance = 0.0f;
  parameters.plane_model = PlaneModel::initial;
  parameters.maximum_angle = 0.5001f;
  const PlanarPatches initial = patchesOf (frame, parameters);
  expectConsistent (frame, initial);
  EXPECT_EQ (lengthOf (initial, initial.labels (0, 1)), 26);
  EXPECT_EQ (lengthOf (initial, initial.labels (26, 1)), 26);
  parameters.plane_model = PlaneModel::running;
  const PlanarPatches running = patchesOf (frame, parameters);
  EXPECT_NEAR (lengthOf (running, running.labels (0, 1)), 51, 2);
}

TEST (PlanarPatches, StartAtTheLowestCurvature)
{
  Frame frame = turningStrip (80, 0.02);
  PatchParameters parameters;
  parameters.maximum_distance = parameters.maximum_step = 1.0f;
  parameters.reassign_distance = 0.0f;
  parameters.plane_model = PlaneModel::initial;
  parameters.maximum_angle = 0.2001f;
  // The flattest point is in the middle: the first patch lies around it, 10 columns to either side.
  for (int row = 0; row < 4; ++row)
    frame.normals.curvature[frame.index (40, row)] = 0.0f;
  const PlanarPatches patches = patchesOf (frame, parameters);
  EXPECT_EQ (patches.labels (40, 1), 1);
  EXPECT_EQ (patches.labels (30, 1), 1);
  EXPECT_EQ (patches.labels (50, 1), 1);
  EXPECT_NE (patches.labels (29, 1), 1);
  EXPECT_NE (patches.labels (51, 1), 1);
}

TEST (PlanarPatches, OfTheInitialPlaneHaveNoTwoNormalsBeyondTwiceTheAngle)
{
  const Frame frame = shapes::look (shapes::cylinder ({0, 0, 0.85}, {0, 1, 0}, 0.05), {101, 60});
  PatchParameters parameters;
  parameters.plane_model = PlaneModel::initial;
  parameters.maximum_angle = 0.3f;
  parameters.reassign_distance = 0.0f;
  const PlanarPatches patches = patchesOf (frame, parameters);
  expectConsistent (frame, patches);
  EXPECT_GE (patches.patches.size (), 4u); // nearly 180 degrees in steps of at most 34
  for (const PlanarPatch& patch : patches.patches)
  {
    double left = 10.0, right = -10.0;
    for (const pcl::index_t index : patch.pixels)
    {
      const double angle = std::atan2 (frame.normals.x[index], -frame.normals.z[index]);
      left = std::min (left, angle);
      right = std::max (right, angle);
    }
    EXPECT_LE (right - left, 0.6 + 1e-4);
  }
}

TEST (PlanarPatches, PointsBeyondTheDistanceFromThePlaneAreNotTaken)
{
  // Normals all alike, but the points rise 0.5 mm a column: the seed's plane is left after 8 mm, at column 16.
  Frame frame = shapes::emptyFrame (60, 4);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 60; ++column)
    {
      frame.set (frame.index (column, row), {0.001 * column, 0.001 * row, 1.0 + 0.0005 * column}, {0, 0, -1});
      frame.normals.curvature[frame.index (column, row)] = 1e-4f * static_cast<float> (column + 1);
    }
  PatchParameters parameters;
  parameters.plane_model = PlaneModel::initial;
  parameters.maximum_distance = 0.00825f;
  parameters.minimum_size = 9;
  parameters.reassign_distance = 0.0f;
  const PlanarPatches patches = patchesOf (frame, parameters);
  EXPECT_EQ (lengthOf (patches, 1), 17);
}

TEST (PlanarPatches, AStepInDepthEndsAPatch)
{
  // Two walls with the same normal, 2 cm apart.
  const shapes::Surface left = shapes::plane ({0, 0, 0.8}, {0, 0, -1}),
                        right = shapes::plane ({0, 0, 0.82}, {0, 0, -1});
  const Frame frame = shapes::look ([&] (const Vector3d& ray) { return (ray.x () < 0.0 ? left (ray) : right (ray)); });
  PatchParameters parameters;
  parameters.maximum_distance = 0.1f; // the planes alone would be one
  const PlanarPatches patches = patchesOf (frame, parameters);
  EXPECT_EQ (patches.patches.size (), 2u);
  EXPECT_NE (patches.labels (31, 20), patches.labels (32, 20));
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column)
      EXPECT_EQ (patches.labels (column, row), patches.labels (column < 32 ? 0 : 63, 0));
  parameters.maximum_step = 1.0f;
  EXPECT_EQ (patchesOf (frame, parameters).patches.size (), 1u);
}

TEST (PlanarPatches, ASlantedSurfaceIsNoStep)
{
  // Neighbouring points of this plane are up to 2 cm apart.
  const Frame frame = shapes::look (shapes::plane ({0, 0, 1}, {1, 0, -0.1}), {40, 30, 525.0});
  PatchParameters parameters;
  parameters.maximum_distance = 1.0f;
  EXPECT_EQ (patchesOf (frame, parameters).patches.size (), 1u);
}

TEST (PlanarPatches, SmallClustersAreDissolved)
{
  // A square of 3x3 pixels, far before a wall.
  const shapes::Surface wall = shapes::plane ({0, 0, 1}, {0, 0, -1}), near = shapes::plane ({0, 0, 0.5}, {0, 0, -1});
  const shapes::Camera camera;
  const Frame frame = shapes::look ([&] (const Vector3d& ray) {
    const bool inside = std::abs (ray.x () - camera.ray (20, 20).x ()) < 1.5 / 525.0 &&
                        std::abs (ray.y () - camera.ray (20, 20).y ()) < 1.5 / 525.0;
    return (inside ? near (ray) : wall (ray));
  });
  PatchParameters parameters;
  parameters.minimum_size = 9;
  const PlanarPatches two = patchesOf (frame, parameters);
  ASSERT_EQ (two.patches.size (), 2u);
  EXPECT_EQ (std::min (two.patches[0].pixels.size (), two.patches[1].pixels.size ()), 9u);
  parameters.minimum_size = 10;
  const PlanarPatches one = patchesOf (frame, parameters);
  ASSERT_EQ (one.patches.size (), 1u);
  EXPECT_EQ (one.labels (20, 20), 0); // nothing within reassign_distance
  EXPECT_EQ (one.patches[0].pixels.size (), frame.cloud.size () - 9);
}

TEST (PlanarPatches, LeftOversJoinTheNearestNeighbourWithinReach)
{
  // A plane whose middle columns have wild normals: they form no patch of their own.
  Frame frame = shapes::look (shapes::plane ({0, 0, 0.8}, {0, 0, -1}));
  std::mt19937 random (1);
  std::normal_distribution<double> gauss;
  for (int row = 0; row < 48; ++row)
    for (int column = 30; column < 34; ++column)
    {
      const std::size_t index = frame.index (column, row);
      const double angle = 1.3 + 0.2 * ((column + row) % 2);
      frame.set (index, frame.point (index), {std::sin (angle) * ((column + row) % 2 ? 1 : -1), 0, -std::cos (angle)});
      frame.normals.curvature[index] = 0.3f;
    }
  PatchParameters parameters;
  parameters.reassign_distance = 0.0f;
  const PlanarPatches left_over = patchesOf (frame, parameters);
  ASSERT_EQ (left_over.patches.size (), 2u);
  EXPECT_EQ (left_over.labels (31, 20), 0);
  parameters.reassign_distance = 0.01f;
  const PlanarPatches joined = patchesOf (frame, parameters);
  ASSERT_EQ (joined.patches.size (), 2u);
  for (int row = 0; row < 48; ++row)
  {
    // Ring by ring from both sides: two columns each.
    EXPECT_EQ (joined.labels (31, row), joined.labels (0, row));
    EXPECT_EQ (joined.labels (32, row), joined.labels (63, row));
  }
  expectConsistent (frame, joined);
  // Points near their neighbours, but off the planes, belong to neither.
  Frame bulge = frame;
  for (int row = 0; row < 48; ++row)
    for (int column = 30; column < 34; ++column)
    {
      const std::size_t index = frame.index (column, row);
      bulge.set (index, frame.point (index) + Eigen::Vector3d (0, 0, column == 30 || column == 33 ? -0.009 : -0.016),
                 frame.normal (index));
    }
  parameters.reassign_distance = 0.0105f;
  EXPECT_EQ (patchesOf (bulge, parameters).labels (30, 20), joined.labels (0, 20)) << "9 mm off";
  EXPECT_EQ (patchesOf (bulge, parameters).labels (31, 20), 0) << "7 mm from its neighbour, but 16 mm off the plane";
  // The points are 1.5 mm apart.
  parameters.reassign_distance = 0.001f;
  EXPECT_EQ (patchesOf (frame, parameters).labels (31, 20), 0);
}

TEST (PlanarPatches, AreThoseOfPclsRegionGrowing)
{
  for (const SceneKind kind : {SceneKind::clutter, SceneKind::cylinders})
    for (const double noise : {0.0, 1.0})
      for (const PlaneModel model : {PlaneModel::initial, PlaneModel::running})
      {
        Frame frame = shapes::rendered (kind, 3, 203, 151, noise);
        shapes::punchHoles (frame, 4, 0.02);
        // No two curvatures alike, as PCL takes points of equal curvature in any order.
        std::vector<std::size_t> order (frame.cloud.size ());
        std::iota (order.begin (), order.end (), 0);
        std::stable_sort (order.begin (), order.end (), [&] (std::size_t a, std::size_t b) {
          return (frame.normals.curvature[a] < frame.normals.curvature[b]);
        });
        for (std::size_t rank = 0; rank < order.size (); ++rank)
          frame.normals.curvature[order[rank]] = static_cast<float> (rank) * 1e-6f;
        PatchParameters parameters;
        parameters.plane_model = model;
        parameters.minimum_size = 9;
        const PlanarPatches on_grid = patchesOf (frame, parameters);
        parameters.method = PatchMethod::region_growing;
        const PlanarPatches by_pcl = patchesOf (frame, parameters);
        EXPECT_GT (on_grid.patches.size (), 10u);
        EXPECT_EQ (on_grid.labels.data, by_pcl.labels.data);
      }
}

TEST (PlanarPatches, OfEqualCurvatureStartAtTheFirstPoint)
{
  // Two walls side by side, both flat: the left one is met first.
  Frame frame = shapes::emptyFrame (20, 6);
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 20; ++column)
      frame.set (frame.index (column, row), {0.001 * column, 0.001 * row, column < 10 ? 1.0 : 1.5}, {0, 0, -1});
  PatchParameters parameters;
  parameters.minimum_size = 9;
  const PlanarPatches patches = patchesOf (frame, parameters);
  ASSERT_EQ (patches.patches.size (), 2u);
  EXPECT_EQ (patches.labels (0, 0), 1);
  EXPECT_EQ (patches.labels (19, 5), 2);
}

TEST (PlanarPatches, AreTheSameForAnyNumberOfThreads)
{
  for (const SceneKind kind : {SceneKind::clutter, SceneKind::cylinders, SceneKind::stacked})
  {
    Frame frame = shapes::rendered (kind, 5, 203, 151, 1.0);
    shapes::punchHoles (frame, 4, 0.02);
    PatchParameters parameters;
    parameters.minimum_size = 9;
    const PlanarPatches by_one = patchesOf (frame, parameters);
    EXPECT_GT (by_one.patches.size (), 10u);
    for (const int threads : {0, 2, 3, 8})
      EXPECT_EQ (patchesOf (frame, parameters, threads).labels.data, by_one.labels.data) << threads;
  }
}

TEST (PlanarPatches, ThatGrowBesideEachOtherAreNumberedByTheCurvatureTheyStartAt)
{
  // Five walls of different depths side by side, the flattest one in the middle.
  const std::array<float, 5> curvatures{0.03f, 0.02f, 0.0f, 0.02f, 0.01f};
  const std::array<int, 5> expected{5, 3, 1, 4, 2};
  Frame frame = shapes::emptyFrame (50, 6);
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 50; ++column)
    {
      const int wall = column / 10;
      frame.set (frame.index (column, row), {0.001 * column, 0.001 * row, 1.0 + 0.1 * wall}, {0, 0, -1});
      frame.normals.curvature[frame.index (column, row)] = curvatures[wall];
    }
  PatchParameters parameters;
  parameters.minimum_size = 9;
  for (const int threads : {1, 2, 4})
  {
    const PlanarPatches patches = patchesOf (frame, parameters, threads);
    for (int wall = 0; wall < 5; ++wall)
      EXPECT_EQ (patches.labels (10 * wall + 5, 3), expected[wall]) << threads;
  }
}

TEST (PlanarPatches, GrowOverAStepThatIsOneFromTheOtherSideOnly)
{
  // The right wall's normals lie across the step, so that it goes on in the left one, which ends there.
  Frame frame = shapes::emptyFrame (20, 12);
  for (int row = 0; row < 12; ++row)
    for (int column = 0; column < 20; ++column)
    {
      const bool is_left = column < 10;
      frame.set (frame.index (column, row), {0.001 * column, 0.001 * row, is_left ? 1.0 : 1.02},
                 is_left ? Vector3d (0, 0, -1) : Vector3d (1, 0, -0.05).normalized ());
      frame.normals.curvature[frame.index (column, row)] = is_left ? 0.01f : 0.0f;
    }
  PatchParameters parameters;
  parameters.maximum_angle = 1.55f;
  parameters.maximum_distance = 1.0f;
  parameters.minimum_size = 9;
  for (const int threads : {1, 2, 4})
    EXPECT_EQ (patchesOf (frame, parameters, threads).patches.size (), 1u) << threads;
  for (float& curvature : frame.normals.curvature)
    curvature = 0.01f - curvature;
  for (const int threads : {1, 2, 4})
    EXPECT_EQ (patchesOf (frame, parameters, threads).patches.size (), 2u) << threads;
}

TEST (PlanarPatches, WithoutPointsOrNormalsThereAreNone)
{
  const Frame empty = shapes::emptyFrame (20, 10);
  EXPECT_TRUE (patchesOf (empty).patches.empty ());
  EXPECT_TRUE (patchesOf (empty, PatchParameters (), 2).patches.empty ());
  EXPECT_EQ (patchesOf (empty).labels.size (), 200u);
  Frame frame = shapes::look (shapes::plane ({0, 0, 1}, {0, 0, -1}));
  frame.normals.reset (frame.cloud.size ());
  EXPECT_TRUE (patchesOf (frame).patches.empty ());
}

TEST (PlanarPatches, OfANoisySceneAreConsistentAndTheSameEveryTime)
{
  const Frame frame = shapes::rendered (SceneKind::clutter, 7, 240, 180, 1.0);
  const PlanarPatches once = patchesOf (frame), twice = patchesOf (frame);
  expectConsistent (frame, once);
  EXPECT_GT (once.patches.size (), 5u);
  EXPECT_EQ (once.labels.data, twice.labels.data);
}

TEST (DescribePatches, ByHand)
{
  // Four points of a square, 2 cm wide, one of them 4 mm behind the others' plane on each diagonal: heights +-1 mm.
  Frame frame = shapes::emptyFrame (3, 2);
  frame.set (0, {-0.01, -0.01, 1.001}, {0, 0, -1});
  frame.set (1, {0.01, -0.01, 0.999}, {0, 0, -1});
  frame.set (3, {-0.01, 0.01, 0.999}, {0, 0, -1});
  frame.set (4, {0.01, 0.01, 1.001}, {0, 0, -1});
  PlanarPatches patches;
  patches.labels.assign (3, 2, 0);
  patches.labels.data = {2, 2, 0, 2, 2, 0};
  describePatches (frame.cloud, patches);
  ASSERT_EQ (patches.patches.size (), 2u);
  EXPECT_TRUE (patches.patches[0].pixels.empty ());
  EXPECT_EQ (patches.patches[1].pixels, (pcl::Indices{0, 1, 3, 4}));
  EXPECT_LT ((patches.patches[1].centroid - Vector3f (0, 0, 1)).norm (), 1e-6f);
  EXPECT_LT ((patches.patches[1].normal - Vector3f (0, 0, -1)).norm (), 1e-4f);
  EXPECT_NEAR (patches.patches[1].rms, 0.001f, 1e-6f);
}
