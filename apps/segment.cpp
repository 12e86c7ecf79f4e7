// SPDX-License-Identifier: BSD-3-Clause
// pcl_attention_segment: the objects of RGB-D scenes, in order of attention.
#include "output_folder.h"
#include "parameter_flags.h"
#include "prior_flags.h"
#include "scene_flags.h"
#include "scene_stream.h"
#include "segment_writer.h"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace fs = std::filesystem;
using namespace pcl_attention;

namespace
{

const char* const program = "pcl_attention_segment";

struct Settings
{
  fs::path output_folder;
  NamedParameters parameters;
  NamedPrior prior;
  unsigned int threads{0};
  SceneOptions scene_options;
};

/** \brief Print what the user should know about a scene. That there is no colour is said once: it holds for all scenes
 * of a sensor. */
void
printNotes (const Scene& scene, bool& no_color_said)
{
  for (const std::string& note : scene.notes)
    std::cerr << program << ": " << scene.path << ": " << note << std::endl;
  if (!scene.has_color && !no_color_said)
  {
    no_color_said = true;
    std::cerr << program << ": " << scene.path << ": no colour: the colour constraint is off" << std::endl;
  }
}

/** \brief Print what is known about a scene and write its results.
 * \return "6 objects, 210 ms" */
std::string
finishScene (const SceneStream::Item& item, const Settings& settings, bool& no_color_said)
{
  if (item.scene)
    printNotes (*item.scene, no_color_said);
  if (item.error)
    std::rethrow_exception (item.error);
  OutputFolder folder (settings.output_folder, item.scene->name);
  writeSceneSegments (*item.scene, item.result, settings.parameters, folder);
  folder.commit ();
  const std::size_t objects = item.result.segments.size ();
  return (std::to_string (objects) + (objects == 1 ? " object, " : " objects, ") +
          std::to_string (std::lround (item.result.times.total ())) + " ms");
}

/** \brief In the order of the paths; a scene that fails does not keep the others from being segmented.
 * \return how many failed */
std::size_t
processScenes (const std::vector<std::string>& paths, const Settings& settings)
{
  std::size_t failures = 0;
  bool no_color_said = false;
  SceneStream scenes (paths, settings.scene_options, settings.parameters.values, settings.prior, settings.threads);
  for (std::size_t i = 0; i < paths.size (); ++i)
  {
    const std::string file_name = fs::path (paths[i]).filename ().string ();
    std::string error;
    try
    {
      const std::string summary = finishScene (scenes.next (), settings, no_color_said);
      if (paths.size () > 1)
        std::cerr << '[' << i + 1 << '/' << paths.size () << "] " << file_name << ": " << summary << std::endl;
      std::cout << (settings.output_folder / fs::path (paths[i]).stem ()).string () << ": " << summary << std::endl;
    }
    catch (const std::bad_alloc&)
    {
      error = paths[i] + ": not enough memory";
    }
    catch (const std::exception& exception)
    {
      error = exception.what ();
    }
    if (!error.empty ())
    {
      ++failures;
      std::cerr << program << ": " << error << std::endl;
    }
  }
  if (failures > 0 && paths.size () > 1)
    std::cerr << program << ": " << failures << " of " << paths.size () << " scenes failed" << std::endl;
  return (failures);
}

} // namespace

int
main (int argc, char** argv)
{
#ifdef __GLIBC__
  // The threads hand large images on to each other: what one frees another can use.
  mallopt (M_ARENA_MAX, 1);
#endif
  namespace po = boost::program_options;
  CommandLine command_line (
      std::string (program) + " SCENE... -output_dir DIR [flags]",
      "Finds the objects of RGB-D scenes in order of attention. SCENE: organized PCD or PLY files "
      "(x, y, z in metres, rgb or rgba),\nunorganized ones or depth images (16-bit PNG) with "
      "-intrinsics, or folders with them.\nWrites into DIR/<stem of the scene>/, which is replaced "
      "as a whole: attention_points.csv, segments.json,\nmask_0001.png ..., labels.pcd, "
      "overview.png and summary.json.\n\n"
      "Exit code: 0, 1 if a scene failed, 2 for a bad command line.");
  command_line.addOptions () ("output_dir", po::value<std::string> (), "folder for the results; made if need be");
  addThreadsFlag (command_line);
  addSceneFlags (command_line);
  addPriorFlags (command_line);
  addParameterFlags (command_line);
  command_line.parse (argc, argv);

  Settings settings;
  settings.parameters = parametersFromFlags (command_line);
  settings.prior = priorFromFlags (command_line);
  settings.threads = threadsFromFlag (command_line);
  settings.scene_options = sceneOptionsFromFlags (command_line);
  if (command_line.positional ().empty ())
    command_line.fail ("no scene given");
  if (!command_line.has ("output_dir") || command_line.get<std::string> ("output_dir").empty ())
    command_line.fail ("-output_dir is missing");
  settings.output_folder = command_line.get<std::string> ("output_dir");

  try
  {
    const std::vector<std::string> paths = listScenesToRead (command_line.positional (), settings.scene_options);
    OutputFolder::prepareParent (settings.output_folder);
    return (exitCode (program, processScenes (paths, settings) == 0 ? EXIT_SUCCESS : EXIT_FAILURE));
  }
  catch (const std::exception& error)
  {
    std::cerr << program << ": " << error.what () << std::endl;
    return (EXIT_FAILURE);
  }
}
