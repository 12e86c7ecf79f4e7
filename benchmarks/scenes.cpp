// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include "scene_io.h"
#include "scene_renderer.h"

#include <pcl/common/io.h>

namespace pcl_attention
{

std::vector<SceneCloud::ConstPtr>
loadScenes (const std::vector<std::string>& paths, int columns)
{
  std::vector<SceneCloud::ConstPtr> clouds;
  for (const std::string& path : paths)
    clouds.push_back (readScene (path).cloud);
  if (!paths.empty ())
    return (clouds);
  for (const SceneKind kind : {SceneKind::clutter, SceneKind::stacked, SceneKind::occluded, SceneKind::cylinders})
  {
    SceneDescription description = makeScene (kind, 1);
    description.camera = description.camera.resized (columns, columns * 3 / 4);
    const SceneCloud::Ptr cloud (new SceneCloud);
    pcl::copyPointCloud (*renderScene (description, 1), *cloud);
    clouds.push_back (cloud);
  }
  return (clouds);
}

} // namespace pcl_attention
