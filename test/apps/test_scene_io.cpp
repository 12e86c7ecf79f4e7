// SPDX-License-Identifier: BSD-3-Clause
#include "files.h"
#include "reading_errors.h"

#include <pcl/io/pcd_io.h>

#include <cmath>
#include <limits>
#include <random>

using namespace pcl_attention;

namespace
{

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN ();

pcl::PointCloud<pcl::PointXYZRGB>
coloredWall (int width = 32, int height = 24, float depth = 1.0f)
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

/** \brief A PCD file with the header's values replaced as asked for, and 4x3 points of zeros. */
std::string
pcdText (const std::string& from = "", const std::string& to = "")
{
  std::string text = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 4\nHEIGHT 3\n"
                     "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 12\nDATA binary\n";
  if (!from.empty ())
    text.replace (text.find (from), from.size (), to);
  for (int i = 0; i < 36; ++i)
  {
    const float value = 1.0f;
    text.append (reinterpret_cast<const char*> (&value), sizeof (value));
  }
  return (text);
}

SceneOptions
rowsOf (int image_width)
{
  SceneOptions options;
  options.image_width = image_width;
  return (options);
}

class SceneIo : public testing::Test
{
protected:
  test::TemporaryFolder folder_;
  std::string file_{folder_ / "scene.pcd"};

  template <typename PointT>
  Scene
  roundTrip (const pcl::PointCloud<PointT>& cloud)
  {
    pcl::io::savePCDFileBinaryCompressed (file_, cloud);
    return (readScene (file_));
  }

  /** \brief What is in a PCD file: text, binary or compressed for encoding 0, 1 or 2. */
  template <typename PointT>
  std::string
  textOf (const pcl::PointCloud<PointT>& cloud, int encoding)
  {
    if (encoding == 0)
      pcl::io::savePCDFileASCII (file_, cloud);
    else if (encoding == 1)
      pcl::io::savePCDFileBinary (file_, cloud);
    else
      pcl::io::savePCDFileBinaryCompressed (file_, cloud);
    return (test::readText (file_));
  }

  std::string
  error (const SceneOptions& options = {})
  {
    return (errorOfReading (file_, options));
  }

