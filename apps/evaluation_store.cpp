// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_store.h"

#include "evaluation/file_error.h"
#include "output_folder.h"
#include "parameter_io.h"
#include "whole_file.h"

#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace pcl_attention
{

namespace
{

using Json = nlohmann::ordered_json;

const char* const description_file = "evaluation.json";

/** \brief Where two descriptions first differ, e.g. "/systems/0/parameters/parts is true there and false now". */
std::string
differenceOf (const Json& there, const Json& now)
{
  const Json patch = Json::diff (there, now);
  if (patch.empty ())
    return ("");
  Json::json_pointer path (patch[0].at ("path").get<std::string> ());
  // Of lists of different lengths an element may be in one alone.
  if (!there.contains (path) && there.at (path.parent_pointer ()).is_array ())
    path.pop_back ();
  const auto valueIn = [&] (const Json& document) {
    return (document.contains (path) ? shortText (document.at (path)) : "absent");
  };
  return (escaped (path.to_string ()) + " is " + valueIn (there) + " there and " + valueIn (now) + " now");
}

/** \brief Files that a killed run was writing. Nobody writes at one for as long as an hour. */
void
removeStaleParts (const fs::path& folder)
{
  std::error_code ignored;
  const auto now = fs::file_time_type::clock::now ();
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator (folder, ignored))
    if (entry.path ().filename ().string ().find (".part-") != std::string::npos &&
        now - entry.last_write_time (ignored) > std::chrono::hours (1))
      fs::remove (entry.path (), ignored);
}

} // namespace

EvaluationStore::EvaluationStore (const fs::path& folder, const Json& description)
    : folder_ (folder), description_ (description)
{
  std::error_code ignored;
  if (fs::exists (folder / description_file, ignored))
    EvaluationStore (folder).checkSameAs (description);
  OutputFolder::prepareParent (folder / "results");
  removeStaleParts (folder);
  if (!fs::exists (folder / description_file, ignored))
    writeWholeFile ((folder / description_file).string (), description.dump (1) + '\n');
}

EvaluationStore::EvaluationStore (const fs::path& folder) : folder_ (folder)
{
  const fs::path file = folder / description_file;
  std::error_code ignored;
  if (!fs::exists (file, ignored))
    fail (folder, std::string ("no folder of an evaluation, there is no ") + description_file + " in it");
  description_ = readJsonFile (file.string ());
}

void
EvaluationStore::checkSameAs (const Json& description) const
{
  const std::string difference = differenceOf (description_, description);
  if (!difference.empty ())
    fail (folder_, "holds another evaluation: " + difference + ". Take another folder, or remove this one");
}

fs::path
EvaluationStore::fileOf (const std::string& system, const std::string& scene, const char* extension) const
{
  return (folder_ / "results" / (system.empty () ? "ground_truth" : system) / (scene + extension));
}

std::optional<SceneResult>
EvaluationStore::read (const std::string& system, const std::string& scene) const
{
  const fs::path file = fileOf (system, scene, ".json");
  std::error_code ignored;
  if (!fs::exists (file, ignored))
    return (std::nullopt);
  const Json json = readJsonFile (file.string ());
  try
  {
    return (sceneResultFromJson (json));
  }
  catch (const std::exception&)
  {
    fail (file, "damaged: remove it, and it will be made again");
  }
}

void
EvaluationStore::write (const std::string& system, const std::string& scene, const SceneResult& result) const
{
  const fs::path file = fileOf (system, scene, ".json");
  std::error_code ignored;
  fs::create_directories (file.parent_path (), ignored);
  writeWholeFile (file.string (), sceneResultToJson (result).dump () + '\n');
}

std::string
EvaluationStore::readPicture (const std::string& system, const std::string& scene) const
{
  std::ostringstream content;
  content << std::ifstream (fileOf (system, scene, ".png"), std::ios::binary).rdbuf ();
  return (content.str ());
}

void
EvaluationStore::writePicture (const std::string& system, const std::string& scene, const std::string& png) const
{
  const fs::path file = fileOf (system, scene, ".png");
  std::error_code ignored;
  fs::create_directories (file.parent_path (), ignored);
  writeWholeFile (file.string (), png);
}

} // namespace pcl_attention
