// SPDX-License-Identifier: BSD-3-Clause
// The Gaussian pyramid (paper III-B) against naive double-precision versions.
#include "pyramid_oracle.h"
#include "shapes.h"
#include <pcl_attention/core/pyramid.h>

#include <gtest/gtest.h>

using namespace pcl_attention;
using shapes::Frame;

namespace
{

Image<float>
randomMap (unsigned seed, int width, int height)
{
  std::mt19937 random (seed);
  std::uniform_real_distribution<float> uniform (0.0f, 1.0f);
  Image<float> map (width, height);
  for (float& value : map.data)
    value = uniform (random);
  return (map);
}

void
expectNear (const Image<float>& map, const Image<double>& expected, double tolerance)
{
  ASSERT_EQ (map.width, expected.width);
  ASSERT_EQ (map.height, expected.height);
  for (std::size_t index = 0; index < map.size (); ++index)
    ASSERT_NEAR (map[index], expected[index], tolerance) << index % map.width << " " << index / map.width;
}

} // namespace

TEST (Halving, IsValidFromHalfOfTheKernelsWeightOn)
{
  // Under the third coarse column lie the fine columns 3 to 6; their weights are 1/8, 3/8, 3/8, 1/8, exact in float.
  for (const auto& [first_hole, is_valid] : {std::pair<int, bool> (5, true), {4, false}})
  {
    Frame frame = shapes::look (shapes::plane ({0, 0, 1}, {0, 0, -1}), {16, 12});
    for (int row = 0; row < 12; ++row)
      for (int column = first_hole; column < 16; ++column)
        frame.invalidate (frame.index (column, row));
    Frame half;
    halve (frame.cloud, frame.normals, 1, half.cloud, half.normals);
    EXPECT_EQ (half.cloud.valid[3 * 8 + 2] == 1, is_valid);
    EXPECT_EQ (half.cloud.valid[3 * 8 + 1], 1);
    EXPECT_EQ (half.cloud.valid[3 * 8 + 3], 0);
  }
}

TEST (Halving, EqualsTheNaiveVersion)
{
  for (const auto& [width, height] :
       std::vector<std::pair<int, int>>{{64, 48}, {63, 48}, {64, 47}, {33, 21}, {2, 2}, {1, 1}})
    for (const double holes : {0.0, 0.4})
    {
      SCOPED_TRACE (::testing::Message () << width << "x" << height << " holes " << holes);
      Frame frame = shapes::hills (9, {width, height});
      if (holes > 0.0)
        shapes::punchHoles (frame, 5, holes);
      Frame half;
      halve (frame.cloud, frame.normals, 1, half.cloud, half.normals);
      const oracle::Level expected = oracle::halved (oracle::levelOf (frame.cloud, frame.normals));
      ASSERT_EQ (half.cloud.width, expected.width);
      ASSERT_EQ (half.cloud.height, expected.height);
      int valid = 0;
      for (std::size_t index = 0; index < half.cloud.size (); ++index)
      {
        EXPECT_EQ (half.cloud.valid[index], half.normals.valid[index]);
        // Half of the weight may be either side of a rounding.
        if (std::abs (expected.weight[index] - 0.5) < 1e-6)
          continue;
        ASSERT_EQ (half.cloud.valid[index] != 0, expected.valid[index]) << index;
        if (!expected.valid[index])
          continue;
        ++valid;
        EXPECT_LT ((half.point (index) - expected.points[index]).norm (), 1e-6);
        EXPECT_LT ((half.normal (index) - expected.normals[index]).norm (), 1e-6);
        EXPECT_NEAR (half.normal (index).norm (), 1.0, 1e-6);
      }
      EXPECT_EQ (valid > 0, std::find (expected.valid.begin (), expected.valid.end (), true) != expected.valid.end ());
      if (width > 30 && holes == 0.0)
      {
        EXPECT_GT (valid, half.cloud.width * half.cloud.height / 2);
      }
    }
}

