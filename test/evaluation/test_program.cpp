// SPDX-License-Identifier: BSD-3-Clause
// pcl_attention_evaluate as its users run it.
#include "program_test.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/png_io.h>

#include <regex>

namespace pcl_attention
{
namespace
{

class EvaluateProgram : public test::ProgramTest
{
protected:
  /** \brief Two labelled scenes of 4x2 pixels in data/, exact results in results/. */
  EvaluateProgram ()
  {
    std::filesystem::create_directories (folder_ / "data");
    const auto cloud = test::cloudOf (4, {20, 20, 1, 1, 20, 20, 1, 1});
    for (const std::string name : {"first", "second"})
    {
      pcl::io::savePCDFileBinary (folder_ / ("data/" + name + ".pcd"), cloud);
      const std::string results = "results/" + name + "/";
      std::filesystem::create_directories (folder_ / results);
      test::writeText (folder_ / (results + "attention_points.csv"),
                       "rank,column,row,x,y,z,saliency,kind,mask_points\n1,0,0,0,0,1,1,junction,4\n");
      const std::vector<unsigned char> mask{255, 255, 0, 0, 255, 255, 0, 0};
      pcl::io::saveCharPNGFile (folder_ / (results + "mask_0001.png"), mask.data (), 4, 2, 1);
    }
  }
};

TEST_F (EvaluateProgram, scoresAFolder)
{
  const test::Outcome result = run ("data -results results -csv objects.csv -summary_csv summary.csv");
  EXPECT_EQ (result.exit_code, 0) << result.errors;
  EXPECT_TRUE (std::regex_match (result.errors, std::regex ("scene 1/2 first, \\d+ s left\nscene 2/2 second\n")))
      << result.errors;
  EXPECT_NE (result.output.find ("Ground truth: objects"), std::string::npos);
  EXPECT_NE (result.output.find ("Ground truth: parts"), std::string::npos);
  EXPECT_NE (result.output.find ("1.000 +-0.000"), std::string::npos);

  const std::string objects = test::readText (folder_ / "objects.csv");
  EXPECT_EQ (std::count (objects.begin (), objects.end (), '\n'), 1 + 4);
  EXPECT_NE (objects.find ("second,data,parts,20,4,0,0,1,1,1,1,1,1,1,1,1,1\n"), std::string::npos);
  const std::string summary = test::readText (folder_ / "summary.csv");
  EXPECT_EQ (std::count (summary.begin (), summary.end (), '\n'), 1 + 2);
}

TEST_F (EvaluateProgram, oneSceneOnOneGroundTruthIsQuiet)
{
  const test::Outcome result = run ("data/first.pcd -results results -ground_truth parts");
  EXPECT_EQ (result.exit_code, 0);
  EXPECT_EQ (result.errors, "");
  EXPECT_EQ (result.output.find ("Ground truth: objects"), std::string::npos);
  EXPECT_NE (result.output.find ("Ground truth: parts"), std::string::npos);
}

TEST_F (EvaluateProgram, aBrokenSceneIsAnErrorThatNamesTheFileAndWritesNothing)
{
  std::filesystem::remove (folder_ / "results/second/mask_0001.png");
  const test::Outcome result = run ("data -results results -csv objects.csv -summary_csv summary.csv");
  EXPECT_EQ (result.exit_code, 1);
  EXPECT_EQ (result.output, "");
  EXPECT_NE (result.errors.find ("pcl_attention_evaluate: results/second/mask_0001.png: missing\n"), std::string::npos)
      << result.errors;
  EXPECT_FALSE (std::filesystem::exists (folder_ / "objects.csv"));
  EXPECT_FALSE (std::filesystem::exists (folder_ / "summary.csv"));
}

TEST_F (EvaluateProgram, missingThingsAreErrors)
{
  std::filesystem::remove_all (folder_ / "results/second");
  EXPECT_EQ (run ("data/second.pcd -results results").errors,
             "pcl_attention_evaluate: results/second: no such folder of results\n");
  EXPECT_EQ (run ("data/none.pcd -results results").errors,
             "pcl_attention_evaluate: data/none.pcd: no such file or folder\n");
  EXPECT_EQ (run ("data/first.pcd -results results -csv none/a.csv").exit_code, 1);
}

TEST_F (EvaluateProgram, asksForEveryObject)
{
  const test::Outcome result = run ("data -asked_for all");
  EXPECT_EQ (result.exit_code, 0) << result.errors;
  // Scenes of 8 pixels have no segments: the rank is one more than there are.
  for (const char* kind : {"map", "region", "exemplar", "color_name", "size", "coarse_distance"})
    EXPECT_NE (result.output.find (std::string ("\n  ") + kind + " "), std::string::npos) << result.output;
  EXPECT_NE (result.output.find ("        2    1.000    1.000"), std::string::npos) << result.output;
  EXPECT_EQ (run ("data -asked_for taste").exit_code, 2);
  EXPECT_EQ (run ("data -asked_for map -results results").exit_code, 2);
}

TEST_F (EvaluateProgram, aBadCommandLineIsAnErrorOfItsOwn)
{
  EXPECT_EQ (run ("").exit_code, 2);
  EXPECT_EQ (run ("data -results").exit_code, 2);
  EXPECT_EQ (run ("data -results results -unknown").exit_code, 2);
  const test::Outcome result = run ("data -results results -ground_truth pixels");
  EXPECT_EQ (result.exit_code, 2);
  EXPECT_NE (result.errors.find ("-ground_truth is objects, parts or both, not \"pixels\""), std::string::npos);
  EXPECT_EQ (run ("data -systems proposed,mine").exit_code, 2);
  EXPECT_NE (run ("data -systems mine").errors.find ("of M09+TJ3D, M09+WTA2D, M09+WTA3D, M11, G10, proposed, paper"), std::string::npos);
  for (const char* values : {"", "5,", "0", "5mm", "-1", "nan"})
    EXPECT_EQ (run (std::string ("data -sweep '") + values + "'").exit_code, 2) << values;
  for (const char* shard : {"1", "0/2", "3/2", "1/2/3", "a/b", "1/"})
    EXPECT_EQ (run (std::string ("data -output_dir out -shard ") + shard).exit_code, 2) << shard;
  EXPECT_EQ (run ("data -shard 1/2").exit_code, 2);
  EXPECT_EQ (run ("data -jobs -1").exit_code, 2);
  EXPECT_EQ (run ("-h").exit_code, 0);
}

} // namespace
} // namespace pcl_attention
