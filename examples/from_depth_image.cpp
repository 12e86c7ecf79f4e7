// SPDX-License-Identifier: BSD-3-Clause
// Objects of a depth image that is already in memory, as a camera's driver hands it over: neither files nor VTK needed.
#include <pcl/segmentation/attention_segmentation.h>

#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>

namespace
{

constexpr int width = 320, height = 240;
constexpr float focal_length = 262.5f, center_x = 0.5f * (width - 1), center_y = 0.5f * (height - 1); // pixels

/** \brief A stand-in for the driver: a ball and a block on a floor that slopes away below the camera.
 * \return millimetres, 0 = none */
std::uint16_t
depthAt (int column, int row)
{
  const Eigen::Vector3f ray ((static_cast<float> (column) - center_x) / focal_length,
                             (static_cast<float> (row) - center_y) / focal_length, 1.0f);
  const Eigen::Vector3f up = Eigen::Vector3f (0.0f, -0.8f, -0.6f); // the floor's normal, towards the camera
  float depth = up.dot (Eigen::Vector3f (0.0f, 0.0f, 1.0f)) / up.dot (ray);

  const Eigen::Vector3f ball = Eigen::Vector3f (-0.15f, 0.0f, 1.0f) + 0.06f * up; // of 6 cm radius
  const float along = ray.dot (ball) / ray.squaredNorm ();
  const float discriminant = along * along - (ball.squaredNorm () - 0.0036f) / ray.squaredNorm ();
  if (discriminant > 0.0f)
    depth = along - std::sqrt (discriminant);

  // The block, 16 x 12 x 10 cm: its top and the side that faces the camera.
  const Eigen::Vector3f right (1.0f, 0.0f, 0.0f), near = right.cross (up); // along the floor, near: towards the camera
  const Eigen::Vector3f corner (0.05f, 0.0f, 1.0f);
  const auto hit = [&] (const Eigen::Vector3f& normal, float offset) -> Eigen::Vector3f {
    return ((normal.dot (corner) + offset) / normal.dot (ray) * ray - corner);
  };
  const auto inside = [] (float value, float size) { return (value >= 0.0f && value <= size); };
  const Eigen::Vector3f on_top = hit (up, 0.12f), on_side = hit (near, 0.1f);
  if (inside (right.dot (on_top), 0.16f) && inside (near.dot (on_top), 0.1f))
    depth = (on_top + corner).z ();
  if (inside (right.dot (on_side), 0.16f) && inside (up.dot (on_side), 0.12f))
    depth = (on_side + corner).z ();
  return (depth > 0.0f && depth < 5.0f ? static_cast<std::uint16_t> (std::lround (1000.0f * depth)) : 0);
}

} // namespace

int
main ()
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ> (width, height));
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      pcl::PointXYZ& point = cloud->at (column, row);
      const std::uint16_t millimetres = depthAt (column, row);
      point.z = millimetres > 0 ? 0.001f * millimetres : std::numeric_limits<float>::quiet_NaN ();
      point.x = (static_cast<float> (column) - center_x) / focal_length * point.z;
      point.y = (static_cast<float> (row) - center_y) / focal_length * point.z;
    }

  pcl::AttentionSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud (cloud);
  std::vector<pcl::AttentionSegment> objects;
  if (!segmentation.segment (objects))
    return (1);
  for (const pcl::AttentionSegment& object : objects)
    std::cout << object.rank << ": " << object.indices.size () << " points, box of " << object.box.size.transpose ()
              << " m at " << object.box.center.transpose () << std::endl;
}
