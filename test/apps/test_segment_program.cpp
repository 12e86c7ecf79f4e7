// SPDX-License-Identifier: BSD-3-Clause
// pcl_attention_segment as its users run it.
#include "evaluation/results.h"
#include "files.h"
#include "png_image.h"
#include "scene_renderer.h"
#include "segment_writer.h"

#include <nlohmann/json.hpp>
#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/io/png_io.h>

#include <limits>
#include <sys/wait.h>

using namespace pcl_attention;
using Names = std::set<std::string>;
using Json = nlohmann::json;

namespace
{

struct Outcome
{
  int exit_code;
  std::string output, errors;
};

pcl::PointCloud<pcl::PointXYZRGBL>
rendered (std::uint64_t seed = 1)
{
  SceneDescription description = makeScene (SceneKind::separate, seed);
  description.camera = description.camera.resized (320, 240);
  return (*renderScene (description, seed));
}

class SegmentProgram : public testing::Test
{
protected:
  test::TemporaryFolder folder_;

  /** \brief Run in the test's folder, with the flag that every run needs.
   * \param[in] wrapper shell commands to run before */
  Outcome
  run (const std::string& arguments, const std::string& wrapper = "")
  {
    const std::string command = "cd '" + (folder_ / "") + "' && " + wrapper +
                                " unset DISPLAY; '" PCL_ATTENTION_SEGMENT "' " + arguments +
                                " > stdout.txt 2> stderr.txt";
    const int status = std::system (("bash -c \"" + command + "\"").c_str ());
    EXPECT_TRUE (WIFEXITED (status));
    const Outcome outcome{WEXITSTATUS (status), test::readText (folder_ / "stdout.txt"),
                          test::readText (folder_ / "stderr.txt")};
    std::filesystem::remove (folder_ / "stdout.txt");
    std::filesystem::remove (folder_ / "stderr.txt");
    return (outcome);
  }

  /** \brief One line on stderr that holds the text, nothing on stdout, no results. */
  void
  expectError (const std::string& arguments, int exit_code, const std::string& text)
  {
    const Outcome outcome = run (arguments);
    EXPECT_EQ (outcome.exit_code, exit_code) << arguments << "\n" << outcome.errors;
    EXPECT_EQ (outcome.output, "") << arguments;
    EXPECT_EQ (outcome.errors.find ("pcl_attention_segment: "), 0u) << outcome.errors;
    EXPECT_NE (outcome.errors.find (text), std::string::npos) << outcome.errors;
    EXPECT_EQ (std::count (outcome.errors.begin (), outcome.errors.end (), '\n'), 1) << outcome.errors;
    EXPECT_EQ (test::namesIn (folder_ / "out"), Names{}) << arguments;
  }

