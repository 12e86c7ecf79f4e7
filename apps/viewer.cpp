// SPDX-License-Identifier: BSD-3-Clause
// pcl_attention_viewer: see what the method sees.
#include "evaluation/labelled_scene.h"
#include "parameter_flags.h"
#include "viewer_window.h"

#include <pcl/pcl_config.h>
#ifdef HAVE_OPENNI2
#include <pcl/io/openni2_grabber.h>
#endif

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace fs = std::filesystem;
namespace po = boost::program_options;
using namespace pcl_attention;

namespace
{

const char* const program = "pcl_attention_viewer";

/** \brief Numbers parted by a character, all of the text. */
std::vector<double>
parseNumbers (const std::string& text, char separator)
{
  std::vector<double> numbers;
  const char *place = text.data (), *end = place + text.size ();
  while (place != end)
  {
    double number = 0.0;
    const auto [next, error] = std::from_chars (place, end, number);
    if (error != std::errc () || (next != end && *next != separator) || next + 1 == end)
      return {};
    numbers.push_back (number);
    place = next == end ? end : next + 1;
  }
  return (numbers);
}

/** \brief A PNG file, or those of a folder by name. */
std::vector<std::string>
listImages (const std::string& path)
{
  if (!fs::is_directory (path))
    return {path};
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator (path))
    if (entry.path ().extension () == ".png")
      files.push_back (entry.path ().string ());
  if (files.empty ())
    throw std::runtime_error (path + ": a folder without a PNG file");
  std::sort (files.begin (), files.end ());
  return (files);
}

std::vector<DepthImages>
pairImages (const CommandLine& command_line)
{
  DepthImages camera;
  if (command_line.has ("intrinsics"))
  {
    const std::vector<double> numbers = parseNumbers (command_line.get<std::string> ("intrinsics"), ',');
    if (numbers.size () != 4 || numbers[0] <= 0.0 || numbers[1] <= 0.0)
      command_line.fail ("-intrinsics takes FX,FY,CX,CY in pixels, as 525,525,319.5,239.5");
    camera.focal_length_x = numbers[0];
    camera.focal_length_y = numbers[1];
    camera.center_x = numbers[2];
    camera.center_y = numbers[3];
  }
  camera.depth_scale = command_line.get<double> ("depth_scale");
  if (!(camera.depth_scale > 0.0 && camera.depth_scale <= 1.0))
    command_line.fail ("-depth_scale takes metres of one unit, above 0 and up to 1");
  const std::vector<std::string> depth = listImages (command_line.get<std::string> ("depth"));
  std::vector<std::string> color;
  if (command_line.has ("color"))
    color = listImages (command_line.get<std::string> ("color"));
  if (!color.empty () && color.size () != depth.size ())
    throw std::runtime_error (command_line.get<std::string> ("color") + ": " + std::to_string (color.size ()) +
                              " colour images for " + std::to_string (depth.size ()) + " of depth");
  std::vector<DepthImages> images;
  for (std::size_t k = 0; k < depth.size (); ++k)
  {
    camera.depth = depth[k];
    camera.color = color.empty () ? "" : color[k];
    images.push_back (camera);
  }
  return (images);
}

