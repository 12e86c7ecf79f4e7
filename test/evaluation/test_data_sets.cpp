// SPDX-License-Identifier: BSD-3-Clause
// Data sets in every layout that is read, written from one rendered scene, and what is said of broken ones.
#include "data_set.h"
#include "program_test.h"

#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>
#include <pcl/io/png_io.h>

#include <functional>
#include <png.h>

namespace fs = std::filesystem;

namespace pcl_attention
{
namespace
{

constexpr int width = 160, height = 120;

class DataSets : public test::ProgramTest
{
protected:
  pcl::PointCloud<pcl::PointXYZRGBL>::Ptr cloud_ = test::renderedScene (3, width, height);
  DataSetOptions by_depth_; ///< with the camera that the scene was rendered by

  DataSets ()
  {
    const SceneCamera camera = SceneCamera ().resized (width, height);
    by_depth_.scene.camera.fx = by_depth_.scene.camera.fy = camera.focal_length;
    by_depth_.scene.camera.cx = camera.center_x;
    by_depth_.scene.camera.cy = camera.center_y;
  }

  std::string
  make (const std::string& file) const
  {
    fs::create_directories (fs::path (folder_ / file).parent_path ());
    return (folder_ / file);
  }

  void
  writeColor (const std::string& file) const
  {
    std::vector<unsigned char> values;
    for (const auto& point : *cloud_)
      values.insert (values.end (), {point.r, point.g, point.b});
    pcl::io::saveCharPNGFile (make (file), values.data (), width, height, 3);
  }

  /** \brief Depths in millimetres. */
  void
  writeDepth (const std::string& file) const
  {
    std::vector<unsigned short> values;
    for (const auto& point : *cloud_)
      values.push_back (pcl::isXYZFinite (point) ? static_cast<unsigned short> (std::lround (1e3 * point.z)) : 0);
    pcl::io::saveShortPNGFile (make (file), values.data (), width, height, 1);
  }

  /** \brief Object k, from 0 on, has first + k; what is no object its label, at most most_support. */
  std::vector<std::uint16_t>
  labelValues (int first, int most_support) const
  {
    std::vector<std::uint16_t> values;
    for (const auto& point : *cloud_)
      values.push_back (static_cast<std::uint16_t> (point.label >= 20 ? point.label / 10 - 2 + first
                                                                      : std::min<int> (point.label, most_support)));
    return (values);
  }

  void
  writeGrey (const std::string& file, const std::vector<std::uint16_t>& values) const
  {
    std::vector<unsigned char> bytes (values.begin (), values.end ());
    pcl::io::saveCharPNGFile (make (file), bytes.data (), width, height, 1);
  }

  void
  writePalette (const std::string& file, const std::vector<std::uint16_t>& values) const
  {
    const std::vector<unsigned char> bytes (values.begin (), values.end ());
    std::vector<unsigned char> colors;
    for (int value = 0; value <= *std::max_element (values.begin (), values.end ()); ++value)
      colors.insert (colors.end (), {static_cast<unsigned char> (200 - 20 * value), 17, 99}); // unlike the indices
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = PNG_FORMAT_RGB_COLORMAP;
    image.colormap_entries = static_cast<png_uint_32> (colors.size () / 3);
    ASSERT_NE (png_image_write_to_file (&image, make (file).c_str (), 0, bytes.data (), 0, colors.data ()), 0);
  }

  void
  writeCloud (const std::string& file) const
  {
    pcl::PointCloud<pcl::PointXYZRGB> unlabelled;
    pcl::copyPointCloud (*cloud_, unlabelled);
    pcl::io::savePCDFileBinary (make (file), unlabelled);
  }

  void
  writeOsd (const std::string& folder) const
  {
    writeColor (folder + "/image_color/learn20.png");
    writeDepth (folder + "/disparity/learn20.png");
    writeGrey (folder + "/annotation/learn20.png", labelValues (1, 0));
  }

  void
  writeOcid (const std::string& folder, const std::string& name = "result_1") const
  {
    writeColor (folder + "/rgb/" + name + ".png");
    writeDepth (folder + "/depth/" + name + ".png");
    writePalette (folder + "/label/" + name + ".png", labelValues (3, 2));
  }

  /** \brief The one scene of a data set has the points, colours and objects of the rendered one. */
  SceneSource
  expectTheScene (const std::string& folder, const DataSetOptions& options, double tolerance)
  {
    const std::vector<SceneSource> sources = listSceneSources ({folder_ / folder}, options);
    EXPECT_EQ (sources.size (), 1u);
    const LabelledScene scene = loadScene (sources.front (), options);
    EXPECT_EQ (scene.cloud->width, cloud_->width);
    const GroundTruth truth = makeGroundTruth (*scene.cloud, GroundTruthKind::objects);
    EXPECT_EQ (truth.region_of, makeGroundTruth (*cloud_, GroundTruthKind::objects).region_of);
    EXPECT_GT (truth.regions.size (), 1u);
    for (std::size_t i = 0; i < cloud_->size (); ++i)
    {
      const auto &expected = (*cloud_)[i], &point = (*scene.cloud)[i];
      EXPECT_EQ (pcl::isXYZFinite (point), pcl::isXYZFinite (expected));
      EXPECT_EQ (point.r, expected.r);
      if (pcl::isXYZFinite (expected))
      {
        EXPECT_NEAR ((point.getVector3fMap () - expected.getVector3fMap ()).norm (), 0, tolerance);
      }
      if (testing::Test::HasFailure ())
        break;
    }
    return (sources.front ());
  }

