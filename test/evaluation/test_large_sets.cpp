// SPDX-License-Identifier: BSD-3-Clause
// Evaluations that are interrupted, resumed, shared and merged give the report of one that was not.
#include "program_test.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <thread>

namespace fs = std::filesystem;

namespace pcl_attention
{
namespace
{

const std::vector<std::string> same_reports{"report.csv", "objects.csv", "report.json", "report.md"};

class LargeSets : public test::ProgramTest
{
protected:
  static constexpr int scenes_ = 6;

  LargeSets ()
  {
    fs::create_directories (folder_ / "data");
    for (int scene = 0; scene < scenes_; ++scene)
      pcl::io::savePCDFileBinary (folder_ / ("data/scene" + std::to_string (scene) + ".pcd"),
                                  *test::renderedScene (scene));
  }

  void
  expectSameReports (const std::string& folder, const std::string& plain) const
  {
    for (const std::string& name : same_reports)
    {
      EXPECT_FALSE (content (plain + "/" + name).empty ()) << name;
      EXPECT_TRUE (content (folder + "/" + name) == content (plain + "/" + name)) << name;
    }
    EXPECT_FALSE (content (folder + "/report.html").empty ());
  }

  /** \brief Results by system and scene with the time at which they were written. */
  std::map<std::string, fs::file_time_type>
  resultsIn (const std::string& folder) const
  {
    std::map<std::string, fs::file_time_type> results;
    std::error_code ignored;
    for (const auto& entry : fs::recursive_directory_iterator (folder_ / (folder + "/results"), ignored))
      if (entry.path ().extension () == ".json")
        results[entry.path ().string ()] = entry.last_write_time (ignored);
    return (results);
  }

