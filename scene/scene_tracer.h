// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_description.h"

#include <limits>
#include <vector>

namespace pcl_attention
{

/** \brief The first surface on a ray. */
struct SceneHit
{
  const SceneObject* object = nullptr;                        /**< \brief nullptr if the ray hits nothing */
  double distance = std::numeric_limits<double>::infinity (); /**< \brief in lengths of the ray's direction */
  Eigen::Vector3d local_point{0, 0, 0};                       /**< \brief in the object's frame, metres */
  Eigen::Vector3d local_normal{0, 0, 0}; /**< \brief in the object's frame, unit length, towards the viewer */
  Eigen::Vector3d normal{0, 0, 0};       /**< \brief in the world frame */
};

/** \brief Casts rays, in the world frame, into a scene that must outlive the tracer. */
class SceneTracer
{
public:
  explicit SceneTracer (const SceneDescription& scene);

  /** \param[in] origin metres
   * \param[in] direction of any length above 0 */
  SceneHit trace (const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;

  /** \return whether something stands between two points (metres), which may themselves lie on surfaces */
  bool blocked (const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

private:
  struct Item
  {
    const SceneObject* object;
    Eigen::Isometry3d to_local;
    Eigen::Vector3d center; // of the sphere around it, in the world frame
    double radius;
  };
  std::vector<Item> items_;
};

/** \return the colour of the surface at a hit, without light; red, green, blue in [0, 1] */
Eigen::Vector3d surfaceColor (const SceneHit& hit);

} // namespace pcl_attention
