// SPDX-License-Identifier: BSD-3-Clause
#include "counter_random.h"
#include "scene_renderer.h"

#include <gtest/gtest.h>
#include <pcl/console/print.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

using namespace pcl_attention;
using Eigen::Vector3d;
using Cloud = pcl::PointCloud<pcl::PointXYZRGBL>;

namespace
{

/** \brief A plane that faces a camera at the origin, and no noise but what the test switches on. */
SceneDescription
wallAt (double depth)
{
  SceneDescription scene;
  SceneObject wall;
  wall.shape = SceneShape::plane;
  wall.label = scene_label::wall;
  wall.pose.translation ().z () = depth;
  scene.supports.push_back (wall);
  auto& noise = scene.noise;
  noise.axial = noise.quantization = noise.lateral = noise.shadows = noise.grazing_holes = noise.edge_holes =
      noise.color = false;
  return (scene);
}

/** \brief A thin board at 1 m in front of a wall at 1.5 m; its left edge is at x = -0.1. */
SceneDescription
boardScene ()
{
  SceneDescription scene = wallAt (1.5);
  SceneObject board;
  board.size = {0.2, 0.2, 1e-6};
  board.pose.translation ().z () = 1.0;
  scene.objects.push_back (board);
  return (scene);
}

/** \brief Bit by bit, so that NaN equals NaN. */
bool
areSame (const Cloud& a, const Cloud& b)
{
  const auto areSamePoints = [] (const pcl::PointXYZRGBL& p, const pcl::PointXYZRGBL& q) {
    return (std::memcmp (p.data, q.data, 3 * sizeof (float)) == 0 && p.rgba == q.rgba && p.label == q.label);
  };
  return (a.width == b.width && std::equal (a.begin (), a.end (), b.begin (), b.end (), areSamePoints));
}

struct Statistics
{
  double mean = 0.0, deviation = 0.0;
};

Statistics
depthStatistics (const Cloud& cloud)
{
  double sum = 0.0, squares = 0.0;
  for (const auto& point : cloud)
  {
    sum += point.z;
    squares += static_cast<double> (point.z) * point.z;
  }
  const double n = static_cast<double> (cloud.size ()), mean = sum / n;
  return {mean, std::sqrt (squares / n - mean * mean)};
}

/** \brief Of the depths of a wall at 1 m, between pixels so far from each other. */
double
correlation (const Cloud& cloud, int dx, int dy)
{
  double sum = 0.0, squares = 0.0;
  for (int row = 0; row + dy < 480; ++row)
    for (int column = 0; column + dx < 640; ++column)
    {
      const double a = cloud.at (column, row).z - 1.0, b = cloud.at (column + dx, row + dy).z - 1.0;
      sum += a * b;
      squares += a * a;
    }
  return (sum / squares);
}

} // namespace

TEST (CounterRandom, IsTheSameEverywhere)
{
  // From a second implementation, in Python, whose first mix of 0 is the published 0xe220a8397b1dcdaf of SplitMix64.
  EXPECT_EQ (CounterRandom (0).bits (0), 0x238275bc38fcbe91U);
  EXPECT_EQ (CounterRandom (1, 2).bits (3), 0x2a38bbe987fdf051U);
  const CounterRandom random (5);
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < 100000; ++i)
  {
    sum += random.normal (i);
    squares += random.normal (i) * random.normal (i);
    ASSERT_GE (random.uniform (i), 0.0);
    ASSERT_LT (random.uniform (i), 1.0);
  }
  EXPECT_NEAR (sum / 100000, 0.0, 0.01);
  EXPECT_NEAR (squares / 100000, 1.0, 0.01);
}

TEST (SceneRenderer, SeedsAreReproducibleAndDiffer)
{
  const SceneDescription scene = makeScene (SceneKind::clutter, 1);
  const auto cloud = renderScene (scene, 5);
  EXPECT_TRUE (areSame (*cloud, *renderScene (makeScene (SceneKind::clutter, 1), 5)));
  EXPECT_FALSE (areSame (*cloud, *renderScene (scene, 6)));
  EXPECT_FALSE (areSame (*cloud, *renderScene (makeScene (SceneKind::clutter, 2), 5)));
}

