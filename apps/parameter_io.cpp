// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_io.h"

#include "number_text.h"
#include "whole_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace pcl_attention
{

namespace
{

using Json = nlohmann::ordered_json;

[[noreturn]] void
fail (const std::string& source, const std::string& message)
{
  throw std::runtime_error (source + ": " + message);
}

bool
isToggle (const ParameterDescription& row)
{
  static const std::vector<std::string> off_and_on{"off", "on"};
  return (row.choices == off_and_on);
}

Json
valueToJson (const ParameterDescription& row, const AttentionParameters& parameters)
{
  const double value = row.get (parameters);
  if (isToggle (row))
    return (value != 0.0);
  if (!row.choices.empty ())
    return (row.toString (parameters));
  if (row.integer)
    return (static_cast<std::int64_t> (value));
  return (shortestDouble (static_cast<float> (value)));
}

/** \brief Text as ParameterDescription::parse takes it.
 * \return empty if the value is of the wrong type */
std::string
valueToText (const ParameterDescription& row, const Json& value)
{
  if (isToggle (row))
    return (value.is_boolean () ? row.choices[value.get<bool> () ? 1 : 0] : "");
  if (!row.choices.empty ())
    return (value.is_string () ? escaped (value.get<std::string> ()) : "");
  return (value.is_number () ? value.dump () : "");
}

const char*
typeName (const ParameterDescription& row)
{
  return (isToggle (row) ? "true or false" : row.choices.empty () ? "a number" : "a string");
}

} // namespace

const std::vector<std::string>&
presetNames ()
{
  static const std::vector<std::string> names{"default", "paper"};
  return (names);
}

NamedParameters
presetParameters (const std::string& name)
{
  if (name == "default")
    return {name, AttentionParameters ()};
  if (name == "paper")
    return {name, AttentionParameters::paper ()};
  throw std::runtime_error ("preset is '" + escaped (name) + "', but must be one of default paper");
}

Json
parametersToJson (const NamedParameters& parameters)
{
  Json json;
  json["preset"] = parameters.preset;
  for (const ParameterDescription& row : parameterTable ())
    json[row.name] = valueToJson (row, parameters.values);
  return (json);
}

void
parametersFromJson (const Json& json, const std::string& source, NamedParameters& parameters)
{
  if (!json.is_object ())
    fail (source, "not a JSON object of parameters");
  NamedParameters changed = parameters;
  for (const auto& [key, value] : json.items ())
  {
    if (key == "preset")
    {
      const auto& names = presetNames ();
      if (!value.is_string () || std::find (names.begin (), names.end (), value.get<std::string> ()) == names.end ())
        fail (source, "preset is " + shortText (value) + ", but must be one of \"default\" \"paper\"");
      changed.preset = value.get<std::string> ();
      continue;
    }
    const auto& table = parameterTable ();
    const auto row = std::find_if (table.begin (), table.end (), [name = key] (const ParameterDescription& candidate) {
      return (candidate.name == name);
    });
    if (row == table.end ())
      fail (source, "unknown parameter \"" + escaped (key) + "\"");
    const std::string text = valueToText (*row, value);
    if (text.empty ())
      fail (source, key + " is " + shortText (value) + ", but must be " + typeName (*row));
    const std::string error = row->parse (text, changed.values);
    if (!error.empty ())
      fail (source, error);
  }
  parameters = changed;
}

Json
readJsonFile (const std::string& path)
{
  std::ifstream stream (path);
  if (!stream)
    fail (path, std::string ("cannot be opened: ") + std::strerror (errno));
  // Much of what is done with JSON, writing it for one, calls itself once a level.
  constexpr int deepest = 100;
  const auto check_depth = [&] (int depth, Json::parse_event_t, const Json&) {
    if (depth > deepest)
      fail (path, "nested more than " + std::to_string (deepest) + " deep");
    return (true);
  };
  try
  {
    return (Json::parse (stream, check_depth));
  }
  catch (const Json::parse_error& error)
  {
    fail (path, "not valid JSON, at byte " + std::to_string (error.byte));
  }
  catch (const Json::exception& error) // a number that no double can hold
  {
    fail (path, "not valid JSON: " + std::string (error.what ()));
  }
}

std::string
escaped (const std::string& text)
{
  const std::string quoted = Json (text).dump (-1, ' ', false, Json::error_handler_t::replace);
  return (quoted.substr (1, quoted.size () - 2));
}

std::string
shortText (const Json& value)
{
  constexpr std::size_t longest = 80;
  const std::string text = value.dump ();
  return (text.size () <= longest ? text : text.substr (0, longest) + "...");
}

NamedParameters
readParameters (const std::string& path, const std::string& preset)
{
  const Json json = readJsonFile (path);
  std::string base = preset.empty () ? "default" : preset;
  if (preset.empty () && json.is_object () && json.contains ("preset") && json["preset"] == "paper")
    base = "paper";
  NamedParameters parameters = presetParameters (base);
  parametersFromJson (json, path, parameters);
  parameters.preset = base;
  return (parameters);
}

void
writeParameters (const std::string& path, const NamedParameters& parameters)
{
  writeWholeFile (path, parametersToJson (parameters).dump (2) + '\n');
}

void
applyParts (AttentionParameters& parameters)
{
  parameters.visiblePieces ();
}

} // namespace pcl_attention
