// SPDX-License-Identifier: BSD-3-Clause
// Results as pcl_attention_segment writes them, and every way in which they can be broken.
#include "cases.h"
#include "evaluation/results.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/png_io.h>

#include <cmath>

namespace pcl_attention
{
namespace
{

const std::string header = "rank,column,row,x,y,z,saliency,kind,mask_points\n";

/** \brief A scene of 4x3 pixels with two overlapping segments. */
class Results : public testing::Test
{
protected:
  test::TemporaryFolder folder_;

  Results ()
  {
    test::writeText (folder_ / "attention_points.csv",
                     header + "1,1,0,0.1,0.2,1.5,0.9,junction,2\n2,3,2,0.1,0.2,1.5,0.8,coverage,3\n");
    writeMask ("mask_0001.png", 4, 3, {0, 1});
    writeMask ("mask_0002.png", 4, 3, {1, 10, 11});
  }

  void
  writeMask (const std::string& name, int width, int height, const pcl::Indices& pixels, unsigned char value = 255,
             int channels = 1)
  {
    std::vector<unsigned char> image (static_cast<std::size_t> (width) * height * channels, 0);
    for (const auto pixel : pixels)
      image[pixel * channels] = value;
    pcl::io::saveCharPNGFile (folder_ / name, image.data (), width, height, channels);
  }

  ScenePrediction
  read () const
  {
    return (readResults (folder_ / "", 4, 3));
  }

  /** \brief The complaint about a file, without its path. */
  std::string
  complaintAbout (const std::string& name) const
  {
    const std::string message = test::messageOf ([this] { read (); });
    const std::string path = folder_ / name;
    EXPECT_EQ (message.substr (0, path.size () + 2), path + ": ");
    return (message.size () > path.size () + 2 ? message.substr (path.size () + 2) : "");
  }

  std::string
  complaintAboutPoints (const std::string& text)
  {
    test::writeText (folder_ / "attention_points.csv", text);
    return (complaintAbout ("attention_points.csv"));
  }