  /** \brief Start an evaluation and kill it as soon as so many results are there. */
  void
  killAfter (std::size_t results, const std::string& folder, const std::string& arguments) const
  {
    const std::string text = command (arguments);
    const pid_t process = fork ();
    if (process == 0)
    {
      execl ("/bin/sh", "sh", "-c", text.c_str (), static_cast<char*> (nullptr));
      _exit (127);
    }
    int status = 0;
    while (resultsIn (folder).size () < results && waitpid (process, &status, WNOHANG) == 0)
      std::this_thread::sleep_for (std::chrono::milliseconds (1));
    kill (process, SIGKILL);
    waitpid (process, &status, 0);
  }
};

TEST_F (LargeSets, jobsGiveTheSameReport)
{
  expectSuccess ("data -systems proposed,paper -sweep 5 -output_dir plain");
  expectSuccess ("data -systems proposed,paper -sweep 5 -output_dir jobs -jobs 3 -threads 1");
  expectSameReports ("jobs", "plain");
  const auto json = nlohmann::json::parse (content ("plain/report.json"));
  EXPECT_EQ (json["systems"].size (), 4u);
  EXPECT_GT (json["systems"][0]["summaries"][0]["attended"], 0);
  EXPECT_NE (content ("plain/report.csv").find ("\npaper,0.005,objects,overall,6,"), std::string::npos);
  // A page with pictures of the ground truth and both systems
  const std::string page = content ("plain/report.html");
  EXPECT_NE (page.find ("alt=\"ground truth, scene0\" src=\"data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  EXPECT_NE (page.find ("alt=\"paper, scene5\" src=\"data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  expectSuccess ("data -systems proposed,paper -sweep 5 -output_dir bare -no_pictures");
  expectSameReports ("bare", "plain");
  EXPECT_FALSE (fs::exists (folder_ / "bare/results/ground_truth"));
}

TEST_F (LargeSets, aKilledRunGoesOnWhereItWas)
{
  expectSuccess ("data -systems proposed,paper -output_dir plain");
  for (const std::size_t results : {1u, 4u, 9u})
  {
    killAfter (results, "killed", "data -systems proposed,paper -output_dir killed -jobs 2");
    ASSERT_GE (resultsIn ("killed").size (), results);
    ASSERT_LT (resultsIn ("killed").size (), 2u * scenes_) << "the run ended before it was killed";
    EXPECT_FALSE (fs::exists (folder_ / "killed/report.csv"));
  }
  const auto before = resultsIn ("killed");
  const test::Outcome result = run ("data -systems proposed,paper -output_dir killed");
  ASSERT_EQ (result.exit_code, 0) << result.errors;
  EXPECT_NE (result.errors.find ("of 6 scenes are there already\n"), std::string::npos) << result.errors;
  expectSameReports ("killed", "plain");
  const auto after = resultsIn ("killed");
  EXPECT_EQ (after.size (), 2u * scenes_);
  for (const auto& [file, time] : before)
    EXPECT_EQ (after.at (file), time) << file << " was made twice";
}

TEST_F (LargeSets, shardsInOneFolder)
{
  expectSuccess ("data -systems proposed,paper -output_dir plain");
  for (int shard = 1; shard <= 4; ++shard)
  {
    const std::string i = std::to_string (shard);
    const test::Outcome result = run ("data -systems proposed,paper -output_dir shared -shard " + i + "/4");
    ASSERT_EQ (result.exit_code, 0) << result.errors;
    // six scenes: two, two, one and one; the last writes the report
    EXPECT_EQ (resultsIn ("shared").size (), (std::vector<std::size_t>{4, 8, 10, 12})[shard - 1]);
    EXPECT_EQ (fs::exists (folder_ / "shared/report.csv"), shard == 4) << result.errors;
  }
  expectSameReports ("shared", "plain");
}

TEST_F (LargeSets, shardsAtOnceInOneFolder)
{
  expectSuccess ("data -output_dir plain");
  std::vector<pid_t> processes;
  for (int shard = 1; shard <= 3; ++shard)
  {
    const std::string i = std::to_string (shard);
    const std::string text = command ("data -output_dir shared -threads 1 -shard " + i + "/3") + i;
    processes.push_back (fork ());
    if (processes.back () == 0)
    {
      execl ("/bin/sh", "sh", "-c", text.c_str (), static_cast<char*> (nullptr));
      _exit (127);
    }
  }
  for (const pid_t process : processes)
  {
    int status = 0;
    waitpid (process, &status, 0);
    EXPECT_EQ (status, 0);
  }
  // by the shard that was the last, without another run
  expectSameReports ("shared", "plain");
}

TEST_F (LargeSets, shardsMerged)
{
  expectSuccess ("data -systems proposed,paper -output_dir plain");
  std::string folders;
  for (int shard = 1; shard <= 4; ++shard)
  {
    const std::string i = std::to_string (shard);
    EXPECT_NE (run ("-output_dir merged -merge" + folders + " shard" + i).exit_code, 0) << "merged an unfinished one";
    expectSuccess ("data -systems proposed,paper -output_dir shard" + i + " -shard " + i + "/4");
    folders += " shard" + i;
  }
  fs::remove_all (folder_ / "data"); // which may be on other machines
  expectSuccess ("-output_dir merged -merge" + folders);
  expectSameReports ("merged", "plain");
  // one with the other: pictures are found in whatever folder has them
  const std::string page = content ("merged/report.html");
  for (int scene = 0; scene < scenes_; ++scene)
    EXPECT_NE (page.find ("alt=\"paper, scene" + std::to_string (scene) + "\" src=\"data:image/png;base64,iVBORw0KGgo"),
               std::string::npos);
}

TEST_F (LargeSets, mergeNamesWhatIsMissingOrDoesNotBelong)
{
  expectSuccess ("data -output_dir shard1 -shard 1/2");
  expectSuccess ("data -preset paper -output_dir shard2 -shard 2/2");
  EXPECT_EQ (
      run ("-output_dir merged -merge shard1").errors,
      "pcl_attention_evaluate: 3 results are in no folder of -merge, the first of them proposed on scene1: is a shard "
      "missing, or not done?\n");
  const test::Outcome other = run ("-output_dir merged -merge shard1 shard2");
  EXPECT_EQ (other.exit_code, 1);
  EXPECT_NE (other.errors.find ("pcl_attention_evaluate: shard1: holds another evaluation: "
                                "/systems/0/parameters/preset is \"default\" there and \"paper\" now"),
             std::string::npos)
      << other.errors;
  EXPECT_EQ (run ("-output_dir merged -merge data").errors,
             "pcl_attention_evaluate: data: no folder of an evaluation, there is no evaluation.json in it\n");
  EXPECT_FALSE (fs::exists (folder_ / "merged"));
  EXPECT_EQ (run ("-merge shard1").exit_code, 2);
  EXPECT_EQ (run ("-output_dir merged -merge shard1 -shard 1/2").exit_code, 2);
}

TEST_F (LargeSets, otherParametersOrDataAreRefused)
{
  expectSuccess ("data -output_dir out -ground_truth objects");
  const auto before = resultsIn ("out");
  const auto refusal = [&] (const std::string& arguments) {
    const test::Outcome result = run (arguments + " -output_dir out");
    EXPECT_EQ (result.exit_code, 1);
    EXPECT_EQ (std::count (result.errors.begin (), result.errors.end (), '\n'), 1) << result.errors;
    return (result.errors);
  };
  EXPECT_NE (refusal ("data -ground_truth objects -compactness_threshold 0.007")
                 .find ("out: holds another evaluation: /systems/0/parameters/compactness_threshold is 0.005 there and "
                        "0.007 now"),
             std::string::npos);
  EXPECT_NE (refusal ("data -ground_truth objects -systems proposed,paper").find ("/systems"), std::string::npos);
  EXPECT_NE (refusal ("data").find ("/ground_truth is [\"objects\"] there and [\"objects\",\"parts\"] now"), std::string::npos);
  EXPECT_NE (refusal ("data/scene0.pcd -ground_truth objects").find ("/scenes"), std::string::npos);

  // One bit of one scene
  std::string bytes = content ("data/scene3.pcd");
  bytes.back () ^= 1;
  test::writeText (folder_ / "data/scene3.pcd", bytes);
  EXPECT_EQ (refusal ("data -ground_truth objects"),
             "pcl_attention_evaluate: data/scene3.pcd: has changed since proposed was evaluated on it. Take another "
             "-output_dir, or remove that one\n");
  EXPECT_EQ (resultsIn ("out"), before);
}

TEST_F (LargeSets, aDamagedResultIsNamed)
{
  expectSuccess ("data -output_dir out");
  const std::string file = "out/results/proposed/scene2.json", whole = content (file);
  std::string no_rank = whole, large_label = whole;
  no_rank.replace (no_rank.find ("\"rank\":"), 7, "\"rank\":1e300,\"k\":");
  large_label.replace (large_label.find ("\"label\":"), 8, "\"label\":4294967296,\"k\":");
  for (const std::string& text : {std::string ("{\"scores\": []}"), no_rank, large_label})
  {
    test::writeText (folder_ / file, text);
    EXPECT_EQ (run ("data -output_dir out").errors,
               "pcl_attention_evaluate: " + file + ": damaged: remove it, and it will be made again\n");
  }
  fs::remove (folder_ / "out/results/proposed/scene2.json");
  EXPECT_EQ (run ("data -output_dir out").errors, "5 of 6 scenes are there already\nThe report is out/report.html\n");
}

} // namespace
} // namespace pcl_attention
