// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.h"
#include "parameter_io.h"

namespace pcl_attention
{

/** \brief Add -preset, -parameters, -parts, -all_points, and a flag for every row of the parameter table. */
void addParameterFlags (CommandLine& command_line);

/** \brief The parameters that the flags ask for: the preset, over it the file's, over these -parts and -all_points, and
 * last the flags of single parameters. A bad value or file ends the program as CommandLine::fail does. */
NamedParameters parametersFromFlags (const CommandLine& command_line);

} // namespace pcl_attention
