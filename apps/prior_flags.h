// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.h"

#include <pcl_attention/core/attention_prior.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace pcl_attention
{

/** \brief What is asked for, and the file of its map. */
struct NamedPrior
{
  AttentionPrior values; /**< its map is that of one scene */
  std::string map_file;  /**< empty without one */
};

/** \brief Add -prior_map, -prior_region, -prior_box, -prior_color, -prior_size and -prior_distance. */
void addPriorFlags (CommandLine& command_line);

/** \brief What the flags ask for, without the map. A bad value ends the program as CommandLine::fail does. */
NamedPrior priorFromFlags (const CommandLine& command_line);

/** \brief The prior for a scene of this size: with the map of its file, 255 for what is asked for, 0 for what is not.
 * \throws std::runtime_error if it does not fit the scene */
NamedPrior priorForScene (const NamedPrior& prior, int width, int height, bool has_color);

/** \brief The parts that are asked for by the names and in the order of the flags' numbers. */
nlohmann::ordered_json priorToJson (const NamedPrior& prior);

} // namespace pcl_attention
