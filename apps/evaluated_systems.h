// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/labelled_scene.h"
#include "evaluation/prediction.h"
#include "parameter_io.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_attention
{

/** \brief What a system makes of a scene. */
struct SystemOutput
{
  ScenePrediction prediction;
  std::vector<std::pair<std::string, double>> milliseconds; /**< of each stage, and last "total"; empty: not known */
};

/** \brief Something that is evaluated: it turns a scene into segments. */
struct EvaluatedSystem
{
  std::string name;
  std::string note;                  /**< see SystemEvaluation */
  std::string swept;                 /**< see SystemEvaluation */
  double theta_com{0.0};             /**< see SystemEvaluation */
  nlohmann::ordered_json parameters; /**< what its results depend on besides the scene */

  /** \brief \throws std::runtime_error that names the scene; may be called from several threads at once */
  std::function<SystemOutput (const LabelledScene& scene, unsigned int threads)> run;

  /** \brief Files of a scene besides the data that it reads; may be empty. */
  std::function<std::vector<std::string> (const std::string& scene)> inputs;
};

/** \brief The systems by the names that \ref makeEvaluatedSystem takes, in the order of the reports. */
const std::vector<std::string>& evaluatedSystemNames ();

/** \brief \param[in] own parameters of the system "proposed" */
EvaluatedSystem makeEvaluatedSystem (const std::string& name, const NamedParameters& own);

/** \brief Results that someone has written before, in FOLDER/<name of the scene>/. */
EvaluatedSystem storedResults (const std::string& folder);

/** \brief The module with another theta_com.
 * \param[in] system the name of the system that is varied
 * \param[in] theta_com metres */
EvaluatedSystem makeSweptSystem (const std::string& system, const NamedParameters& parameters, double theta_com);

/** \brief The parameters of the systems that are the module itself: "proposed" and "paper". */
NamedParameters parametersOfSystem (const std::string& name, const NamedParameters& own);

} // namespace pcl_attention
