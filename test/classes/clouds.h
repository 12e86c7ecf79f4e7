// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_renderer.h"
#include <pcl/segmentation/attention_segment.h>

#include <gtest/gtest.h>
#include <pcl/common/io.h>
#include <pcl/common/transforms.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>

// Clouds to test the classes on, and ways to compare what comes out.

using PointT = pcl::PointXYZRGB;
using Cloud = pcl::PointCloud<PointT>;

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN ();

/** \brief A rendered scene with a sensor's noise, small to be quick. */
inline Cloud::Ptr
renderCloud (pcl_attention::SceneKind kind = pcl_attention::SceneKind::clutter, std::uint64_t seed = 7, int width = 320,
             int height = 240)
{
  pcl_attention::SceneDescription scene = pcl_attention::makeScene (kind, seed);
  scene.camera = scene.camera.resized (width, height);
  const Cloud::Ptr cloud (new Cloud);
  pcl::copyPointCloud (*pcl_attention::renderScene (scene, seed), *cloud);
  return (cloud);
}

/** \brief The scene of most tests, rendered once; nobody changes it. */
inline Cloud::ConstPtr
sceneCloud ()
{
  static const Cloud::ConstPtr cloud = renderCloud ();
  return (cloud);
}

/** \brief A cloud of equal points. */
inline Cloud::Ptr
filledCloud (int width, int height, float x, float y, float z)
{
  const Cloud::Ptr cloud (new Cloud (width, height));
  for (PointT& point : *cloud)
    point.getVector3fMap () = Eigen::Vector3f (x, y, z);
  return (cloud);
}

/** \brief The indices of a rectangle in the middle, half as wide and high as the cloud. */
inline pcl::IndicesPtr
middleIndices (const Cloud& cloud)
{
  const pcl::IndicesPtr indices (new pcl::Indices);
  for (std::uint32_t row = cloud.height / 4; row < 3 * cloud.height / 4; ++row)
    for (std::uint32_t column = cloud.width / 4; column < 3 * cloud.width / 4; ++column)
      indices->push_back (static_cast<pcl::index_t> (row * cloud.width + column));
  return (indices);
}

/** \brief The cloud with NaN everywhere but at the indices. */
inline Cloud::Ptr
onlyAt (const pcl::Indices& indices, const Cloud& cloud)
{
  const Cloud::Ptr masked (new Cloud (cloud));
  for (PointT& point : *masked)
    point.getVector3fMap ().setConstant (nan_value);
  for (const pcl::index_t index : indices)
    (*masked)[index] = cloud[index];
  return (masked);
}

/** \brief Cloud and sensor moved together: the same view. */
inline Cloud::Ptr
moved (const Cloud& cloud, const Eigen::Isometry3f& motion)
{
  const Cloud::Ptr result (new Cloud);
  pcl::transformPointCloud (cloud, *result, motion.matrix ());
  result->sensor_origin_ << motion * cloud.sensor_origin_.head<3> (), 0.0f;
  result->sensor_orientation_ = Eigen::Quaternionf (motion.linear ()) * cloud.sensor_orientation_;
  return (result);
}

inline Eigen::Isometry3f
someMotion ()
{
  Eigen::Isometry3f motion = Eigen::Isometry3f::Identity ();
  motion.linear () = Eigen::AngleAxisf (2.1f, Eigen::Vector3f (0.3f, -0.8f, 0.5f).normalized ()).toRotationMatrix ();
  motion.translation () = Eigen::Vector3f (1.3f, -0.7f, 0.4f);
  return (motion);
}

/** \brief Two bars that cross, 1 where they lie: one component with a junction. */
inline pcl::PointCloud<pcl::Intensity>::Ptr
crossMap (std::uint32_t width, std::uint32_t height, int center_column, int center_row, float value = 1.0f)
{
  const pcl::PointCloud<pcl::Intensity>::Ptr map (
      new pcl::PointCloud<pcl::Intensity> (width, height, pcl::Intensity (0.0f)));
  for (int row = 0; row < static_cast<int> (height); ++row)
    for (int column = 0; column < static_cast<int> (width); ++column)
    {
      const int right = std::abs (column - center_column), down = std::abs (row - center_row);
      if (std::min (right, down) <= 1 && std::max (right, down) <= 15)
        (*map)[row * width + column].intensity = value;
    }
  return (map);
}

inline pcl::AttentionPoint
pointAt (int column, int row)
{
  pcl::AttentionPoint point;
  point.column = column;
  point.row = row;
  return (point);
}

inline pcl::index_t
indexOf (const pcl::AttentionPoint& point, const Cloud& cloud)
{
  return (static_cast<pcl::index_t> (point.row * cloud.width + point.column));
}

/** \brief What a call writes to the error stream. */
template <typename Call>
std::string
errorsOf (const Call& call)
{
  testing::internal::CaptureStderr ();
  call ();
  return (testing::internal::GetCapturedStderr ());
}

inline testing::AssertionResult
contains (const std::string& text, const std::string& part)
{
  if (text.find (part) != std::string::npos)
    return (testing::AssertionSuccess ());
  return (testing::AssertionFailure () << "'" << part << "' is missing in: " << text);
}

/** \brief Intersection over union of two ascending lists. */
inline double
overlap (const pcl::Indices& a, const pcl::Indices& b)
{
  pcl::Indices common;
  std::set_intersection (a.begin (), a.end (), b.begin (), b.end (), std::back_inserter (common));
  const std::size_t all = a.size () + b.size () - common.size ();
  return (all == 0 ? 1.0 : static_cast<double> (common.size ()) / static_cast<double> (all));
}

/** \brief Bit by bit the same object. */
inline void
expectSame (const pcl::AttentionSegment& a, const pcl::AttentionSegment& b)
{
  EXPECT_EQ (a.indices, b.indices);
  EXPECT_EQ (a.rank, b.rank);
  EXPECT_EQ (a.patches, b.patches);
  EXPECT_EQ (a.attention_point.column, b.attention_point.column);
  EXPECT_EQ (a.attention_point.row, b.attention_point.row);
  EXPECT_EQ (a.attention_point.saliency, b.attention_point.saliency);
  EXPECT_EQ (a.plane, b.plane);
  EXPECT_EQ (a.box.center, b.box.center);
  EXPECT_EQ (a.box.size, b.box.size);
  EXPECT_EQ (a.box.orientation.coeffs (), b.box.orientation.coeffs ());
  EXPECT_EQ (a.compactness, b.compactness);
  EXPECT_EQ (a.growth_end, b.growth_end);
}

inline void
expectSame (const std::vector<pcl::AttentionSegment>& a, const std::vector<pcl::AttentionSegment>& b)
{
  ASSERT_EQ (a.size (), b.size ());
  for (std::size_t index = 0; index < a.size (); ++index)
    expectSame (a[index], b[index]);
}
