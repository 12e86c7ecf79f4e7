// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/report_page.h"

#include "evaluation/charts.h"
#include "evaluation/report.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl_attention
{
namespace
{

constexpr std::size_t rows_side_by_side = 7; // as many as the paper's Fig. 4 has
constexpr std::size_t worst_scenes = 6;

const char* const style = R"(<style>
body { font: 16px/1.5 sans-serif; max-width: 1200px; margin: 2em auto; padding: 0 1em; color: #222; background: #fff; }
h1, h2 { line-height: 1.2; } h2 { margin-top: 2em; border-bottom: 1px solid #ccc; }
.scroll { overflow-x: auto; } svg { max-width: 100%; height: auto; }
table { border-collapse: collapse; font-size: 14px; } th { text-align: right; vertical-align: bottom; }
th, td { padding: .25em .7em; border-bottom: 1px solid #ddd; white-space: nowrap; } thead th { border-color: #666; }
tbody th, thead th:first-child { text-align: left; } td { text-align: right; font-variant-numeric: tabular-nums; }
.pictures td, .pictures th { text-align: center; padding: .2em; border: 0; } .pictures img { width: 240px; display: block; }
.pictures td, .pictures th { vertical-align: middle; }
p.note { max-width: 50em; color: #555; }
</style>
)";

std::string
base64 (const std::string& bytes)
{
  using namespace boost::archive::iterators;
  using Iterator = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text (Iterator (bytes.begin ()), Iterator (bytes.end ()));
  return (text.append ((3 - bytes.size () % 3) % 3, '='));
}

std::string
heading (const std::string& title, const std::string& note)
{
  return ("<h2>" + escapeMarkup (title) + "</h2>\n" +
          (note.empty () ? "" : "<p class=\"note\">" + escapeMarkup (note) + "</p>\n"));
}

std::string
tableElement (const ReportTable& table)
{
  std::string text = "<div class=\"scroll\"><table>\n<thead><tr>";
  for (const std::string& cell : table.header)
    text += "<th>" + escapeMarkup (cell) + "</th>";
  text += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows)
  {
    text += "<tr><th>" + escapeMarkup (row.front ()) + "</th>";
    for (auto cell = row.begin () + 1; cell != row.end (); ++cell)
      text += "<td>" + escapeMarkup (*cell) + "</td>";
    text += "</tr>\n";
  }
  return (text + "</tbody>\n</table></div>\n");
}

std::string
sweepSection (const Evaluation& evaluation, GroundTruthKind kind)
{
  std::vector<Curve> curves;
  double largest = 0;
  int color = 0;
  for (const SystemEvaluation* system : evaluation.ownSystems ())
  {
    const auto sweep = evaluation.sweepOf (system->name);
    if (sweep.empty ())
      continue;
    Curve attended{system->name + ", first, attended", {}, color, false, true};
    Curve strict{system->name + ", first, strict", {}, color++, true, true};
    for (const SystemEvaluation* point : sweep)
    {
      const Summary summary = overallOf (*point, kind);
      largest = std::max (largest, 1e3 * point->theta_com);
      attended.points.emplace_back (1e3 * point->theta_com, summary.attended_first.mean);
      strict.points.emplace_back (1e3 * point->theta_com, summary.strict_first.mean);
    }
    curves.push_back (attended);
    curves.push_back (strict);
  }
  if (curves.empty ())
    return ("");
  const double step = largest > 20 ? std::ceil (largest / 50) * 5 : largest > 10 ? 2 : 1;
  return (heading ("Figure 3: F over theta_com, " + toString (kind),
                   "The compactness threshold: smaller values split objects, larger values join them.") +
          lineChart ({"theta_com [mm]", 0, std::ceil (largest / step) * step, step}, {"F", 0, 1, .1}, curves));
}

std::string
riskSection (const Evaluation& evaluation)
{
  std::vector<Curve> curves;
  double highest = 0;
  int color = 0;
  for (const SystemEvaluation* system : evaluation.ownSystems ())
  {
    Curve curve{system->name, {}, color++, false, false};
    for (const RiskPoint& point : riskCoverage (*system, evaluation.kinds.front ()))
    {
      curve.points.emplace_back (point.coverage, point.risk);
      highest = std::max (highest, point.risk);
    }
    if (curve.points.size () > 1)
      curves.push_back (curve);
  }
  if (curves.empty ())
    return ("");
  const double step = highest > .5 ? .1 : highest > .2 ? .05 : .02;
  return (heading ("Risk and coverage of the confidence",
                   "What is risked, 1 - mean F, when only the most confident share of the segments is kept: a "
                   "confidence that knows is low on the left. A segment whose attention point lies on no object has F "
                   "0.") +
          lineChart ({"share of the segments that is kept", 0, 1, .1},
                     {"1 - mean F", 0, std::max (step, std::ceil (highest / step) * step), step}, curves));
}

std::string
timeSection (const Evaluation& evaluation)
{
  std::vector<Bar> bars;
  for (const SystemEvaluation* system : evaluation.ownSystems ())
  {
    Bar bar{system->name, medianTimes (*system)};
    // The total is shown where there are no stages; stages that ran beside each other add up to more.
    if (bar.parts.size () > 1)
      bar.parts.pop_back ();
    if (!bar.parts.empty ())
      bars.push_back (bar);
  }
  if (bars.empty ())
    return ("");
  return (heading ("Time", "Median over the scenes of each stage's wall time; reading and writing is not in it.") +
          barChart ("ms", bars));
}

std::string
pictureCell (const PictureOf& picture_of, const std::string& system, const std::string& scene)
{
  const std::string png = picture_of (system, scene);
  if (png.empty ())
    return ("<td></td>");
  return ("<td><img alt=\"" + escapeMarkup ((system.empty () ? "ground truth" : system) + ", " + scene) +
          "\" src=\"data:image/png;base64," + base64 (png) + "\"></td>");
}

/** \brief Scenes for the comparison: the first of every category, then further ones evenly spaced. */
std::vector<const SceneScore*>
shownScenes (const std::vector<const SceneScore*>& scores)
{
  std::set<std::string> categories;
  std::set<std::size_t> chosen;
  for (std::size_t i = 0; i < scores.size () && chosen.size () < rows_side_by_side; ++i)
    if (categories.insert (scores[i]->category).second)
      chosen.insert (i);
  const std::size_t wanted = std::min (rows_side_by_side, scores.size ());
  for (std::size_t k = 0; k < wanted && chosen.size () < wanted; ++k)
    chosen.insert (k * scores.size () / wanted);
  std::vector<const SceneScore*> shown;
  for (const std::size_t i : chosen)
    shown.push_back (scores[i]);
  return (shown);
}

std::vector<const SceneScore*>
scoresOfKind (const SystemEvaluation& system, GroundTruthKind kind)
{
  std::vector<const SceneScore*> scores;
  for (const SceneResult& scene : system.scenes)
    for (const SceneScore& score : scene.scores)
      if (score.kind == kind)
        scores.push_back (&score);
  return (scores);
}

std::string
comparisonSection (const Evaluation& evaluation, const PictureOf& picture_of)
{
  const auto systems = evaluation.ownSystems ();
  std::string text = heading ("Figure 4: side by side",
                              "Outlines and attention points, numbered in order of attention; the first of every "
                              "category, and some more.") +
                     "<div class=\"scroll\"><table class=\"pictures\">\n<tr><th></th><th>ground truth</th>";
  for (const SystemEvaluation* system : systems)
    text += "<th>" + escapeMarkup (system->name) + "</th>";
  text += "</tr>\n";
  for (const SceneScore* scene : shownScenes (scoresOfKind (*systems.front (), evaluation.kinds.front ())))
  {
    text += "<tr><th>" + escapeMarkup (scene->name) + "</th>" + pictureCell (picture_of, "", scene->name);
    for (const SystemEvaluation* system : systems)
      text += pictureCell (picture_of, system->name, scene->name);
    text += "</tr>\n";
  }
  return (text + "</table></div>\n");
}

std::string
worstSection (const SystemEvaluation& system, GroundTruthKind kind, const PictureOf& picture_of)
{
  std::vector<const SceneScore*> scores = scoresOfKind (system, kind);
  scores.erase (std::remove_if (scores.begin (), scores.end (),
                                [] (const SceneScore* score) { return (score->regions.empty ()); }),
                scores.end ());
  std::stable_sort (scores.begin (), scores.end (),
                    [] (const SceneScore* a, const SceneScore* b) { return (sceneFigure (*a) < sceneFigure (*b)); });
  scores.resize (std::min (scores.size (), worst_scenes));
  std::string text = heading ("The worst scenes of " + system.name, "By the mean of strict first F over the scene.") +
                     "<div class=\"scroll\"><table class=\"pictures\">\n<tr><th></th><th>ground truth</th><th>" +
                     escapeMarkup (system.name) + "</th><th></th></tr>\n";
  for (const SceneScore* score : scores)
  {
    std::string failures;
    for (const RegionScore& region : score->regions)
      if (region.first.f < .9)
        failures += "<br>" + escapeMarkup (std::to_string (region.region.label)) + ": " +
                    (region.attended ()
                         ? "F " + figureText (region.first.f) + ", precision " + figureText (region.first.precision) +
                               ", recall " + figureText (region.first.recall)
                         : std::string ("no attention point"));
    text += "<tr><th>" + escapeMarkup (score->name) + "</th>" + pictureCell (picture_of, "", score->name) +
            pictureCell (picture_of, system.name, score->name) + "<td style=\"text-align: left\">F " +
            figureText (sceneFigure (*score)) + ", overlap " + figureText (score->overlap.f) + failures +
            "</td></tr>\n";
  }
  return (text + "</table></div>\n");
}

} // namespace

std::string
reportPage (const Evaluation& evaluation, const PictureOf& picture_of)
{
  const auto systems = evaluation.ownSystems ();
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
                     "content=\"width=device-width\">\n<title>pcl_attention: evaluation</title>\n";
  page += style;
  page += "</head>\n<body>\n<h1>Evaluation</h1>\n<p>By pcl_attention_evaluate " + escapeMarkup (evaluation.version) +
          " on " + std::to_string (systems.front ()->scenes.size ()) + " scenes.</p>\n";
  for (const ReportTable& table : reportTables (evaluation))
    page += heading (table.title, table.note) + tableElement (table);
  for (const GroundTruthKind kind : evaluation.kinds)
    page += sweepSection (evaluation, kind);
  page += riskSection (evaluation) + timeSection (evaluation) + comparisonSection (evaluation, picture_of) +
          worstSection (evaluation.mainSystem (), evaluation.kinds.front (), picture_of);
  return (page + "</body>\n</html>\n");
}

} // namespace pcl_attention
