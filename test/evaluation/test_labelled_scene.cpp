// SPDX-License-Identifier: BSD-3-Clause
#include "cases.h"

#include <pcl/io/pcd_io.h>

namespace pcl_attention
{
namespace
{

TEST (SceneCategory, followsTheNumberingOfMosdLearn)
{
  EXPECT_EQ (sceneCategory ("/data/mosd_learn/learn0.pcd"), "boxes");
  EXPECT_EQ (sceneCategory ("/data/mosd_learn/learn16.pcd"), "boxes");
  EXPECT_EQ (sceneCategory ("learn17.pcd"), "stacked");
  EXPECT_EQ (sceneCategory ("learn24.pcd"), "stacked");
  EXPECT_EQ (sceneCategory ("learn25.pcd"), "occluded");
  EXPECT_EQ (sceneCategory ("learn32.pcd"), "occluded");
  EXPECT_EQ (sceneCategory ("learn33.pcd"), "cylindric");
  EXPECT_EQ (sceneCategory ("learn44.pcd"), "cylindric");
}

TEST (SceneCategory, elseIsTheFolder)
{
  EXPECT_EQ (sceneCategory ("/data/other_sensors/ucn_d4xx_00.pcd"), "other_sensors");
  EXPECT_EQ (sceneCategory ("/data/folder/learn45.pcd"), "folder");
  EXPECT_EQ (sceneCategory ("/data/folder/learn.pcd"), "folder");
  EXPECT_EQ (sceneCategory ("/data/folder/learn1x.pcd"), "folder");
  EXPECT_EQ (sceneCategory ("/data/folder/learn99999999999999.pcd"), "folder");
  EXPECT_EQ (sceneCategory ("scene.pcd"), std::filesystem::current_path ().filename ().string ());
}

TEST (ListScenes, takesFilesAsTheyAreAndFoldersByName)
{
  const test::TemporaryFolder folder;
  std::filesystem::create_directories (folder / "scenes/deeper");
  for (const char* name : {"scenes/b.pcd", "scenes/a.pcd", "scenes/notes.txt", "scenes/deeper/c.pcd", "z.pcd"})
    test::writeText (folder / name, "");
  EXPECT_EQ (listScenes ({folder / "z.pcd", folder / "scenes"}),
             (std::vector<std::string>{folder / "z.pcd", folder / "scenes/a.pcd", folder / "scenes/b.pcd"}));
}

TEST (ListScenes, namesWhatIsWrong)
{
  const test::TemporaryFolder folder;
  std::filesystem::create_directories (folder / "empty");
  std::filesystem::create_directories (folder / "other");
  test::writeText (folder / "a.pcd", "");
  test::writeText (folder / "other/a.pcd", "");
  EXPECT_EQ (test::messageOf ([&] { listScenes ({folder / "none"}); }), (folder / "none") + ": no such file or folder");
  EXPECT_EQ (test::messageOf ([&] { listScenes ({folder / "empty"}); }),
             (folder / "empty") + ": a folder without a .pcd file");
  EXPECT_EQ (test::messageOf ([&] {
               listScenes ({folder / "a.pcd", folder / "other"});
             }),
             (folder / "other/a.pcd") + ": same name as " + (folder / "a.pcd"));
}

TEST (LoadLabelledScene, readsCoordinatesColourLabelsAndSensorPose)
{
  const test::TemporaryFolder folder;
  auto cloud = test::cloudOf (2, {20, -1, 1, 31});
  cloud[0].r = 10;
  cloud[0].g = 20;
  cloud[0].b = 30;
  cloud.sensor_origin_ = Eigen::Vector4f (1, 2, 3, 0);
  pcl::io::savePCDFileBinaryCompressed (folder / "a.pcd", cloud);
  const LabelledScene scene = loadLabelledScene (folder / "a.pcd");
  EXPECT_EQ (scene.name, "a");
  EXPECT_EQ (scene.cloud->width, 2u);
  EXPECT_EQ (scene.cloud->height, 2u);
  EXPECT_EQ (scene.cloud->at (1, 1).label, 31u);
  EXPECT_EQ (scene.cloud->at (0, 0).g, 20);
  EXPECT_TRUE (std::isnan (scene.cloud->at (1, 0).z));
  EXPECT_EQ (scene.cloud->sensor_origin_, cloud.sensor_origin_);
}

TEST (LoadLabelledScene, takesAnUnorganizedVgaSceneAsAnImage)
{
  const test::TemporaryFolder folder;
  std::vector<int> labels (640 * 480, 1);
  labels[640 * 2 + 3] = 20;
  pcl::io::savePCDFileBinary (folder / "a.pcd", test::cloudOf (640 * 480, labels));
  const LabelledScene scene = loadLabelledScene (folder / "a.pcd");
  EXPECT_EQ (scene.cloud->width, 640u);
  EXPECT_EQ (scene.cloud->height, 480u);
  EXPECT_EQ (scene.cloud->at (3, 2).label, 20u);
}

TEST (LoadLabelledScene, takesSignedLabels)
{
  const test::TemporaryFolder folder;
  test::writeText (folder / "a.pcd",
                   "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F I\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 2\n"
                   "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n0 0 1 1\n0 0 1 20\n0 0 1 21\n0 0 1 0\n");
  EXPECT_EQ (loadLabelledScene (folder / "a.pcd").cloud->at (1, 0).label, 20u);
}

TEST (LoadLabelledScene, namesTheFileAndWhatIsWrongWithIt)
{
  const test::TemporaryFolder folder;
  const auto message = [&] (const std::string& name) {
    return (test::messageOf ([&] { loadLabelledScene (folder / name); }));
  };
  EXPECT_EQ (message ("missing.pcd"), (folder / "missing.pcd") + ": no such file");

  // on the first of these PCL 1.13 itself crashes, for the last it allocates 32 GB
  const std::pair<std::string, std::string> texts[] = {
      {"no point cloud\n", "not a PCD file"},
      {"", "an empty file"},
      {"VERSION 0.7\nFIELDS x y z label\n", "truncated: the PCD header has no end"},
      {"WIDTH 2\nHEIGHT 2\nPOINTS 4\nDATA ascii\n", "damaged PCD header: a point has 0 bytes"},
      {"FIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 0\nHEIGHT 0\nPOINTS 0\nDATA ascii\n", "no points"},
      {"FIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2000000000\nHEIGHT 1\nPOINTS 2000000000\n"
       "DATA binary\n",
       "truncated: the header announces 2000000000 points, the file holds 0"}};
  for (const auto& [text, complaint] : texts)
  {
    test::writeText (folder / "text.pcd", text);
    EXPECT_EQ (message ("text.pcd"), (folder / "text.pcd") + ": " + complaint);
  }

  pcl::io::savePCDFileBinary (folder / "plain.pcd", pcl::PointCloud<pcl::PointXYZ> (2, 2));
  EXPECT_EQ (message ("plain.pcd"), (folder / "plain.pcd") + ": no field \"label\": not a labelled scene");

  pcl::io::savePCDFileBinary (folder / "labels.pcd", pcl::PointCloud<pcl::Label> (2, 2));
  EXPECT_EQ (message ("labels.pcd"), (folder / "labels.pcd") + ": no 4-byte floating-point field \"x\"");

  pcl::io::savePCDFileBinary (folder / "row.pcd", test::cloudOf (4, {1, 1, 20, 20}));
  EXPECT_EQ (message ("row.pcd"),
             (folder / "row.pcd") + ": unorganized, 4 points; only 640 * 480 can be taken as an image");
}

TEST (LoadLabelledScene, survivesFilesCutShort)
{
  const test::TemporaryFolder folder;
  const auto cloud = test::cloudOf (8, std::vector<int> (64, 20));
  pcl::io::savePCDFileASCII (folder / "0.pcd", cloud);
  pcl::io::savePCDFileBinary (folder / "1.pcd", cloud);
  pcl::io::savePCDFileBinaryCompressed (folder / "2.pcd", cloud);
  for (const std::string name : {"0.pcd", "1.pcd", "2.pcd"})
  {
    const std::string whole = test::readText (folder / name);
    for (std::size_t length = 0; length + 32 < whole.size (); length += 3)
    {
      SCOPED_TRACE (name + " cut to " + std::to_string (length));
      test::writeText (folder / "cut.pcd", whole.substr (0, length));
      ASSERT_NE (test::messageOf ([&] { loadLabelledScene (folder / "cut.pcd"); }), "");
    }
  }
}

} // namespace
} // namespace pcl_attention
