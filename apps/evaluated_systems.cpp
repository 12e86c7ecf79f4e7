// SPDX-License-Identifier: BSD-3-Clause
#include "evaluated_systems.h"

#include "evaluation/prediction_of_segments.h"
#include "evaluation/results.h"
#include "number_text.h"
#include "systems/attention_system.h"

#include <pcl/common/io.h>
#include <pcl/segmentation/attention_segmentation.h>

#include <algorithm>
#include <chrono>
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

/** \brief Another row of the paper's Table I. */
EvaluatedSystem
otherSystem (const std::string& name)
{
  const SystemSettings settings;
  EvaluatedSystem system;
  system.name = name;
  if (name == "M11")
    system.note = "at most " + std::to_string (settings.simple_objects.maximum_fixations) + " boundaries a scene";
  else
    system.note = "at most " + std::to_string (settings.maximum_fixations) + " fixations a scene";
  system.parameters = {{"limit", system.note}};
  system.run = [name] (const LabelledScene& scene, unsigned int threads) {
    const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
    pcl::copyPointCloud (*scene.cloud, *cloud);
    SystemSettings own;
    own.threads = static_cast<int> (std::max (1u, threads));
    const auto begin = std::chrono::steady_clock::now ();
    const std::vector<AttentionSegment> segments = makeSystem (name, own)->segment (cloud);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now () - begin;
    return (SystemOutput{
        predictionOfSegments (static_cast<int> (cloud->width), static_cast<int> (cloud->height), segments),
        {{"total", time.count ()}}});
  };
  return (system);
}

} // namespace

const std::vector<std::string>&
evaluatedSystemNames ()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = systemNames ();
    all.emplace_back ("paper");
    return (all);
  }();
  return (names);
}

EvaluatedSystem
makeEvaluatedSystem (const std::string& name, const NamedParameters& own)
{
  if (name == "proposed" || name == "paper")
    return (moduleWith (name, parametersOfSystem (name, own)));
  const std::vector<std::string>& names = evaluatedSystemNames ();
  if (std::find (names.begin (), names.end (), name) == names.end ())
    throw std::invalid_argument ("no system \"" + name + "\"");
  return (otherSystem (name));
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