TEST (SceneRenderer, ThreadsDoNotChangeTheResult)
{
  const SceneDescription scene = makeScene (SceneKind::clutter, 4);
  const auto cloud = renderScene (scene, 9, 1);
  for (const unsigned threads : {0, 2, 3, 7})
    EXPECT_TRUE (areSame (*cloud, *renderScene (scene, 9, threads))) << threads;
}

TEST (SceneRenderer, NoNoiseHasNoHoles)
{
  for (const SceneKind kind : allSceneKinds ())
  {
    SceneDescription scene = makeScene (kind, 2);
    scene.camera = scene.camera.resized (320, 240);
    scene.noise.level = 0.0;
    const auto cloud = renderScene (scene, 1);
    for (const auto& point : *cloud)
      ASSERT_TRUE (std::isfinite (point.x) && point.label > 0);
    EXPECT_TRUE (areSame (*cloud, *renderScene (scene, 2)));
  }
}

TEST (SceneRenderer, RaysThatHitNothingAreInvalid)
{
  SceneDescription scene = boardScene ();
  scene.supports.clear ();
  for (const double level : {0.0, 1.0})
  {
    scene.noise = SensorNoise ();
    scene.noise.level = level;
    const auto cloud = renderScene (scene);
    EXPECT_EQ (cloud->at (0, 0).label, 0U);
    EXPECT_TRUE (std::isnan (cloud->at (0, 0).x) && std::isnan (cloud->at (0, 0).y) && std::isnan (cloud->at (0, 0).z));
    EXPECT_EQ (cloud->at (320, 240).label, 20U);
  }
}

TEST (SceneRenderer, AxialNoiseHasTheDocumentedDeviation)
{
  EXPECT_NEAR (SensorNoise ().axialDeviation (2.0), 4.0 * 1.425e-3, 1e-12);
  for (const double depth : {1.0, 2.0})
    for (const double level : {0.5, 1.0, 3.0})
    {
      SceneDescription scene = wallAt (depth);
      scene.noise.level = level;
      scene.noise.axial = scene.noise.quantization = true;
      const Statistics measured = depthStatistics (*renderScene (scene, 3));
      const double expected = 1.425e-3 * depth * depth * level;
      EXPECT_NEAR (measured.deviation, expected, 0.15 * expected) << depth << " m, level " << level;
      EXPECT_NEAR (measured.mean, depth, 0.2 * expected);

      scene.noise = SensorNoise (); // all of it: a bare wall has no edges and shadows
      scene.noise.level = level;
      scene.noise.grazing_holes = false;
      EXPECT_NEAR (depthStatistics (*renderScene (scene, 4)).deviation, expected, 0.15 * expected);
    }
}

TEST (SceneRenderer, QuantizationHasTheDocumentedSteps)
{
  SceneDescription scene = wallAt (1.0);
  scene.noise.axial = scene.noise.quantization = true;
  std::set<long> steps;
  const auto rendered = renderScene (scene);
  for (const auto& point : *rendered)
  {
    const double disparity = 1.0 / (point.z * SensorNoise::disparity_unit);
    ASSERT_NEAR (disparity, std::round (disparity), 1e-3);
    steps.insert (std::lround (disparity));
  }
  EXPECT_GE (steps.size (), 3U);
  EXPECT_LE (steps.size (), 8U);
}

TEST (SceneRenderer, NoiseIsCorrelatedOverAFewPixels)
{
  SceneDescription scene = wallAt (1.0);
  scene.noise.axial = true;
  const auto cloud = renderScene (scene, 8);
  for (const auto& [lag, expected] :
       std::map<int, double>{{1, 56.0 / 70.0}, {2, 28.0 / 70.0}, {3, 8.0 / 70.0}, {6, 0.0}})
  {
    EXPECT_NEAR (correlation (*cloud, lag, 0), expected, 0.03) << lag;
    EXPECT_NEAR (correlation (*cloud, 0, lag), expected, 0.03) << lag;
  }
}

