// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/labelled_scene.h"

#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief A labelled scene that is not read yet. */
struct SceneSource
{
  std::string name;               ///< different for all scenes of an evaluation, without a slash
  std::string category;           ///< what it is reported under
  std::vector<std::string> files; ///< all that it is read from
};

/** \brief The scenes that a list of files and folders stands for, see \ref listScenes.
 * \throws std::runtime_error that names the path */
std::vector<SceneSource> listSceneSources (const std::vector<std::string>& paths);

/** \brief Read a scene.
 * \throws std::runtime_error that names the file and what is wrong with it */
LabelledScene loadScene (const SceneSource& source);

} // namespace pcl_attention
