// SPDX-License-Identifier: BSD-3-Clause
// What the programs leave behind where a disk is full or read-only, where they are killed, and where frames of all kinds follow
// each other: whole results or none, and one line that names the file and the cause.
#include "evaluation/results.h"
#include "files.h"
#include "scene_renderer.h"

#include <nlohmann/json.hpp>
#include <pcl/common/io.h>
#include <pcl/io/pcd_io.h>

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <limits>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace pcl_attention;
using Names = std::set<std::string>;

namespace
{

const std::string segment = "'" PCL_ATTENTION_SEGMENT "' ";
const std::string make_scene = "'" PCL_ATTENTION_MAKE_SCENE "' ";
const std::string evaluate = "'" PCL_ATTENTION_EVALUATE "' ";

pcl::PointCloud<pcl::PointXYZRGBL>
rendered (std::uint64_t seed, int width = 160, int height = 120)
{
  SceneDescription description = makeScene (SceneKind::separate, seed);
  description.camera = description.camera.resized (width, height);
  return (*renderScene (description, seed));
}

class Faults : public testing::Test
{
protected:
  test::TemporaryFolder folder_;

  template <typename PointT>
  void
  save (const std::string& name, const pcl::PointCloud<PointT>& cloud)
  {
    std::filesystem::create_directories (std::filesystem::path (folder_ / name).parent_path ());
    pcl::io::savePCDFileBinary (folder_ / name, cloud);
  }

  std::string
  takeErrors ()
  {
    const std::string errors = test::readText (folder_ / "errors.txt");
    std::filesystem::remove (folder_ / "errors.txt");
    return (errors);
  }

  /** \brief Run in the test's folder. */
  int
  run (const std::string& command)
  {
    test::writeText (folder_ / "run.sh", "cd '" + (folder_ / "") + "'\n" + command + " > /dev/null 2> errors.txt\n");
    return (WEXITSTATUS (std::system (("bash '" + (folder_ / "run.sh") + "'").c_str ())));
  }

  /** \brief Run with a file system of its own on the folder out, a copy of which is then in the folder left.
   * \param[in] options of the file system, as size=64k
   * \param[in] before run when it is there */
  int
  runOnDisk (const std::string& options, const std::string& command, const std::string& before = "true")
  {
    std::filesystem::remove_all (folder_ / "left");
    test::writeText (folder_ / "disk.sh", "cd '" + (folder_ / "") + "' && mkdir -p out && mount -t tmpfs -o " + options +
                                              " none out || exit 99\n" + before + "\n" + command +
                                              " > /dev/null 2> errors.txt\ncode=$?\ncp -r out left\nexit $code\n");
    const std::string in_namespace = "unshare --user --map-root-user --mount bash '";
    return (WEXITSTATUS (std::system ((in_namespace + (folder_ / "disk.sh") + "'").c_str ())));
  }

  bool
  hasDisks ()
  {
    return (runOnDisk ("size=64k", "true") == 0);
  }

  /** \brief One line that has both texts. */
  void
  expectLine (const std::string& file, const std::string& cause)
  {
    const std::string errors = takeErrors ();
    EXPECT_EQ (std::count (errors.begin (), errors.end (), '\n'), 1) << errors;
    EXPECT_NE (errors.find (file), std::string::npos) << errors;
    EXPECT_NE (errors.find (cause), std::string::npos) << errors;
  }

  /** \brief That a folder of results has all that belongs to it. */
  void
  expectWhole (const std::string& results, int width, int height)
  {
    for (const char* name : {"attention_points.csv", "segments.json", "labels.pcd", "overview.png", "summary.json"})
      EXPECT_TRUE (std::filesystem::exists (folder_ / (results + "/" + name))) << results << "/" << name;
    EXPECT_NO_THROW (readResults (folder_ / results, width, height)) << results;
  }