std::unique_ptr<SceneSequence>
openScenes (const CommandLine& command_line)
{
  const auto frame_rate = static_cast<float> (command_line.get<double> ("frame_rate"));
  if (!(frame_rate > 0.0f && frame_rate <= 1000.0f))
    command_line.fail ("-frame_rate takes frames per second, above 0 and up to 1000");
  const bool has_files = !command_line.positional ().empty ();
  if (has_files + command_line.has ("depth") + command_line.has ("camera") > 1)
    command_line.fail ("give scenes, -depth or -camera, not several of them");
  if (command_line.has ("color") && !command_line.has ("depth"))
    command_line.fail ("-color goes with -depth");
  if (command_line.has ("camera"))
  {
#ifdef HAVE_OPENNI2
    try
    {
      return (std::make_unique<SceneSequence> (std::make_unique<pcl::io::OpenNI2Grabber> (), "camera"));
    }
    catch (const std::exception& error)
    {
      throw std::runtime_error (std::string ("no OpenNI2 camera: ") + error.what ());
    }
#else
    throw std::runtime_error ("this PCL was built without OpenNI2");
#endif
  }
  if (command_line.has ("depth"))
    return (std::make_unique<SceneSequence> (pairImages (command_line), frame_rate));
  const int image_width = command_line.get<int> ("image_width");
  if (image_width < 0)
    command_line.fail ("-image_width is " + std::to_string (image_width) + ", but must be 0 or more");
  return (std::make_unique<SceneSequence> (
      has_files ? listScenes (command_line.positional ()) : std::vector<std::string> (), image_width, frame_rate));
}

WindowSettings
windowSettings (const CommandLine& command_line)
{
  WindowSettings settings;
  const std::vector<double> size = parseNumbers (command_line.get<std::string> ("size"), 'x');
  if (size.size () != 2 || size[0] < 320 || size[1] < 240 || size[0] > 16384 || size[1] > 16384)
    command_line.fail ("-size takes WIDTHxHEIGHT in pixels, from 320x240 to 16384x16384");
  settings.width = static_cast<int> (size[0]);
  settings.height = static_cast<int> (size[1]);
  const std::string& view = command_line.get<std::string> ("view");
  const auto name = std::find (viewNames ().begin (), viewNames ().end (), view);
  if (name != viewNames ().end ())
    settings.view = static_cast<View> (name - viewNames ().begin ());
  else if (view != "all")
    command_line.fail ("-view is '" + view + "', but must be one of color saliency points patches segments all");
  settings.output_dir = command_line.get<std::string> ("output_dir");
  if (command_line.has ("parameters"))
    settings.parameters_file = command_line.get<std::string> ("parameters");
  return (settings);
}

/** \brief -show, -object and -step: what is looked at when the results are there. */
void
lookAt (const CommandLine& command_line, ViewerModel& model)
{
  const int object = command_line.get<int> ("object"), step = command_line.get<int> ("step");
  if (object > static_cast<int> (model.segments ().size ()))
    throw std::runtime_error ("-object is " + std::to_string (object) + ", but there are " +
                              std::to_string (model.segments ().size ()) + " objects");
  for (int k = 0; k < object; ++k)
    model.selectNext (1);
  for (int k = -1; k < step; ++k)
    model.stepNext (1);
}

void
switchOn (const CommandLine& command_line, ViewerSwitches& switches)
{
  const std::string& text = command_line.get<std::string> ("show");
  std::size_t begin = 0;
  while (begin < text.size ())
  {
    const std::size_t end = std::min (text.find (',', begin), text.size ());
    const std::string name = text.substr (begin, end - begin);
    begin = end + 1;
    if (name == "normals")
      switches.normals = true;
    else if (name == "hull")
      switches.hull = true;
    else if (name == "convexity")
      switches.convexity = true;
    else if (name == "errors")
      switches.errors = true;
    else
      command_line.fail ("-show has '" + name + "', but takes normals,hull,convexity,errors");
  }
}

