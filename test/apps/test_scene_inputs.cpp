// SPDX-License-Identifier: BSD-3-Clause
// Scenes in other forms than an organized PCD file: depth images, PLY, unorganized clouds, and a limit of the range.
#include "files.h"
#include "png_image.h"
#include "reading_errors.h"

#include <pcl/common/point_tests.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/io/png_io.h>

#include <boost/crc.hpp>
#include <cmath>
#include <random>

using namespace pcl_attention;

namespace
{

constexpr int width = 32, height = 24;

SceneOptions
withCamera ()
{
  SceneOptions options;
  options.camera.fx = options.camera.fy = 100.0;
  options.camera.cx = 0.5 * (width - 1);
  options.camera.cy = 0.5 * (height - 1);
  return (options);
}

SceneOptions
withImageSize ()
{
  SceneOptions options = withCamera ();
  options.camera.width = width;
  options.camera.height = height;
  return (options);
}

pcl::PointCloud<pcl::PointXYZRGB>
coloredWall (float depth = 1.0f)
{
  auto cloud = test::wallBefore<pcl::PointXYZRGB> (width, height, depth);
  for (std::size_t i = 0; i < cloud.size (); ++i)
  {
    cloud[i].r = static_cast<std::uint8_t> (i);
    cloud[i].g = 7;
    cloud[i].b = 255;
  }
  return (cloud);
}

/** \brief Points and colours alike, NaN where NaN. */
void
expectSameCloud (const pcl::PointCloud<pcl::PointXYZRGB>& cloud, const pcl::PointCloud<pcl::PointXYZRGB>& expected)
{
  ASSERT_EQ (cloud.width, expected.width);
  ASSERT_EQ (cloud.height, expected.height);
  for (std::size_t i = 0; i < cloud.size (); ++i)
  {
    ASSERT_EQ (pcl::isFinite (cloud[i]), pcl::isFinite (expected[i])) << i;
    if (!pcl::isFinite (cloud[i]))
      continue;
    ASSERT_LT ((cloud[i].getVector3fMap () - expected[i].getVector3fMap ()).norm (), 1e-6f) << i;
    ASSERT_EQ (cloud[i].r, expected[i].r) << i;
  }
}

class SceneInputs : public testing::Test
{
protected:
  test::TemporaryFolder folder_;

  std::string
  saveDepths (const std::string& name, const std::vector<std::uint16_t>& depths)
  {
    pcl::io::saveShortPNGFile (folder_ / name, depths.data (), width, height, 1);
    return (folder_ / name);
  }

  void
  saveColors (const std::string& name, const pcl::PointCloud<pcl::PointXYZRGB>& cloud)
  {
    std::vector<std::uint8_t> values;
    for (const auto& point : cloud)
      values.insert (values.end (), {point.r, point.g, point.b});
    pcl::io::saveRgbPNGFile (folder_ / name, values.data (), static_cast<int> (cloud.width),
                             static_cast<int> (cloud.height));
  }
};

std::vector<std::uint16_t>
depthsOfWall (std::uint16_t value)
{
  return (std::vector<std::uint16_t> (static_cast<std::size_t> (width) * height, value));
}

} // namespace

TEST_F (SceneInputs, ReadsADepthImageWithItsColour)
{
  auto expected = coloredWall ();
  expected[5].x = expected[5].y = expected[5].z = std::numeric_limits<float>::quiet_NaN ();
  std::vector<std::uint16_t> depths = depthsOfWall (1000);
  depths[5] = 0;
  depths[9] = 1300;
  expected[9].getVector3fMap () *= 1.3f;
  const std::string file = saveDepths ("scene.png", depths);
  saveColors ("color.png", expected);
  SceneOptions options = withCamera ();
  options.color = folder_ / "color.png";
  const Scene scene = readScene (file, options);
  EXPECT_TRUE (scene.has_color);
  EXPECT_EQ (scene.valid_points, expected.size () - 1);
  expectSameCloud (*scene.cloud, expected);
  ASSERT_EQ (scene.notes.size (), 1u);
  EXPECT_EQ (scene.notes[0], "depth 1 to 1.3 m, median 1 m, at 99 % of the pixels");

  std::filesystem::create_directory (folder_ / "colors");
  saveColors ("colors/scene.png", expected);
  options.color = folder_ / "colors";
  expectSameCloud (*readScene (file, options).cloud, expected);
  EXPECT_FALSE (readScene (file, withCamera ()).has_color);
}

