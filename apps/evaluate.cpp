// SPDX-License-Identifier: BSD-3-Clause
// pcl_attention_evaluate: systems side by side on labelled scenes, the module's own and anyone's results.
#include "command_line.h"
#include "data_set.h"
#include "evaluated_systems.h"
#include "evaluation/asked_for.h"
#include "evaluation/evaluation.h"
#include "evaluation/report.h"
#include "evaluation/report_page.h"
#include "evaluation_run.h"
#include "evaluation_store.h"
#include "number_text.h"
#include "output_folder.h"
#include "parameter_flags.h"
#include "progress.h"
#include "scene_flags.h"
#include "whole_file.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <thread>

namespace fs = std::filesystem;
using namespace pcl_attention;

namespace
{

const char* const program = "pcl_attention_evaluate";

/** \brief The parts of a text between commas; an empty part is one as well. */
std::vector<std::string>
splitList (const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream stream (text + ',');
  for (std::string part; std::getline (stream, part, ',');)
    parts.push_back (part);
  return (parts);
}

std::string
joinList (const std::vector<std::string>& parts)
{
  std::string text;
  for (const std::string& part : parts)
    text += (text.empty () ? "" : ", ") + part;
  return (text);
}

/** \brief Numbers of theta_com in metres, from a list in millimetres. */
std::vector<double>
sweepValues (const CommandLine& command_line)
{
  std::vector<double> values;
  if (!command_line.has ("sweep"))
    return (values);
  const std::string& text = command_line.get<std::string> ("sweep");
  for (const double value : numbersOf<double> (text))
    if (std::find (values.begin (), values.end (), value / 1e3) == values.end ())
      values.push_back (value / 1e3);
  if (values.empty () || *std::min_element (values.begin (), values.end ()) <= 0.0 ||
      *std::max_element (values.begin (), values.end ()) > 10.0)
    command_line.fail ("-sweep takes millimetres above 0 and at most 10000 with commas between, as in 2,3,5,8, not \"" +
                       text + "\"");
  return (values);
}

/** \brief The systems that the flags ask for, in the order of the report. */
std::vector<EvaluatedSystem>
systemsFromFlags (const CommandLine& command_line, const NamedParameters& own)
{
  std::vector<EvaluatedSystem> systems;
  if (command_line.has ("results"))
    systems.push_back (storedResults (command_line.get<std::string> ("results")));
  if (command_line.has ("systems") || systems.empty ())
  {
    const std::string text = command_line.get<std::string> ("systems");
    const std::vector<std::string> asked = text == "all" ? evaluatedSystemNames () : splitList (text);
    for (const std::string& name : asked)
      if (std::find (evaluatedSystemNames ().begin (), evaluatedSystemNames ().end (), name) ==
          evaluatedSystemNames ().end ())
        command_line.fail ("-systems takes all, or a list with commas of " + joinList (evaluatedSystemNames ()) +
                           ", not \"" + name + "\"");
    for (const std::string& name : evaluatedSystemNames ())
      if (std::find (asked.begin (), asked.end (), name) != asked.end ())
        systems.push_back (makeEvaluatedSystem (name, own));
  }
  std::vector<EvaluatedSystem> swept;
  for (const EvaluatedSystem& system : systems)
    if (system.name == "proposed" || system.name == "paper")
      for (const double theta_com : sweepValues (command_line))
        swept.push_back (makeSweptSystem (system.name, parametersOfSystem (system.name, own), theta_com));
  systems.insert (systems.end (), swept.begin (), swept.end ());
  return (systems);
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

/** \brief Ask for every object of every scene in turn, by every kind of prior. */
void
scoreAskedFor (const std::vector<SceneSource>& sources, const DataSetOptions& data, const std::vector<AskedFor>& kinds,
               const AttentionParameters& parameters, unsigned int threads)
{
  std::vector<std::vector<AskedForRanks>> ranks (kinds.size ());
  Progress progress (sources.size ());
  for (const SceneSource& source : sources)
  {
    const auto of_scene = rankAskedFor (loadScene (source, data), kinds, parameters, threads);
    for (std::size_t kind = 0; kind < kinds.size (); ++kind)
      ranks[kind].insert (ranks[kind].end (), of_scene[kind].begin (), of_scene[kind].end ());
    progress.finished (source.name);
  }
  printAskedFor (std::cout, kinds, ranks);
}

/** \brief "2/8": the second of eight. */
void
readShard (const CommandLine& command_line, EvaluationWork& work)
{
  if (!command_line.has ("shard"))
    return;
  const std::string& text = command_line.get<std::string> ("shard");
  const auto numbers = numbersOf<unsigned int> (text, '/');
  if (numbers.size () != 2 || numbers[0] < 1 || numbers[0] > numbers[1])
    command_line.fail ("-shard is i/n with i from 1 to n, as in 2/8, not \"" + text + "\"");
  work.shard = numbers[0];
  work.shards = numbers[1];
  if (!command_line.has ("output_dir"))
    command_line.fail ("-shard needs -output_dir, where its results are kept");
}

/** \brief The camera of depth images, and what of label images is no object. */
DataSetOptions
dataSetOptions (const CommandLine& command_line)
{
  DataSetOptions options;
  options.scene = sceneOptionsFromFlags (command_line);
  if (!options.scene.color.empty ())
    command_line.fail ("-color does not go with a data set: its layout says where the colours are");
  if (!command_line.has ("support_labels"))
    return (options);
  const std::string& text = command_line.get<std::string> ("support_labels");
  options.support_labels = numbersOf<std::uint16_t> (text);
  if (options.support_labels.empty ())
    command_line.fail ("-support_labels takes numbers from 0 to 65535 with commas between, not \"" + text + "\"");
  return (options);
}

EvaluationWork
workFromFlags (const CommandLine& command_line)
{
  EvaluationWork work;
  const auto count = [&] (const char* flag) {
    const int value = command_line.get<int> (flag);
    if (value < 0)
      command_line.fail (std::string ("-") + flag + " is " + std::to_string (value) + ", but must be 0 or more");
    return (static_cast<unsigned int> (value));
  };
  work.jobs = count ("jobs");
  if (work.jobs == 0)
    work.jobs = std::max (1u, std::thread::hardware_concurrency ());
  work.threads = threadsFromFlag (command_line);
  work.pictures = !command_line.has ("no_pictures");
  work.data = dataSetOptions (command_line);
  readShard (command_line, work);
  return (work);
}

/** \brief The tables of every system, and the files of -csv and -summary_csv. */
void
printReport (const CommandLine& command_line, const Evaluation& evaluation)
{
  const auto systems = evaluation.ownSystems ();
  for (const SystemEvaluation* system : systems)
  {
    if (systems.size () > 1)
      std::cout << "System: " << system->name << "\n\n";
    for (const GroundTruthKind kind : evaluation.kinds)
      printTables (std::cout, summarizeByCategory (kind, scoresOf (*system)));
  }
  if (command_line.has ("csv"))
  {
    std::ostringstream stream;
    writeObjectsCsv (stream, scoresOf (evaluation.mainSystem ()));
    writeWholeFile (command_line.get<std::string> ("csv"), stream.str ());
  }
  if (command_line.has ("summary_csv"))
  {
    std::vector<Summary> summaries;
    for (const GroundTruthKind kind : evaluation.kinds)
      for (const Summary& summary : summarizeByCategory (kind, scoresOf (evaluation.mainSystem ())))
        summaries.push_back (summary);
    std::ostringstream stream;
    writeSummaryCsv (stream, summaries);
    writeWholeFile (command_line.get<std::string> ("summary_csv"), stream.str ());
  }
}

void
writeReport (const fs::path& folder, const Evaluation& evaluation, const PictureOf& picture_of)
{
  const auto write = [&] (const char* name, const std::string& content) {
    writeWholeFile ((folder / name).string (), content);
  };
  write ("report.csv", reportCsv (evaluation));
  write ("objects.csv", objectsCsv (evaluation));
  write ("timings.csv", timingsCsv (evaluation));
  write ("report.json", reportJson (evaluation).dump (1) + '\n');
  write ("report.md", reportMarkdown (evaluation));
  write ("report.html", reportPage (evaluation, picture_of));
  std::cerr << "The report is " << (folder / "report.html").string () << std::endl;
}

/** \brief Results of all scenes, or nothing while other shards are not done. */
bool
collect (std::vector<std::vector<std::optional<SceneResult>>>&& results, const std::vector<EvaluatedSystem>& systems,
         Evaluation& evaluation)
{
  for (std::size_t system = 0; system < systems.size (); ++system)
  {
    evaluation.systems.push_back (
        {systems[system].name, systems[system].note, systems[system].swept, systems[system].theta_com, {}});
    for (std::optional<SceneResult>& result : results[system])
    {
      if (!result)
        return (false);
      evaluation.systems.back ().scenes.push_back (std::move (*result));
    }
  }
  return (true);
}

void
evaluate (const CommandLine& command_line, const std::vector<SceneSource>& sources,
          const std::vector<EvaluatedSystem>& systems, const std::vector<GroundTruthKind>& kinds,
          const EvaluationWork& work)
{
  const nlohmann::ordered_json description = describeEvaluation (sources, work.data, systems, kinds);
  std::optional<EvaluationStore> store;
  if (command_line.has ("output_dir"))
    store.emplace (command_line.get<std::string> ("output_dir"), description);

  Evaluation evaluation;
  evaluation.version = description["version"];
  evaluation.kinds = kinds;
  const EvaluationStore* const where = store ? &*store : nullptr;
  if (!collect (evaluateScenes (sources, systems, kinds, work, where), systems, evaluation))
  {
    std::cerr << "Shard " << work.shard << "/" << work.shards << " is done; the report is written when the others are"
              << std::endl;
    return;
  }
  printReport (command_line, evaluation);
  if (store)
    writeReport (
        command_line.get<std::string> ("output_dir"), evaluation,
        [&] (const std::string& system, const std::string& scene) { return (store->readPicture (system, scene)); });
}

/** \brief The evaluation that a description speaks of, its results from whichever folder has them.
 * \throws std::runtime_error if a result is in none of them */
Evaluation
mergedEvaluation (const std::vector<EvaluationStore>& stores)
{
  const nlohmann::ordered_json& description = stores.front ().description ();
  Evaluation evaluation;
  evaluation.version = description.at ("version");
  for (const auto& kind : description.at ("ground_truth"))
    evaluation.kinds.push_back (groundTruthKindFromName (kind));
  std::size_t missing = 0;
  std::string first_missing;
  for (const auto& system : description.at ("systems"))
  {
    const std::string name = system.at ("name");
    evaluation.systems.push_back ({name, system.at ("note"), system.at ("swept"), system.at ("theta_com"), {}});
    for (const auto& scene : description.at ("scenes"))
    {
      const std::string scene_name = scene.at ("name");
      std::optional<SceneResult> result;
      for (auto store = stores.begin (); store != stores.end () && !result; ++store)
        result = store->read (name, scene_name);
      if (result)
        evaluation.systems.back ().scenes.push_back (std::move (*result));
      else if (missing++ == 0)
        first_missing = name + " on " + scene_name;
    }
  }
  if (missing > 0)
    throw std::runtime_error (std::to_string (missing) + " results are in no folder of -merge, the first of them " +
                              first_missing + ": is a shard missing, or not done?");
  return (evaluation);
}

/** \brief The report of shards that were evaluated in folders of their own; the data is not needed. */
void
merge (const CommandLine& command_line)
{
  const auto& folders = command_line.get<std::vector<std::string>> ("merge");
  for (const char* flag : {"systems", "results", "sweep", "shard", "asked_for", "ground_truth"})
    if (command_line.has (flag))
      command_line.fail (std::string ("-merge reports what was evaluated before: -") + flag + " does not go with it");
  if (!command_line.positional ().empty ())
    command_line.fail ("-merge needs no DATA");
  if (!command_line.has ("output_dir"))
    command_line.fail ("-merge needs -output_dir for the report");
  std::vector<EvaluationStore> stores (folders.begin (), folders.end ());
  for (const EvaluationStore& store : stores)
    store.checkSameAs (stores.back ().description ());
  const Evaluation evaluation = mergedEvaluation (stores);
  const fs::path output = command_line.get<std::string> ("output_dir");
  OutputFolder::prepareParent (output);
  printReport (command_line, evaluation);
  writeReport (output, evaluation, [&] (const std::string& system, const std::string& scene) {
    std::string picture;
    for (auto store = stores.begin (); store != stores.end () && picture.empty (); ++store)
      picture = store->readPicture (system, scene);
    return (picture);
  });
}

} // namespace

int
main (int argc, char** argv)
{
  namespace po = boost::program_options;
  CommandLine command_line (
      std::string (program) + " DATA... [-systems all] [-output_dir OUT] [flags]",
      "Evaluates systems on labelled scenes: our own, others of the literature, or results of anyone in -results DIR.\n"
      "DATA: labelled PCD files, or folders with them (labels: 0 invalid, 1-19 support, 20.. parts of objects,\n"
      "label / 10 = object), with PCD files and masks NAME_*.png, or in the layout of OSD 0.2 (image_color, "
      "annotation,\n"
      "disparity or pcd) or OCID (rgb, label, depth or pcd); depth images need -intrinsics. Prints tables, and writes "
      "into OUT: report.html with charts and pictures, report.md,\n"
      "report.csv, report.json, objects.csv, timings.csv, and results/, from which a run that was interrupted goes "
      "on.\n"
      "Results of -results are read from DIR/<stem>/, in the layout that pcl_attention_segment writes:\n"
      "attention_points.csv, mask_0001.png ..., optionally labels.pcd and segments.json.");
  // clang-format off
  command_line.addOptions ()
    ("output_dir", po::value<std::string> (), "folder for the report; made if need be, gone on with if it is there")
    ("systems", po::value<std::string> ()->default_value ("proposed"),
     ("all, or a list with commas of " + joinList (evaluatedSystemNames ()) + "; the flags of parameters are those of proposed").c_str ())
    ("results", po::value<std::string> (), "folder with results to score instead of our own")
    ("sweep", po::value<std::string> (), "also vary theta_com of proposed and paper: millimetres with commas, as in 2,3,4,5,6,8,10,12,15")
    ("jobs", po::value<int> ()->default_value (1), "scenes at once, 0 for as many as processors; does not change the results")
    ("shard", po::value<std::string> (), "do a part of the scenes only: i/n, as in 2/8 for the second of eight parts")
    ("merge", po::value<std::vector<std::string>> ()->multitoken (), "instead, report what shards have written into these folders, into OUT")
    ("no_pictures", "no pictures in the report: for very many scenes, of which each takes about 0.1 MB a system")
    ("ground_truth", po::value<std::string> ()->default_value ("both"), "objects, parts or both")
    ("asked_for", po::value<std::string> (), ("instead, ask for every object by " + askedForChoices () +
                                             ": mean rank of the asked-for object").c_str ())
    ("csv", po::value<std::string> (), "file to write with one row an object, of proposed or else the first system")
    ("summary_csv", po::value<std::string> (), "file to write with all figures of proposed or else the first system, one row a ground truth and category");
  // clang-format on
  addThreadsFlag (command_line);
  addSceneFlags (command_line);
  command_line.addOptions () (
      "support_labels", po::value<std::string> (),
      "values of label images that are no objects, with commas; default 0, in OCID's layout 0,1, and "
      "2 below a folder \"table\"");
  addParameterFlags (command_line);
  command_line.parse (argc, argv);
  if (command_line.positional ().empty () && !command_line.has ("merge"))
    command_line.fail ("no labelled scene given");
  const NamedParameters parameters = parametersFromFlags (command_line);
  const EvaluationWork work = workFromFlags (command_line);
  const std::vector<GroundTruthKind> kinds = groundTruthKinds (command_line);
  const std::vector<AskedFor> asked_for = askedForKinds (command_line);
  if (!asked_for.empty () && command_line.has ("results"))
    command_line.fail ("-asked_for is about our own segments, not about -results");
  const std::vector<EvaluatedSystem> systems = systemsFromFlags (command_line, parameters);

  try
  {
    if (command_line.has ("merge"))
      merge (command_line);
    else if (!asked_for.empty ())
      scoreAskedFor (listSceneSources (command_line.positional (), work.data), work.data, asked_for, parameters.values,
                     work.threads);
    else
      evaluate (command_line, listSceneSources (command_line.positional (), work.data), systems, kinds, work);
  }
  catch (const std::exception& error)
  {
    std::cerr << program << ": " << error.what () << std::endl;
    return (EXIT_FAILURE);
  }
  return (exitCode (program, EXIT_SUCCESS));
}
