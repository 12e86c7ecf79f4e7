// SPDX-License-Identifier: BSD-3-Clause
#include "files.h"
#include "parameter_io.h"

#include <nlohmann/json.hpp>

using namespace pcl_attention;
using Json = nlohmann::ordered_json;

namespace
{

std::string
errorOf (const Json& json)
{
  NamedParameters parameters;
  const Json before = parametersToJson (parameters);
  try
  {
    parametersFromJson (json, "file.json", parameters);
  }
  catch (const std::exception& error)
  {
    EXPECT_EQ (parametersToJson (parameters), before) << "changed in spite of the error";
    return (error.what ());
  }
  return ("");
}

TEST (ParameterTable, hasUniqueNamesAndDefaultsInRange)
{
  std::set<std::string> names;
  for (const ParameterDescription& row : parameterTable ())
  {
    EXPECT_TRUE (names.insert (row.name).second) << row.name;
    EXPECT_FALSE (row.help.empty ()) << row.name;
    AttentionParameters parameters;
    EXPECT_EQ (row.parse (row.toString (parameters), parameters), "");
  }
  EXPECT_EQ (validate (AttentionParameters ()), "");
  EXPECT_EQ (validate (AttentionParameters::paper ()), "");
}

TEST (ParameterJson, holdsEveryRowAndReadsBackTheSame)
{
  for (const std::string& preset : presetNames ())
  {
    const NamedParameters written = presetParameters (preset);
    const Json json = parametersToJson (written);
    EXPECT_EQ (json.size (), parameterTable ().size () + 1);
    NamedParameters read = presetParameters (preset == "paper" ? "default" : "paper");
    parametersFromJson (Json::parse (json.dump ()), "text", read);
    EXPECT_EQ (read.preset, preset);
    for (const ParameterDescription& row : parameterTable ())
      EXPECT_EQ (row.get (read.values), row.get (written.values)) << row.name;
  }
}

TEST (ParameterJson, keepsEveryBitOfANumberAndShowsTheShortest)
{
  NamedParameters parameters;
  parameters.values.patches.maximum_angle = 0.1f;
  EXPECT_EQ (parametersToJson (parameters)["patch_maximum_angle"].dump (), "0.1");
  parameters.values.patches.maximum_angle = 0.123456789f;
  NamedParameters read;
  parametersFromJson (Json::parse (parametersToJson (parameters).dump ()), "text", read);
  EXPECT_EQ (read.values.patches.maximum_angle, parameters.values.patches.maximum_angle);
}

TEST (ParameterJson, namesTheSourceAndTheKeyOfAnError)
{
  EXPECT_EQ (errorOf (Json::array ()), "file.json: not a JSON object of parameters");
  EXPECT_EQ (errorOf (Json{{"levels", 3}, {"lvels", 3}}), "file.json: unknown parameter \"lvels\"");
  EXPECT_EQ (errorOf (Json{{"levels", "3"}}), "file.json: levels is \"3\", but must be a number");
  EXPECT_EQ (errorOf (Json{{"levels", nullptr}}), "file.json: levels is null, but must be a number");
  EXPECT_EQ (errorOf (Json{{"coverage", 1}}), "file.json: coverage is 1, but must be true or false");
  EXPECT_EQ (errorOf (Json{{"plane_model", true}}), "file.json: plane_model is true, but must be a string");
  EXPECT_EQ (errorOf (Json{{"preset", "best"}}),
             "file.json: preset is \"best\", but must be one of \"default\" \"paper\"");
  EXPECT_EQ (errorOf (Json{{"pixel_threshold", 0.5}, {"levels", 99}}).find ("file.json: levels is '99', but must be"),
             0u);
  EXPECT_EQ (errorOf (Json{{"levels", 2.5}}).find ("file.json: levels is '2.5', but must be a whole number"), 0u);
  EXPECT_EQ (errorOf (Json{{"levels", 2}, {"coverage", false}, {"plane_model", "initial"}}), "");
}

TEST (ParameterJson, putsWhateverIsWrongIntoOneShortLine)
{
  EXPECT_EQ (errorOf (Json{{"two\nlines\x1b", 3}}), "file.json: unknown parameter \"two\\nlines\\u001b\"");
  EXPECT_EQ (errorOf (Json{{"plane_model", "two\nlines"}}).find ("file.json: plane_model is 'two\\nlines', but must be"), 0u);
  EXPECT_LT (errorOf (Json{{"levels", std::string (100000, '3')}}).size (), 150u);
}

TEST (ParameterFile, isReadOverThePreset)
{
  const test::TemporaryFolder folder;
  const std::string file = folder / "parameters.json";
  test::writeText (file, R"({"levels": 2})");
  EXPECT_EQ (readParameters (file).preset, "default");
  EXPECT_EQ (readParameters (file).values.saliency.levels, 2);
  const NamedParameters over_paper = readParameters (file, "paper");
  EXPECT_EQ (over_paper.preset, "paper");
  EXPECT_EQ (over_paper.values.saliency.window_radius, AttentionParameters::paper ().saliency.window_radius);
  EXPECT_EQ (over_paper.values.saliency.levels, 2);

  test::writeText (file, R"({"preset": "paper", "levels": 2})");
  EXPECT_EQ (readParameters (file).preset, "paper");
  EXPECT_EQ (readParameters (file).values.saliency.window_radius, AttentionParameters::paper ().saliency.window_radius);
  EXPECT_EQ (readParameters (file, "default").preset, "default");
}

TEST (ParameterFile, isWrittenAndReadBack)
{
  const test::TemporaryFolder folder;
  NamedParameters parameters = presetParameters ("paper");
  parameters.values.saliency.levels = 5;
  writeParameters (folder / "parameters.json", parameters);
  EXPECT_EQ (parametersToJson (readParameters (folder / "parameters.json")), parametersToJson (parameters));
  EXPECT_THROW (writeParameters (folder / "missing/parameters.json", parameters), std::runtime_error);
}

TEST (ParameterFile, thatIsMissingOrNoJsonIsAnErrorThatNamesIt)
{
  const test::TemporaryFolder folder;
  for (const std::string text : {"", "{", "levels = 2", R"({"levels": 1e999})"})
  {
    test::writeText (folder / "broken.json", text);
    try
    {
      readParameters (folder / "broken.json");
      FAIL () << text;
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_EQ (std::string (error.what ()).find (folder / "broken.json: not valid JSON"), 0u) << error.what ();
    }
  }
  EXPECT_THROW (readParameters (folder / "missing.json"), std::runtime_error);
}

TEST (ParameterFile, thatIsNestedTooDeepIsAnError)
{
  const test::TemporaryFolder folder;
  const auto nested = [&] (std::size_t depth) {
    test::writeText (folder / "deep.json", "{\"levels\": " + std::string (depth, '[') + std::string (depth, ']') + "}");
    try
    {
      readParameters (folder / "deep.json");
    }
    catch (const std::runtime_error& error)
    {
      return (std::string (error.what ()));
    }
    return (std::string ());
  };
  EXPECT_EQ (nested (3), (folder / "deep.json") + ": levels is [[[]]], but must be a number");
  EXPECT_EQ (nested (1000000), (folder / "deep.json") + ": nested more than 100 deep");
}

} // namespace