TEST_F (SceneInputs, TakesTheScaleOfADepthImageAndShowsAWrongOne)
{
  const std::string file = saveDepths ("scene.png", depthsOfWall (5000));
  SceneOptions options = withCamera ();
  options.camera.depth_scale = 0.0002;
  expectSameCloud (*readScene (file, options).cloud, test::wallBefore<pcl::PointXYZRGB> (width, height, 1.0f));
  options.camera.depth_scale = 1.0;
  const Scene wrong = readScene (file, options);
  ASSERT_EQ (wrong.notes.size (), 2u);
  EXPECT_EQ (wrong.notes[0], "depth 5000 to 5000 m, median 5000 m, at 100 % of the pixels");
  EXPECT_EQ (wrong.notes[1].find ("the median depth is 5000 m: "), 0u);
}

TEST_F (SceneInputs, SaysWhatIsWrongWithADepthImage)
{
  const std::string file = saveDepths ("scene.png", depthsOfWall (1000));
  EXPECT_EQ (errorOfReading (file, {}), "a depth image needs the camera's -intrinsics fx,fy,cx,cy");
  SceneOptions options = withImageSize ();
  options.camera.width = 640;
  EXPECT_EQ (errorOfReading (file, options), "32 x 24 pixels, but the intrinsics are of 640 x 24");
  EXPECT_EQ (errorOfReading (saveDepths ("zero.png", depthsOfWall (0)), withCamera ()), "no depth: all values are 0");
  saveColors ("rgb.png", coloredWall ());
  EXPECT_EQ (errorOfReading (folder_ / "rgb.png", withCamera ()).find ("not a depth image: that has to be a 16-bit grey PNG"),
             0u);
  test::writeText (folder_ / "text.png", "text");
  EXPECT_EQ (errorOfReading (folder_ / "text.png", withCamera ()).find ("cannot be read as PNG: "), 0u);

  options = withCamera ();
  options.color = folder_ / "none.png";
  EXPECT_EQ (errorOfReading (file, options), "its colour image " + (folder_ / "none.png") + ": no such file");
  options.color = folder_ / "text.png";
  EXPECT_EQ (errorOfReading (file, options).find ("its colour image " + options.color + ": cannot be read as PNG"), 0u);
  options.color = folder_ / "small.png";
  saveColors ("small.png", test::wallBefore<pcl::PointXYZRGB> (16, 12));
  EXPECT_EQ (errorOfReading (file, options)
                 .find ("its colour image " + options.color +
                        ": 16 x 12 pixels, the depth image has 32 x 24: depth registered"),
             0u);
}

TEST_F (SceneInputs, AllocatesNothingForPixelsThatAnImageCannotHold)
{
  const std::string file = saveDepths ("scene.png", depthsOfWall (1000));
  const std::string whole = test::readText (file);
  // The header's size, and the checksum of its 17 bytes.
  const auto announce = [&] (std::uint32_t columns, std::uint32_t rows) {
    std::string text = whole;
    const auto put = [&] (std::size_t at, std::uint32_t value) {
      for (std::size_t byte = 0; byte < 4; ++byte)
        text[at + byte] = static_cast<char> (value >> (24 - 8 * byte));
    };
    put (16, columns);
    put (20, rows);
    boost::crc_32_type checksum;
    checksum.process_bytes (&text[12], 17);
    put (29, checksum.checksum ());
    test::writeText (file, text);
    return (errorOfReading (file, withCamera ()));
  };
  EXPECT_EQ (announce (32, 24), "");
  EXPECT_EQ (announce (8000, 8000), "truncated: the header announces an image that the file cannot hold");
  EXPECT_EQ (announce (16385, 2), "the image is 16385 x 2, more than the 16384 a side and 67108864 in all that are taken");
  EXPECT_EQ (announce (16384, 16384),
             "the image is 16384 x 16384, more than the 16384 a side and 67108864 in all that are taken");
  SceneOptions options = withCamera ();
  options.color = folder_ / "color.png";
  std::filesystem::rename (file, options.color);
  saveDepths ("scene.png", depthsOfWall (1000));
  EXPECT_EQ (errorOfReading (file, options),
             "its colour image " + options.color +
                 ": the image is 16384 x 16384, more than the 16384 a side and 67108864 in all that are taken");
}

