// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.h"
#include "scene_io.h"

namespace pcl_attention
{

/** \brief Add -intrinsics, -depth_scale, -color, -image_width and -max_range. */
void addSceneFlags (CommandLine& command_line);

/** \brief How scenes are to be read. A bad value or file ends the program as CommandLine::fail does. */
SceneOptions sceneOptionsFromFlags (const CommandLine& command_line);

} // namespace pcl_attention
