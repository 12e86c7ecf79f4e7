// SPDX-License-Identifier: BSD-3-Clause
#include "scene_description.h"

#include <algorithm>

namespace pcl_attention
{

SceneCamera
SceneCamera::resized (int new_width, int new_height) const
{
  const double x_scale = static_cast<double> (new_width) / width, y_scale = static_cast<double> (new_height) / height;
  SceneCamera camera = *this;
  camera.width = new_width;
  camera.height = new_height;
  camera.focal_length = focal_length * std::min (x_scale, y_scale);
  // Column 0 reaches from -0.5 to 0.5.
  camera.center_x = (center_x + 0.5) * x_scale - 0.5;
  camera.center_y = (center_y + 0.5) * y_scale - 0.5;
  return (camera);
}

void
SceneCamera::lookAt (const Eigen::Vector3d& eye, const Eigen::Vector3d& target)
{
  const Eigen::Vector3d forward = (target - eye).normalized ();
  // Straight up or down, where right is not defined by the view, it is the world's x.
  Eigen::Vector3d right = forward.cross (Eigen::Vector3d::UnitZ ());
  right = right.norm () > 1e-9 ? right.normalized () : Eigen::Vector3d::UnitX ();
  pose.linear () << right, forward.cross (right), forward;
  pose.translation () = eye;
}

Eigen::Vector3d
SceneCamera::project (const Eigen::Vector3d& point) const
{
  const Eigen::Vector3d p = pose.inverse () * point;
  return {focal_length * p.x () / p.z () + center_x, focal_length * p.y () / p.z () + center_y, p.z ()};
}

Eigen::AlignedBox3d
SceneObject::bounds () const
{
  const Eigen::Vector3d half = 0.5 * size;
  return {-half, half + Eigen::Vector3d (handleReach (), 0, 0)};
}

double
SceneObject::bowlCenter () const
{
  // The outer sphere, cut off half a wall above its lowest point, passes through the rim.
  const double rim = 0.5 * size.x (), height = size.z (), t = wall_thickness;
  return ((rim * rim + height * height - 0.25 * t * t) / (t + 2.0 * height) - 0.5 * height);
}

} // namespace pcl_attention