TEST_F (SceneInputs, SurvivesDamagedImages)
{
  std::vector<std::uint16_t> depths = depthsOfWall (1000);
  for (std::size_t i = 0; i < depths.size (); ++i)
    depths[i] = static_cast<std::uint16_t> (700 + i * 7919 % 900);
  const std::string file = saveDepths ("scene.png", depths);
  saveColors ("color.png", coloredWall ());
  SceneOptions options = withCamera ();
  options.color = folder_ / "color.png";
  std::mt19937 random (1);
  for (const std::string& damaged : {file, options.color})
  {
    const std::string whole = test::readText (damaged);
    for (int trial = 0; trial < 200; ++trial)
    {
      std::string text = whole;
      if (trial % 2 == 0)
        text.resize (random () % text.size ());
      else
        text[random () % text.size ()] = static_cast<char> (random ());
      test::writeText (damaged, text);
      const std::string message = errorOfReading (file, options);
      // The last twelve bytes say nothing but that the image ends.
      EXPECT_TRUE (text.size () + 12 >= whole.size () || !message.empty ()) << "cut to " << text.size ();
    }
    test::writeText (damaged, whole);
  }
  EXPECT_EQ (errorOfReading (file, options), "");
}

TEST_F (SceneInputs, IsToldWhereverAnImageIsCut)
{
  const std::string file = saveDepths ("scene.png", depthsOfWall (1000));
  saveColors ("color.png", coloredWall ());
  SceneOptions options = withCamera ();
  options.color = folder_ / "color.png";
  EXPECT_EQ (errorOfReading (file, options), "");
  for (const std::string& cut : {file, options.color})
  {
    const std::string whole = test::readText (cut);
    for (std::size_t length = 0; length + 12 < whole.size (); ++length)
    {
      test::writeText (cut, whole.substr (0, length));
      EXPECT_NE (errorOfReading (file, options), "") << cut << " cut to " << length;
    }
    test::writeText (cut, whole);
  }
}

TEST_F (SceneInputs, ReadsPly)
{
  auto cloud = coloredWall ();
  cloud[5].x = cloud[5].y = cloud[5].z = std::numeric_limits<float>::quiet_NaN ();
  const std::string file = folder_ / "scene.ply";
  for (const bool binary : {true, false})
  {
    pcl::PLYWriter ().write (file, cloud, binary, true);
    const Scene scene = readScene (file);
    EXPECT_TRUE (scene.has_color);
    EXPECT_EQ (scene.valid_points, cloud.size () - 1);
    expectSameCloud (*scene.cloud, cloud);
  }
  // As other programs write it: doubles, and no image size.
  test::writeText (file,
                   "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                   "property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
                   "0 0 1 9 8 7\n0.01 0 1 9 8 7\n0 0.01 1 9 8 7\n0.01 0.01 1 9 8 7\n");
  EXPECT_EQ (errorOfReading (file, {}).find ("not organized (4 x 1 points)"), 0u);
  SceneOptions options;
  options.image_width = 2;
  const Scene scene = readScene (file, options);
  EXPECT_EQ (scene.cloud->height, 2u);
  EXPECT_EQ (scene.cloud->at (1, 1).y, 0.01f);
  EXPECT_EQ (scene.cloud->at (1, 1).r, 9);
}

