// SPDX-License-Identifier: BSD-3-Clause
// What is estimated from the cloud itself: the focal length and the noise of the depth.
#include "shapes.h"
#include <pcl_attention/core/sensor_model.h>

#include <gtest/gtest.h>

#include <random>

using namespace pcl_attention;
using Eigen::Vector3d;
using shapes::Frame;

namespace
{

/** \brief A plane whose inverse depth has Gaussian noise: then sigma_z = noise z^2. */
Frame
noisyPlane (double noise, const Vector3d& normal, double depth, unsigned seed)
{
  std::mt19937 random (seed);
  std::normal_distribution<double> gauss (0.0, noise);
  const shapes::Camera camera{200, 150};
  Frame frame = shapes::look (shapes::plane ({0, 0, depth}, normal), camera);
  for (int row = 0; row < 150; ++row)
    for (int column = 0; column < 200; ++column)
    {
      const std::size_t index = frame.index (column, row);
      const double z = 1.0 / (1.0 / frame.point (index).z () + gauss (random));
      frame.set (index, camera.ray (column, row) * z, normal);
    }
  return (frame);
}

} // namespace

TEST (DepthNoise, OfPlanesIsFoundWithinAFewPercent)
{
  for (const double noise : {1e-4, 1e-3, 3e-3})
    for (const Vector3d& normal : {Vector3d (0, 0, -1), Vector3d (0.5, -0.6, -1)})
      for (const double depth : {0.6, 2.0})
        EXPECT_NEAR (estimateDepthNoise (noisyPlane (noise, normal, depth, 1).cloud) / noise, 1.0, 0.05)
            << noise << " " << depth << " " << normal.transpose ();
}

TEST (DepthNoise, OfRenderedScenesIsTheSensors)
{
  for (const auto& [kind, tolerance] : std::vector<std::pair<SceneKind, double>>{
           {SceneKind::wall, 0.15}, {SceneKind::empty_table, 0.15}, {SceneKind::clutter, 0.3}})
    for (const bool quantization : {false, true})
    {
      SceneDescription scene = makeScene (kind, 3);
      scene.noise.quantization = quantization;
      scene.noise.lateral = false;
      const OrganizedCloud cloud = gather (*renderScene (scene, 3), nullptr);
      // Quantization contributes a twelfth of the squared step.
      const double gauss = SensorNoise::disparity_unit * std::sqrt (0.25 - 1.0 / 12.0);
      const double expected = quantization ? scene.noise.axialDeviation (1.0) : gauss;
      const double share = estimateDepthNoise (cloud) / expected;
      std::printf ("             %s%s: %.2f of the true noise\n", sceneKindName (kind).c_str (),
                   quantization ? " quantized" : "", share);
      // The median of quantized differences is a multiple of the step itself. Edges and curved surfaces add to the
      // noise.
      EXPECT_NEAR (share, 1.0, quantization ? std::max (0.25, tolerance) : tolerance) << sceneKindName (kind);
    }
}

TEST (DepthNoise, OfExactPlanesIsZeroAndOfTinyCloudsUnknown)
{
  EXPECT_LT (estimateDepthNoise (shapes::look (shapes::plane ({0, 0, 1}, {0.5, 0.2, -1})).cloud), 1e-6f);
  EXPECT_EQ (estimateDepthNoise (shapes::emptyFrame (200, 150).cloud), 0.0f);
  EXPECT_EQ (estimateDepthNoise (noisyPlane (1e-3, {0, 0, -1}, 1.0, 1).cloud) > 0.0f, true);
  EXPECT_EQ (estimateDepthNoise (shapes::hills (1, {12, 10}).cloud), 0.0f);
}

TEST (SmoothedDepth, IsToldFromIndependentNoise)
{
  const OrganizedCloud independent = noisyPlane (1e-3, {0.5, -0.6, -1}, 1.0, 1).cloud;
  EXPECT_FALSE (hasSmoothedDepth (independent));
  // A sensor that averages over windows, of 3 and of 17 columns: noise 4 columns apart has nothing in common, and most of it.
  for (const int around : {1, 8})
  {
    OrganizedCloud smoothed = independent;
    for (int row = 0; row < 150; ++row)
      for (int column = 0; column < 200; ++column)
      {
        double sum = 0.0;
        int count = 0;
        for (int other = std::max (0, column - around); other <= std::min (199, column + around); ++other, ++count)
          sum += 1.0 / independent.z[row * 200 + other];
        smoothed.z[row * 200 + column] = static_cast<float> (count / sum);
      }
    EXPECT_EQ (hasSmoothedDepth (smoothed), around == 8) << around;
  }
  EXPECT_FALSE (hasSmoothedDepth (shapes::look (shapes::plane ({0, 0, 1}, {0.5, 0.2, -1})).cloud)) << "exact";
  EXPECT_FALSE (hasSmoothedDepth (shapes::emptyFrame (200, 150).cloud)) << "without points";
}

TEST (SmoothedDepth, IsTheStereoCamerasAndNotTheKinects)
{
  for (const SceneKind kind : {SceneKind::clutter, SceneKind::empty_table, SceneKind::separate})
    for (const SceneSensor sensor : {SceneSensor::kinect, SceneSensor::stereo})
    {
      SceneDescription scene = makeScene (kind, 3);
      scene.noise.sensor = sensor;
      const OrganizedCloud cloud = gather (*renderScene (scene, 3), nullptr);
      EXPECT_EQ (hasSmoothedDepth (cloud), sensor == SceneSensor::stereo) << sceneKindName (kind);
      EXPECT_EQ (estimateSensor (cloud).smoothed_depth, sensor == SceneSensor::stereo);
    }
}

TEST (FocalLength, IsThatOfTheCamera)
{
  for (const double focal_length : {120.0, 525.0, 1050.0})
  {
    const shapes::Camera camera{96, 64, focal_length};
    for (const shapes::Surface& surface : {shapes::plane ({0, 0, 1}, {0, 0, -1}),
                                           shapes::plane ({0, 0, 1}, {0.6, 0.3, -1}), shapes::sphere ({0, 0, 1}, 0.3)})
      EXPECT_NEAR (estimateFocalLength (shapes::look (surface, camera).cloud) / focal_length, 1.0, 1e-4);
  }
}

TEST (FocalLength, IsFoundThroughNoiseHolesAndAnOffCentrePrincipalPoint)
{
  SceneDescription scene = makeScene (SceneKind::clutter, 1);
  scene.camera = scene.camera.resized (160, 120);
  scene.camera.center_x += 20.0;
  scene.camera.center_y -= 10.0;
  const OrganizedCloud cloud = gather (*renderScene (scene, 1), nullptr);
  EXPECT_NEAR (estimateFocalLength (cloud) / scene.camera.focal_length, 1.0, 1e-3);
}

TEST (FocalLength, OfTooFewPointsIsUnknown)
{
  Frame frame = shapes::emptyFrame (10, 10);
  EXPECT_EQ (estimateFocalLength (frame.cloud), 0.0f);
  frame.set (0, {0, 0, 1}, {0, 0, -1});
  frame.set (5, {0.1, 0, 1}, {0, 0, -1});
  EXPECT_EQ (estimateFocalLength (frame.cloud), 0.0f);
  // All points on one ray tell nothing.
  for (std::size_t index = 0; index < 100; ++index)
    frame.set (index, {0.1, 0.1, 1}, {0, 0, -1});
  EXPECT_EQ (estimateFocalLength (frame.cloud), 0.0f);
}
