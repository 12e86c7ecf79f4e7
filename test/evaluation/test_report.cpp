// SPDX-License-Identifier: BSD-3-Clause
#include "cases.h"
#include "evaluation/report.h"

namespace pcl_attention
{
namespace
{

std::vector<SceneScore>
twoObjects ()
{
  const GroundTruth truth = test::truthOf (4, {20, 20, 31, 1});
  SceneScore score = scoreScene (truth, test::predictionOf (4, 1, {test::segmentAt (0, 0, {0})}));
  score.name = "a,b";
  score.category = "table";
  return {score};
}

TEST (Report, objectsCsv)
{
  std::ostringstream stream;
  writeObjectsCsv (stream, twoObjects ());
  EXPECT_EQ (stream.str (),
             "scene,category,ground_truth,object,pixels,center_column,center_row,attended,points,first_rank,"
             "first_precision,first_recall,first_f,best_f,all_f,best_of_scene_f,center_f\n"
             "\"a,b\",table,objects,2,2,0,0,1,1,1,1,0.5,0.666667,0.666667,0.666667,0.666667,0.666667\n"
             "\"a,b\",table,objects,3,1,2,0,0,0,,0,0,0,0,0,0,0\n");
}

TEST (Report, summaryCsvHasAsManyValuesAsItsHeader)
{
  std::ostringstream stream;
  writeSummaryCsv (stream, summarizeByCategory (GroundTruthKind::objects, twoObjects ()));
  std::istringstream lines (stream.str ());
  std::string header, row, rest;
  std::getline (lines, header);
  std::getline (lines, row);
  EXPECT_EQ (std::count (header.begin (), header.end (), ','), std::count (row.begin (), row.end (), ','));
  EXPECT_FALSE (std::getline (lines, rest));
  EXPECT_EQ (header.substr (0, 86),
             "ground_truth,group,scenes,objects,attended,points,attended_first_f,attended_first_f_de");
  EXPECT_EQ (row.substr (0, 46), "objects,overall,1,2,1,1,0.666667,0,0.666667,0,");
  EXPECT_EQ (row.back (), ','); // no confidences: no correlation
}

TEST (Report, tables)
{
  std::ostringstream stream;
  printTables (stream, summarizeByCategory (GroundTruthKind::objects, twoObjects ()));
  EXPECT_NE (stream.str ().find ("Ground truth: objects (label / 10)"), std::string::npos);
  EXPECT_NE (stream.str ().find ("0.667 +-0.000"), std::string::npos);
  EXPECT_NE (stream.str ().find ("0.333 +-0.333"), std::string::npos);
  EXPECT_EQ (stream.str ().find ("nan"), std::string::npos);
}

} // namespace
} // namespace pcl_attention
