// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "scene_renderer.h"
#include "whole_file.h"

#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace po = boost::program_options;

namespace
{

using Cloud = pcl::PointCloud<pcl::PointXYZRGBL>;

void
save (const Cloud& cloud, const std::string& file)
{
  pcl::PCLPointCloud2 points;
  pcl::toPCLPointCloud2 (cloud, points);
  std::ostringstream stream;
  stream.imbue (std::locale::classic ());
  if (pcl::PCDWriter ().writeBinaryCompressed (stream, points, cloud.sensor_origin_, cloud.sensor_orientation_) != 0)
    throw std::runtime_error (file + ": its points cannot be encoded as PCD");
  pcl_attention::writeWholeFile (file, stream.str ());
}

/** \return OUTPUT_0003.pcd for number 3 of several, OUTPUT.pcd for a single scene */
std::string
fileName (const std::string& output, int number, int count)
{
  if (count == 1)
    return (output);
  char suffix[32];
  std::snprintf (suffix, sizeof (suffix), "_%04d.pcd", number);
  return (output.substr (0, output.size () - 4) + suffix);
}

std::string
kindNames ()
{
  std::string names;
  for (const pcl_attention::SceneKind kind : pcl_attention::allSceneKinds ())
    names += (names.empty () ? "" : ", ") + pcl_attention::sceneKindName (kind);
  return (names);
}

} // namespace

int
main (int argc, char** argv)
{
  pcl_attention::CommandLine command_line (
      "pcl_attention_make_scene OUTPUT.pcd [flags]",
      "Renders labelled RGB-D scenes of objects on a table, as a Kinect or a stereo camera would see them: an organized PCD\n"
      "with x y z rgba label. Labels: 0 no depth, 1 table, 2 floor, 3 and 4 walls, 20 + 10 k object k,\n"
      "its separately visible pieces + 0, + 1, ...");
  command_line.addOptions () ("kind", po::value<std::string> ()->default_value ("clutter"),
                              ("what is in the scene: " + kindNames ()).c_str ()) (
      "objects", po::value<int> ()->default_value (0),
      "number of objects, 0 = as usual for the kind; fewer where no more find room") (
      "seed", po::value<long long> ()->default_value (0), "of the scene, and of its noise without -noise_seed") (
      "noise_seed", po::value<long long> (), "of the noise: other frames of a still camera") (
      "sensor", po::value<std::string> ()->default_value ("kinect"),
      "whose noise: kinect, or stereo, which smooths creases and small steps away") (
      "noise", po::value<double> ()->default_value (1.0), "of the sensor: 0 = exact, 1 = the sensor's own, up to 3") (
      "width", po::value<int> ()->default_value (640),
      "of the image, pixels") ("height", po::value<int> ()->default_value (480), "of the image, pixels") (
      "world", po::bool_switch (),
      "points in the table's frame, the camera as sensor pose; else in the camera's frame") (
      "count", po::value<int> ()->default_value (1),
      "number of scenes, of successive seeds, in OUTPUT_0001.pcd, OUTPUT_0002.pcd, ...");
  command_line.parse (argc, argv);

  if (command_line.positional ().size () != 1)
    command_line.fail ("give one OUTPUT.pcd to write to");
  const std::string& output = command_line.positional ().front ();
  if (std::filesystem::path (output).extension () != ".pcd")
    command_line.fail ("the output has to end in .pcd, '" + output + "' does not");
  const auto kind = pcl_attention::sceneKindFromName (command_line.get<std::string> ("kind"));
  if (!kind)
    command_line.fail ("no kind '" + command_line.get<std::string> ("kind") + "', -kind takes " + kindNames ());
  const auto integer = [&command_line] (const std::string& flag, int low, int high) {
    const int value = command_line.get<int> (flag);
    if (value < low || value > high)
      command_line.fail ("-" + flag + " takes " + std::to_string (low) + " to " + std::to_string (high) + ", not " +
                         std::to_string (value));
    return (value);
  };
  const int width = integer ("width", 1, 10000), height = integer ("height", 1, 10000);
  const int objects = integer ("objects", 0, 1000), count = integer ("count", 1, 9999);
  const long long seed = command_line.get<long long> ("seed");
  if (seed < 0)
    command_line.fail ("-seed takes 0 or more, not " + std::to_string (seed));
  const bool has_noise_seed = command_line.has ("noise_seed");
  const long long noise_seed = has_noise_seed ? command_line.get<long long> ("noise_seed") : 0;
  if (noise_seed < 0)
    command_line.fail ("-noise_seed takes 0 or more, not " + std::to_string (noise_seed));
  const auto sensor = pcl_attention::sceneSensorFromName (command_line.get<std::string> ("sensor"));
  if (!sensor)
    command_line.fail ("no sensor '" + command_line.get<std::string> ("sensor") + "', -sensor takes kinect or stereo");
  const double noise = command_line.get<double> ("noise");
  if (!(noise >= 0.0 && noise <= pcl_attention::SensorNoise::max_level))
    command_line.fail ("-noise takes 0 (exact) to 3, not " + std::to_string (noise));

  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS); // one line of our own says what went wrong
  try
  {
    for (int number = 1; number <= count; ++number)
    {
      const auto scene_seed = static_cast<std::uint64_t> (seed) + static_cast<std::uint64_t> (number - 1);
      auto scene = pcl_attention::makeScene (*kind, scene_seed, static_cast<unsigned> (objects));
      scene.camera = scene.camera.resized (width, height);
      scene.noise.level = noise;
      scene.noise.sensor = *sensor;
      scene.world_frame = command_line.get<bool> ("world");
      const std::string file = fileName (output, number, count);
      save (*pcl_attention::renderScene (scene, has_noise_seed ? static_cast<std::uint64_t> (noise_seed) : scene_seed), file);
      std::cout << file << ": " << scene.objects.size () << " objects (" << number << "/" << count << ")" << std::endl;
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "pcl_attention_make_scene: " << error.what () << std::endl;
    return (1);
  }
  return (pcl_attention::exitCode ("pcl_attention_make_scene", EXIT_SUCCESS));
}
