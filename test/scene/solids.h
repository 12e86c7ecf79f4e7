// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_description.h"

#include <cmath>
#include <limits>

/** \brief The shapes once more, as functions of a point instead of a ray: what the renderer is checked against. */
namespace solids
{

using pcl_attention::SceneObject;
using pcl_attention::SceneShape;

inline double
boxDistance (const Eigen::Vector3d& p, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
  const Eigen::Vector3d d = (low - p).cwiseMax (p - high);
  return (d.cwiseMax (0.0).norm () + std::min (0.0, d.maxCoeff ()));
}

inline double
tubeDistance (const Eigen::Vector3d& p, double radius, double low, double high)
{
  const Eigen::Vector2d d (p.head<2> ().norm () - radius, std::max (low - p.z (), p.z () - high));
  return (d.cwiseMax (0.0).norm () + std::min (0.0, d.maxCoeff ()));
}

/** \return a number that is 0 on the surface, negative inside the material, positive outside; near the surface it is
 * the distance in metres \param[in] p in the object's frame, metres */
inline double
distance (const SceneObject& object, const Eigen::Vector3d& p)
{
  const Eigen::Vector3d half = 0.5 * object.size;
  const double thickness = object.wall_thickness;
  switch (object.shape)
  {
  case SceneShape::plane:
    return (std::abs (p.z ()));
  case SceneShape::box:
    return (boxDistance (p, -half, half));
  case SceneShape::cylinder:
    return (tubeDistance (p, half.x (), -half.z (), half.z ()));
  case SceneShape::sphere:
    return (p.norm () - half.x ());
  case SceneShape::bowl:
  {
    // The outer sphere from three of its points: the rim, and the bottom half a wall below the foot.
    const double bottom = -half.z () - 0.5 * thickness, rise = half.z () - bottom, rim = half.x ();
    const double radius = (rise * rise + rim * rim) / (2.0 * rise);
    const double from_center = (p - Eigen::Vector3d (0, 0, bottom + radius)).norm ();
    const double shell = std::max (from_center - radius, radius - thickness - from_center);
    return (std::max (shell, std::abs (p.z ()) - half.z ()));
  }
  case SceneShape::mug:
  {
    const double hollow = tubeDistance (p, half.x () - thickness, -half.z () + thickness, 1.0);
    const double body = std::max (tubeDistance (p, half.x (), -half.z (), half.z ()), -hollow);
    const double bar = 0.12 * half.z (), reach = half.x () + object.handleReach (), start = half.x () - thickness;
    const double low = -0.5 * half.z (), high = 0.7 * half.z ();
    double handle = boxDistance (p, {reach - 2.0 * bar, -bar, low - bar}, {reach, bar, high + bar});
    for (const double z : {low, high})
      handle = std::min (handle, boxDistance (p, {start, -bar, z - bar}, {reach, bar, z + bar}));
    return (std::min (body, handle));
  }
  }
  return (std::numeric_limits<double>::quiet_NaN ());
}

} // namespace solids
