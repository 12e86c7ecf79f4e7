// SPDX-License-Identifier: BSD-3-Clause
// Systems side by side: tables, charts and the page, from scores by hand.
#include "cases.h"
#include "evaluation/charts.h"
#include "evaluation/evaluation.h"
#include "evaluation/report_page.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <regex>

namespace pcl_attention
{
namespace
{

/** \brief Two objects of two pixels; the first is found exactly, with confidence .9, and again by half of it, with .5;
 * the third point lies on the table, with .7. */
SceneResult
resultOf (const std::string& name, const std::string& category)
{
  const GroundTruth truth = test::truthOf (6, {20, 20, 30, 30, 1, 1});
  SceneResult result;
  result.scores.push_back (
      scoreScene (truth, test::predictionOf (6, 1,
                                             {test::segmentAt (0, 0, {0, 1}, .9), test::segmentAt (1, 0, {0}, .5),
                                              test::segmentAt (4, 0, {4, 5}, .7)})));
  result.scores.back ().name = name;
  result.scores.back ().category = category;
  result.milliseconds = {{"patches", 3}, {"total", 10}};
  result.checksum = "0badcafe";
  return (result);
}

Evaluation
evaluationOf (const std::string& system)
{
  Evaluation evaluation;
  evaluation.version = "1.2";
  evaluation.kinds = {GroundTruthKind::objects};
  evaluation.systems.push_back ({system,
                                 system == "M11" ? "at most 7 fixations" : "",
                                 "",
                                 0,
                                 {resultOf ("one", "boxes"), resultOf ("two", "<bowls>")}});
  return (evaluation);
}

TEST (SceneResult, isTheSameAfterJson)
{
  SceneResult result = resultOf ("one", "boxes");
  result.scores[0].segments[1].confidence = std::numeric_limits<double>::quiet_NaN ();
  result.scores[0].overlap.f = 1.0 / 3;
  const nlohmann::ordered_json json = sceneResultToJson (result);
  const SceneResult again = sceneResultFromJson (nlohmann::ordered_json::parse (json.dump ()));
  EXPECT_EQ (sceneResultToJson (again).dump (), json.dump ());
  EXPECT_EQ (again.scores[0].overlap.f, 1.0 / 3);
  EXPECT_TRUE (std::isnan (again.scores[0].segments[1].confidence));
  EXPECT_EQ (again.scores[0].regions[0].points, 2);
  EXPECT_EQ (again.scores[0].regions[0].all_f, (1 + 2.0 / 3) / 2);
  EXPECT_EQ (again.scores[0].category, "boxes");
  EXPECT_EQ (again.milliseconds, result.milliseconds);
  EXPECT_THROW (sceneResultFromJson (nlohmann::ordered_json::parse ("{\"scores\": 1}")), std::exception);
}

TEST (Evaluation, tableOneHasThePapersFiguresBesideOurs)
{
  const std::string text = reportMarkdown (evaluationOf ("M11"));
  EXPECT_NE (text.find ("| system | all | best | first | TOSD all |"), std::string::npos) << text;
  EXPECT_NE (text.find ("| M11 | 0.833 +-0.000 | 1.000 +-0.000 | 1.000 +-0.000 | 0.570 +-0.080 | 0.660 +-0.060 | 0.620 "
                        "+-0.070 | 0.820 +-0.060 | 0.880 +-0.030 | 0.860 +-0.040 |"),
             std::string::npos)
      << text;
  EXPECT_NE (text.find ("| M11 | 0.417 +-0.417 | 0.500 +-0.500 | 0.500 +-0.500 | 0.500 (2 of 4) |"), std::string::npos)
      << text;
  EXPECT_NE (text.find (" M11: at most 7 fixations.\n"), std::string::npos) << text;
  EXPECT_NE (text.find ("| boxes | M11 | 1 | 2 |"), std::string::npos) << text;
  EXPECT_NE (
      reportMarkdown (evaluationOf ("mine")).find ("| mine | 0.833 +-0.000 | 1.000 +-0.000 | 1.000 +-0.000 | - |"),
      std::string::npos);
}

TEST (Evaluation, csvHasARowForEverySystemAndCategory)
{
  Evaluation evaluation = evaluationOf ("paper");
  evaluation.systems.push_back (evaluation.systems.front ());
  evaluation.systems.back ().swept = "paper";
  evaluation.systems.back ().theta_com = .005;
  const std::string csv = reportCsv (evaluation);
  EXPECT_EQ (std::count (csv.begin (), csv.end (), '\n'), 1 + 2 * 3);
  EXPECT_NE (csv.find ("\npaper,,objects,overall,2,4,2,6,1,0,"), std::string::npos) << csv;
  EXPECT_NE (csv.find ("\npaper,0.005,objects,boxes,1,2,1,3,"), std::string::npos) << csv;
  const std::string objects = objectsCsv (evaluation);
  EXPECT_EQ (std::count (objects.begin (), objects.end (), '\n'), 1 + 2 * 4);
  EXPECT_NE (objects.find ("\npaper,0.005,two,<bowls>,objects,3,2,"), std::string::npos) << objects;
  EXPECT_NE (timingsCsv (evaluation).find ("\npaper,,two,patches,3\n"), std::string::npos);
  const auto json = reportJson (evaluation);
  EXPECT_EQ (json["systems"].size (), 2u);
  EXPECT_EQ (json["systems"][1]["theta_com"], .005);
  EXPECT_EQ (json["systems"][0]["summaries"].size (), 3u);
  ASSERT_EQ (json["systems"][0]["scenes"].size (), 2u);
  EXPECT_EQ (json["systems"][0]["scenes"][1]["scene"], "two");
  EXPECT_NE (reportMarkdown (evaluation).find ("| paper | 5 | 0.833"), std::string::npos);
}

TEST (Evaluation, riskIsOfTheMostConfidentSegments)
{
  // In both scenes .9 is right, .7 lies on the table, .5 has F 2/3.
  const std::vector<RiskPoint> points = riskCoverage (evaluationOf ("a").systems.front (), GroundTruthKind::objects);
  ASSERT_EQ (points.size (), 3u);
  EXPECT_DOUBLE_EQ (points[0].coverage, 1.0 / 3);
  EXPECT_DOUBLE_EQ (points[0].risk, 0);
  EXPECT_DOUBLE_EQ (points[1].coverage, 2.0 / 3);
  EXPECT_DOUBLE_EQ (points[1].risk, .5);
  EXPECT_DOUBLE_EQ (points[2].coverage, 1);
  EXPECT_DOUBLE_EQ (points[2].risk, 1 - (1 + 2.0 / 3) / 3);
}

TEST (Evaluation, mediansOfTimes)
{
  SystemEvaluation system = evaluationOf ("a").systems.front ();
  system.scenes.push_back (system.scenes.front ());
  system.scenes[0].milliseconds[0].second = 50;
  system.scenes[1].milliseconds[0].second = 7;
  const std::vector<std::pair<std::string, double>> expected{{"patches", 7}, {"total", 10}};
  EXPECT_EQ (medianTimes (system), expected);
}

TEST (ReportPage, refersToNothingOutsideAndShowsEveryPicture)
{
  std::vector<std::string> asked;
  const std::string page =
      reportPage (evaluationOf ("proposed"), [&] (const std::string& system, const std::string& scene) {
        asked.push_back (system + "/" + scene);
        return (std::string ("PNG\0<", 5));
      });
  const std::regex reference ("(src|href)=\"(?!data:)|url\\(|@import|<script|<link");
  EXPECT_FALSE (std::regex_search (page, reference));
  EXPECT_NE (page.find ("src=\"data:image/png;base64,UE5HADw=\""), std::string::npos);
  for (const char* picture : {"/one", "/two", "proposed/one", "proposed/two"})
    EXPECT_NE (std::find (asked.begin (), asked.end (), picture), asked.end ()) << picture;
  EXPECT_EQ (page.find ("<bowls>"), std::string::npos);
  EXPECT_NE (page.find ("&lt;bowls&gt;"), std::string::npos);
  EXPECT_EQ (page.find ("nan"), std::string::npos);
  EXPECT_EQ (page.substr (page.size () - 8), "</html>\n");
}

TEST (ReportPage, chartsOfASweep)
{
  Evaluation evaluation = evaluationOf ("paper");
  EXPECT_EQ (reportPage (evaluation, [] (auto&, auto&) { return (""); }).find ("Figure 3"), std::string::npos);
  for (const double theta_com : {.015, .002})
  {
    evaluation.systems.push_back (evaluation.systems.front ());
    evaluation.systems.back ().swept = "paper";
    evaluation.systems.back ().theta_com = theta_com;
  }
  ASSERT_EQ (evaluation.sweepOf ("paper").size (), 2u);
  EXPECT_EQ (evaluation.sweepOf ("paper").front ()->theta_com, .002);
  const std::string page = reportPage (evaluation, [] (auto&, auto&) { return (""); });
  EXPECT_NE (page.find ("Figure 3"), std::string::npos);
  EXPECT_NE (page.find (">paper, first, strict</text>"), std::string::npos);
}

TEST (Charts, pointsAreWhereTheAxesSay)
{
  const std::string chart = lineChart ({"x", 0, 10, 5}, {"y", 0, 1, .5}, {{"a & b", {{0, 0}, {10, 1}}, 1, true, true}});
  // 480 x 280 pixels from (60, 12) on
  EXPECT_NE (chart.find ("<polyline points=\"60.0,292.0 540.0,12.0 \" stroke=\"#d55e00\""), std::string::npos) << chart;
  EXPECT_NE (chart.find ("a &amp; b"), std::string::npos);
  EXPECT_NE (chart.find (">0.5</text>"), std::string::npos);
  const std::string bars = barChart ("ms", {{"fast", {{"one", 10}, {"two", 20}}}, {"slow", {{"two", 60}}}});
  EXPECT_NE (bars.find ("x=\"130.0\" y=\"16.0\" width=\"80.0\""), std::string::npos) << bars;
  EXPECT_NE (bars.find ("x=\"210.0\" y=\"16.0\" width=\"160.0\""), std::string::npos) << bars;
  EXPECT_NE (bars.find ("x=\"130.0\" y=\"44.0\" width=\"480.0\""), std::string::npos) << bars;
}

} // namespace
} // namespace pcl_attention
