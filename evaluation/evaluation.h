// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/scene_result.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief What one system yields on all scenes. */
struct SystemEvaluation
{
  std::string name;                ///< e.g. "proposed"
  std::string note;                ///< what a reader of the report has to know, e.g. a cap on fixations
  std::string swept;               ///< the system whose theta_com is varied; empty for a system of its own
  double theta_com = 0;            ///< metres, of a system that is varied
  std::vector<SceneResult> scenes; ///< in the order of the scenes
};

/** \brief Systems side by side on the same scenes. */
struct Evaluation
{
  std::string version; ///< of the program
  std::vector<GroundTruthKind> kinds;
  std::vector<SystemEvaluation> systems; ///< those of their own, then those whose theta_com is varied

  /** \brief The systems of their own. */
  std::vector<const SystemEvaluation*> ownSystems () const;

  /** \brief The one whose failures are looked at: "proposed", else the first. */
  const SystemEvaluation& mainSystem () const;

  /** \brief Those whose theta_com is varied, of one system in ascending order of it. */
  std::vector<const SystemEvaluation*> sweepOf (const std::string& system) const;
};

/** \brief The scores of all scenes on all ground truths. */
std::vector<SceneScore> scoresOf (const SystemEvaluation& system);

/** \brief Summary over all scenes of a ground truth. */
Summary overallOf (const SystemEvaluation& system, GroundTruthKind kind);

/** \brief A table for people. */
struct ReportTable
{
  std::string title, note;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/** \brief The paper's Table I with its own figures beside, the strict figures, attention, label images, categories, and
 * the sweep of theta_com. */
std::vector<ReportTable> reportTables (const Evaluation& evaluation);

/** \brief The tables as Markdown. */
std::string reportMarkdown (const Evaluation& evaluation);

/** \brief All figures, one row a system, ground truth and category. */
std::string reportCsv (const Evaluation& evaluation);

/** \brief One row an object of every scene and system. */
std::string objectsCsv (const Evaluation& evaluation);

/** \brief One row a stage of every scene and system, milliseconds. */
std::string timingsCsv (const Evaluation& evaluation);

/** \brief All figures, those of the scenes included. */
nlohmann::ordered_json reportJson (const Evaluation& evaluation);

/** \brief A point of a risk-coverage curve. */
struct RiskPoint
{
  double coverage = 0; ///< share of the segments that are at least as confident
  double risk = 0;     ///< 1 - their mean F; a segment whose attention point lies on no object has F 0
};

/** \brief The risk of keeping only the more confident segments, in ascending order of coverage; empty without
 * confidences. Segments of the same confidence are kept together. */
std::vector<RiskPoint> riskCoverage (const SystemEvaluation& system, GroundTruthKind kind);

/** \brief Median time of a stage over the scenes, milliseconds, in the order of the stages; scenes without it do not
 * count. */
std::vector<std::pair<std::string, double>> medianTimes (const SystemEvaluation& system);

/** \brief Mean strict first F over a scene's objects; NaN without any. */
double sceneFigure (const SceneScore& score);

} // namespace pcl_attention