  std::string
  complaintAboutSegments (const std::string& text)
  {
    test::writeText (folder_ / "segments.json", text);
    return (complaintAbout ("segments.json"));
  }
};

TEST_F (Results, pointsAndMasks)
{
  const ScenePrediction prediction = read ();
  ASSERT_EQ (prediction.segments.size (), 2u);
  EXPECT_EQ (prediction.segments[0].column, 1);
  EXPECT_EQ (prediction.segments[0].row, 0);
  EXPECT_EQ (prediction.segments[0].kind, "junction");
  EXPECT_EQ (prediction.segments[0].mask, (pcl::Indices{0, 1})); // not upside down
  EXPECT_TRUE (std::isnan (prediction.segments[0].confidence));
  EXPECT_EQ (prediction.segments[1].column, 3);
  EXPECT_EQ (prediction.segments[1].row, 2);
  EXPECT_EQ (prediction.segments[1].mask, (pcl::Indices{1, 10, 11}));
}

TEST_F (Results, withoutLabelsTheFirstMaskThatClaimsAPixelHasIt)
{
  EXPECT_EQ (read ().labels, (std::vector<std::uint32_t>{1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 2, 2}));
}

TEST_F (Results, labelsAreTakenFromTheFile)
{
  auto cloud = test::cloudOf (4, {0, 2, 2, 0, 0, 0, 0, 0, 0, 0, 1, 1});
  pcl::io::savePCDFileBinaryCompressed (folder_ / "labels.pcd", cloud);
  const std::vector<std::uint32_t> expected{0, 2, 2, 0, 0, 0, 0, 0, 0, 0, 1, 1};
  EXPECT_EQ (read ().labels, expected);

  cloud.width = 12;
  cloud.height = 1;
  pcl::io::savePCDFileBinaryCompressed (folder_ / "labels.pcd", cloud);
  EXPECT_EQ (read ().labels, expected);
}

TEST_F (Results, confidencesAreFoundByRank)
{
  test::writeText (
      folder_ / "segments.json",
      "{\"segments\": [{\"rank\": 2, \"confidence\": 0.25, \"plane\": [0, 0, 1, 2]}, {\"rank\": 1}], \"planes\": []}");
  EXPECT_TRUE (std::isnan (read ().segments[0].confidence));
  EXPECT_EQ (read ().segments[1].confidence, .25);

  test::writeText (folder_ / "segments.json",
                   "[{\"rank\": 1, \"confidence\": 1}, {\"rank\": 2, \"confidence\": null}]");
  EXPECT_EQ (read ().segments[0].confidence, 1);
  EXPECT_TRUE (std::isnan (read ().segments[1].confidence));
}

TEST_F (Results, columnsAreFoundByNameInAnyOrder)
{
  test::writeText (folder_ / "attention_points.csv", "row,rank,column\r\n0,1,1\r\n2,2,3\r\n");
  EXPECT_EQ (read ().segments[1].column, 3);
  EXPECT_EQ (read ().segments[1].row, 2);
  EXPECT_EQ (read ().segments[1].kind, "");
}

TEST_F (Results, aSceneMayHaveNoAttentionPoint)
{
  test::writeText (folder_ / "attention_points.csv", header);
  std::filesystem::remove (folder_ / "mask_0001.png");
  std::filesystem::remove (folder_ / "mask_0002.png");
  EXPECT_TRUE (read ().segments.empty ());
  EXPECT_EQ (read ().labels, std::vector<std::uint32_t> (12, 0));
}

TEST_F (Results, missingFolder)
{
  const std::string path = folder_ / "scene";
  EXPECT_EQ (test::messageOf ([&] { readResults (path, 4, 3); }), path + ": no such folder of results");
}

TEST_F (Results, missingPoints)
{
  std::filesystem::remove (folder_ / "attention_points.csv");
  EXPECT_EQ (complaintAbout ("attention_points.csv"), "missing or not readable");
}

TEST_F (Results, brokenPoints)
{
  EXPECT_EQ (complaintAboutPoints (""), "empty, not even a header");
  EXPECT_EQ (complaintAboutPoints ("rank,x,y\n"), "the header has no column \"column\"");
  EXPECT_EQ (complaintAboutPoints (header + "1,1,0\n"), "line 2: 3 values, the header has 9");
  EXPECT_EQ (complaintAboutPoints (header + "1,1,0,0,0,1,1,junction,2\n\n"), "line 3: 1 values, the header has 9");
  EXPECT_EQ (complaintAboutPoints (header + "1,one,0,0,0,1,1,junction,2\n"),
             "line 2: column is not an integer: \"one\"");
  EXPECT_EQ (complaintAboutPoints (header + "1,1.5,0,0,0,1,1,junction,2\n"),
             "line 2: column is not an integer: \"1.5\"");
  EXPECT_EQ (complaintAboutPoints (header + "1,1,,0,0,1,1,junction,2\n"), "line 2: row is not an integer: \"\"");
  EXPECT_EQ (complaintAboutPoints (header + "1,1,0,0,0,1,1,junction,2\n3,1,0,0,0,1,1,junction,2\n"),
             "line 3: the ranks are not 1, 2, ... in this order");
  EXPECT_EQ (complaintAboutPoints (header + "0,1,0,0,0,1,1,junction,2\n"),
             "line 2: the ranks are not 1, 2, ... in this order");
  EXPECT_EQ (complaintAboutPoints (header + "1,4,0,0,0,1,1,junction,2\n"),
             "line 2: the point lies outside of the 4x3 image");
  EXPECT_EQ (complaintAboutPoints (header + "1,0,-1,0,0,1,1,junction,2\n"),
             "line 2: the point lies outside of the 4x3 image");
}

TEST_F (Results, missingMask)
{
  std::filesystem::remove (folder_ / "mask_0002.png");
  EXPECT_EQ (complaintAbout ("mask_0002.png"), "missing");
}

TEST_F (Results, maskWithoutPoint)
{
  writeMask ("mask_0003.png", 4, 3, {0});
  EXPECT_EQ (complaintAbout ("mask_0003.png"), "a mask of a rank that attention_points.csv does not have");
}

TEST_F (Results, maskOfAnotherSize)
{
  writeMask ("mask_0002.png", 3, 4, {0});
  EXPECT_EQ (complaintAbout ("mask_0002.png"), "3x4 pixels, the scene has 4x3");
}

TEST_F (Results, maskOfAnotherKind)
{
  writeMask ("mask_0002.png", 4, 3, {0}, 255, 3);
  EXPECT_EQ (complaintAbout ("mask_0002.png"), "not an 8-bit grey image");
  writeMask ("mask_0002.png", 4, 3, {0}, 1);
  EXPECT_EQ (complaintAbout ("mask_0002.png"), "has a grey value other than 0 and 255: 1");
}

TEST_F (Results, maskThatIsNoImage)
{
  for (const std::string text : {"no image", ""})
  {
    test::writeText (folder_ / "mask_0002.png", text);
    EXPECT_EQ (complaintAbout ("mask_0002.png").substr (0, 23), "not a readable PNG file");
  }
}

TEST_F (Results, maskCutShort)
{
  const std::string whole = test::readText (folder_ / "mask_0002.png");
  for (std::size_t length = 0; length + 12 < whole.size (); ++length) // the last 12 bytes only say that it ends
  {
    SCOPED_TRACE (length);
    test::writeText (folder_ / "mask_0002.png", whole.substr (0, length));
    ASSERT_EQ (complaintAbout ("mask_0002.png").substr (0, 23), "not a readable PNG file");
  }
}

TEST_F (Results, brokenLabels)
{
  test::writeText (folder_ / "labels.pcd", "no cloud");
  EXPECT_EQ (complaintAbout ("labels.pcd"), "not a PCD file");
  pcl::io::savePCDFileBinary (folder_ / "labels.pcd", pcl::PointCloud<pcl::PointXYZ> (4, 3));
  EXPECT_EQ (complaintAbout ("labels.pcd"), "no 4-byte unsigned field \"label\"");
  pcl::io::savePCDFileBinary (folder_ / "labels.pcd", pcl::PointCloud<pcl::Label> (3, 4));
  EXPECT_EQ (complaintAbout ("labels.pcd"), "3x4 points, the scene has 4x3");
}

TEST_F (Results, brokenSegments)
{
  EXPECT_EQ (complaintAboutSegments ("{\"segments\": ["), "not valid JSON");
  EXPECT_EQ (complaintAboutSegments (""), "not valid JSON");
  EXPECT_EQ (complaintAboutSegments ("{\"planes\": []}"), "no array of segments");
  EXPECT_EQ (complaintAboutSegments ("[{\"confidence\": 0.5}]"), "a confidence without a rank");
  EXPECT_EQ (complaintAboutSegments ("[{\"rank\": 3, \"confidence\": 0.5}]"), "rank 3 is not in attention_points.csv");
  EXPECT_EQ (complaintAboutSegments ("[{\"rank\": 1, \"confidence\": 1.5}]"),
             "the confidence of rank 1 is not a number from 0 to 1");
  EXPECT_EQ (complaintAboutSegments ("[{\"rank\": 1, \"confidence\": \"high\"}]"),
             "the confidence of rank 1 is not a number from 0 to 1");
}

} // namespace
} // namespace pcl_attention