  template <typename PointT>
  void
  save (const std::string& name, const pcl::PointCloud<PointT>& cloud)
  {
    std::filesystem::create_directories (std::filesystem::path (folder_ / name).parent_path ());
    pcl::io::savePCDFileBinary (folder_ / name, cloud);
  }
};

TEST_F (SegmentProgram, writesTheContractsFilesConsistently)
{
  const auto cloud = rendered ();
  save ("scene.pcd", cloud);
  const Outcome outcome = run ("scene.pcd -output_dir out/deep");
  EXPECT_EQ (outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ (outcome.errors, "");
  EXPECT_EQ (outcome.output.find ("out/deep/scene: "), 0u) << outcome.output;
  EXPECT_EQ (std::count (outcome.output.begin (), outcome.output.end (), '\n'), 1);
  EXPECT_EQ (test::namesIn (folder_ / "out/deep"), Names{"scene"});

  // Reading the results checks ranks, sizes, values of the masks and ranges.
  const ScenePrediction prediction = readResults (folder_ / "out/deep/scene", 320, 240);
  ASSERT_FALSE (prediction.segments.empty ());
  EXPECT_EQ (prediction.labels, labelsOfMasks (320, 240, prediction.segments));
  Names expected{"attention_points.csv", "segments.json", "labels.pcd", "overview.png", "summary.json"};
  for (std::size_t i = 0; i < prediction.segments.size (); ++i)
    expected.insert (maskFileName (static_cast<int> (i) + 1));
  EXPECT_EQ (test::namesIn (folder_ / "out/deep/scene"), expected);

  const Json segments = Json::parse (test::readText (folder_ / "out/deep/scene/segments.json"));
  const Json summary = Json::parse (test::readText (folder_ / "out/deep/scene/summary.json"));
  ASSERT_EQ (segments["segments"].size (), prediction.segments.size ());
  EXPECT_EQ (summary["counts"]["segments"], prediction.segments.size ());
  EXPECT_EQ (summary["counts"]["points"], 320 * 240);
  std::istringstream csv (test::readText (folder_ / "out/deep/scene/attention_points.csv"));
  std::string line;
  std::getline (csv, line);
  EXPECT_EQ (line, "rank,column,row,x,y,z,saliency,kind,mask_points");
  for (std::size_t i = 0; i < prediction.segments.size (); ++i)
  {
    std::getline (csv, line);
    std::istringstream cells (line);
    std::vector<std::string> values;
    for (std::string cell; std::getline (cells, cell, ',');)
      values.push_back (cell);
    ASSERT_EQ (values.size (), 9u) << line;
    const PredictedSegment& segment = prediction.segments[i];
    const auto& point = cloud (segment.column, segment.row);
    EXPECT_TRUE (pcl::isFinite (point));
    EXPECT_EQ (std::stof (values[3]), point.x);
    EXPECT_EQ (std::stof (values[4]), point.y);
    EXPECT_EQ (std::stof (values[5]), point.z);
    EXPECT_EQ (values[8], std::to_string (segment.mask.size ()));
    EXPECT_EQ (segments["segments"][i]["rank"], i + 1);
    EXPECT_EQ (segments["segments"][i]["points"], segment.mask.size ());
    for (const auto index : segment.mask)
      ASSERT_TRUE (pcl::isFinite (cloud[index])) << "a segment on a hole";
  }
}

TEST_F (SegmentProgram, asksForWhatItIsTold)
{
  save ("scene.pcd", rendered ());
  Image<std::uint8_t> map (320, 240, 0);
  for (int row = 0; row < 240; ++row)
    for (int column = 160; column < 320; ++column)
      map (column, row) = 255;
  test::writeText (folder_ / "map.png", encodePng (map));
  const Outcome outcome = run ("scene.pcd -output_dir out -prior_map map.png -prior_region 160,0,160,240 -prior_color 200,30,30 "
                               "-prior_size 0.05,0.3 -prior_distance 0.2,3 -prior_box -5,-5,0,5,5,5");
  EXPECT_EQ (outcome.exit_code, 0) << outcome.errors;
  const Json summary = Json::parse (test::readText (folder_ / "out/scene/summary.json"));
  EXPECT_EQ (summary["prior"], Json::parse (R"({"map": "map.png", "region": [160, 0, 160, 240], "color": [200, 30, 30],
                                                "size": [0.05, 0.3], "distance": [0.2, 3.0],
                                                "box": [-5.0, -5.0, 0.0, 5.0, 5.0, 5.0]})"));
  const ScenePrediction prediction = readResults (folder_ / "out/scene", 320, 240);
  ASSERT_FALSE (prediction.segments.empty ());
  EXPECT_GE (prediction.segments.front ().column, 160);
  const Json segments = Json::parse (test::readText (folder_ / "out/scene/segments.json"))["segments"];
  EXPECT_GT (segments.front ()["attention_point"]["weight"], segments.back ()["attention_point"]["weight"]);

  EXPECT_EQ (run ("scene.pcd -output_dir plain").exit_code, 0);
  EXPECT_FALSE (Json::parse (test::readText (folder_ / "plain/scene/summary.json")).contains ("prior"));
  EXPECT_EQ (readResults (folder_ / "plain/scene", 320, 240).segments.size (), prediction.segments.size ());
  EXPECT_EQ (run ("scene.pcd -output_dir red -prior_color red").exit_code, 0);
}

TEST_F (SegmentProgram, refusesWhatCannotBeAskedFor)
{
  save ("scene.pcd", rendered ());
  pcl::PointCloud<pcl::PointXYZ> colorless;
  pcl::copyPointCloud (rendered (), colorless);
  test::writeText (folder_ / "small.png", encodePng (Image<std::uint8_t> (10, 10, 255)));
  for (const char* flag : {"-prior_map none.png", "-prior_region 1,2,3", "-prior_region 1,2,3,4,5", "-prior_region 1,2,0,4",
                           "-prior_region a,b,c,d", "-prior_color pinkish", "-prior_color 1,2,256", "-prior_size 0.3,0.2",
                           "-prior_size 0.3", "-prior_distance -1,2", "-prior_distance 0,inf", "-prior_box 1,1,1,0,2,2"})
    expectError (std::string ("scene.pcd -output_dir out ") + flag, 2, std::string (flag).substr (0, 10));
  expectError ("scene.pcd -output_dir out -prior_map small.png", 1, "small.png: 10x10 pixels, the scene has 320x240");
  expectError ("scene.pcd -output_dir out -prior_map scene.pcd", 1, "not a readable PNG file");
  expectError ("scene.pcd -output_dir out -prior_region 320,0,5,5", 1, "the region of the prior");
  save ("colorless.pcd", colorless);
  const Outcome outcome = run ("colorless.pcd -output_dir out -prior_color red");
  EXPECT_EQ (outcome.exit_code, 1);
  EXPECT_NE (outcome.errors.find ("the prior asks for a colour, but the cloud has none"), std::string::npos);
}

TEST_F (SegmentProgram, printsItsHelpWithTheFlagsAsTheyAreWritten)
{
  const Outcome outcome = run ("-h");
  EXPECT_EQ (outcome.exit_code, 0);
  EXPECT_EQ (outcome.output.find ("--"), std::string::npos) << outcome.output;
  for (const ParameterDescription& row : parameterTable ())
  {
    EXPECT_NE (outcome.output.find ("\n   -" + row.name + " arg"), std::string::npos) << row.name;
    EXPECT_NE (outcome.output.find ("\nStage " + row.stage + ":\n"), std::string::npos) << row.stage;
  }
}

TEST_F (SegmentProgram, failsWhereItsOutputCannotBeWritten)
{
  save ("scene.pcd", rendered ());
  for (const char* arguments : {"-h", "scene.pcd -output_dir out"})
  {
    const std::string command = "cd '" + (folder_ / "") + "' && '" PCL_ATTENTION_SEGMENT "' " + arguments +
                                " > /dev/full 2> stderr.txt";
    EXPECT_EQ (WEXITSTATUS (std::system (command.c_str ())), 1) << arguments;
    EXPECT_NE (test::readText (folder_ / "stderr.txt").find ("standard output cannot be written"), std::string::npos);
  }
}

TEST_F (SegmentProgram, resultsDoNotDependOnThreads)
{
  save ("scene.pcd", rendered ());
  EXPECT_EQ (run ("scene.pcd -output_dir one -threads 1").exit_code, 0);
  EXPECT_EQ (run ("scene.pcd -output_dir many -threads 4").exit_code, 0);
  for (const char* name : {"attention_points.csv", "segments.json", "labels.pcd", "overview.png", "mask_0001.png"})
    EXPECT_EQ (test::readText (folder_ / ("one/scene/" + std::string (name))),
               test::readText (folder_ / ("many/scene/" + std::string (name))))
        << name;
}

TEST_F (SegmentProgram, parametersOfASummaryRepeatARun)
{
  save ("scene.pcd", rendered ());
  EXPECT_EQ (run ("scene.pcd -output_dir first -preset paper -levels 3").exit_code, 0);
  const Json first = Json::parse (test::readText (folder_ / "first/scene/summary.json"));
  EXPECT_EQ (first["parameters"]["levels"], 3);
  EXPECT_EQ (first["parameters"]["preset"], "paper");
  test::writeText (folder_ / "p.json", first["parameters"].dump ());
  const Outcome outcome = run ("scene.pcd -output_dir second -parameters p.json");
  EXPECT_EQ (outcome.exit_code, 0) << outcome.errors;
  const Json second = Json::parse (test::readText (folder_ / "second/scene/summary.json"));
  EXPECT_EQ (second["parameters"], first["parameters"]);
  EXPECT_EQ (test::readText (folder_ / "second/scene/segments.json"),
             test::readText (folder_ / "first/scene/segments.json"));
}

TEST_F (SegmentProgram, replacesAnOlderResultAsAWhole)
{
  save ("scene.pcd", rendered ());
  test::writeText (folder_ / "out/scene/mask_9999.png", "old");
  test::writeText (folder_ / "out/scene/notes/text", "old");
  test::writeText (folder_ / "out/.pcl_attention-new-1-0/half", "left by a killed run");
  EXPECT_EQ (run ("scene.pcd -output_dir out").exit_code, 0);
  const Names names = test::namesIn (folder_ / "out/scene");
  EXPECT_EQ (names.count ("mask_9999.png") + names.count ("notes"), 0u);
  EXPECT_EQ (names.count ("summary.json"), 1u);
  EXPECT_EQ (test::namesIn (folder_ / "out"), Names{"scene"});
}

TEST_F (SegmentProgram, worksWithoutColourAndSaysSoOnce)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::copyPointCloud (rendered (), cloud);
  save ("in/a.pcd", cloud);
  save ("in/b.pcd", cloud);
  const Outcome outcome = run ("in -output_dir out");
  EXPECT_EQ (outcome.exit_code, 0) << outcome.errors;
  const std::string said = "no colour: the colour constraint is off";
  ASSERT_NE (outcome.errors.find (said), std::string::npos) << outcome.errors;
  EXPECT_EQ (outcome.errors.find (said), outcome.errors.rfind (said));
  EXPECT_NE (outcome.errors.find ("[2/2] b.pcd: "), std::string::npos);
  EXPECT_NO_THROW (readResults (folder_ / "out/a", 320, 240));
}

TEST_F (SegmentProgram, oneBadSceneDoesNotStopTheOthers)
{
  const auto cloud = rendered ();
  save ("in/a.pcd", cloud);
  test::writeText (folder_ / "in/b.pcd", "nonsense");
  save ("in/c.pcd", cloud);
  const Outcome outcome = run ("in -output_dir out");
  EXPECT_EQ (outcome.exit_code, 1);
  EXPECT_NE (outcome.errors.find ("in/b.pcd: not a PCD file\n"), std::string::npos) << outcome.errors;
  EXPECT_NE (outcome.errors.find ("1 of 3 scenes failed\n"), std::string::npos) << outcome.errors;
  EXPECT_EQ (test::namesIn (folder_ / "out"), (Names{"a", "c"}));
}

TEST_F (SegmentProgram, reportsScenesInTheOrderTheyAreGivenIn)
{
  // The small one and the one that cannot be read are done long before the others could be.
  save ("large.pcd", rendered (2));
  pcl::PointCloud<pcl::PointXYZRGB> small (32, 24);
  for (int index = 0; index < 32 * 24; ++index)
    small[index].getVector3fMap () << 0.002f * static_cast<float> (index % 32 - 16),
        0.002f * static_cast<float> (index / 32 - 12), 1.0f;
  save ("small.pcd", small);
  test::writeText (folder_ / "bad.pcd", "nonsense");
  save ("last.pcd", rendered (3));
  const Outcome outcome = run ("large.pcd small.pcd bad.pcd last.pcd -output_dir out");
  EXPECT_EQ (outcome.exit_code, 1);
  std::size_t at = 0;
  for (const char* text : {"[1/4] large.pcd: ", "[2/4] small.pcd: ", "bad.pcd: not a PCD file", "[4/4] last.pcd: "})
  {
    const std::size_t found = outcome.errors.find (text, at);
    ASSERT_NE (found, std::string::npos) << text << " in\n" << outcome.errors;
    at = found;
  }
  EXPECT_LT (outcome.output.find ("out/large: "), outcome.output.find ("out/small: "));
  EXPECT_LT (outcome.output.find ("out/small: "), outcome.output.find ("out/last: "));
}

TEST_F (SegmentProgram, givesTheSameForAStreamAsForEachScene)
{
  for (const int seed : {1, 2, 3})
  {
    save ("in/" + std::to_string (seed) + ".pcd", rendered (seed));
    EXPECT_EQ (run ("in/" + std::to_string (seed) + ".pcd -output_dir single").exit_code, 0);
  }
  EXPECT_EQ (run ("in -output_dir stream").exit_code, 0);
  for (const char* name : {"1/segments.json", "2/segments.json", "3/segments.json", "3/labels.pcd", "3/attention_points.csv"})
    EXPECT_EQ (test::readText (folder_ / ("single/" + std::string (name))),
               test::readText (folder_ / ("stream/" + std::string (name))))
        << name;
}

TEST_F (SegmentProgram, refusesBadInputsWithOneLine)
{
  const std::string flags = " -output_dir out";
  expectError ("missing.pcd" + flags, 1, "missing.pcd");
  test::writeText (folder_ / "text.pcd", "no cloud\n");
  expectError ("text.pcd" + flags, 1, "text.pcd: not a PCD file");
  test::writeText (folder_ / "nothing.pcd", "");
  expectError ("nothing.pcd" + flags, 1, "nothing.pcd: an empty file");
  test::writeText (folder_ / "empty.pcd",
                   "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 0\nHEIGHT 0\n"
                   "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 0\nDATA ascii\n");
  expectError ("empty.pcd" + flags, 1, "empty.pcd: no points");
  std::filesystem::create_directory (folder_ / "no_scenes");
  expectError ("no_scenes" + flags, 1, "no_scenes");

  save ("whole.pcd", rendered ());
  const std::string whole = test::readText (folder_ / "whole.pcd");
  test::writeText (folder_ / "truncated.pcd", whole.substr (0, whole.size () / 2));
  expectError ("truncated.pcd" + flags, 1, "truncated.pcd: truncated: the header announces 76800 points");

  auto cloud = rendered ();
  cloud.width = static_cast<std::uint32_t> (cloud.size ());
  cloud.height = 1;
  save ("unorganized.pcd", cloud);
  expectError ("unorganized.pcd" + flags, 1, "unorganized.pcd: not organized");
  save ("pixel.pcd", test::wallBefore<pcl::PointXYZRGB> (1, 1));
  expectError ("pixel.pcd" + flags, 1, "pixel.pcd: not organized");
  save ("row.pcd", test::wallBefore<pcl::PointXYZRGB> (640, 1));
  expectError ("row.pcd" + flags, 1, "row.pcd: not organized");

  auto holes = rendered ();
  for (auto& point : holes)
    point.x = point.y = point.z = std::numeric_limits<float>::quiet_NaN ();
  save ("holes.pcd", holes);
  expectError ("holes.pcd" + flags, 1, "holes.pcd: no valid point");
}

TEST_F (SegmentProgram, givesNoObjectsWhereThereIsNoRoomForAny)
{
  save ("column.pcd", test::wallBefore<pcl::PointXYZRGB> (1, 480));
  save ("tiny.pcd", test::wallBefore<pcl::PointXYZRGB> (2, 2));
  const Outcome outcome = run ("column.pcd tiny.pcd -output_dir out");
  EXPECT_EQ (outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ (test::readText (folder_ / "out/tiny/attention_points.csv"),
             "rank,column,row,x,y,z,saliency,kind,mask_points\n");
  EXPECT_TRUE (readResults (folder_ / "out/column", 1, 480).segments.empty ());
}

TEST_F (SegmentProgram, refusesTwoScenesOfTheSameStem)
{
  save ("a/scene.pcd", rendered ());
  save ("b/scene.pcd", rendered ());
  expectError ("a b -output_dir out", 1, "scene.pcd");
  expectError ("a a/scene.pcd -output_dir out", 1, "scene.pcd");
}

TEST_F (SegmentProgram, refusesABadCommandLine)
{
  save ("scene.pcd", rendered ());
  expectError ("", 2, "no scene given");
  expectError ("scene.pcd", 2, "-output_dir is missing");
  expectError ("scene.pcd -output_dir", 2, "output_dir");
  expectError ("scene.pcd -output_dir out -no_such_flag 3", 2, "no_such_flag");
  expectError ("scene.pcd -output_dir out -levels many", 2, "levels is 'many', but must be a whole number from 1 to 8");
  expectError ("scene.pcd -output_dir out -threads -1", 2, "threads");
  expectError ("scene.pcd -output_dir out -threads x", 2, "threads");
  expectError ("scene.pcd -output_dir out -preset best", 2, "must be one of default paper");
  test::writeText (folder_ / "p.json", R"({"levels": "3"})");
  expectError ("scene.pcd -output_dir out -parameters p.json", 2, "p.json: levels is \"3\", but must be a number");
  const Outcome help = run ("-h");
  EXPECT_EQ (help.exit_code, 0);
  EXPECT_EQ (help.output.find ("Usage: pcl_attention_segment SCENE... -output_dir DIR"), 0u);
}

TEST_F (SegmentProgram, refusesAnOutputThatCannotBeWritten)
{
  save ("scene.pcd", rendered ());
  test::writeText (folder_ / "file", "text");
  expectError ("scene.pcd -output_dir file", 1, "file: cannot be made: Not a directory");
  expectError ("scene.pcd -output_dir file/below", 1, "file/below: cannot be made");
  expectError ("scene.pcd -output_dir /proc/out", 1, "/proc/out: cannot be made");

  test::writeText (folder_ / "full/scene", "in the way");
  expectError ("scene.pcd -output_dir full", 1, "full/scene: a file or link is in the way of the results folder");
  EXPECT_EQ (test::readText (folder_ / "full/scene"), "in the way");
}

TEST_F (SegmentProgram, leavesTheOlderResultWhereTheNewOneCannotBeWritten)
{
  save ("scene.pcd", rendered ());
  test::writeText (folder_ / "out/scene/old", "old");
  // A limit of 8 blocks of 1024 bytes stands in for a full disk: the files of text fit, the cloud does not.
  const Outcome outcome = run ("scene.pcd -output_dir out", "trap '' XFSZ; ulimit -f 8;");
  EXPECT_EQ (outcome.exit_code, 1);
  EXPECT_NE (outcome.errors.find ("cannot be written: File too large"), std::string::npos) << outcome.errors;
  EXPECT_EQ (std::count (outcome.errors.begin (), outcome.errors.end (), '\n'), 1) << outcome.errors;
  EXPECT_EQ (test::namesIn (folder_ / "out"), Names{"scene"});
  EXPECT_EQ (test::readText (folder_ / "out/scene/old"), "old");
}

TEST_F (SegmentProgram, FindsTheSameInEveryFormOfAScene)
{
  // Depths in whole millimetres, so that an image can hold them, and points as the intrinsics give them.
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  pcl::copyPointCloud (rendered (), cloud);
  const SceneCamera camera = SceneCamera ().resized (320, 240);
  std::vector<std::uint16_t> depths;
  std::vector<std::uint8_t> colors;
  for (std::size_t i = 0; i < cloud.size (); ++i)
  {
    pcl::PointXYZRGB& point = cloud[i];
    depths.push_back (std::isfinite (point.z) ? static_cast<std::uint16_t> (std::lround (1000.0f * point.z)) : 0);
    colors.insert (colors.end (), {point.r, point.g, point.b});
    const double depth = depths.back () * 0.001;
    point.x = static_cast<float> ((static_cast<double> (i % 320) - camera.center_x) / camera.focal_length * depth);
    point.y = static_cast<float> ((static_cast<double> (i / 320) - camera.center_y) / camera.focal_length * depth);
    point.z = static_cast<float> (depth);
    if (depths.back () == 0)
      point.x = point.y = point.z = std::numeric_limits<float>::quiet_NaN ();
  }
  const auto number = [] (double value) { return (Json (value).dump ()); };
  const std::string intrinsics = " -intrinsics " + number (camera.focal_length) + "," + number (camera.focal_length) +
                                 "," + number (camera.center_x) + "," + number (camera.center_y);
  save ("a.pcd", cloud);
  pcl::PLYWriter ().write (folder_ / "b.ply", cloud, true, true);
  pcl::io::saveShortPNGFile (folder_ / "c.png", depths.data (), 320, 240, 1);
  pcl::io::saveRgbPNGFile (folder_ / "color.png", colors.data (), 320, 240);
  cloud.width = static_cast<std::uint32_t> (cloud.size ());
  cloud.height = 1;
  std::reverse (cloud.begin (), cloud.end ());
  save ("d.pcd", cloud);

  EXPECT_EQ (run ("a.pcd b.ply -output_dir out").exit_code, 0);
  const Outcome outcome = run ("c.png -output_dir out -color color.png" + intrinsics);
  EXPECT_EQ (outcome.exit_code, 0) << outcome.errors;
  EXPECT_NE (outcome.errors.find ("c.png: depth 0."), std::string::npos) << outcome.errors;
  EXPECT_EQ (run ("d.pcd -output_dir out" + intrinsics + ",320,240").exit_code, 0);

  const Names files = test::namesIn (folder_ / "out/a");
  EXPECT_GE (files.size (), 8u) << "two objects at least";
  for (const char* other : {"b", "c", "d"})
  {
    EXPECT_EQ (test::namesIn (folder_ / ("out/" + std::string (other))), files) << other;
    for (const std::string& file : files)
    {
      // Times differ, and the colour of holes, which an unorganized cloud does not tell.
      if (file == "summary.json" || (other == std::string ("d") && (file == "labels.pcd" || file == "overview.png")))
        continue;
      EXPECT_TRUE (test::readText (folder_ / ("out/" + std::string (other) + "/" + file)) ==
                   test::readText (folder_ / ("out/a/" + file)))
          << other << ": " << file;
    }
  }
}

TEST_F (SegmentProgram, ChecksTheFlagsOfTheScene)
{
  save ("a.pcd", rendered ());
  expectError ("a.pcd -output_dir out -max_range 0", 2, "-max_range is 0, but must be above 0 metres");
  expectError ("a.pcd -output_dir out -depth_scale 5000", 2, "-depth_scale is 5000, but must be above 0 and at most 1");
  expectError ("a.pcd -output_dir out -intrinsics 525", 2, "-intrinsics '525': neither a JSON file nor numbers");
  expectError ("a.pcd -output_dir out -max_range 0.1", 1, "a.pcd: all points are beyond -max_range 0.1 m");
}

} // namespace
