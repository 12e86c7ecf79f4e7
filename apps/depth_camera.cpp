// SPDX-License-Identifier: BSD-3-Clause
#include "depth_camera.h"

#include "number_text.h"
#include "parameter_io.h"
#include <pcl_attention/core/organized_cloud.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace pcl_attention
{

namespace
{

[[noreturn]] void
fail (const std::string& source, const std::string& message)
{
  throw std::runtime_error (source + ": " + message);
}

/** \brief One of the numbers by name, which is that of the JSON key. */
void
setValue (const std::string& source, const std::string& name, double value, DepthCamera& camera)
{
  const auto set = [&] (double& field, bool is_right, const char* range) {
    if (!std::isfinite (value) || !is_right)
      fail (source, name + " is " + numberText (value) + ", but must be " + range);
    field = value;
  };
  const auto set_size = [&] (int& field) {
    double number = 0.0;
    set (number, value >= 1.0 && value <= static_cast<double> (longest_side) && value == std::floor (value),
         "a whole number from 1 to 16384");
    field = static_cast<int> (number);
  };
  if (name == "fx")
    set (camera.fx, value > 0.0, "above 0, in pixels");
  else if (name == "fy")
    set (camera.fy, value > 0.0, "above 0, in pixels");
  else if (name == "cx")
    set (camera.cx, true, "a number of pixels");
  else if (name == "cy")
    set (camera.cy, true, "a number of pixels");
  else if (name == "width")
    set_size (camera.width);
  else if (name == "height")
    set_size (camera.height);
  else if (name == "depth_scale")
    set (camera.depth_scale, value > 0.0 && value <= 1.0,
         "above 0 and at most 1, in metres a unit: 0.001 for millimetres");
  else
    fail (source, "unknown key \"" + escaped (name) + "\"; there are fx, fy, cx, cy, width, height and depth_scale");
}

DepthCamera
fromFile (const std::string& path)
{
  const nlohmann::ordered_json json = readJsonFile (path);
  if (!json.is_object ())
    fail (path, "not a JSON object with the camera's fx, fy, cx and cy");
  DepthCamera camera;
  for (const auto& [key, value] : json.items ())
  {
    if (!value.is_number ())
      fail (path, escaped (key) + " is " + shortText (value) + ", but must be a number");
    setValue (path, key, value.get<double> (), camera);
  }
  for (const char* key : {"fx", "fy", "cx", "cy"})
    if (!json.contains (key))
      fail (path, std::string ("no ") + key + ": the camera's fx, fy, cx and cy are needed");
  return (camera);
}

DepthCamera
fromText (const std::string& text)
{
  static const std::array<const char*, 6> names{"fx", "fy", "cx", "cy", "width", "height"};
  const std::vector<double> numbers = numbersOf<double> (text);
  if (numbers.size () != 4 && numbers.size () != 6)
    fail ("'" + escaped (text) + "'", "neither a JSON file nor numbers as fx,fy,cx,cy or fx,fy,cx,cy,width,height");
  DepthCamera camera;
  for (std::size_t k = 0; k < numbers.size (); ++k)
    setValue ("'" + text + "'", names[k], numbers[k], camera);
  return (camera);
}

} // namespace

DepthCamera
readDepthCamera (const std::string& text_or_file)
{
  const std::filesystem::path path (text_or_file);
  std::error_code ignored;
  const bool is_file = path.extension () == ".json" || std::filesystem::exists (path, ignored);
  const DepthCamera camera = is_file ? fromFile (text_or_file) : fromText (text_or_file);
  const std::string problem =
      imageSizeProblem (static_cast<std::uint64_t> (camera.width), static_cast<std::uint64_t> (camera.height));
  if (!problem.empty ())
    fail (is_file ? text_or_file : "'" + text_or_file + "'", "width x height is " + problem);
  return (camera);
}

} // namespace pcl_attention
