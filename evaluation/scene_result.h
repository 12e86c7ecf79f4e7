// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/metrics.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <utility>
#include <vector>

namespace pcl_attention
{

/** \brief What one system yields on one scene: all that a report is made from. */
struct SceneResult
{
  std::vector<SceneScore> scores;                           ///< one a ground truth
  std::vector<std::pair<std::string, double>> milliseconds; ///< wall time of each stage, and last of all ("total")
  std::string checksum;                                     ///< of the files that it was made from
};

/** \brief As JSON, which \ref sceneResultFromJson reads back to the same numbers. */
nlohmann::ordered_json sceneResultToJson (const SceneResult& result);

/** \throws std::exception if it is not what \ref sceneResultToJson makes */
SceneResult sceneResultFromJson (const nlohmann::ordered_json& json);

} // namespace pcl_attention
