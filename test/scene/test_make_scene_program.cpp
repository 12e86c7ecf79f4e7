// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <sys/wait.h>

namespace fs = std::filesystem;
using Cloud = pcl::PointCloud<pcl::PointXYZRGBL>;

namespace
{

class MakeScene : public testing::Test
{
protected:
  void
  SetUp () override
  {
    std::string pattern = (fs::temp_directory_path () / "pcl_attention_make_scene_XXXXXX").string ();
    ASSERT_NE (mkdtemp (pattern.data ()), nullptr);
    directory_ = pattern;
  }

  void
  TearDown () override
  {
    fs::remove_all (directory_);
  }

  /** \brief Run the program in the test's directory; its output and errors are then in out_ and err_. */
  int
  run (const std::string& arguments)
  {
    const std::string command =
        "cd '" + directory_.string () + "' && '" PCL_ATTENTION_MAKE_SCENE "' " + arguments + " > out 2> err";
    const int status = std::system (command.c_str ());
    out_ = take ("out");
    err_ = take ("err");
    return (WEXITSTATUS (status));
  }

  std::string
  take (const char* name)
  {
    std::stringstream text;
    text << std::ifstream (directory_ / name).rdbuf ();
    fs::remove (directory_ / name);
    return (text.str ());
  }

  std::set<std::string>
  files () const
  {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator (directory_))
      names.insert (entry.path ().filename ());
    return (names);
  }

  fs::path directory_;
  std::string out_, err_;
};

} // namespace

TEST_F (MakeScene, WritesOneScene)
{
  ASSERT_EQ (run ("scene.pcd -kind single_box -width 160 -height 120 -seed 3"), 0) << err_;
  EXPECT_EQ (files (), std::set<std::string>{"scene.pcd"});
  EXPECT_EQ (err_, "");
  EXPECT_NE (out_.find ("scene.pcd: 1 objects"), std::string::npos) << out_;
  Cloud cloud;
  ASSERT_EQ (pcl::io::loadPCDFile ((directory_ / "scene.pcd").string (), cloud), 0);
  EXPECT_EQ (cloud.width, 160U);
  EXPECT_EQ (cloud.height, 120U);
  int object_pixels = 0;
  for (const auto& point : cloud)
    object_pixels += point.label == 20;
  EXPECT_GT (object_pixels, 50);
  std::ifstream file (directory_ / "scene.pcd");
  const std::string header (std::istreambuf_iterator<char> (file), {});
  EXPECT_NE (header.find ("FIELDS x y z rgba label\n"), std::string::npos);
  EXPECT_NE (header.find ("DATA binary_compressed\n"), std::string::npos);
}

TEST_F (MakeScene, WritesManyScenesOfSuccessiveSeeds)
{
  ASSERT_EQ (run ("many.pcd -count 3 -seed 7 -width 64 -height 48"), 0) << err_;
  EXPECT_EQ (files (), (std::set<std::string>{"many_0001.pcd", "many_0002.pcd", "many_0003.pcd"}));
  EXPECT_NE (out_.find ("(3/3)"), std::string::npos) << out_;
  ASSERT_EQ (run ("third.pcd -seed 9 -width 64 -height 48"), 0);
  const auto content = [this] (const char* name) {
    std::ifstream file (directory_ / name);
    return (std::string (std::istreambuf_iterator<char> (file), {}));
  };
  EXPECT_EQ (content ("third.pcd"), content ("many_0003.pcd"));
  EXPECT_NE (content ("third.pcd"), content ("many_0002.pcd"));
}

TEST_F (MakeScene, WorldFrameHasTheSensorPose)
{
  ASSERT_EQ (run ("scene.pcd -world -noise 0 -width 64 -height 48"), 0) << err_;
  Cloud cloud;
  ASSERT_EQ (pcl::io::loadPCDFile ((directory_ / "scene.pcd").string (), cloud), 0);
  EXPECT_GT (cloud.sensor_origin_.z (), 0.4F);
  for (const auto& point : cloud)
  {
    if (point.label != 1)
      continue;
    EXPECT_LT (point.z, 1e-5F);
  }
}

TEST_F (MakeScene, BadCommandLinesExitWithTwoAndOneLine)
{
  for (const char* arguments :
       {"", "scene.txt", "a.pcd b.pcd", "scene.pcd -kind mess", "scene.pcd -width 0", "scene.pcd -height -4",
        "scene.pcd -width 4x", "scene.pcd -noise 3.5", "scene.pcd -noise -1", "scene.pcd -noise nan",
        "scene.pcd -seed -1", "scene.pcd -objects -1", "scene.pcd -count 0", "scene.pcd -frobnicate",
        "scene.pcd -seed"})
  {
    EXPECT_EQ (run (arguments), 2) << arguments;
    EXPECT_EQ (out_, "") << arguments;
    EXPECT_EQ (std::count (err_.begin (), err_.end (), '\n'), 1) << arguments << ": " << err_;
    EXPECT_NE (err_.find ("pcl_attention_make_scene -h"), std::string::npos) << err_;
    EXPECT_TRUE (files ().empty ()) << arguments;
  }
}

TEST_F (MakeScene, UnwritableTargetsExitWithOneAndOneLine)
{
  fs::create_directories (directory_ / "taken.pcd" / "inside"); // rename cannot replace a directory
  for (const char* arguments : {"missing/scene.pcd -width 8 -height 8", "taken.pcd -width 8 -height 8"})
  {
    EXPECT_EQ (run (arguments), 1) << arguments;
    EXPECT_EQ (out_, "");
    EXPECT_EQ (std::count (err_.begin (), err_.end (), '\n'), 1) << err_;
    EXPECT_NE (err_.find (": cannot be written: "), std::string::npos) << err_;
    EXPECT_EQ (files (), std::set<std::string>{"taken.pcd"}) << "nothing is left behind";
  }
}

TEST_F (MakeScene, HelpExitsWithZero)
{
  EXPECT_EQ (run ("-h"), 0);
  EXPECT_NE (out_.find ("empty_table"), std::string::npos);
  EXPECT_EQ (err_, "");
}

TEST_F (MakeScene, OfAnotherSensor)
{
  ASSERT_EQ (run ("kinect.pcd -kind single_box -width 160 -height 120 -seed 3"), 0) << err_;
  ASSERT_EQ (run ("stereo.pcd -kind single_box -width 160 -height 120 -seed 3 -sensor stereo"), 0) << err_;
  Cloud kinect, stereo;
  ASSERT_EQ (pcl::io::loadPCDFile ((directory_ / "kinect.pcd").string (), kinect), 0);
  ASSERT_EQ (pcl::io::loadPCDFile ((directory_ / "stereo.pcd").string (), stereo), 0);
  EXPECT_NE (kinect[80 + 60 * 160].z, stereo[80 + 60 * 160].z);
  EXPECT_EQ (run ("other.pcd -sensor laser"), 2);
  EXPECT_NE (err_.find ("no sensor 'laser', -sensor takes kinect or stereo"), std::string::npos) << err_;
  EXPECT_FALSE (fs::exists (directory_ / "other.pcd"));
}
