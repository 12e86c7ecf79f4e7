// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/parameters.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief The parameters of all stages, and the preset that they started from. */
struct NamedParameters
{
  std::string preset{"default"};
  AttentionParameters values;
};

/** \brief "default" and "paper". */
const std::vector<std::string>& presetNames ();

/** \brief The parameters of a preset.
 * \throws std::runtime_error if there is no such preset */
NamedParameters presetParameters (const std::string& name);

/** \brief The preset's name and every row of the parameter table: numbers, true and false, or the name of a choice. */
nlohmann::ordered_json parametersToJson (const NamedParameters& parameters);

/** \brief Change those parameters that a JSON object holds. The name of a preset in it is taken over, its values are
 * not. \param[in] source named in errors \throws std::runtime_error that names the source and the key: unknown, of the
 * wrong type, or out of range; the parameters are then unchanged */
void parametersFromJson (const nlohmann::ordered_json& json, const std::string& source, NamedParameters& parameters);

/** \brief Parse a JSON file, nested at most 100 deep.
 * \throws std::runtime_error that names the file */
nlohmann::ordered_json readJsonFile (const std::string& path);

/** \brief A text for a message of one line: with line feeds and other control characters as JSON has them between its
 * quotes. */
std::string escaped (const std::string& text);

/** \brief A value for a message, cut off where it gets long. */
std::string shortText (const nlohmann::ordered_json& value);

/** \brief Read parameters from a JSON file, as in the "parameters" of a summary.json.
 * \param[in] preset what the file's parameters are put over; empty: the preset that the file names, else the default
 * one \throws std::runtime_error that names the file */
NamedParameters readParameters (const std::string& path, const std::string& preset = "");

/** \brief Write all parameters to a JSON file.
 * \throws std::runtime_error that names the file */
void writeParameters (const std::string& path, const NamedParameters& parameters);

/** \brief Whole objects or visible pieces: -parts, everything that differs between the two. */
void applyParts (AttentionParameters& parameters);

} // namespace pcl_attention
