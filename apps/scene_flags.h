// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.h"
#include "scene_io.h"

#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief Add -intrinsics, -depth_scale, -color, -image_width and -max_range. */
void addSceneFlags (CommandLine& command_line);

/** \brief How scenes are to be read. A bad value or file ends the program as CommandLine::fail does. */
SceneOptions sceneOptionsFromFlags (const CommandLine& command_line);

/** \brief The scenes that a list of files and folders stands for, see \ref listScenes: of a folder the PCD and PLY files,
 * and the PNG files where the camera of depth images is known. */
std::vector<std::string> listScenesToRead (const std::vector<std::string>& paths, const SceneOptions& options);

} // namespace pcl_attention
