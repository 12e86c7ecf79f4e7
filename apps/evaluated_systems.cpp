// SPDX-License-Identifier: BSD-3-Clause
#include "evaluated_systems.h"

#include "evaluation/prediction_of_segments.h"
#include "evaluation/results.h"
#include "number_text.h"
#include <pcl/segmentation/attention_segmentation.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace fs = std::filesystem;

namespace pcl_attention
{

namespace
{

SystemOutput
segment (const LabelledScene& scene, const AttentionParameters& parameters, unsigned int threads)
{
  pcl::AttentionSegmentation<pcl::PointXYZRGBL> segmentation (parameters);
  segmentation.setNumberOfThreads (threads);
  segmentation.setInputCloud (scene.cloud);
  std::vector<pcl::AttentionSegment> segments;
  if (!segmentation.segment (segments))
    throw std::runtime_error (scene.name + ": could not be segmented, see above");
  const StageTimes times = segmentation.getPipeline ()->times ();
  return {
      predictionOfSegments (static_cast<int> (scene.cloud->width), static_cast<int> (scene.cloud->height), segments),
      {{"normals", times.normals},
       {"saliency", times.saliency},
       {"attention_points", times.attention_points},
       {"patches", times.patches},
       {"segmentation", times.segmentation},
       {"total", times.total ()}}};
}

EvaluatedSystem
moduleWith (const std::string& name, const NamedParameters& parameters)
{
  EvaluatedSystem system;
  system.name = name;
  system.parameters = parametersToJson (parameters);
  system.run = [values = parameters.values] (const LabelledScene& scene, unsigned int threads) {
    return (segment (scene, values, threads));
  };
  return (system);
}

struct NamedSystem
{
  const char* name;
  EvaluatedSystem (*make) (const std::string& name, const NamedParameters& own);
};

EvaluatedSystem
makeModule (const std::string& name, const NamedParameters& own)
{
  return (moduleWith (name, parametersOfSystem (name, own)));
}

// Another system is one more line.
const std::vector<NamedSystem>&
namedSystems ()
{
  static const std::vector<NamedSystem> systems{{"proposed", makeModule}, {"paper", makeModule}};
  return (systems);
}

} // namespace

const std::vector<std::string>&
evaluatedSystemNames ()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const NamedSystem& system : namedSystems ())
      all.emplace_back (system.name);
    return (all);
  }();
  return (names);
}

EvaluatedSystem
makeEvaluatedSystem (const std::string& name, const NamedParameters& own)
{
  for (const NamedSystem& system : namedSystems ())
    if (name == system.name)
      return (system.make (name, own));
  throw std::invalid_argument ("no system \"" + name + "\"");
}

EvaluatedSystem
storedResults (const std::string& folder)
{
  EvaluatedSystem system;
  system.name = "results";
  system.run = [folder] (const LabelledScene& scene, unsigned int) {
    return (SystemOutput{readResults ((fs::path (folder) / scene.name).string (), static_cast<int> (scene.cloud->width),
                                      static_cast<int> (scene.cloud->height)),
                         {}});
  };
  system.inputs = [folder] (const std::string& scene) {
    std::vector<std::string> files;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator (fs::path (folder) / scene, ignored))
      if (entry.is_regular_file ())
        files.push_back (entry.path ().string ());
    std::sort (files.begin (), files.end ());
    return (files);
  };
  return (system);
}

EvaluatedSystem
makeSweptSystem (const std::string& name, const NamedParameters& parameters, double theta_com)
{
  NamedParameters varied = parameters;
  varied.values.clustering.compactness_threshold = static_cast<float> (theta_com);
  EvaluatedSystem system = moduleWith (name + "@" + numberText (static_cast<float> (1e3 * theta_com)) + "mm", varied);
  system.swept = name;
  system.theta_com = theta_com;
  return (system);
}

NamedParameters
parametersOfSystem (const std::string& name, const NamedParameters& own)
{
  return (name == "paper" ? presetParameters ("paper") : own);
}

} // namespace pcl_attention