TEST_F (SceneInputs, SaysWhatIsWrongWithAPlyFile)
{
  const auto errorOf = [&] (const std::string& text) {
    test::writeText (folder_ / "scene.ply", text);
    return (errorOfReading (folder_ / "scene.ply", withImageSize ()));
  };
  const std::string begin = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  const std::string end = "property float x\nproperty float y\nproperty float z\nend_header\n";
  EXPECT_EQ (errorOf (""), "an empty file");
  EXPECT_EQ (errorOf ("VERSION 0.7\n"), "not a PLY file");
  EXPECT_EQ (errorOf (begin + "3\n"), "truncated: the PLY header has no end");
  EXPECT_EQ (errorOf (begin + "0\n" + end), "no points");
  EXPECT_EQ (errorOf (begin + "-3\n" + end), "damaged PLY header: 'element vertex -3'");
  EXPECT_EQ (errorOf (begin + "2000000000\n" + end),
             "truncated: the header announces 2000000000 elements, more than the file can hold");
  EXPECT_EQ (errorOf (begin + "2\n" + end + "123456789012"),
             "truncated: the header announces 2 points, more than the file can hold");
  EXPECT_EQ (errorOf (begin + "1\n" + end.substr (0, end.size () - 1)),
             "truncated: the header announces 1 points, more than the file can hold");
  EXPECT_EQ (errorOf (begin + "1\nproperty half x\nend_header\n"), "damaged PLY header: unknown type 'half'");
  EXPECT_EQ (errorOf (begin + "1\nproperty float x\nproperty float y\nend_header\n12345678"),
             "no property z: a cloud with the properties x, y and z is needed");
}

TEST_F (SceneInputs, SparesPclWhatItCannotReadOfPly)
{
  const std::string file = folder_ / "scene.ply", begin = "ply\nformat ascii 1.0\n",
                    points = "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n",
                    end = "end_header\n0 0 1\n0 0 1\n";
  const auto errorOf = [&] (const std::string& text) {
    test::writeText (file, text);
    return (errorOfReading (file, {}));
  };
  EXPECT_EQ (errorOf (begin + points + "property list uchar int indices\n" + end),
             "its points have a list as a property, on which PCL's reader ends the program: leave it out");
  EXPECT_EQ (errorOf (begin + points + "property uchar blue\n" + end), "damaged PLY header: blue without red before it");
  EXPECT_EQ (errorOf (begin + " obj_info num_cols 2\n" + points + end), "damaged PLY header: ' obj_info num_cols 2'");
  EXPECT_EQ (errorOf (begin + points + points + end), "damaged PLY header: points twice");
  EXPECT_EQ (errorOf (begin + points + "proper float w\n" + end), "damaged PLY header: 'proper float w'");
  const std::string announces = "truncated: the header announces an image of 2000000000 x 2 points, more than the file can hold";
  EXPECT_EQ (errorOf (begin + "obj_info num_cols 2000000000\nobj_info num_rows 2\n" + points + end), announces);
  EXPECT_EQ (errorOf (begin + "obj_info num_cols 5555555555\nobj_info num_rows 2\n" + points + end),
             "damaged PLY header: 'obj_info num_cols 5555555555'");
  EXPECT_EQ (errorOf (begin + "obj_info num_cols 1\nobj_info num_rows 1\n" + points + end),
             "damaged PLY header: 2 points in an image of 1 x 1");
  EXPECT_EQ (errorOf (begin + "obj_info num_cols 0\nobj_info num_rows 0\n" + points + end),
             "damaged PLY header: 2 points in an image of 0 x 0");
  EXPECT_EQ (errorOf (begin + "obj_info num_cols 8\n" + points + end), "damaged PLY header: 2 points in an image of 8 x 0");
  EXPECT_EQ (errorOf (begin + "obj_info num_rows 2\n" + points + "obj_info num_cols 1\n" + end),
             "damaged PLY header: 'obj_info num_cols 1' after the points");
  const std::string grid = "obj_info num_cols 3\nobj_info num_rows 2\n" + points +
                           "element range_grid 6\nproperty list uchar int vertex_indices\n" + end;
  EXPECT_EQ (errorOf (begin + grid + "1 0\n0\n1 1\n0\n0\n0\n"), "");
  EXPECT_EQ (errorOf (begin + grid + "1 0\n0\n1 2000000000\n0\n0\n0\n"), "damaged: PCL cannot read its points");
  EXPECT_EQ (errorOf (begin + grid + "1 -9\n0\n1 1\n0\n0\n0\n"), "damaged: PCL cannot read its points");
}