TEST (SceneRenderer, LateralNoiseMovesEdgesOnly)
{
  SceneDescription scene = boardScene ();
  scene.noise.lateral = true;
  const auto cloud = renderScene (scene, 2);
  // The board's left edge is at column 319.5 - 52.5 = 267, in the middle of a pixel: half of these show the wall.
  double sum = 0.0, squares = 0.0;
  int moved = 0;
  for (int row = 200; row < 280; ++row)
  {
    int wall_pixels = 0;
    for (int column = 250; column < 284; ++column)
    {
      const double z = cloud->at (column, row).z;
      ASSERT_TRUE (std::abs (z - 1.0) < 1e-5 || std::abs (z - 1.5) < 1e-5) << z;
      wall_pixels += z > 1.2;
      EXPECT_EQ (cloud->at (column, row).label, column < 267 ? 3U : 20U) << "labels do not wobble";
    }
    const double edge = 250.0 + wall_pixels - 267.0;
    moved += edge != 0.0;
    sum += edge;
    squares += edge * edge;
  }
  EXPECT_GT (moved, 20);
  EXPECT_NEAR (sum / 80, 0.5, 0.4);
  EXPECT_NEAR (std::sqrt (squares / 80 - sum * sum / 6400), 0.8, 0.3);
}

TEST (SceneRenderer, LateralNoiseKeepsSlantedPlanesFlat)
{
  SceneDescription scene = wallAt (1.0);
  scene.supports[0].pose.rotate (Eigen::AngleAxisd (0.8, Vector3d::UnitX ()));
  const auto exact = renderScene (scene);
  scene.noise.lateral = true;
  const auto cloud = renderScene (scene);
  for (std::size_t i = 0; i < cloud->size (); ++i)
    ASSERT_NEAR ((*cloud)[i].z, (*exact)[i].z, 1e-5);
}

TEST (SceneRenderer, TheShadowLiesWhereTheProjectorDoesNotReach)
{
  SceneDescription scene = boardScene ();
  scene.noise.shadows = true;
  const auto cloud = renderScene (scene);
  // Seen past the board's left edge from the camera, the wall begins at x = -0.15; from the projector at -0.1875.
  const int row = 240;
  int holes = 0;
  for (int column = 0; column < 640; ++column)
  {
    const double x = (column - 319.5) / 525.0 * 1.5;
    const bool is_shadow = x > -0.1875 && x < -0.15 - 1e-9; // the edge itself is in the middle of a pixel
    EXPECT_EQ (cloud->at (column, row).label == 0, is_shadow) << column;
    holes += is_shadow;
  }
  EXPECT_EQ (holes, 13);
}

TEST (StereoSensor, NoiseIsWavesOfTheDocumentedDeviation)
{
  for (const double depth : {1.0, 2.0})
  {
    SceneDescription scene = wallAt (depth);
    scene.noise.sensor = SceneSensor::stereo;
    scene.noise.axial = true;
    EXPECT_DOUBLE_EQ (scene.noise.axialDeviation (depth), 3e-3 * depth * depth);
    const Statistics measured = depthStatistics (*renderScene (scene, 3));
    EXPECT_NEAR (measured.deviation, 3e-3 * depth * depth, 0.1 * 3e-3 * depth * depth);
    EXPECT_NEAR (measured.mean, depth, 2e-3 * depth * depth);
  }
}

TEST (StereoSensor, NoiseIsCorrelatedByTwoExponentialWindows)
{
  // There and back is exp (-|x| / 4); twice, and once more for what two pixels have in common.
  std::vector<double> window{1.0};
  for (int round = 0; round < 4; ++round)
  {
    std::vector<double> wider (window.size () + 120, 0.0);
    for (std::size_t i = 0; i < window.size (); ++i)
      for (int k = -60; k <= 60; ++k)
        wider[i + static_cast<std::size_t> (k + 60)] += window[i] * std::exp (-std::abs (k) / 4.0);
    window = wider;
  }
  const std::size_t middle = window.size () / 2;
  SceneDescription scene = wallAt (1.0);
  scene.noise.sensor = SceneSensor::stereo;
  scene.noise.axial = true;
  const auto cloud = renderScene (scene, 8);
  for (const int lag : {2, 4, 8, 16, 32})
    for (const auto& [dx, dy] : {std::pair<int, int> (lag, 0), std::pair<int, int> (0, lag)})
      EXPECT_NEAR (correlation (*cloud, dx, dy), window[middle + static_cast<std::size_t> (lag)] / window[middle], 0.06) << dx << " " << dy;
}

