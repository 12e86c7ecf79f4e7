// SPDX-License-Identifier: BSD-3-Clause
#include "files.h"
#include "parameter_flags.h"

using namespace pcl_attention;

namespace
{

NamedParameters
parametersOf (std::vector<std::string> arguments)
{
  CommandLine command_line ("program [flags]", "");
  addParameterFlags (command_line);
  arguments.insert (arguments.begin (), "program");
  std::vector<char*> argv;
  for (std::string& argument : arguments)
    argv.push_back (argument.data ());
  command_line.parse (static_cast<int> (argv.size ()), argv.data ());
  return (parametersFromFlags (command_line));
}

TEST (ParameterFlags, withoutAnyGiveTheDefaultPreset)
{
  const NamedParameters parameters = parametersOf ({});
  EXPECT_EQ (parameters.preset, "default");
  for (const ParameterDescription& row : parameterTable ())
    EXPECT_EQ (row.get (parameters.values), row.get (AttentionParameters ())) << row.name;
}

TEST (ParameterFlags, thereIsOneForEveryRow)
{
  for (const ParameterDescription& row : parameterTable ())
  {
    AttentionParameters expected;
    row.set (expected, row.maximum);
    const NamedParameters parameters = parametersOf ({"-" + row.name, row.toString (expected)});
    EXPECT_EQ (row.get (parameters.values), row.get (expected)) << row.name;
  }
}

TEST (ParameterFlags, precedenceIsPresetThenFileThenFlags)
{
  const test::TemporaryFolder folder;
  test::writeText (folder / "p.json", R"({"levels": 2, "blur_radius": 7, "join_occluded": true})");
  const AttentionParameters paper = AttentionParameters::paper ();
  const NamedParameters parameters =
      parametersOf ({"-blur_radius", "9", "-parameters", folder / "p.json", "-parts", "-preset", "paper"});
  EXPECT_EQ (parameters.preset, "paper");
  EXPECT_EQ (parameters.values.saliency.window_radius, paper.saliency.window_radius);
  EXPECT_EQ (parameters.values.saliency.levels, 2);
  EXPECT_EQ (parameters.values.saliency.blur_radius, 9);
  EXPECT_FALSE (parameters.values.clustering.join_occluded);
  EXPECT_FALSE (parameters.values.clustering.join_hollows);
  EXPECT_TRUE (parametersOf ({"-parts", "-join_occluded", "on"}).values.clustering.join_occluded);
  EXPECT_FALSE (parametersOf ({"-all_points"}).values.segmentation.inhibition_of_return);
}

TEST (ParameterFlags, takeNegativeNumbers)
{
  EXPECT_EQ (parametersOf ({"-minimum_convexity", "-0.5"}).values.clustering.minimum_convexity, -0.5f);
}

TEST (ParameterFlagsDeathTest, badOnesEndTheProgramWithOneLine)
{
  const auto exits = testing::ExitedWithCode (2);
  EXPECT_EXIT (parametersOf ({"-levels", "99"}), exits, "^program: -levels is '99', but must be .*\n$");
  EXPECT_EXIT (parametersOf ({"-levels", "nan"}), exits, "^program: -levels is 'nan', .*\n$");
  EXPECT_EXIT (parametersOf ({"-levels", ""}), exits, "^program: .*levels.*\n$");
  EXPECT_EXIT (parametersOf ({"-levels"}), exits, "^program: .*levels.*\n$");
  EXPECT_EXIT (parametersOf ({"-level", "3"}), exits, "^program: .*level.*\n$");
  EXPECT_EXIT (parametersOf ({"-levels", "3", "-levels", "4"}), exits, "^program: .*levels.*\n$");
  EXPECT_EXIT (parametersOf ({"-coverage", "maybe"}), exits,
               "^program: -coverage is 'maybe', but must be one of off on.*\n$");
  EXPECT_EXIT (parametersOf ({"-preset", "best"}), exits, "^program: preset is 'best', .*default paper.*\n$");
  EXPECT_EXIT (parametersOf ({"-preset", ""}), exits, "^program: .*preset.*\n$");
  EXPECT_EXIT (parametersOf ({"-parameters", "/nowhere/p.json"}), exits, "^program: /nowhere/p.json: .*\n$");
}

TEST (ParameterFlagsDeathTest, helpShowsRangeDefaultAndSource)
{
  // The help goes to stdout and death tests look at stderr, so that the child joins the two.
  const auto help = [] {
    dup2 (STDERR_FILENO, STDOUT_FILENO);
    parametersOf ({"-h"});
  };
  EXPECT_EXIT (help (), testing::ExitedWithCode (0), "compactness_threshold.*eq. 13");
  EXPECT_EXIT (help (), testing::ExitedWithCode (0), "normal_depth_gate");
}

} // namespace