TEST_F (SceneInputs, SurvivesDamagedPlyFiles)
{
  const std::string file = folder_ / "scene.ply";
  for (const bool binary : {true, false})
  {
    pcl::PLYWriter ().write (file, coloredWall (), binary, true);
    const std::string whole = test::readText (file);
    std::mt19937 random (1);
    for (int trial = 0; trial < 200; ++trial)
    {
      std::string text = whole;
      if (trial % 2 == 0)
        text.resize (random () % text.size ());
      else
        text[random () % (trial % 4 == 1 ? 600 : text.size ())] = static_cast<char> (random ());
      test::writeText (file, text);
      errorOfReading (file, withImageSize ()); // any error or none, but one line that names the file, and no crash
    }
  }
}

TEST_F (SceneInputs, OrganizesByTheIntrinsics)
{
  const auto wall = coloredWall ();
  pcl::PointCloud<pcl::PointXYZRGB> points;
  points.push_back (wall[7]); // hidden: something stands before it
  points.back ().getVector3fMap () *= 3.0f;
  for (std::size_t i = 0; i < wall.size (); ++i)
    points.push_back (wall[(i * 389) % wall.size ()]); // in any order
  points.push_back (wall[0]);                          // outside the image
  points.back ().x -= 1.0f;
  const std::string file = folder_ / "scene.pcd";
  pcl::io::savePCDFileBinary (file, points);
  const Scene scene = readScene (file, withImageSize ());
  expectSameCloud (*scene.cloud, wall);
  ASSERT_EQ (scene.notes.size (), 1u);
  EXPECT_EQ (scene.notes[0],
             "organized by the intrinsics: 770 points in 32 x 24 pixels, 1 outside the image, 1 behind or "
             "before others");

  EXPECT_EQ (errorOfReading (file, {}).find ("not organized (770 x 1 points)"), 0u);
  EXPECT_NE (errorOfReading (file, withCamera ()).find ("the camera's image size is needed"), std::string::npos);
  for (auto& point : points)
    point.z = -point.z;
  pcl::io::savePCDFileBinary (file, points);
  EXPECT_EQ (errorOfReading (file, withImageSize ()).find ("no point is seen by the camera of the intrinsics"), 0u);
}

TEST_F (SceneInputs, OrganizesFromTheSensorPose)
{
  const auto wall = coloredWall ();
  pcl::PointCloud<pcl::PointXYZRGB> points = wall;
  const Eigen::Quaternionf turn (Eigen::AngleAxisf (2.0f, Eigen::Vector3f (1, 2, 3).normalized ()));
  const Eigen::Vector3f shift (5, -3, 2);
  for (auto& point : points)
    point.getVector3fMap () = (turn * point.getVector3fMap () + shift).eval ();
  points.sensor_orientation_ = turn;
  points.sensor_origin_.head<3> () = shift;
  points.width = static_cast<std::uint32_t> (points.size ());
  points.height = 1;
  const auto expected = points;
  pcl::io::savePCDFileBinary (folder_ / "scene.pcd", points);
  const Scene scene = readScene (folder_ / "scene.pcd", withImageSize ());
  ASSERT_EQ (scene.cloud->width, static_cast<std::uint32_t> (width));
  for (std::size_t i = 0; i < expected.size (); ++i)
    ASSERT_EQ ((*scene.cloud)[i].getVector3fMap (), expected[i].getVector3fMap ());
}

TEST_F (SceneInputs, NotesIntrinsicsThatAreNotNeeded)
{
  pcl::io::savePCDFileBinary (folder_ / "scene.pcd", coloredWall ());
  const Scene scene = readScene (folder_ / "scene.pcd", withImageSize ());
  ASSERT_EQ (scene.notes.size (), 1u);
  EXPECT_EQ (scene.notes[0], "organized already, the intrinsics are not used");
}

