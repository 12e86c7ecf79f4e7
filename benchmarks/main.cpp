// SPDX-License-Identifier: BSD-3-Clause
// pcl_attention_benchmark: the time of every stage, and of what PCL offers for the same work.
#include "../src/core/instruction_set.h"
#include "command_line.h"
#include "peers.h"
#include "stages.h"

#include <benchmark/benchmark.h>

#include <iostream>

using namespace pcl_attention;

int
main (int argc, char** argv)
{
  benchmark::Initialize (&argc, argv);
  CommandLine command_line ("pcl_attention_benchmark [SCENE.pcd...] [--benchmark_...]",
                            "Times every stage, whole frames, and PCL's normals and LCCP on the same scenes: the mean over "
                            "the scenes, in milliseconds a frame.\nWithout SCENE.pcd, on rendered scenes. --help lists "
                            "Google Benchmark's own flags; for medians,\n--benchmark_repetitions=9 "
                            "--benchmark_report_aggregates_only.");
  std::string instruction_sets;
  for (const std::string& name : instructionSets ())
    instruction_sets += (instruction_sets.empty () ? "" : " | ") + name;
  command_line.addOptions () ("columns", boost::program_options::value<int> ()->default_value (640),
                              "of rendered scenes, pixels; three quarters as many rows") (
      "instruction_set", boost::program_options::value<std::string> ()->default_value (instructionSets ().back ()),
      ("inner loops to use here: " + instruction_sets).c_str ());
  command_line.parse (argc, argv);
  const int columns = command_line.get<int> ("columns");
  if (columns < 64 || columns > 4096)
    command_line.fail ("-columns is " + std::to_string (columns) + ", but must be 64 to 4096");
  const std::string name = command_line.get<std::string> ("instruction_set");
  if (!useInstructionSet (name))
    command_line.fail ("-instruction_set is " + name + ", but must be " + instruction_sets);
  try
  {
    const std::vector<SceneCloud::ConstPtr> clouds = loadScenes (command_line.positional (), columns);
    const std::vector<Frame> frames (clouds.begin (), clouds.end ());
    measureStages (frames);
    measurePeers (clouds);
    benchmark::RunSpecifiedBenchmarks ();
  }
  catch (const std::exception& error)
  {
    std::cerr << "pcl_attention_benchmark: " << error.what () << std::endl;
    return (EXIT_FAILURE);
  }
  return (EXIT_SUCCESS);
}
