// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_flags.h"

#include "number_text.h"

namespace pcl_attention
{

namespace
{

std::string
joinChoices (const std::vector<std::string>& choices)
{
  std::string text;
  for (const std::string& choice : choices)
    text += (text.empty () ? "" : " | ") + choice;
  return (text);
}

/** \brief E.g. "of a point from the patch's plane; 1e-05 to 1 m, default 0.008; paper IV-A". */
std::string
describe (const ParameterDescription& row)
{
  std::string text = row.help + "; ";
  if (row.choices.empty ())
    text += numberText (row.minimum) + " to " + numberText (row.maximum) + (row.unit.empty () ? "" : " " + row.unit);
  else
    text += joinChoices (row.choices);
  text += ", default " + row.toString (AttentionParameters ());
  return (row.source.empty () ? text : text + "; paper " + row.source);
}

} // namespace

void
addParameterFlags (CommandLine& command_line)
{
  namespace po = boost::program_options;
  auto add = command_line.addOptions ("Parameters");
  add ("preset", po::value<std::string> (),
       (joinChoices (presetNames ()) + ": what all parameters start from").c_str ());
  add ("parameters", po::value<std::string> (),
       "JSON file of parameters, as in a summary.json; it goes over the preset, the flags go over it");
  add ("parts", "visible pieces instead of whole objects");
  add ("all_points", "also segment attention points that lie in an earlier segment");
  for (const ParameterDescription& row : parameterTable ())
    command_line.addOptions ("Stage " + row.stage) (row.name.c_str (), po::value<std::string> (), describe (row).c_str ());
}

NamedParameters
parametersFromFlags (const CommandLine& command_line)
{
  NamedParameters parameters;
  try
  {
    const std::string preset = command_line.has ("preset") ? command_line.get<std::string> ("preset") : "";
    if (!preset.empty () || command_line.has ("preset"))
      parameters = presetParameters (preset);
    if (command_line.has ("parameters"))
      parameters = readParameters (command_line.get<std::string> ("parameters"), preset);
  }
  catch (const std::exception& error)
  {
    command_line.fail (error.what ());
  }
  if (command_line.has ("parts"))
    applyParts (parameters.values);
  if (command_line.has ("all_points"))
    parameters.values.segmentation.inhibition_of_return = false;
  for (const ParameterDescription& row : parameterTable ())
  {
    if (!command_line.has (row.name))
      continue;
    const std::string error = row.parse (command_line.get<std::string> (row.name), parameters.values);
    if (!error.empty ())
      command_line.fail ("-" + error);
  }
  return (parameters);
}

} // namespace pcl_attention
