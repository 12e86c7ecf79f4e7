// SPDX-License-Identifier: BSD-3-Clause
// pcl_attention_evaluate: segment labelled scenes and score the result, or score anyone's results against labelled scenes.
#include "command_line.h"
#include "evaluation/asked_for.h"
#include "evaluation/labelled_scene.h"
#include "evaluation/metrics.h"
#include "evaluation/prediction_of_segments.h"
#include "evaluation/report.h"
#include "evaluation/results.h"
#include "parameter_flags.h"
#include "whole_file.h"

#include <pcl/segmentation/attention_segmentation.h>

#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <sstream>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace pcl_attention;

namespace
{

/** \brief What is scored: anything that turns a scene into segments. */
using Predictor = std::function<ScenePrediction (const LabelledScene& scene)>;

/** \brief Results that someone has written before, in FOLDER/<stem of the scene>/. */
Predictor
storedResults (const std::string& folder)
{
  return ([folder] (const LabelledScene& scene) {
    return (readResults ((fs::path (folder) / scene.name).string (), static_cast<int> (scene.cloud->width),
                         static_cast<int> (scene.cloud->height)));
  });
}

/** \brief Our own segments. */
Predictor
ownSegments (const AttentionParameters& parameters, unsigned int threads)
{
  const auto segmentation = std::make_shared<pcl::AttentionSegmentation<pcl::PointXYZRGBL>> (parameters);
  segmentation->setNumberOfThreads (threads);
  return ([segmentation] (const LabelledScene& scene) {
    segmentation->setInputCloud (scene.cloud);
    std::vector<pcl::AttentionSegment> segments;
    if (!segmentation->segment (segments))
      throw std::runtime_error (scene.name + ": could not be segmented, see above");
    return (predictionOfSegments (static_cast<int> (scene.cloud->width), static_cast<int> (scene.cloud->height), segments));
  });
}

std::vector<GroundTruthKind>
groundTruthKinds (const CommandLine& command_line)
{
  const std::string& name = command_line.get<std::string> ("ground_truth");
  if (name == "objects")
    return {GroundTruthKind::objects};
  if (name == "parts")
    return {GroundTruthKind::parts};
  if (name != "both")
    command_line.fail ("-ground_truth is objects, parts or both, not \"" + name + "\"");
  return {GroundTruthKind::objects, GroundTruthKind::parts};
}

std::string
askedForChoices ()
{
  std::string text;
  for (const std::string& name : askedForNames ())
    text += name + ", ";
  return (text + "or all");
}

/** \brief The kinds of prior to evaluate; none without the flag. */
std::vector<AskedFor>
askedForKinds (const CommandLine& command_line)
{
  std::vector<AskedFor> kinds;
  if (!command_line.has ("asked_for"))
    return (kinds);
  const std::string& asked = command_line.get<std::string> ("asked_for");
  const std::vector<std::string>& names = askedForNames ();
  for (std::size_t kind = 0; kind < names.size (); ++kind)
    if (asked == "all" || asked == names[kind])
      kinds.push_back (static_cast<AskedFor> (kind));
  if (kinds.empty ())
    command_line.fail ("-asked_for is " + askedForChoices () + ", not \"" + asked + "\"");
  return (kinds);
}

/** \brief Progress on stderr, for more than one scene: on a terminal one line that is overwritten, else a line each. */
class Progress
{
public:
  explicit Progress (std::size_t total) : total_ (total), is_terminal_ (isatty (STDERR_FILENO) != 0) {}

  ~Progress ()
  {
    if (is_open_)
      std::cerr << std::endl;
  }

