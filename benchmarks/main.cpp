// SPDX-License-Identifier: BSD-3-Clause
// pcl_attention_benchmark: the time of every stage, and of what PCL offers for the same work.
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
  command_line.parse (argc, argv);
  try
  {
    const std::vector<SceneCloud::ConstPtr> clouds = loadScenes (command_line.positional ());
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
