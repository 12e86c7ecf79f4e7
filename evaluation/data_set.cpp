// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/data_set.h"

#include <filesystem>

namespace pcl_attention
{

std::vector<SceneSource>
listSceneSources (const std::vector<std::string>& paths)
{
  std::vector<SceneSource> sources;
  for (const std::string& path : listScenes (paths))
    sources.push_back ({std::filesystem::path (path).stem ().string (), sceneCategory (path), {path}});
  return (sources);
}

LabelledScene
loadScene (const SceneSource& source)
{
  return (loadLabelledScene (source.files.front ()));
}

} // namespace pcl_attention
