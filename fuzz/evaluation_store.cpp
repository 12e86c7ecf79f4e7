// SPDX-License-Identifier: BSD-3-Clause
#include "input_file.h"

#include "evaluation_store.h"

#include <cstdint>

// The files of an evaluation that goes on: results of a scene, and the description of all.

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size)
{
  using namespace pcl_attention;
  static const InputFolder folder;
  static const bool is_prepared = std::filesystem::create_directories (folder.path () + "/results/system");
  static_cast<void> (is_prepared);
  static const nlohmann::ordered_json description = nlohmann::ordered_json::parse (
      R"({"version": "0.1.0", "systems": [{"name": "system", "parameters": {"levels": 4}}], "scenes": ["scene"]})");
  folder.write ("results/system/scene.json", data, size);
  const std::string text = description.dump ();
  folder.write ("evaluation.json", text.data (), text.size ());
  expectOneLine ([] { EvaluationStore (folder.path ()).read ("system", "scene"); });
  folder.write ("evaluation.json", data, size);
  expectOneLine ([] { EvaluationStore (folder.path ()).checkSameAs (description); });
  return (0);
}
