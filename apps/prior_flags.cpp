// SPDX-License-Identifier: BSD-3-Clause
#include "prior_flags.h"

#include "evaluation/png_file.h"
#include "number_text.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <stdexcept>

namespace pcl_attention
{

namespace
{

[[noreturn]] void
fail (const CommandLine& command_line, const std::string& flag, const std::string& expected)
{
  command_line.fail ("-" + flag + " is '" + command_line.get<std::string> (flag) + "', but must be " + expected);
}

std::optional<ValueRange>
rangeFromFlag (const CommandLine& command_line, const std::string& flag)
{
  if (!command_line.has (flag))
    return {};
  const auto numbers = numbersOf<float> (command_line.get<std::string> (flag));
  if (numbers.size () != 2 || numbers[0] < 0.0f || numbers[0] > numbers[1])
    fail (command_line, flag, "MIN,MAX in metres, from 0 up, the smaller one first");
  return (ValueRange{numbers[0], numbers[1]});
}

std::string
colorNames ()
{
  std::string names;
  for (const auto& color : namedColors ())
    names += (names.empty () ? "" : ", ") + color.first;
  return (names);
}

std::array<std::uint8_t, 3>
colorFromFlag (const CommandLine& command_line)
{
  const std::string& text = command_line.get<std::string> ("prior_color");
  for (const auto& [name, color] : namedColors ())
    if (text == name)
      return (color);
  const auto numbers = numbersOf<std::uint8_t> (text);
  if (numbers.size () != 3)
    fail (command_line, "prior_color", "R,G,B from 0 to 255, or one of " + colorNames ());
  return {numbers[0], numbers[1], numbers[2]};
}

nlohmann::ordered_json
toJson (const ValueRange& range)
{
  return {shortestDouble (range.minimum), shortestDouble (range.maximum)};
}

} // namespace

void
addPriorFlags (CommandLine& command_line)
{
  namespace po = boost::program_options;
  // clang-format off
  command_line.addOptions ("What is asked for comes first, nothing is left out")
    ("prior_map", po::value<std::string> (), "8-bit grey PNG file of the scene's size: 255 is asked for, 0 is not")
    ("prior_region", po::value<std::string> (), "COLUMN,ROW,WIDTH,HEIGHT: a rectangle of the image, pixels")
    ("prior_box", po::value<std::string> (), "X,Y,Z,X,Y,Z: smallest and largest corner of a box in the cloud's frame, metres")
    ("prior_color", po::value<std::string> (), ("R,G,B from 0 to 255, or " + colorNames ()).c_str ())
    ("prior_size", po::value<std::string> (), "MIN,MAX: length of the longest side, metres")
    ("prior_distance", po::value<std::string> (), "MIN,MAX: distance from the viewpoint, metres");
  // clang-format on
}

NamedPrior
priorFromFlags (const CommandLine& command_line)
{
  NamedPrior prior;
  if (command_line.has ("prior_map"))
  {
    prior.map_file = command_line.get<std::string> ("prior_map");
    if (!std::filesystem::is_regular_file (prior.map_file))
      fail (command_line, "prior_map", "a PNG file");
  }
  if (command_line.has ("prior_region"))
  {
    const auto numbers = numbersOf<int> (command_line.get<std::string> ("prior_region"));
    if (numbers.size () != 4 || numbers[2] < 1 || numbers[3] < 1)
      fail (command_line, "prior_region", "COLUMN,ROW,WIDTH,HEIGHT in pixels, at least one wide and high");
    prior.values.region = PixelRegion{numbers[0], numbers[1], numbers[2], numbers[3]};
  }
  if (command_line.has ("prior_box"))
  {
    const auto numbers = numbersOf<float> (command_line.get<std::string> ("prior_box"));
    if (numbers.size () != 6 || numbers[0] > numbers[3] || numbers[1] > numbers[4] || numbers[2] > numbers[5])
      fail (command_line, "prior_box", "X,Y,Z,X,Y,Z in metres, the smaller corner first");
    prior.values.box = Eigen::AlignedBox3f (Eigen::Vector3f (numbers[0], numbers[1], numbers[2]),
                                            Eigen::Vector3f (numbers[3], numbers[4], numbers[5]));
  }
  if (command_line.has ("prior_color"))
    prior.values.color = colorFromFlag (command_line);
  prior.values.size = rangeFromFlag (command_line, "prior_size");
  prior.values.distance = rangeFromFlag (command_line, "prior_distance");
  return (prior);
}

NamedPrior
priorForScene (const NamedPrior& prior, int width, int height, bool has_color)
{
  NamedPrior for_scene = prior;
  if (!prior.map_file.empty ())
  {
    const Image<std::uint8_t> grey = readGreyPng (prior.map_file, width, height);
    for_scene.values.map.assign (width, height);
    for (std::size_t pixel = 0; pixel < grey.size (); ++pixel)
      for_scene.values.map[pixel] = static_cast<float> (grey[pixel]) / 255.0f;
  }
  const std::string problem = validate (for_scene.values, width, height, has_color);
  if (!problem.empty ())
    throw std::runtime_error (problem);
  return (for_scene);
}

nlohmann::ordered_json
priorToJson (const NamedPrior& prior)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::object ();
  const AttentionPrior& values = prior.values;
  if (!prior.map_file.empty ())
    json["map"] = prior.map_file;
  if (values.region)
    json["region"] = {values.region->column, values.region->row, values.region->width, values.region->height};
  if (values.box)
    for (const Eigen::Vector3f& corner : {values.box->min (), values.box->max ()})
      for (const float coordinate : corner)
        json["box"].push_back (shortestDouble (coordinate));
  if (values.color)
    json["color"] = *values.color;
  if (values.size)
    json["size"] = toJson (*values.size);
  if (values.distance)
    json["distance"] = toJson (*values.distance);
  return (json);
}

} // namespace pcl_attention
