// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/evaluation.h"

#include "evaluation/paper_table.h"
#include "evaluation/report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl_attention
{
namespace
{

using Json = nlohmann::ordered_json;
using Row = std::vector<std::string>;

/** \brief The figures of a system or of the paper, in the paper's order. */
void
appendFigures (Row& row, const PaperFigures& figures)
{
  for (const Distribution& distribution : {figures.all, figures.best, figures.first})
    row.push_back (figureText (distribution));
}

ReportTable
tableOne (const Evaluation& evaluation, GroundTruthKind kind)
{
  const bool has_paper = kind == GroundTruthKind::objects;
  ReportTable table{
      "Table I: F of the segments, " + toString (kind),
      "Mean and standard deviation over the " + toString (kind) +
          " with an attention point. First: the segment of the first attention point on it, best: the one "
          "that fits best, all: the mean over all of them.",
      {"system", "all", "best", "first"},
      {}};
  if (has_paper)
  {
    table.note += " Beside them what the paper reports of the system on its own data, TOSD and Willow.";
    for (const char* data : {"TOSD", "Willow"})
      for (const char* name : {" all", " best", " first"})
        table.header.push_back (std::string (data) + name);
  }
  for (const SystemEvaluation* system : evaluation.ownSystems ())
  {
    const Summary summary = overallOf (*system, kind);
    Row row{system->name};
    appendFigures (row, {summary.attended_all, summary.attended_best, summary.attended_first});
    if (has_paper)
    {
      const PaperRow* paper = paperRow (system->name);
      appendFigures (row, paper ? paper->tosd : PaperFigures ());
      appendFigures (row, paper ? paper->willow : PaperFigures ());
    }
    table.rows.push_back (row);
    if (!system->note.empty ())
      table.note += " " + system->name + ": " + system->note + ".";
  }
  return (table);
}

ReportTable
strictTable (const Evaluation& evaluation, GroundTruthKind kind)
{
  ReportTable table{"Strict F, coverage and label image, " + toString (kind),
                    "Strict: over all " + toString (kind) +
                        ", 0 without an attention point. Coverage: the share with one. Overlap: of the label image of "
                        "the whole scene. Confidence: its rank correlation with F.",
                    {"system", "strict all", "strict best", "strict first", "coverage", "points/scene",
                     "on " + toString (kind), "on support", "overlap P", "overlap R", "overlap F", "confidence"},
                    {}};
  for (const SystemEvaluation* system : evaluation.ownSystems ())
  {
    const Summary s = overallOf (*system, kind);
    table.rows.push_back (
        {system->name, figureText (s.strict_all), figureText (s.strict_best), figureText (s.strict_first),
         figureText (s.coverage) + " (" + std::to_string (s.attended) + " of " + std::to_string (s.objects) + ")",
         figureText (s.points_per_scene), figureText (s.points_on_objects), figureText (s.points_on_support),
         figureText (s.overlap.precision), figureText (s.overlap.recall), figureText (s.overlap.f),
         figureText (s.confidence_correlation)});
  }
  return (table);
}

/** \brief Empty with a single category. */
ReportTable
categoryTable (const Evaluation& evaluation, GroundTruthKind kind)
{
  ReportTable table{"By category, " + toString (kind),
                    "",
                    {"category", "system", "scenes", toString (kind), "all", "best", "first", "strict first",
                     "coverage", "overlap F"},
                    {}};
  std::map<std::string, std::vector<Row>> rows_of;
  std::vector<std::string> categories;
  for (const SystemEvaluation* system : evaluation.ownSystems ())
  {
    const std::vector<Summary> summaries = summarizeByCategory (kind, scoresOf (*system));
    for (auto s = summaries.begin () + 1; s != summaries.end (); ++s)
    {
      if (rows_of.count (s->group) == 0)
        categories.push_back (s->group);
      rows_of[s->group].push_back ({s->group, system->name, std::to_string (s->scenes), std::to_string (s->objects),
                                    figureText (s->attended_all), figureText (s->attended_best),
                                    figureText (s->attended_first), figureText (s->strict_first),
                                    figureText (s->coverage), figureText (s->overlap.f)});
    }
  }
  for (const std::string& category : categories)
    table.rows.insert (table.rows.end (), rows_of[category].begin (), rows_of[category].end ());
  return (table);
}

/** \brief Empty where theta_com is not varied. */
ReportTable
sweepTable (const Evaluation& evaluation, GroundTruthKind kind)
{
  ReportTable table{"Sweep of theta_com, " + toString (kind),
                    "",
                    {"system", "theta_com [mm]", "all", "best", "first", "strict first", "coverage", "overlap F"},
                    {}};
  for (const SystemEvaluation* system : evaluation.ownSystems ())
    for (const SystemEvaluation* point : evaluation.sweepOf (system->name))
    {
      const Summary s = overallOf (*point, kind);
      table.rows.push_back ({system->name, csvNumber (1e3 * point->theta_com), figureText (s.attended_all),
                             figureText (s.attended_best), figureText (s.attended_first), figureText (s.strict_first),
                             figureText (s.coverage), figureText (s.overlap.f)});
    }
  return (table);
}

std::string
markdownRow (const Row& row)
{
  std::string text = "|";
  for (const std::string& cell : row)
  {
    text += ' ';
    for (const char character : cell)
      text += character == '|' ? std::string ("\\|") : std::string (1, character);
    text += " |";
  }
  return (text + '\n');
}

std::string
systemCells (const SystemEvaluation& system)
{
  return (system.swept.empty () ? csvText (system.name) + ','
                                : csvText (system.swept) + ',' + csvNumber (system.theta_com));
}

Json
figureToJson (double value)
{
  return (std::isnan (value) ? Json () : Json (value));
}

Json
figureToJson (const Distribution& distribution)
{
  return {{"mean", figureToJson (distribution.mean)}, {"deviation", figureToJson (distribution.deviation)}};
}

Json
summaryToJson (const Summary& s)
{
  return {{"ground_truth", toString (s.kind)},
          {"group", s.group},
          {"scenes", s.scenes},
          {"objects", s.objects},
          {"attended", s.attended},
          {"points", s.points},
          {"attended_first_f", figureToJson (s.attended_first)},
          {"attended_best_f", figureToJson (s.attended_best)},
          {"attended_all_f", figureToJson (s.attended_all)},
          {"strict_first_f", figureToJson (s.strict_first)},
          {"strict_best_f", figureToJson (s.strict_best)},
          {"strict_all_f", figureToJson (s.strict_all)},
          {"best_of_scene_f", figureToJson (s.best_of_scene)},
          {"center_f", figureToJson (s.center)},
          {"coverage", figureToJson (s.coverage)},
          {"hits_within_5", figureToJson (s.hits_within_5)},
          {"hits_within_10", figureToJson (s.hits_within_10)},
          {"hits_within_objects", figureToJson (s.hits_within_objects)},
          {"points_per_scene", figureToJson (s.points_per_scene)},
          {"points_per_object", figureToJson (s.points_per_object)},
          {"points_on_objects", figureToJson (s.points_on_objects)},
          {"points_on_support", figureToJson (s.points_on_support)},
          {"points_on_invalid", figureToJson (s.points_on_invalid)},
          {"points_duplicate", figureToJson (s.points_duplicate)},
          {"overlap_precision", figureToJson (s.overlap.precision)},
          {"overlap_recall", figureToJson (s.overlap.recall)},
          {"overlap_f", figureToJson (s.overlap.f)},
          {"confidence_correlation", figureToJson (s.confidence_correlation)}};
}

} // namespace

std::vector<const SystemEvaluation*>
Evaluation::ownSystems () const
{
  std::vector<const SystemEvaluation*> own;
  for (const SystemEvaluation& system : systems)
    if (system.swept.empty ())
      own.push_back (&system);
  return (own);
}

const SystemEvaluation&
Evaluation::mainSystem () const
{
  const auto proposed = std::find_if (systems.begin (), systems.end (),
                                      [] (const SystemEvaluation& system) { return (system.name == "proposed"); });
  return (proposed == systems.end () ? systems.front () : *proposed);
}

std::vector<const SystemEvaluation*>
Evaluation::sweepOf (const std::string& system) const
{
  std::vector<const SystemEvaluation*> points;
  for (const SystemEvaluation& candidate : systems)
    if (!candidate.swept.empty () && candidate.swept == system)
      points.push_back (&candidate);
  std::sort (points.begin (), points.end (),
             [] (const SystemEvaluation* a, const SystemEvaluation* b) { return (a->theta_com < b->theta_com); });
  return (points);
}

std::vector<SceneScore>
scoresOf (const SystemEvaluation& system)
{
  std::vector<SceneScore> scores;
  for (const SceneResult& scene : system.scenes)
    scores.insert (scores.end (), scene.scores.begin (), scene.scores.end ());
  return (scores);
}

Summary
overallOf (const SystemEvaluation& system, GroundTruthKind kind)
{
  return (summarizeByCategory (kind, scoresOf (system)).front ());
}

std::vector<ReportTable>
reportTables (const Evaluation& evaluation)
{
  std::vector<ReportTable> tables;
  for (const GroundTruthKind kind : evaluation.kinds)
    for (ReportTable& table : std::vector<ReportTable>{tableOne (evaluation, kind), strictTable (evaluation, kind),
                                                       categoryTable (evaluation, kind), sweepTable (evaluation, kind)})
      if (!table.rows.empty ())
        tables.push_back (std::move (table));
  return (tables);
}

std::string
reportMarkdown (const Evaluation& evaluation)
{
  const std::size_t scenes = evaluation.systems.empty () ? 0 : evaluation.systems.front ().scenes.size ();
  std::string text = "# Evaluation\n\nBy pcl_attention_evaluate " + evaluation.version + " on " +
                     std::to_string (scenes) + (scenes == 1 ? " scene.\n" : " scenes.\n");
  for (const ReportTable& table : reportTables (evaluation))
  {
    text += "\n## " + table.title + "\n\n";
    if (!table.note.empty ())
      text += table.note + "\n\n";
    text += markdownRow (table.header) + markdownRow (Row (table.header.size (), "---"));
    for (const Row& row : table.rows)
      text += markdownRow (row);
  }
  return (text);
}

std::string
reportCsv (const Evaluation& evaluation)
{
  std::string text = "system,theta_com," + summaryCsvHeader () + '\n';
  for (const SystemEvaluation& system : evaluation.systems)
    for (const GroundTruthKind kind : evaluation.kinds)
      for (const Summary& summary : summarizeByCategory (kind, scoresOf (system)))
        text += systemCells (system) + ',' + summaryCsvRow (summary) + '\n';
  return (text);
}

std::string
objectsCsv (const Evaluation& evaluation)
{
  std::string text = "system,theta_com," + objectCsvHeader () + '\n';
  for (const SystemEvaluation& system : evaluation.systems)
    for (const SceneScore& score : scoresOf (system))
      for (const RegionScore& region : score.regions)
        text += systemCells (system) + ',' + objectCsvRow (score, region) + '\n';
  return (text);
}

std::string
timingsCsv (const Evaluation& evaluation)
{
  std::string text = "system,theta_com,scene,stage,milliseconds\n";
  for (const SystemEvaluation& system : evaluation.systems)
    for (const SceneResult& scene : system.scenes)
      for (const auto& [stage, time] : scene.milliseconds)
        text += systemCells (system) + ',' + csvText (scene.scores.front ().name) + ',' + csvText (stage) + ',' +
                csvNumber (time) + '\n';
  return (text);
}

Json
reportJson (const Evaluation& evaluation)
{
  Json systems = Json::array ();
  for (const SystemEvaluation& system : evaluation.systems)
  {
    Json summaries = Json::array (), scenes = Json::array ();
    for (const GroundTruthKind kind : evaluation.kinds)
      for (const Summary& summary : summarizeByCategory (kind, scoresOf (system)))
        summaries.push_back (summaryToJson (summary));
    for (const SceneResult& scene : system.scenes)
    {
      const Json result = sceneResultToJson (scene);
      scenes.insert (scenes.end (), result["scores"].begin (), result["scores"].end ());
    }
    Json entry;
    entry["system"] = system.swept.empty () ? system.name : system.swept;
    entry["theta_com"] = system.swept.empty () ? Json () : Json (system.theta_com);
    entry["summaries"] = summaries;
    entry["scenes"] = scenes;
    systems.push_back (entry);
  }
  return {{"version", evaluation.version}, {"systems", systems}};
}

std::vector<RiskPoint>
riskCoverage (const SystemEvaluation& system, GroundTruthKind kind)
{
  std::vector<std::pair<double, double>> segments; // confidence, F
  for (const SceneScore& score : scoresOf (system))
    if (score.kind == kind)
      for (const SegmentScore& segment : score.segments)
        if (!std::isnan (segment.confidence))
          segments.emplace_back (segment.confidence, segment.overlap.f);
  std::sort (segments.begin (), segments.end (), std::greater<> ());
  std::vector<RiskPoint> points;
  double sum = 0;
  for (std::size_t i = 0; i < segments.size (); ++i)
  {
    sum += segments[i].second;
    const auto kept = static_cast<double> (i + 1);
    if (i + 1 == segments.size () || segments[i + 1].first != segments[i].first)
      points.push_back ({kept / static_cast<double> (segments.size ()), 1 - sum / kept});
  }
  return (points);
}

std::vector<std::pair<std::string, double>>
medianTimes (const SystemEvaluation& system)
{
  std::vector<std::pair<std::string, double>> medians;
  std::map<std::string, std::vector<double>> times_of;
  for (const SceneResult& scene : system.scenes)
    for (const auto& [stage, time] : scene.milliseconds)
    {
      if (times_of.count (stage) == 0)
        medians.emplace_back (stage, 0);
      times_of[stage].push_back (time);
    }
  for (auto& [stage, median] : medians)
  {
    std::vector<double>& times = times_of[stage];
    std::nth_element (times.begin (), times.begin () + times.size () / 2, times.end ());
    median = times[times.size () / 2];
  }
  return (medians);
}

double
sceneFigure (const SceneScore& score)
{
  std::vector<double> figures;
  for (const RegionScore& region : score.regions)
    figures.push_back (region.first.f);
  return (distributionOf (figures).mean);
}

} // namespace pcl_attention