TEST_F (SceneInputs, CutsTheRange)
{
  auto cloud = coloredWall ();
  for (int i = 0; i < 40; ++i)
    cloud[i].getVector3fMap () *= 4.0f;
  pcl::io::savePCDFileBinary (folder_ / "scene.pcd", cloud);
  SceneOptions options;
  options.max_range = 2.5f;
  const Scene scene = readScene (folder_ / "scene.pcd", options);
  EXPECT_EQ (scene.valid_points, cloud.size () - 40);
  EXPECT_TRUE (std::isnan ((*scene.cloud)[39].z));
  EXPECT_EQ ((*scene.cloud)[40].z, 1.0f);
  ASSERT_EQ (scene.notes.size (), 1u);
  EXPECT_EQ (scene.notes[0], "40 points beyond 2.5 m are left out");
  options.max_range = 0.5f;
  EXPECT_EQ (errorOfReading (folder_ / "scene.pcd", options), "all points are beyond -max_range 0.5 m");
  options.max_range = 5.0f;
  EXPECT_TRUE (readScene (folder_ / "scene.pcd", options).notes.empty ());
}

TEST_F (SceneInputs, ReadsTheCameraFromTextOrJson)
{
  DepthCamera camera = readDepthCamera ("525,526.5,319.5,239.5");
  EXPECT_EQ (camera.fy, 526.5);
  EXPECT_EQ (camera.cy, 239.5);
  EXPECT_EQ (camera.width, 0);
  EXPECT_EQ (camera.depth_scale, 0.001);
  EXPECT_EQ (readDepthCamera ("525,525,319.5,239.5,640,480").height, 480);
  const std::string file = folder_ / "camera.json";
  test::writeText (
      file, R"({"fx": 525, "fy": 525, "cx": 319.5, "cy": 239.5, "width": 640, "height": 480, "depth_scale": 0.0002})");
  camera = readDepthCamera (file);
  EXPECT_EQ (camera.cx, 319.5);
  EXPECT_EQ (camera.width, 640);
  EXPECT_EQ (camera.depth_scale, 0.0002);

  const auto errorOf = [] (const std::string& text) {
    try
    {
      readDepthCamera (text);
    }
    catch (const std::runtime_error& error)
    {
      return (std::string (error.what ()));
    }
    return (std::string ());
  };
  for (const char* text : {"", "525", "525,525,319.5", "525,525,319.5,239.5,", "525,525,319.5,239.5,640", "525;525;1;1",
                           "525,525,319.5,239.5,640,480,1", "a,b,c,d", "nan,525,319.5,239.5", "525,525,inf,239.5"})
    EXPECT_EQ (errorOf (text), "'" + std::string (text) +
                                   "': neither a JSON file nor numbers as fx,fy,cx,cy or fx,fy,cx,cy,width,height");
  EXPECT_EQ (errorOf ("0,525,319.5,239.5"), "'0,525,319.5,239.5': fx is 0, but must be above 0, in pixels");
  EXPECT_EQ (errorOf ("525,525,319.5,239.5,640.5,480"),
             "'525,525,319.5,239.5,640.5,480': width is 640.5, but must be a whole number from 1 to 16384");
  EXPECT_EQ (errorOf ("525,525,319.5,239.5,16384,16384"),
             "'525,525,319.5,239.5,16384,16384': width x height is 16384 x 16384, more than the 16384 a side and 67108864 in all "
             "that are taken");
  EXPECT_EQ (errorOf (folder_ / "none.json").find (folder_ / "none.json: cannot be opened"), 0u);
  test::writeText (file, R"({"fx": 525, "fy": 525, "cx": 319.5})");
  EXPECT_EQ (errorOf (file), file + ": no cy: the camera's fx, fy, cx and cy are needed");
  test::writeText (file, R"({"fx": "wide"})");
  EXPECT_EQ (errorOf (file), file + ": fx is \"wide\", but must be a number");
  test::writeText (file, R"({"focal": 525})");
  EXPECT_EQ (errorOf (file).find (file + ": unknown key \"focal\""), 0u);
}
