// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_renderer.h"

#include <vector>

namespace pcl_attention
{

/** \brief Some small rendered scenes, from which inputs start that are to get far. */
inline const std::vector<pcl::PointCloud<pcl::PointXYZRGBL>::Ptr>&
smallScenes ()
{
  static const auto scenes = [] {
    std::vector<pcl::PointCloud<pcl::PointXYZRGBL>::Ptr> clouds;
    for (const SceneKind kind : {SceneKind::clutter, SceneKind::stacked, SceneKind::occluded, SceneKind::cylinders,
                                 SceneKind::empty_table, SceneKind::corner, SceneKind::single_mug, SceneKind::boxes})
    {
      SceneDescription scene = makeScene (kind, 1);
      const int columns = 20 + 4 * static_cast<int> (clouds.size () % 4);
      scene.camera = scene.camera.resized (columns, columns * 3 / 4);
      scene.world_frame = clouds.size () % 2 == 1;
      clouds.push_back (renderScene (scene, 1, 1));
    }
    return (clouds);
  }();
  return (scenes);
}

} // namespace pcl_attention