  /** \brief Run and kill after a while.
   * \return false if it was done before */
  bool
  runAndKill (const char* program, const std::vector<std::string>& arguments, std::chrono::microseconds after)
  {
    std::vector<char*> texts{const_cast<char*> (program)};
    for (const std::string& argument : arguments)
      texts.push_back (const_cast<char*> (argument.c_str ()));
    texts.push_back (nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init (&actions);
    for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen (&actions, descriptor, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    EXPECT_EQ (posix_spawn (&child, program, &actions, nullptr, texts.data (), environ), 0);
    posix_spawn_file_actions_destroy (&actions);
    std::this_thread::sleep_for (after);
    kill (child, SIGKILL);
    int status = 0;
    waitpid (child, &status, 0);
    return (WIFSIGNALED (status));
  }
};

TEST_F (Faults, aFullDiskLeavesTheOlderResultsOrNone)
{
  if (!hasDisks ())
    GTEST_SKIP () << "no file system can be mounted here";
  save ("scene.pcd", rendered (1));
  for (const char* options : {"size=4k", "size=16k", "size=64k", "size=128k", "nr_inodes=4"})
  {
    SCOPED_TRACE (options);
    EXPECT_EQ (runOnDisk (options, segment + "scene.pcd -output_dir out"), 1);
    expectLine ("out", "cannot be written: No space left on device");
    EXPECT_EQ (test::namesIn (folder_ / "left"), Names{});
  }
  EXPECT_EQ (runOnDisk ("size=64k", segment + "scene.pcd -output_dir out", "mkdir out/scene; echo old > out/scene/old"), 1);
  expectLine ("out/scene/labels.pcd", "cannot be written: No space left on device");
  EXPECT_EQ (test::namesIn (folder_ / "left"), Names{"scene"});
  EXPECT_EQ (test::namesIn (folder_ / "left/scene"), Names{"old"});
  EXPECT_EQ (runOnDisk ("size=4m", segment + "scene.pcd -output_dir out"), 0);
  expectWhole ("left/scene", 160, 120);
}

TEST_F (Faults, aFullDiskLeavesNoHalfScene)
{
  if (!hasDisks ())
    GTEST_SKIP () << "no file system can be mounted here";
  for (const char* options : {"size=4k", "size=32k", "nr_inodes=1"})
  {
    EXPECT_EQ (runOnDisk (options, make_scene + "out/scene.pcd -width 160 -height 120"), 1) << options;
    expectLine ("out/scene.pcd", "cannot be written: No space left on device");
    EXPECT_EQ (test::namesIn (folder_ / "left"), Names{}) << options;
  }
}

TEST_F (Faults, aFullDiskLeavesNoHalfEvaluation)
{
  if (!hasDisks ())
    GTEST_SKIP () << "no file system can be mounted here";
  save ("data/a.pcd", rendered (1));
  save ("data/b.pcd", rendered (2));
  for (const char* options : {"size=4k", "size=16k", "size=32k", "nr_inodes=4"})
  {
    SCOPED_TRACE (options);
    EXPECT_EQ (runOnDisk (options, evaluate + "data -systems proposed -no_pictures -output_dir out"), 1);
    const std::string errors = takeErrors ();
    EXPECT_NE (errors.find ("out"), std::string::npos) << errors;
    EXPECT_NE (errors.find ("No space left on device"), std::string::npos) << errors;
    for (const auto& entry : std::filesystem::recursive_directory_iterator (folder_ / "left"))
    {
      const std::string path = entry.path ().string ();
      EXPECT_EQ (path.find (".part-"), std::string::npos) << path;
      EXPECT_TRUE (entry.path ().extension () != ".json" || nlohmann::json::accept (test::readText (path))) << path;
    }
    EXPECT_FALSE (std::filesystem::exists (folder_ / "left/report.html"));
  }
}

TEST_F (Faults, aReadOnlyFolderIsNamed)
{
  if (!hasDisks ())
    GTEST_SKIP () << "no file system can be mounted here";
  save ("data/scene.pcd", rendered (1));
  EXPECT_EQ (runOnDisk ("ro", segment + "data/scene.pcd -output_dir out"), 1);
  expectLine ("out: ", "cannot be written: Read-only file system");
  EXPECT_EQ (runOnDisk ("ro", make_scene + "out/scene.pcd -width 64 -height 48"), 1);
  expectLine ("out/scene.pcd: ", "cannot be written: Read-only file system");
  EXPECT_EQ (runOnDisk ("ro", evaluate + "data -systems proposed -no_pictures -output_dir out"), 1);
  expectLine ("out/results: cannot be ", "Read-only file system");
}

TEST_F (Faults, aKilledRunLeavesWholeResults)
{
  for (const char* name : {"a", "b", "c"})
    save (std::string ("in/") + name + ".pcd", rendered (name[0]));
  const std::vector<std::string> arguments{folder_ / "in", "-output_dir", folder_ / "out"};
  const auto started = std::chrono::steady_clock::now ();
  ASSERT_EQ (run (segment + "in -output_dir out"), 0);
  std::filesystem::remove_all (folder_ / "out");
  const auto whole_run = std::chrono::duration_cast<std::chrono::microseconds> (std::chrono::steady_clock::now () - started);
  int killed = 0;
  constexpr int trials = 16;
  for (int trial = 0; trial < trials; ++trial)
  {
    killed += runAndKill (PCL_ATTENTION_SEGMENT, arguments, whole_run * (trial + 1) / trials);
    for (const std::string& name : test::namesIn (folder_ / "out"))
      if (name.front () != '.')
        expectWhole ("out/" + name, 160, 120);
  }
  EXPECT_GT (killed, trials / 3);
  EXPECT_EQ (run (segment + "in -output_dir out"), 0);
  EXPECT_EQ (test::namesIn (folder_ / "out"), (Names{"a", "b", "c"})) << "what killed runs leave is removed";
}

TEST_F (Faults, aKilledRendererLeavesWholeScenes)
{
  for (int trial = 1; trial <= 8; ++trial)
  {
    std::filesystem::create_directories (folder_ / "out");
    EXPECT_TRUE (runAndKill (PCL_ATTENTION_MAKE_SCENE,
                             {folder_ / "out/scene.pcd", "-count", "9999", "-width", "64", "-height", "48"},
                             std::chrono::milliseconds (20 + 13 * trial)));
    for (const std::string& name : test::namesIn (folder_ / "out"))
      if (std::filesystem::path (name).extension () == ".pcd")
      {
        pcl::PointCloud<pcl::PointXYZRGBL> cloud;
        EXPECT_EQ (pcl::io::loadPCDFile (folder_ / ("out/" + name), cloud), 0) << name;
        EXPECT_EQ (cloud.size (), 64u * 48u) << name;
      }
  }
}

TEST_F (Faults, aSequenceMayChangeItsFramesInEveryWay)
{
  const auto first = rendered (1);
  pcl::PointCloud<pcl::PointXYZ> colorless, holes;
  pcl::copyPointCloud (rendered (3), colorless);
  holes = colorless;
  for (pcl::PointXYZ& point : holes)
    point.x = point.y = point.z = std::numeric_limits<float>::quiet_NaN ();
  save ("in/1.pcd", first);
  save ("in/2.pcd", rendered (2, 64, 48));
  save ("in/3.pcd", colorless);
  save ("in/4.pcd", holes);
  save ("in/5.pcd", rendered (4, 200, 150));
  save ("in/6.pcd", first);
  EXPECT_EQ (run (segment + "in -output_dir stream"), 1);
  const std::string errors = takeErrors ();
  EXPECT_NE (errors.find ("4.pcd: no valid point: all are NaN"), std::string::npos) << errors;
  EXPECT_NE (errors.find ("1 of 6 scenes failed"), std::string::npos) << errors;
  EXPECT_EQ (test::namesIn (folder_ / "stream"), (Names{"1", "2", "3", "5", "6"}));
  for (const std::string name : {"1", "2", "3", "5", "6"})
  {
    EXPECT_EQ (run (segment + "in/" + name + ".pcd -output_dir single"), 0);
    for (const char* file : {"/segments.json", "/labels.pcd", "/attention_points.csv"})
      EXPECT_TRUE (test::readText (folder_ / ("single/" + name + file)) == test::readText (folder_ / ("stream/" + name + file)))
          << name << file;
  }
  EXPECT_EQ (test::readText (folder_ / "stream/6/segments.json"), test::readText (folder_ / "stream/1/segments.json"));
}

} // namespace