  void
  show (std::size_t scene, const std::string& name)
  {
    if (total_ < 2)
      return;
    // "\033[K" clears what a longer name has left
    std::cerr << (is_terminal_ ? "\r" : "") << "scene " << scene << "/" << total_ << " " << name
              << (is_terminal_ ? "\033[K" : "\n") << std::flush;
    is_open_ = is_terminal_;
  }

private:
  std::size_t total_;
  bool is_terminal_, is_open_ = false;
};

/** \brief Score all scenes, first on the first ground truth, then on the next. */
std::vector<SceneScore>
scoreScenes (const std::vector<std::string>& paths, const std::vector<GroundTruthKind>& kinds, const Predictor& predict)
{
  std::vector<SceneScore> scores;
  Progress progress (paths.size ());
  for (std::size_t i = 0; i < paths.size (); ++i)
  {
    progress.show (i + 1, fs::path (paths[i]).stem ().string ());
    const LabelledScene scene = loadLabelledScene (paths[i]);
    const ScenePrediction prediction = predict (scene);
    for (const GroundTruthKind kind : kinds)
    {
      scores.push_back (scoreScene (makeGroundTruth (*scene.cloud, kind), prediction));
      scores.back ().name = scene.name;
      scores.back ().category = scene.category;
    }
  }
  return (scores);
}

/** \brief Ask for every object of every scene in turn, by every kind of prior. */
void
scoreAskedFor (const std::vector<std::string>& paths, const std::vector<AskedFor>& kinds,
               const AttentionParameters& parameters, unsigned int threads)
{
  std::vector<std::vector<AskedForRanks>> ranks (kinds.size ());
  Progress progress (paths.size ());
  for (std::size_t i = 0; i < paths.size (); ++i)
  {
    progress.show (i + 1, fs::path (paths[i]).stem ().string ());
    const auto of_scene = rankAskedFor (loadLabelledScene (paths[i]), kinds, parameters, threads);
    for (std::size_t kind = 0; kind < kinds.size (); ++kind)
      ranks[kind].insert (ranks[kind].end (), of_scene[kind].begin (), of_scene[kind].end ());
  }
  printAskedFor (std::cout, kinds, ranks);
}

void
report (const CommandLine& command_line, const std::vector<GroundTruthKind>& kinds,
        const std::vector<SceneScore>& scores)
{
  std::vector<Summary> all;
  for (const GroundTruthKind kind : kinds)
  {
    const std::vector<Summary> summaries = summarizeByCategory (kind, scores);
    printTables (std::cout, summaries);
    all.insert (all.end (), summaries.begin (), summaries.end ());
  }
  if (command_line.has ("csv"))
  {
    std::ostringstream stream;
    writeObjectsCsv (stream, scores);
    writeWholeFile (command_line.get<std::string> ("csv"), stream.str ());
  }
  if (command_line.has ("summary_csv"))
  {
    std::ostringstream stream;
    writeSummaryCsv (stream, all);
    writeWholeFile (command_line.get<std::string> ("summary_csv"), stream.str ());
  }
}

} // namespace

int
main (int argc, char** argv)
{
  namespace po = boost::program_options;
  CommandLine command_line (
      "pcl_attention_evaluate DATA... [-results DIR] [flags]",
      "Segments labelled scenes and scores the result, or scores results of anyone in DIR against labelled scenes. DATA: labelled PCD files, or folders with them (labels: 0 "
      "invalid, 1-19 support,\n20.. parts of objects, label / 10 = object). Results are read from "
      "DIR/<stem>/, in the layout that\npcl_attention_segment writes: attention_points.csv, mask_0001.png "
      "..., optionally labels.pcd and segments.json.");
  // clang-format off
  command_line.addOptions ()
    ("results", po::value<std::string> (), "folder with results to score instead of our own")
    ("ground_truth", po::value<std::string> ()->default_value ("both"), "objects, parts or both")
    ("asked_for", po::value<std::string> (), ("instead, ask for every object by " + askedForChoices () +
                                             ": mean rank of the asked-for object").c_str ())
    ("csv", po::value<std::string> (), "file to write with one row an object")
    ("summary_csv", po::value<std::string> (), "file to write with all figures, one row a ground truth and category");
  // clang-format on
  addThreadsFlag (command_line);
  addParameterFlags (command_line);
  command_line.parse (argc, argv);
  if (command_line.positional ().empty ())
    command_line.fail ("no labelled scene given");
  const AttentionParameters parameters = parametersFromFlags (command_line).values;
  const unsigned int threads = threadsFromFlag (command_line);
  const std::vector<GroundTruthKind> kinds = groundTruthKinds (command_line);
  const std::vector<AskedFor> asked_for = askedForKinds (command_line);
  if (!asked_for.empty () && command_line.has ("results"))
    command_line.fail ("-asked_for is about our own segments, not about -results");

  try
  {
    const std::vector<std::string> paths = listScenes (command_line.positional ());
    if (!asked_for.empty ())
      scoreAskedFor (paths, asked_for, parameters, threads);
    else
      report (command_line, kinds,
              scoreScenes (paths, kinds,
                           command_line.has ("results") ? storedResults (command_line.get<std::string> ("results"))
                                                        : ownSegments (parameters, threads)));
  }
  catch (const std::exception& error)
  {
    std::cerr << "pcl_attention_evaluate: " << error.what () << std::endl;
    return (EXIT_FAILURE);
  }
  return (exitCode ("pcl_attention_evaluate", EXIT_SUCCESS));
}