TEST (StereoSensor, SmallStepsAreSmoothedAndJumpsAreNot)
{
  const auto depths = [] (double behind, bool smoothing) {
    SceneDescription scene = boardScene ();
    scene.supports[0].pose.translation ().z () = 1.0 + behind;
    scene.noise.sensor = SceneSensor::stereo;
    scene.noise.smoothing = smoothing;
    const auto cloud = renderScene (scene);
    std::vector<double> row;
    for (int column = 200; column < 319; ++column)
      row.push_back (cloud->at (column, 240).z);
    return (row);
  };
  // The board, whose left edge is at column 267, 8 mm before a wall: .008 in 1 / z of the .024 that is a jump.
  const std::vector<double> step = depths (0.008, true), sharp = depths (0.008, false), jump = depths (0.1, true);
  EXPECT_NEAR (step.front (), 1.008, 3e-4);
  EXPECT_NEAR (step.back (), 1.0, 3e-4);
  EXPECT_NEAR (0.5 * (step[66] + step[67]), 1.004, 5e-4) << "half way at the edge";
  EXPECT_TRUE (std::is_sorted (step.rbegin (), step.rend ()));
  // Of exp (-|x| / 4) twice, (1 + |x| / 4) exp (-|x| / 4), (2 + x / 4) exp (-x / 4) / 4 lies beyond x: at 6 pixels .195.
  EXPECT_NEAR ((step[60] - 1.0) / 0.008, 1.0 - 0.195, 0.05);
  EXPECT_NEAR (sharp[66], 1.008, 1e-5);
  EXPECT_NEAR (sharp[67], 1.0, 1e-5);
  EXPECT_NEAR (jump[66], 1.1, 1e-5);
  EXPECT_NEAR (jump[67], 1.0, 1e-5);
}

TEST (StereoSensor, DepthsAreMillimetresAndTheShadowIsNarrower)
{
  SceneDescription scene = boardScene ();
  scene.noise.sensor = SceneSensor::stereo;
  scene.noise.shadows = scene.noise.axial = scene.noise.quantization = true;
  const auto cloud = renderScene (scene);
  int holes = 0;
  for (int column = 0; column < 640; ++column)
  {
    const auto& point = cloud->at (column, 240);
    holes += point.label == 0;
    const double millimetres = point.label == 0 ? 0.0 : 1000.0 * point.z;
    EXPECT_NEAR (millimetres, std::round (millimetres), 1e-3);
  }
  EXPECT_EQ (holes, 8) << "from x = -.15 to -.175 at 1.5 m, columns 259 to 266";
}

TEST (SceneRenderer, GrazingRaysHaveNoDepth)
{
  SceneDescription scene = wallAt (1.0);
  scene.supports[0].pose.rotate (Eigen::AngleAxisd (75.0 * M_PI / 180.0, Vector3d::UnitX ()));
  scene.noise.grazing_holes = true;
  const auto cloud = renderScene (scene);
  const Vector3d normal = scene.supports[0].pose.linear ().col (2);
  const auto exact = [&scene] {
    scene.noise.level = 0.0;
    return (renderScene (scene));
  }();
  int holes = 0, kept = 0;
  for (std::size_t i = 0; i < cloud->size (); ++i)
  {
    const Vector3d ray = (*exact)[i].getVector3fMap ().cast<double> ().normalized ();
    if (!ray.allFinite ())
      continue;
    const double angle = std::acos (std::abs (normal.dot (ray))) * 180.0 / M_PI;
    const bool is_hole = (*cloud)[i].label == 0;
    // The limit of 80 degrees has a deviation of 3 degrees.
    EXPECT_TRUE (is_hole || angle < 80.0 + 3.0 * 4.5);
    EXPECT_TRUE (!is_hole || angle > 80.0 - 3.0 * 4.5);
    (is_hole ? holes : kept) += 1;
  }
  EXPECT_GT (holes, 1000);
  EXPECT_GT (kept, 1000);
}

TEST (SceneRenderer, EdgeHolesAreAtEdges)
{
  SceneDescription scene = boardScene ();
  scene.noise.edge_holes = true;
  const auto cloud = renderScene (scene, 1);
  int holes = 0;
  for (int row = 0; row < 480; ++row)
    for (int column = 0; column < 640; ++column)
      if (cloud->at (column, row).label == 0)
      {
        ++holes;
        // The board is at columns 267 to 371 and rows 187 to 291.
        const double x = std::abs (column - 319.5), y = std::abs (row - 239.5);
        EXPECT_NEAR (std::max (x, y), 52.5, 1.1);
      }
  EXPECT_GT (holes, 50);
  EXPECT_LT (holes, 400); // of about 840 edge pixels
}

