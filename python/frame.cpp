// SPDX-License-Identifier: BSD-3-Clause
#include "frame.h"

#include <pcl/segmentation/impl/organized_cloud.hpp>

#include <array>
#include <pybind11/stl.h>
#include <type_traits>

namespace py = pybind11;

namespace pcl_attention
{

namespace
{

const std::array<const char*, 16> arguments_of_a_frame{"rgb",           "mask",
                                                       "sensor_origin", "sensor_orientation",
                                                       "saliency",      "fixations",
                                                       "threads",       "preset",
                                                       "parts",         "prior_map",
                                                       "prior_region",  "prior_box",
                                                       "prior_color",   "prior_color_exemplar",
                                                       "prior_size",    "prior_distance"};

std::string
shapeText (const py::array& array)
{
  return (py::str (array.attr ("shape")).cast<std::string> ());
}

/** \brief The argument, unless it is absent or None. */
py::object
argumentOf (const py::kwargs& arguments, const char* name)
{
  return (arguments.contains (name) ? py::object (arguments[name]) : py::object (py::none ()));
}

/** \brief The argument as C++ has it.
 * \param[in] type what it must be, for the error */
template <typename T>
T
valueOf (const py::object& argument, const char* name, const std::string& type)
{
  try
  {
    return (argument.cast<T> ());
  }
  catch (const py::cast_error&)
  {
    throw py::type_error (std::string (name) + " must be " + type);
  }
}

/** \brief An argument of the image's size.
 * \param[in] channels 0: (height, width) */
template <typename T>
py::array_t<T, py::array::forcecast>
imageOf (const py::object& argument, const char* name, const char* type, int width, int height, int channels)
{
  const auto array = py::array::ensure (argument);
  // A colour in 0..1 or a mask of numbers is a mistake; a saliency in doubles is none.
  if (!array || (std::is_integral_v<T> && !py::isinstance<py::array_t<T>> (array)))
    throw py::type_error (std::string (name) + " must be an array of " + type);
  const std::string size = std::to_string (height) + ", " + std::to_string (width);
  if (array.ndim () != (channels == 0 ? 2 : 3) || array.shape (0) != height || array.shape (1) != width ||
      (channels > 0 && array.shape (2) != channels))
    throw py::value_error (std::string (name) + " has the shape " + shapeText (array) + ", but must have (" + size +
                           (channels == 0 ? "" : ", " + std::to_string (channels)) + "), as xyz");
  return (array);
}

/** \brief Numbers of an argument like (0, 0, 1). */
template <int size>
Eigen::Matrix<float, size, 1>
vectorOf (const py::object& argument, const char* name, const Eigen::Matrix<float, size, 1>& otherwise)
{
  if (argument.is_none ())
    return (otherwise);
  const auto array = py::array_t<float, py::array::forcecast>::ensure (argument);
  if (!array)
    throw py::type_error (std::string (name) + " must be " + std::to_string (size) + " numbers");
  if (array.ndim () != 1 || array.shape (0) != size)
    throw py::value_error (std::string (name) + " has the shape " + shapeText (array) + ", but must be " +
                           std::to_string (size) + " numbers");
  Eigen::Matrix<float, size, 1> vector;
  for (int i = 0; i < size; ++i)
    vector[i] = array.at (i);
  if (!vector.allFinite ())
    throw py::value_error (std::string (name) + " is not finite");
  return (vector);
}

Eigen::Isometry3f
sensorPoseOf (const py::kwargs& arguments)
{
  const Eigen::Vector3f origin =
      vectorOf<3> (argumentOf (arguments, "sensor_origin"), "sensor_origin", Eigen::Vector3f::Zero ());
  const Eigen::Vector4f wxyz =
      vectorOf<4> (argumentOf (arguments, "sensor_orientation"), "sensor_orientation", Eigen::Vector4f::UnitX ());
  // By way of a cloud, so that a pose is read as everywhere else.
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.sensor_origin_.head<3> () = origin;
  cloud.sensor_orientation_ = Eigen::Quaternionf (wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  return (sensorPose (cloud));
}

std::vector<AttentionPoint>
fixationsOf (const py::object& argument, int width, int height)
{
  std::vector<AttentionPoint> fixations;
  const auto array = py::array_t<double, py::array::forcecast>::ensure (argument);
  if (!array)
    throw py::type_error ("fixations must be pairs of column and row");
  if (array.size () == 0)
    return (fixations);
  if (array.ndim () != 2 || array.shape (1) != 2)
    throw py::value_error ("fixations has the shape " + shapeText (array) + ", but must have (n, 2): column and row");
  const auto pairs = array.unchecked<2> ();
  for (py::ssize_t i = 0; i < pairs.shape (0); ++i)
  {
    const double column = std::floor (pairs (i, 0)), row = std::floor (pairs (i, 1));
    if (!(column >= 0.0 && column < width && row >= 0.0 && row < height))
      throw py::value_error ("the fixation (" + std::to_string (pairs (i, 0)) + ", " + std::to_string (pairs (i, 1)) +
                             ") lies outside the image of " + std::to_string (width) + " columns and " +
                             std::to_string (height) + " rows");
    fixations.emplace_back ();
    fixations.back ().column = static_cast<int> (column);
    fixations.back ().row = static_cast<int> (row);
  }
  return (fixations);
}

std::array<std::uint8_t, 3>
colorOf (const py::object& argument, const char* name)
{
  std::string names;
  for (const auto& [color_name, color] : namedColors ())
  {
    if (py::isinstance<py::str> (argument) && argument.cast<std::string> () == color_name)
      return (color);
    names += ", " + color_name;
  }
  return (valueOf<std::array<std::uint8_t, 3>> (argument, name,
                                                "red, green, blue from 0 to 255, or one of" + names.substr (1)));
}

ColorHistogram
colorsOf (const py::object& argument, const char* name)
{
  const auto array = py::array::ensure (argument);
  if (!array || !py::isinstance<py::array_t<std::uint8_t>> (array))
    throw py::type_error (std::string (name) + " must be an array of uint8");
  if (array.ndim () != 2 || array.shape (1) != 3)
    throw py::value_error (std::string (name) + " has the shape " + shapeText (array) +
                           ", but must have (n, 3): the colours of an example's points");
  ColorHistogram colors;
  const auto pixels = py::array_t<std::uint8_t> (array);
  const auto at = pixels.unchecked<2> ();
  for (py::ssize_t i = 0; i < at.shape (0); ++i)
    colors.add (colorBin (at (i, 0), at (i, 1), at (i, 2)));
  return (colors);
}

/** \brief What the arguments prior_... ask for; still to be checked. */
AttentionPrior
priorOf (const py::kwargs& arguments, int width, int height)
{
  AttentionPrior prior;
  const auto ask = [&] (const char* name, const auto& take) {
    const py::object argument = argumentOf (arguments, name);
    if (!argument.is_none ())
      take (argument, name);
  };
  const auto rangeOf = [] (const py::object& argument, const char* name) -> ValueRange {
    const auto range = valueOf<std::pair<float, float>> (argument, name, "two numbers: minimum and maximum, metres");
    return {range.first, range.second};
  };
  ask ("prior_map", [&] (const py::object& argument, const char* name) {
    const auto values = imageOf<float> (argument, name, "float32", width, height, 0);
    const auto at = values.unchecked<2> ();
    prior.map.assign (width, height);
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        prior.map (column, row) = at (row, column);
  });
  ask ("prior_region", [&] (const py::object& argument, const char* name) {
    const auto region = valueOf<std::array<int, 4>> (argument, name, "whole numbers: column, row, width and height");
    prior.region = PixelRegion{region[0], region[1], region[2], region[3]};
  });
  ask ("prior_box", [&] (const py::object& argument, const char* name) {
    const auto corners =
        valueOf<std::array<std::array<float, 3>, 2>> (argument, name, "two corners of three numbers each");
    prior.box = Eigen::AlignedBox3f (Eigen::Vector3f (corners[0].data ()), Eigen::Vector3f (corners[1].data ()));
  });
  ask ("prior_color", [&] (const py::object& argument, const char* name) { prior.color = colorOf (argument, name); });
  ask ("prior_color_exemplar",
       [&] (const py::object& argument, const char* name) { prior.color_exemplar = colorsOf (argument, name); });
  ask ("prior_size", [&] (const py::object& argument, const char* name) { prior.size = rangeOf (argument, name); });
  ask ("prior_distance",
       [&] (const py::object& argument, const char* name) { prior.distance = rangeOf (argument, name); });
  return (prior);
}

Image<float>
saliencyOf (const py::object& argument, int width, int height)
{
  const auto values = imageOf<float> (argument, "saliency", "float32", width, height, 0);
  pcl::PointCloud<pcl::Intensity> map (static_cast<std::uint32_t> (width), static_cast<std::uint32_t> (height));
  const auto at = values.unchecked<2> ();
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      map.at (column, row).intensity = at (row, column);
  const std::string problem = checkSaliency (&map);
  if (!problem.empty ())
    throw py::value_error (problem);
  return (gather (map));
}

/** \brief The text that ParameterDescription::parse takes. */
std::string
textOf (const py::handle& value)
{
  py::detail::make_caster<bool> flag; // bool or numpy.bool_, and nothing that merely is true or false
  if (flag.load (value, false))
    return (flag ? "on" : "off");
  return (py::str (value).cast<std::string> ());
}

} // namespace

AttentionParameters
parametersOf (const py::kwargs& arguments)
{
  AttentionParameters parameters;
  const py::object preset = argumentOf (arguments, "preset");
  if (!preset.is_none ())
  {
    const std::string name = py::str (preset);
    if (name == "paper")
      parameters = AttentionParameters::paper ();
    else if (name != "default")
      throw py::value_error ("preset is '" + name + "', but must be 'default' or 'paper'");
  }
  const py::object parts = argumentOf (arguments, "parts");
  if (!parts.is_none () && parts.cast<bool> ())
    parameters.visiblePieces ();
  for (const auto& [key, value] : arguments)
  {
    const std::string name = py::str (key);
    if (std::find (arguments_of_a_frame.begin (), arguments_of_a_frame.end (), name) != arguments_of_a_frame.end ())
      continue;
    const auto& table = parameterTable ();
    const auto row = std::find_if (table.begin (), table.end (),
                                   [&] (const ParameterDescription& candidate) { return (candidate.name == name); });
    if (row == table.end ())
      throw py::type_error ("there is no argument '" + name + "'; pcl_attention.parameters () lists the parameters");
    const std::string problem = row->parse (textOf (value), parameters);
    if (!problem.empty ())
      throw py::value_error (problem);
  }
  return (parameters);
}

Frame::Frame (const Points& points_of_frame, const py::kwargs& arguments) : points (points_of_frame)
{
  if (points.ndim () != 3 || points.shape (2) != 3 || points.size () == 0)
    throw py::value_error ("xyz has the shape " + shapeText (points) +
                           ", but must have (height, width, 3): points as the camera delivers them, NaN for holes");
  const std::string size_problem =
    imageSizeProblem (static_cast<std::uint64_t> (points.shape (1)), static_cast<std::uint64_t> (points.shape (0)));
  if (!size_problem.empty ())
    throw py::value_error ("xyz is " + size_problem);
  height = static_cast<int> (points.shape (0));
  width = static_cast<int> (points.shape (1));
  if (width == 1 || height == 1)
    throw py::value_error ("xyz has the shape " + shapeText (points) + ", which is no image");

  const AttentionParameters parameters = parametersOf (arguments);
  const Eigen::Isometry3f pose = sensorPoseOf (arguments);
  py::array_t<std::uint8_t, py::array::forcecast> colors;
  const py::object rgb = argumentOf (arguments, "rgb");
  if (!rgb.is_none ())
    colors = imageOf<std::uint8_t> (rgb, "rgb", "uint8", width, height, 3);
  py::array_t<bool, py::array::forcecast> taken;
  const py::object mask = argumentOf (arguments, "mask");
  if (!mask.is_none ())
    taken = imageOf<bool> (mask, "mask", "bool", width, height, 0);
  const py::object own_saliency = argumentOf (arguments, "saliency"),
                   own_fixations = argumentOf (arguments, "fixations");
  std::optional<Image<float>> map;
  if (!own_saliency.is_none ())
    map = saliencyOf (own_saliency, width, height);
  std::optional<AttentionPoints> fixations;
  if (!own_fixations.is_none ())
  {
    fixations.emplace ();
    fixations->points = fixationsOf (own_fixations, width, height);
  }
  AttentionPrior prior = priorOf (arguments, width, height);
  const std::string problem = validate (prior, width, height, !rgb.is_none ());
  if (!problem.empty ())
    throw py::value_error (problem);
  const py::object threads_argument = argumentOf (arguments, "threads");
  const int threads = threads_argument.is_none () ? 0 : valueOf<int> (threads_argument, "threads", "a whole number");
  if (threads < 0)
    throw py::value_error ("threads is " + std::to_string (threads) + ", but must be 0 (all) or more");

  const auto at = points.unchecked<3> ();
  const py::gil_scoped_release released;
  OrganizedCloud flat;
  flat.reset (width, height);
  struct Position
  {
    float x, y, z;
  };
  gatherPositions (
      [&] (std::size_t index) -> Position {
        const auto row = static_cast<py::ssize_t> (index / width), column = static_cast<py::ssize_t> (index % width);
        return {at (row, column, 0), at (row, column, 1), at (row, column, 2)};
      },
      nullptr, pose, flat);
  if (taken.ndim () == 2)
  {
    const auto selected = taken.unchecked<2> ();
    for (std::size_t index = 0; index < flat.size (); ++index)
      if (!selected (index / width, index % width))
        flat.x[index] = flat.y[index] = flat.z[index] = flat.valid[index] = 0;
  }
  if (colors.ndim () == 3)
  {
    const auto color = colors.unchecked<3> ();
    for (auto* channel : {&flat.red, &flat.green, &flat.blue})
      channel->resize (flat.size ());
    for (std::size_t index = 0; index < flat.size (); ++index)
    {
      const auto row = static_cast<py::ssize_t> (index / width), column = static_cast<py::ssize_t> (index % width);
      flat.red[index] = color (row, column, 0);
      flat.green[index] = color (row, column, 1);
      flat.blue[index] = color (row, column, 2);
    }
  }
  pipeline.start (std::move (flat), pose, parameters, threads);
  if (map)
    pipeline.setSaliency (std::move (*map));
  if (fixations)
    pipeline.setAttentionPoints (std::move (*fixations)); // which keep their order whatever is asked for
  else
    pipeline.setPrior (std::move (prior));
}

} // namespace pcl_attention