TEST (Halving, OfAPlaneStaysOnThePlane)
{
  const Frame frame = shapes::look (shapes::plane ({0, 0, 1}, {0.3, -0.2, -1}));
  Frame half;
  halve (frame.cloud, frame.normals, 1, half.cloud, half.normals);
  const Eigen::Vector3d normal = Eigen::Vector3d (0.3, -0.2, -1).normalized ();
  EXPECT_EQ (half.cloud.width, 32);
  EXPECT_EQ (half.cloud.height, 24);
  for (std::size_t index = 0; index < half.cloud.size (); ++index)
  {
    ASSERT_TRUE (half.cloud.valid[index]);
    EXPECT_NEAR (normal.dot (half.point (index) - Eigen::Vector3d (0, 0, 1)), 0.0, 1e-6);
    EXPECT_LT ((half.normal (index) - normal).norm (), 1e-6);
  }
}

TEST (Halving, CommutesWithMirroringAtEvenWidths)
{
  Frame frame = shapes::hills (4);
  shapes::punchHoles (frame, 3, 0.2);
  Frame half, half_of_mirror;
  halve (frame.cloud, frame.normals, 1, half.cloud, half.normals);
  const Frame mirror = shapes::mirrored (frame);
  halve (mirror.cloud, mirror.normals, 1, half_of_mirror.cloud, half_of_mirror.normals);
  const Frame mirror_of_half = shapes::mirrored (half);
  EXPECT_EQ (half_of_mirror.cloud.valid, mirror_of_half.cloud.valid);
  for (std::size_t index = 0; index < half.cloud.size (); ++index)
  {
    EXPECT_NEAR (half_of_mirror.cloud.x[index], mirror_of_half.cloud.x[index], 1e-7);
    EXPECT_NEAR (half_of_mirror.cloud.z[index], mirror_of_half.cloud.z[index], 2e-7);
    EXPECT_NEAR (half_of_mirror.normals.x[index], mirror_of_half.normals.x[index], 2e-7);
  }
}

TEST (Doubling, EqualsBilinearInterpolationBetweenPixelCentres)
{
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{{64, 48}, {63, 47}, {7, 5}, {2, 1}, {1, 1}})
  {
    SCOPED_TRACE (width);
    const Image<float> map = randomMap (static_cast<unsigned> (width), (width + 1) / 2, (height + 1) / 2);
    expectNear (doubleSize (map, width, height, 1), oracle::doubled (oracle::toDouble (map), width, height), 1e-6);
  }
}

TEST (Doubling, KeepsConstantsAndRamps)
{
  const Image<float> flat = doubleSize (Image<float> (8, 6, 0.7f), 16, 12, 1);
  for (const float value : flat.data)
    EXPECT_FLOAT_EQ (value, 0.7f);
  Image<float> ramp (8, 1);
  for (int column = 0; column < 8; ++column)
    ramp (column, 0) = static_cast<float> (column);
  const Image<float> fine = doubleSize (ramp, 16, 2, 1);
  // The centre of fine pixel c lies at coarse (c - 1/2) / 2.
  for (int column = 1; column < 15; ++column)
    EXPECT_FLOAT_EQ (fine (column, 0), 0.5f * (static_cast<float> (column) - 0.5f));
}

TEST (BoxBlur, EqualsTheNaiveMean)
{
  for (const int radius : {0, 1, 2, 5, 15})
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{{31, 17}, {64, 48}, {3, 2}, {1, 9}})
    {
      SCOPED_TRACE (::testing::Message () << radius << " " << width);
      const Image<float> map = randomMap (7, width, height);
      expectNear (boxBlur (map, radius, 1), oracle::boxBlurred (oracle::toDouble (map), radius), 1e-6);
    }
}

TEST (BoxBlur, ByHand)
{
  Image<float> map (3, 3, 0.0f);
  map (1, 1) = 36.0f;
  // 9, 6 or 4 pixels of the square lie inside the image.
  EXPECT_EQ (boxBlur (map, 1, 1).data, (std::vector<float>{9, 6, 9, 6, 4, 6, 9, 6, 9}));
}