TEST (SceneRenderer, ColorNoiseIsSmall)
{
  SceneDescription scene = wallAt (1.0);
  const auto clean = renderScene (scene);
  scene.noise.color = true;
  const auto noisy = renderScene (scene);
  double squares = 0.0;
  for (std::size_t i = 0; i < clean->size (); ++i)
  {
    squares += std::pow ((*noisy)[i].g - (*clean)[i].g, 2);
    ASSERT_EQ ((*noisy)[i].z, (*clean)[i].z);
  }
  EXPECT_NEAR (std::sqrt (squares / static_cast<double> (clean->size ())), 2.0, 0.15);
}

TEST (SceneRenderer, MoreNoiseMakesMoreHoles)
{
  SceneDescription scene = makeScene (SceneKind::clutter, 3);
  std::size_t previous = 0;
  for (const double level : {0.0, 1.0, 3.0})
  {
    scene.noise.level = level;
    std::size_t holes = 0;
    const auto rendered = renderScene (scene);
    for (const auto& point : *rendered)
      holes += point.label == 0;
    EXPECT_EQ (holes == 0, level == 0.0);
    EXPECT_GE (holes, previous);
    EXPECT_LT (holes, 640U * 480U / 5U);
    previous = holes;
  }
}

TEST (SceneRenderer, VisiblePiecesAreNumberedBySize)
{
  SceneDescription scene = boardScene ();
  scene.objects[0].size = {0.4, 0.1, 0.01};
  SceneObject post; // hides a part right of the middle
  post.size = {0.02, 0.3, 0.01};
  post.pose.translation () = Vector3d (0.05, 0, 0.9);
  post.label = 30;
  scene.objects.push_back (post);
  std::map<std::uint32_t, int> pixels;
  const auto rendered = renderScene (scene);
  for (const auto& point : *rendered)
    ++pixels[point.label];
  EXPECT_EQ (pixels.size (), 4U); // wall, 20, 21, 30
  EXPECT_GT (pixels[20], pixels[21]);
  EXPECT_GT (pixels[21], 1000);
  EXPECT_GT (pixels[30], 1000);

  // Eleven pieces: the number stays below 10.
  scene.objects.resize (1);
  for (int i = 0; i < 10; ++i)
  {
    post.pose.translation ().x () = 0.9 * (-0.165 + 0.036 * i);
    post.size.x () = 0.01;
    post.label = 30 + 10 * i;
    scene.objects.push_back (post);
  }
  pixels.clear ();
  const auto eleven_pieces = renderScene (scene);
  for (const auto& point : *eleven_pieces)
    ++pixels[point.label];
  EXPECT_EQ (pixels.count (29), 1U);
  EXPECT_EQ (pixels.count (22), 1U);
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ (pixels.count (31 + 10 * i), 0U);

  // A piece of less than 20 pixels has the number of the largest one.
  scene.objects.resize (1);
  scene.objects[0].size = {0.4, 0.003, 0.001}; // a line of 210 by 1.6 pixels
  post.size.x () = 0.03;
  post.pose.translation ().x () = 0.9 * 0.18; // leaves about 4 columns on its right
  post.label = 30;
  scene.objects.push_back (post);
  std::set<std::uint32_t> labels;
  bool is_right_seen = false;
  const auto cloud = renderScene (scene);
  for (int row = 0; row < 480; ++row)
    for (int column = 0; column < 640; ++column)
    {
      labels.insert (cloud->at (column, row).label);
      is_right_seen |= column > 410 && cloud->at (column, row).label == 20;
    }
  EXPECT_EQ (labels, (std::set<std::uint32_t>{3, 20, 30}));
  EXPECT_TRUE (is_right_seen);
}

TEST (SceneRenderer, DiagonalPixelsAreOnePiece)
{
  // A thin wire across the image at 45 degrees: its pixels meet at corners.
  SceneDescription scene = wallAt (1.5);
  SceneObject wire;
  wire.size = {0.6, 0.0012, 0.001}; // 0.6 of a pixel wide
  wire.pose.translation ().z () = 1.0;
  wire.pose.rotate (Eigen::AngleAxisd (M_PI / 4.0, Vector3d::UnitZ ()));
  scene.objects.push_back (wire);
  int pixels = 0;
  const auto rendered = renderScene (scene);
  for (const auto& point : *rendered)
  {
    pixels += point.label == 20;
    EXPECT_TRUE (point.label == 3 || point.label == 20) << point.label;
  }
  EXPECT_GT (pixels, 150);
}

