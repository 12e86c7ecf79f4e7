// SPDX-License-Identifier: BSD-3-Clause
// pcl_attention_viewer: see what the method sees.
#include "number_text.h"
#include "parameter_flags.h"
#include "scene_flags.h"
#include "viewer_window.h"

#include <pcl/pcl_config.h>
#ifdef HAVE_OPENNI2
#include <pcl/io/openni2_grabber.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace po = boost::program_options;
using namespace pcl_attention;

namespace
{

const char* const program = "pcl_attention_viewer";

std::unique_ptr<SceneSequence>
openScenes (const CommandLine& command_line, const SceneOptions& options)
{
  if (!command_line.has ("camera"))
  {
    const std::vector<std::string>& paths = command_line.positional ();
    return (std::make_unique<SceneSequence> (paths.empty () ? paths : listScenesToRead (paths, options), options,
                                             static_cast<float> (command_line.get<double> ("frame_rate"))));
  }
#ifdef HAVE_OPENNI2
  try
  {
    return (
        std::make_unique<SceneSequence> (std::make_unique<pcl::io::OpenNI2Grabber> (), "camera", options.max_range));
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error (std::string ("no OpenNI2 camera: ") + error.what ());
  }
#else
  throw std::runtime_error ("this PCL was built without OpenNI2");
#endif
}

WindowSettings
windowSettings (const CommandLine& command_line)
{
  WindowSettings settings;
  const std::vector<int> size = numbersOf<int> (command_line.get<std::string> ("size"), 'x');
  if (size.size () != 2 || size[0] < 320 || size[1] < 240 || size[0] > 16384 || size[1] > 16384)
    command_line.fail ("-size takes WIDTHxHEIGHT in pixels, from 320x240 to 16384x16384");
  settings.width = size[0];
  settings.height = size[1];
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
runViewer (const CommandLine& command_line, ViewerModel& model, const WindowSettings& settings,
           const SceneOptions& options, unsigned int threads)
{
  const std::unique_ptr<SceneSequence> scenes = openScenes (command_line, options);
  AttentionWorker worker (threads);
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
      "SCENE: organized PCD or PLY files, unorganized ones or depth images (16-bit PNG) with -intrinsics, or folders\n"
      "with them; without any a rendered scene. h shows the keys.\n\n"
      "Exit code: 0, 1 if a scene cannot be read or there is no display, 2 for a bad command line.");
  // clang-format off
  command_line.addOptions ()
    ("camera", "an OpenNI2 camera instead of SCENE")
    ("play", "play the scenes as a sequence")
    ("frame_rate", po::value<double> ()->default_value (10.0, "10"), "frames per second of -play")
    ("screenshot", po::value<std::string> (), "save the window as this PNG file and end")
    ("view", po::value<std::string> ()->default_value ("all"),
     "color | saliency | points | patches | segments: one large view; all")
    ("size", po::value<std::string> ()->default_value ("1280x800"), "of the window, pixels")
    ("show", po::value<std::string> ()->default_value (""),
     "what is switched on besides: normals,hull,convexity,errors")
    ("object", po::value<int> ()->default_value (0), "with -screenshot: the object that is selected, 0: none")
    ("step", po::value<int> ()->default_value (-1), "with -screenshot: the step of its growth, -1: the whole object")
    ("output_dir", po::value<std::string> ()->default_value ("attention_viewer"), "folder for what is saved");
  // clang-format on
  addThreadsFlag (command_line);
  addSceneFlags (command_line);
  addParameterFlags (command_line);
  command_line.parse (argc, argv);

  ViewerModel model (parametersFromFlags (command_line));
  const WindowSettings settings = windowSettings (command_line);
  const SceneOptions options = sceneOptionsFromFlags (command_line);
  const unsigned int threads = threadsFromFlag (command_line);
  switchOn (command_line, model.switches);
  const double frame_rate = command_line.get<double> ("frame_rate");
  if (!(frame_rate > 0.0 && frame_rate <= 1000.0))
    command_line.fail ("-frame_rate takes frames per second, above 0 and up to 1000");
  if (command_line.has ("camera") && !command_line.positional ().empty ())
    command_line.fail ("give scenes or -camera, not both");
  try
  {
    if (const std::string problem = checkDisplay (); !problem.empty ())
      throw std::runtime_error (problem);
    return (runViewer (command_line, model, settings, options, threads));
  }
  catch (const std::exception& error)
  {
    std::cerr << program << ": " << error.what () << std::endl;
    return (EXIT_FAILURE);
  }
}