  std::string
  errorOfText (const std::string& text)
  {
    test::writeText (file_, text);
    return (error ());
  }
};

TEST_F (SceneIo, readsPointsColourAndPose)
{
  auto cloud = coloredWall ();
  cloud[5].x = nan_value;
  const Scene scene = roundTrip (cloud);
  EXPECT_EQ (scene.name, "scene");
  EXPECT_TRUE (scene.has_color);
  EXPECT_EQ (scene.valid_points, cloud.size () - 1);
  EXPECT_EQ (scene.cloud->width, 32u);
  EXPECT_EQ (scene.cloud->height, 24u);
  EXPECT_TRUE (std::isnan ((*scene.cloud)[5].z));
  EXPECT_EQ ((*scene.cloud)[40].x, cloud[40].x);
  EXPECT_EQ ((*scene.cloud)[40].r, 40);
  EXPECT_EQ ((*scene.cloud)[40].b, 255);
  EXPECT_TRUE (scene.notes.empty ());
}

TEST_F (SceneIo, takesColourInEveryForm)
{
  const auto cloud = coloredWall ();
  pcl::PCLPointCloud2 blob;
  pcl::toPCLPointCloud2 (cloud, blob);
  for (const char* name : {"rgb", "rgba"})
    for (const std::uint8_t type : {pcl::PCLPointField::FLOAT32, pcl::PCLPointField::UINT32, pcl::PCLPointField::INT32})
    {
      blob.fields[3].name = name;
      blob.fields[3].datatype = type;
      pcl::PCDWriter ().writeBinary (file_, blob);
      const Scene scene = readScene (file_);
      EXPECT_TRUE (scene.has_color);
      EXPECT_EQ ((*scene.cloud)[40].r, 40) << name << int (type);
    }
  EXPECT_FALSE (roundTrip (test::wallBefore<pcl::PointXYZ> (32, 24)).has_color);
}

TEST_F (SceneIo, readsEveryEncoding)
{
  const auto cloud = coloredWall ();
  pcl::io::savePCDFileASCII (file_, cloud);
  EXPECT_EQ (readScene (file_).valid_points, cloud.size ());
  pcl::io::savePCDFileBinary (file_, cloud);
  EXPECT_EQ (readScene (file_).valid_points, cloud.size ());
}

TEST_F (SceneIo, takesZerosForHoles)
{
  auto cloud = coloredWall ();
  cloud[3].x = cloud[3].y = cloud[3].z = 0.0f;
  const Scene scene = roundTrip (cloud);
  EXPECT_EQ (scene.valid_points, cloud.size () - 1);
  ASSERT_EQ (scene.notes.size (), 1u);
  EXPECT_EQ (scene.notes[0], "1 points at 0 0 0 are taken as holes");
}

TEST_F (SceneIo, saysWhatIsWrongWithAFile)
{
  EXPECT_EQ (error (), "no such file");
  EXPECT_EQ (errorOfText (""), "an empty file");
  EXPECT_EQ (errorOfText ("ply\nformat ascii 1.0\n"), "not a PCD file");
  EXPECT_EQ (errorOfText (std::string (100000, 'x')), "not a PCD file");
  EXPECT_EQ (errorOfText ("VERSION 0.7\nFIELDS x y z\n"), "truncated: the PCD header has no end");
  EXPECT_EQ (errorOfText (pcdText ("x y z", "x y q")), "no field z: a cloud with the fields x, y, z and rgb is needed");
  EXPECT_EQ (errorOfText (pcdText ("TYPE F F F", "TYPE F F U")),
             "the field z is not one 4-byte float (TYPE F, SIZE 4): convert it");
  EXPECT_EQ (errorOfText (pcdText ("POINTS 12", "POINTS 13")),
             "damaged PCD header: WIDTH 4 x HEIGHT 3 is not POINTS 13");
  EXPECT_EQ (errorOfText (pcdText ("WIDTH 4", "WIDTH 5")), "damaged PCD header: WIDTH 5 x HEIGHT 3 is not POINTS 12");
  EXPECT_EQ (errorOfText (pcdText ("SIZE 4 4 4", "SIZE 4 4")), "damaged PCD header: SIZE and FIELDS differ in length");
  EXPECT_EQ (errorOfText (pcdText ("SIZE 4 4 4", "SIZE 4 4 -4")), "damaged PCD header: SIZE is '-4'");
  EXPECT_EQ (errorOfText (pcdText ("WIDTH 4\n", "")), "damaged PCD header: WIDTH 0 x HEIGHT 3 is not POINTS 12");
  EXPECT_EQ (errorOfText (pcdText ("SIZE 4 4 4\n", "WIDTH 4\nSIZE 4 4 4\n")),
             "damaged PCD header: SIZE is out of order");
  EXPECT_EQ (errorOfText (pcdText ("binary", "bits")).find ("damaged PCD header: DATA is 'bits'"), 0u);
  std::filesystem::remove (file_);
  std::filesystem::create_directory (file_);
  EXPECT_EQ (error (), "not a regular file");
}

TEST_F (SceneIo, allocatesNothingForPointsThatAFileCannotHold)
{
  for (const std::string data : {"ascii", "binary", "binary_compressed"})
  {
    std::string text = pcdText ("DATA binary", "DATA " + data);
    text.replace (text.find ("WIDTH 4"), 7, "WIDTH 40000");
    text.replace (text.find ("HEIGHT 3"), 8, "HEIGHT 50000");
    text.replace (text.find ("POINTS 12"), 9, "POINTS 2000000000");
    const std::string message = errorOfText (text);
    EXPECT_NE (message.find ("the header announces 2000000000 points"), std::string::npos) << message;
  }
}

// PCL's reader goes on after DATA as long as lines look like a header, and trusts what they say.
TEST_F (SceneIo, refusesASecondHeaderInPlaceOfPoints)
{
  const std::string text = pcdText ("DATA binary", "DATA ascii");
  const std::string header = text.substr (0, text.find ("DATA ascii\n") + 11);
  for (const char* entry : {"WIDTH 100000\n", "COLUMNS", "\n# more\n \t POINTS 10000000000\n"})
    EXPECT_EQ (errorOfText (header + entry + std::string (1000, '0')), "damaged: the points begin like a header") << entry;
  EXPECT_EQ (errorOfText (header + std::string (1 << 17, '\n')), "damaged: the points begin like comments");
  EXPECT_EQ (errorOfText (pcdText ("FIELDS x", "FIELDS \vx")), "damaged PCD header: a control character");
  EXPECT_EQ (errorOfText (pcdText ("VERSION", "\v\nVERSION")), "damaged PCD header: a line of blanks");
  EXPECT_EQ (errorOfText (pcdText ("WIDTH", " \nWIDTH")), "damaged PCD header: a line of blanks");
}

TEST_F (SceneIo, refusesAnImageThatIsTooLarge)
{
  pcl::io::savePCDFileBinaryCompressed (file_, pcl::PointCloud<pcl::PointXYZ> (2, 16385));
  EXPECT_EQ (error (), "the cloud is 2 x 16385, more than the 16384 a side and 67108864 in all that are taken");
}

TEST_F (SceneIo, refusesCloudsWithoutAnything)
{
  EXPECT_EQ (errorOfText (pcdText ("WIDTH 4\nHEIGHT 3\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 12",
                                   "WIDTH 0\nHEIGHT 0\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 0")),
             "no points");
  auto cloud = coloredWall ();
  for (auto& point : cloud)
    point.z = nan_value;
  pcl::io::savePCDFileBinary (file_, cloud);
  EXPECT_EQ (error ().find ("no valid point: all are NaN"), 0u);
}

TEST_F (SceneIo, tellsHowToOrganizeACloud)
{
  auto cloud = coloredWall ();
  cloud.width = 32 * 24;
  cloud.height = 1;
  pcl::io::savePCDFileBinary (file_, cloud);
  EXPECT_EQ (error ().find ("not organized (768 x 1 points): the cloud must be width x height"), 0u);
  EXPECT_EQ (error (rowsOf (31)), "not organized, and its 768 points do not fill rows of 31");
  EXPECT_NE (error (rowsOf (768)), "");
  const Scene scene = readScene (file_, rowsOf (32));
  EXPECT_EQ (scene.cloud->width, 32u);
  EXPECT_EQ (scene.cloud->height, 24u);
}

TEST_F (SceneIo, notesAnImplausibleRangeOrTooFewPoints)
{
  const Scene millimetres = roundTrip (coloredWall (32, 24, 812.0f));
  ASSERT_EQ (millimetres.notes.size (), 1u);
  EXPECT_EQ (millimetres.notes[0].find ("the median depth is 812 m: "), 0u);
  EXPECT_EQ (roundTrip (coloredWall (32, 24, 0.0008f)).notes.size (), 1u);

  auto holes = coloredWall ();
  for (std::size_t i = 20; i < holes.size (); ++i)
    holes[i].z = nan_value;
  const Scene few = roundTrip (holes);
  ASSERT_EQ (few.notes.size (), 1u);
  EXPECT_EQ (few.notes[0].find ("only 20 of 768 points are valid"), 0u);
}

TEST_F (SceneIo, keepsASensorPoseThatFits)
{
  auto cloud = coloredWall ();
  const Eigen::Quaternionf turn (Eigen::AngleAxisf (2.0f, Eigen::Vector3f (1, 2, 3).normalized ()));
  const Eigen::Vector3f shift (5, -3, 2);
  for (auto& point : cloud)
    point.getVector3fMap () = (turn.toRotationMatrix () * point.getVector3fMap () + shift).eval ();
  cloud.sensor_orientation_ = turn;
  cloud.sensor_origin_ << shift.x (), shift.y (), shift.z (), 0.0f;
  const Scene scene = roundTrip (cloud);
  EXPECT_TRUE (scene.notes.empty ());
  EXPECT_TRUE (scene.cloud->sensor_orientation_.isApprox (turn, 1e-4f));
  EXPECT_TRUE (scene.cloud->sensor_origin_.head<3> ().isApprox (shift, 1e-4f));
}

TEST_F (SceneIo, mendsASensorPoseThatCannotHaveSeenThePoints)
{
  const Eigen::Quaternionf half_turn (0.0f, 1.0f, 0.0f, 0.0f);
  auto graphics = coloredWall (); // y up, z backward, as in milk_cartoon_all_small_clorox.pcd
  for (auto& point : graphics)
    point.getVector3fMap () = (half_turn.toRotationMatrix () * point.getVector3fMap ()).eval ();
  Scene scene = roundTrip (graphics);
  ASSERT_EQ (scene.notes.size (), 1u);
  EXPECT_NE (scene.notes[0].find ("y up and z backward"), std::string::npos);
  EXPECT_TRUE (scene.cloud->sensor_orientation_.isApprox (half_turn, 1e-4f));
  EXPECT_TRUE (scene.stored_orientation.isApprox (Eigen::Quaternionf::Identity (), 1e-4f));

  auto turned = coloredWall (); // as in table_scene_mug_stereo_textured.pcd
  turned.sensor_orientation_ = half_turn;
  scene = roundTrip (turned);
  EXPECT_EQ (scene.notes.size (), 1u);
  EXPECT_LT (scene.cloud->sensor_orientation_.angularDistance (Eigen::Quaternionf::Identity ()), 1e-3f);

  auto beside = coloredWall ();
  beside.sensor_orientation_ = Eigen::Quaternionf (Eigen::AngleAxisf (1.57f, Eigen::Vector3f::UnitZ ()));
  scene = roundTrip (beside);
  ASSERT_EQ (scene.notes.size (), 1u);
  EXPECT_EQ (scene.notes[0].find ("the sensor pose of the file (VIEWPOINT) does not fit the image"), 0u);
  EXPECT_LT (scene.cloud->sensor_orientation_.angularDistance (Eigen::Quaternionf::Identity ()), 1e-3f);
}

TEST_F (SceneIo, refusesPointsBehindASensorWhoseTruePoseIsNotKnown)
{
  auto cloud = coloredWall ();
  const Eigen::Quaternionf turn (Eigen::AngleAxisf (0.5f * static_cast<float> (M_PI), Eigen::Vector3f::UnitZ ()));
  for (auto& point : cloud)
    point.getVector3fMap () = (turn.toRotationMatrix () * point.getVector3fMap () - Eigen::Vector3f (0, 0, 3)).eval ();
  pcl::io::savePCDFileBinary (file_, cloud);
  EXPECT_EQ (error ().find ("the points lie behind the sensor pose of the file (VIEWPOINT): correct it"), 0u);
}

TEST_F (SceneIo, replacesASensorPoseThatIsNone)
{
  auto cloud = coloredWall ();
  cloud.sensor_orientation_.coeffs ().setZero ();
  const Scene scene = roundTrip (cloud);
  ASSERT_EQ (scene.notes.size (), 1u);
  EXPECT_EQ (scene.notes[0], "the sensor pose (VIEWPOINT) is not a pose, taken as 0 0 0 1 0 0 0");
}

TEST_F (SceneIo, isToldWhereverAFileIsCut)
{
  const auto cloud = coloredWall (5, 4);
  for (int encoding = 0; encoding < 3; ++encoding)
  {
    const std::string whole = textOf (cloud, encoding);
    EXPECT_EQ (errorOfText (whole), "");
    // PCL's reader takes a last line of text that is not complete for a point.
    const std::size_t certain = encoding == 0 ? whole.rfind ('\n', whole.size () - 2) : whole.size ();
    for (std::size_t length = 0; length < certain; ++length)
      EXPECT_NE (errorOfText (whole.substr (0, length)), "") << "encoding " << encoding << " cut to " << length;
  }
}

TEST_F (SceneIo, isToldOfASingleByteThatIsMissing)
{
  std::string text = textOf (coloredWall (5, 4), 1);
  text.pop_back ();
  EXPECT_EQ (errorOfText (text), "truncated: the header announces 20 points, the file holds 19");
}

TEST_F (SceneIo, survivesDamagedFiles)
{
  const auto cloud = coloredWall ();
  for (int encoding = 0; encoding < 3; ++encoding)
  {
    const std::string whole = textOf (cloud, encoding);
    std::mt19937 random (encoding);
    for (int trial = 0; trial < 300; ++trial)
    {
      std::string text = whole;
      if (trial % 3 == 0)
        text.resize (random () % text.size ());
      else
        for (unsigned i = 0; i < 1 + random () % 3; ++i)
          text[random () % (trial % 3 == 1 ? 250 : text.size ())] = static_cast<char> (random ());
      errorOfText (text); // any error or none, but one that names the file, and no crash
    }
  }
}

} // namespace