TEST (SceneRenderer, WorldFrameTransformsBackToTheCameraFrame)
{
  SceneDescription scene = makeScene (SceneKind::clutter, 6);
  const auto camera_cloud = renderScene (scene);
  EXPECT_TRUE (camera_cloud->sensor_origin_.head<3> ().isZero ());
  EXPECT_TRUE (camera_cloud->sensor_orientation_.isApprox (Eigen::Quaternionf::Identity ()));
  scene.world_frame = true;
  const auto world_cloud = renderScene (scene);
  const Eigen::Isometry3f to_camera =
      (Eigen::Translation3f (world_cloud->sensor_origin_.head<3> ()) * world_cloud->sensor_orientation_).inverse ();
  for (std::size_t i = 0; i < world_cloud->size (); ++i)
  {
    const auto &world = (*world_cloud)[i], &camera = (*camera_cloud)[i];
    ASSERT_EQ (world.label, camera.label);
    ASSERT_EQ (world.rgba, camera.rgba);
    if (world.label == 0)
      continue;
    ASSERT_LT ((to_camera * world.getVector3fMap () - camera.getVector3fMap ()).norm (), 2e-6F);
  }
  EXPECT_GT (world_cloud->sensor_origin_.z (), 0.4F);

  scene.noise.level = 0.0;
  const auto exact_cloud = renderScene (scene);
  float lowest = 1.0F;
  for (const auto& point : *exact_cloud)
    lowest = point.label < 20 ? lowest : std::min (lowest, point.z);
  EXPECT_NEAR (lowest, 0.0F, 0.002F) << "objects stand on z = 0";
}

TEST (SceneRenderer, AnyResolutionShowsTheSameView)
{
  SceneDescription scene = makeScene (SceneKind::separate, 1);
  scene.noise.level = 0.0;
  const SceneCamera camera = scene.camera;
  for (const auto& [width, height] :
       std::vector<std::pair<int, int>>{{1, 1}, {1, 7}, {9, 1}, {2, 2}, {160, 120}, {641, 479}, {1280, 960}})
  {
    scene.camera = camera.resized (width, height);
    for (const double level : {0.0, 1.0})
    {
      scene.noise.level = level;
      const auto cloud = renderScene (scene);
      EXPECT_EQ (cloud->width, static_cast<std::uint32_t> (width));
      EXPECT_EQ (cloud->height, static_cast<std::uint32_t> (height));
      EXPECT_EQ (cloud->size (), static_cast<std::size_t> (width) * height);
    }
    // The old image's corners are within the new image.
    const Vector3d corner = camera.pose * Vector3d (-320.0 / 525.0, -240.0 / 525.0, 1.0);
    const Vector3d seen = scene.camera.project (corner);
    EXPECT_GE (seen.x (), -0.5 - 1e-9);
    EXPECT_GE (seen.y (), -0.5 - 1e-9);
  }
  scene.camera = camera.resized (1280, 960);
  EXPECT_DOUBLE_EQ (scene.camera.focal_length, 1050.0);
  EXPECT_DOUBLE_EQ (scene.camera.center_x, 639.5);
}

TEST (SceneRenderer, SenselessInputGivesAnEmptyCloud)
{
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  SceneDescription scene = makeScene ();
  scene.camera.width = 0;
  EXPECT_TRUE (renderScene (scene)->empty ());
  scene = makeScene ();
  scene.camera.focal_length = 0.0;
  EXPECT_TRUE (renderScene (scene)->empty ());
  for (const double level : {-0.1, 3.1, std::numeric_limits<double>::quiet_NaN ()})
  {
    scene = makeScene ();
    scene.noise.level = level;
    EXPECT_TRUE (renderScene (scene)->empty ()) << level;
  }
  pcl::console::setVerbosityLevel (pcl::console::L_INFO);
  EXPECT_TRUE (renderScene (SceneDescription ())->size () == 640 * 480) << "an empty scene has invalid points only";
}