int
runViewer (const CommandLine& command_line, ViewerModel& model, const WindowSettings& settings)
{
  const std::unique_ptr<SceneSequence> scenes = openScenes (command_line);
  AttentionWorker worker (static_cast<unsigned int> (command_line.get<int> ("threads")));
  const bool screenshot = command_line.has ("screenshot");
  if (scenes->size () > 0)
  {
    AttentionRequest request = model.request ();
    request.load = scenes->move (0);
    worker.submit (std::move (request));
  }
  else if (screenshot)
    throw std::runtime_error ("-screenshot needs a scene, not -camera");

  // The first scene is looked at before there is a window: what cannot be read gives one line and no window.
  if (scenes->size () > 0 && (screenshot || scenes->size () == 1))
  {
    while (!worker.results () || !worker.results ()->scene)
    {
      if (const AttentionResultsPtr results = worker.results (); results && !results->error.empty ())
        throw std::runtime_error (results->error);
      std::this_thread::sleep_for (std::chrono::milliseconds (2));
    }
    for (const std::string& note : worker.results ()->scene->scene.notes)
      std::cerr << program << ": " << worker.results ()->scene->scene.path << ": " << note << std::endl;
  }
  if (screenshot)
  {
    model.setResults (worker.wait ());
    if (!model.results ().error.empty ())
      throw std::runtime_error (model.results ().error);
    lookAt (command_line, model);
    ViewerWindow (settings, model, worker, *scenes).saveScreenshot (command_line.get<std::string> ("screenshot"));
    return (EXIT_SUCCESS);
  }
  ViewerWindow window (settings, model, worker, *scenes);
  if (command_line.has ("play") || scenes->size () == 0)
    scenes->play (true);
  window.run ();
  return (EXIT_SUCCESS);
}

} // namespace

int
main (int argc, char** argv)
{
  CommandLine command_line (
      std::string (program) + " [SCENE...] [flags]",
      "Shows what is found in RGB-D scenes, and why: saliency, attention points, patches, objects, growth step by "
      "step.\n"
      "SCENE: organized PCD files, or folders with them; without any a rendered scene. h shows the keys.\n\n"
      "Exit code: 0, 1 if a scene cannot be read or there is no display, 2 for a bad command line.");
  command_line.addOptions () ("depth", po::value<std::string> (),
                              "16-bit PNG file of depth, or a folder of them, instead of SCENE") (
      "color", po::value<std::string> (), "the colours to -depth, registered: 8-bit PNG, or as many of them") (
      "intrinsics", po::value<std::string> (), "FX,FY,CX,CY of the camera of -depth, pixels; without it a Kinect's") (
      "depth_scale", po::value<double> ()->default_value (0.001, "0.001"), "metres of one unit of -depth") (
      "camera", "an OpenNI2 camera instead of SCENE") ("play", "play the scenes as a sequence") (
      "frame_rate", po::value<double> ()->default_value (10.0, "10"), "frames per second of -play") (
      "screenshot", po::value<std::string> (), "save the window as this PNG file and end") (
      "view", po::value<std::string> ()->default_value ("all"),
      "color | saliency | points | patches | segments: one large view; all") (
      "size", po::value<std::string> ()->default_value ("1280x800"),
      "of the window, pixels") ("show", po::value<std::string> ()->default_value (""),
                                "what is switched on besides: normals,hull,convexity,errors") (
      "object", po::value<int> ()->default_value (0), "with -screenshot: the object that is selected, 0: none") (
      "step", po::value<int> ()->default_value (-1), "with -screenshot: the step of its growth, -1: the whole object") (
      "output_dir", po::value<std::string> ()->default_value ("attention_viewer"),
      "folder for what is saved") ("threads", po::value<int> ()->default_value (0),
                                   "number of threads, 0 for all processors; does not change the results") (
      "image_width", po::value<int> ()->default_value (0),
      "columns of an image that a PCD file holds as one row, in pixels; 0: such a file is an error");
  addParameterFlags (command_line);
  command_line.parse (argc, argv);

  ViewerModel model (parametersFromFlags (command_line));
  const WindowSettings settings = windowSettings (command_line);
  switchOn (command_line, model.switches);
  if (command_line.get<int> ("threads") < 0)
    command_line.fail ("-threads is " + std::to_string (command_line.get<int> ("threads")) + ", but must be 0 or more");
  try
  {
    if (const std::string problem = checkDisplay (); !problem.empty ())
      throw std::runtime_error (problem);
    return (runViewer (command_line, model, settings));
  }
  catch (const std::exception& error)
  {
    std::cerr << program << ": " << error.what () << std::endl;
    return (EXIT_FAILURE);
  }
}
