// SPDX-License-Identifier: BSD-3-Clause
#include "scene_flags.h"

#include "evaluation/labelled_scene.h"
#include "number_text.h"

namespace pcl_attention
{

void
addSceneFlags (CommandLine& command_line)
{
  namespace po = boost::program_options;
  auto add = command_line.addOptions ();
  add (
      "intrinsics", po::value<std::string> (),
      "the camera of depth images and unorganized clouds, in pixels: fx,fy,cx,cy or fx,fy,cx,cy,width,height or a JSON "
      "file with these keys and depth_scale");
  add ("depth_scale", po::value<double> (), "metres a unit of a depth image: 0.001 (the default) is millimetres");
  add ("color", po::value<std::string> (),
       "colour image of a depth image (PNG), or a folder that holds one of the same name");
  add ("image_width", po::value<int> ()->default_value (0),
       "columns of an image that a file holds as one row, in pixels; 0: such a file is an error");
  add ("max_range", po::value<float> (), "points farther before the camera are left out, in metres");
}

SceneOptions
sceneOptionsFromFlags (const CommandLine& command_line)
{
  SceneOptions options;
  options.image_width = command_line.get<int> ("image_width");
  if (options.image_width < 0)
    command_line.fail ("-image_width is " + std::to_string (options.image_width) + ", but must be 0 or more");
  try
  {
    if (command_line.has ("intrinsics"))
      options.camera = readDepthCamera (command_line.get<std::string> ("intrinsics"));
  }
  catch (const std::exception& error)
  {
    command_line.fail (std::string ("-intrinsics ") + error.what ());
  }
  if (command_line.has ("depth_scale"))
  {
    options.camera.depth_scale = command_line.get<double> ("depth_scale");
    if (!(options.camera.depth_scale > 0.0 && options.camera.depth_scale <= 1.0))
      command_line.fail (
          "-depth_scale is " + numberText (options.camera.depth_scale) +
          ", but must be above 0 and at most 1 metre a unit: 0.001 for millimetres, 0.0002 where 5000 are a "
          "metre");
  }
  if (command_line.has ("color"))
    options.color = command_line.get<std::string> ("color");
  if (command_line.has ("max_range"))
  {
    options.max_range = command_line.get<float> ("max_range");
    if (!(options.max_range > 0.0f))
      command_line.fail ("-max_range is " + numberText (options.max_range) + ", but must be above 0 metres");
  }
  return (options);
}

std::vector<std::string>
listScenesToRead (const std::vector<std::string>& paths, const SceneOptions& options)
{
  // A folder of PNG files is one of depth images only where the camera is known: it may be one of results.
  std::vector<std::string> extensions{".pcd", ".ply"};
  if (options.camera.isKnown ())
    extensions.push_back (".png");
  return (listScenes (paths, extensions));
}

} // namespace pcl_attention