  std::string
  errorOf (const std::string& folder, const DataSetOptions& options)
  {
    return (test::messageOf ([&] { listSceneSources ({folder_ / folder}, options); }));
  }
};

TEST_F (DataSets, labelledClouds)
{
  pcl::io::savePCDFileBinary (make ("data/learn20.pcd"), *cloud_);
  const SceneSource source = expectTheScene ("data", {}, 0);
  EXPECT_EQ (source.name, "learn20");
  EXPECT_EQ (source.category, "stacked");
}

TEST_F (DataSets, aSensorPoseThatCannotHaveSeenThePointsIsMended)
{
  pcl::PointCloud<pcl::PointXYZRGBL> y_up = *cloud_; // with the pose of a camera that looks the other way
  for (pcl::PointXYZRGBL& point : y_up)
  {
    point.y = -point.y;
    point.z = -point.z;
  }
  pcl::io::savePCDFileBinary (make ("up/scene.pcd"), y_up);
  pcl::io::savePCDFileBinary (make ("down/scene.pcd"), *cloud_);
  const auto forward = [&] (const std::string& folder) -> Eigen::Vector3f {
    const auto scene = loadScene (listSceneSources ({folder_ / folder}, {}).front (), {});
    EXPECT_TRUE (scene.cloud->sensor_origin_.isZero ());
    return (scene.cloud->sensor_orientation_ * Eigen::Vector3f::UnitZ ());
  };
  EXPECT_TRUE (forward ("up").isApprox (-Eigen::Vector3f::UnitZ ()));
  EXPECT_TRUE (forward ("down").isApprox (Eigen::Vector3f::UnitZ ()));
}

TEST_F (DataSets, aLabelledCloudWithoutAnyPointIsAnError)
{
  pcl::PointCloud<pcl::PointXYZRGBL> holes = *cloud_;
  for (pcl::PointXYZRGBL& point : holes)
    point.x = point.y = point.z = std::numeric_limits<float>::quiet_NaN ();
  pcl::io::savePCDFileBinary (make ("holes/scene.pcd"), holes);
  const SceneSource source = listSceneSources ({folder_ / "holes"}, {}).front ();
  EXPECT_EQ (test::messageOf ([&] { loadScene (source, {}); }).find (source.points + ": no valid point"), 0u);
}

TEST_F (DataSets, osd)
{
  writeOsd ("osd");
  SceneSource source = expectTheScene ("osd", by_depth_, .001);
  EXPECT_EQ (source.name, "learn20");
  EXPECT_EQ (source.category, "stacked");
  EXPECT_EQ (source.files ().size (), 3u);

  // Clouds serve as well, and need no camera.
  EXPECT_EQ (errorOf ("osd", {}), (folder_ / "osd") + ": depth images need the camera's -intrinsics fx,fy,cx,cy");
  writeCloud ("osd/pcd/learn20.pcd");
  EXPECT_EQ (fs::path (expectTheScene ("osd", {}, 0).points).filename (), "learn20.pcd");

  // Another label that is none of an object
  DataSetOptions options;
  options.support_labels = {0, 2};
  const auto sources = listSceneSources ({folder_ / "osd"}, options);
  EXPECT_EQ (makeGroundTruth (*loadScene (sources[0], options).cloud, GroundTruthKind::objects).regions.size () + 1,
             makeGroundTruth (*cloud_, GroundTruthKind::objects).regions.size ());
}

TEST_F (DataSets, ocid)
{
  writeOcid ("ocid/ARID20/table/top/mixed/seq01");
  const SceneSource source = expectTheScene ("ocid", by_depth_, .001);
  EXPECT_EQ (source.name, "ARID20_table_top_mixed_seq01_result_1");
  EXPECT_EQ (source.category, "ARID20/table/top/mixed");
  EXPECT_EQ (listSceneSources ({folder_ / "ocid/ARID20/table/top/mixed/seq01"}, by_depth_)[0].name, "result_1");

  // On the floor label 2 is an object.
  writeOcid ("floor/ARID20/floor/top/seq01");
  EXPECT_EQ (listSceneSources ({folder_ / "floor"}, by_depth_)[0].support_labels, (std::vector<std::uint16_t>{0, 1}));

  writeOcid ("ocid/ARID20/table/top/mixed/seq02");
  EXPECT_EQ (listSceneSources ({folder_ / "ocid"}, by_depth_).size (), 2u);
}

TEST_F (DataSets, cloudsWithMasks)
{
  writeCloud ("willow/masks_apart.pcd");
  std::vector<std::uint16_t> values = labelValues (1, 0);
  const int objects = *std::max_element (values.begin (), values.end ());
  for (int object = 1; object <= objects; ++object)
  {
    std::vector<std::uint16_t> mask;
    for (const auto value : values)
      mask.push_back (value == object ? 255 : 0);
    writeGrey ("willow/masks/masks_apart_" + std::to_string (object) + ".png", mask);
  }
  const SceneSource source = expectTheScene ("willow", {}, 0);
  EXPECT_EQ (source.masks.size (), static_cast<std::size_t> (objects));
  EXPECT_EQ (source.category, "willow");
  fs::remove_all (folder_ / "willow/masks");
  EXPECT_EQ (errorOf ("willow", {}), (folder_ / "willow/masks_apart.pcd") +
                                         ": no field \"label\", and no masks masks_apart_*.png beside it or in masks/");
}

TEST_F (DataSets, whatIsWrongIsNamedFileByFileBeforeTheWork)
{
  writeOsd ("osd");
  for (const char* name : {"a", "b", "c", "d"})
    for (const std::string folder : {"image_color", "disparity", "annotation"})
      fs::copy (folder_ / ("osd/" + folder + "/learn20.png"), folder_ / ("osd/" + folder + "/" + name + ".png"));
  fs::remove (folder_ / "osd/annotation/a.png");
  fs::copy (folder_ / "osd/image_color/a.png", folder_ / "osd/disparity/b.png", fs::copy_options::overwrite_existing);
  test::writeText (folder_ / "osd/image_color/c.png", "no image");
  const std::vector<unsigned char> small (100, 0);
  pcl::io::saveCharPNGFile (folder_ / "osd/annotation/d.png", small.data (), 10, 10, 1);
  const test::Outcome result = run ("osd -output_dir out -intrinsics 131.25,131.25,79.5,59.5");
  EXPECT_EQ (result.exit_code, 1);
  EXPECT_EQ (result.errors, "pcl_attention_evaluate: 4 files are wrong or missing\n"
                            "  osd/annotation/a.png: missing\n"
                            "  osd/disparity/b.png: not a depth image: that has to be a 16-bit grey PNG\n"
                            "  osd/image_color/c.png: cannot be read as PNG: Not a PNG file\n"
                            "  osd/annotation/d.png: 10x10 pixels, but osd/disparity/d.png has 160x120\n");
  EXPECT_FALSE (fs::exists (folder_ / "out"));

  test::writeText (folder_ / "data/x.pcd", "");
  fs::create_directories (folder_ / "data");
  test::writeText (folder_ / "data/x.pcd", "# .PCD v0.7\nno cloud\n");
  EXPECT_NE (errorOf ("data", {}).find ((folder_ / "data/x.pcd") + ": "), std::string::npos);
  fs::create_directories (folder_ / "empty/below");
  EXPECT_NE (errorOf ("empty", {}).find (": no labelled scenes: "), std::string::npos);
  EXPECT_EQ (run ("osd -support_labels 0,x").exit_code, 2);
  EXPECT_EQ (run ("osd -color image_color").exit_code, 2);
}

TEST_F (DataSets, anImageCutShortIsAnErrorOfTheScene)
{
  writeOsd ("osd");
  const std::string file = folder_ / "osd/annotation/learn20.png", whole = test::readText (file);
  test::writeText (file, whole.substr (0, whole.size () / 2));
  const test::Outcome result = run ("osd -intrinsics 131.25,131.25,79.5,59.5");
  EXPECT_EQ (result.exit_code, 1);
  EXPECT_EQ (result.errors.find ("pcl_attention_evaluate: osd/annotation/learn20.png: damaged: "), 0u) << result.errors;
}

TEST_F (DataSets, theProgramEvaluatesEveryLayout)
{
  writeOsd ("osd");
  writeOcid ("ocid/table/seq01");
  for (const std::string data : {"osd", "ocid"})
  {
    expectSuccess (data + " -intrinsics 131.25,131.25,79.5,59.5 -output_dir out_" + data);
    EXPECT_NE (content ("out_" + data + "/report.csv").find ("proposed,,objects,overall,1,"), std::string::npos);
  }
  // the same scene with the same objects
  const auto figures = [this] (const std::string& data) {
    const std::string csv = content ("out_" + data + "/report.csv");
    return (csv.substr (csv.find (",overall,")));
  };
  EXPECT_EQ (figures ("osd").substr (0, figures ("osd").find ('\n')),
             figures ("ocid").substr (0, figures ("ocid").find ('\n')));
  EXPECT_NE (run ("osd -intrinsics 130,130,79.5,59.5 -output_dir out_osd").errors.find ("/camera/0 is 131.25"),
             std::string::npos);
}

} // namespace
} // namespace pcl_attention
