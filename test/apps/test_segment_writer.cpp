// SPDX-License-Identifier: BSD-3-Clause
#include "files.h"
#include "overview_image.h"
#include "segment_writer.h"

#include <nlohmann/json.hpp>
#include <pcl/io/pcd_io.h>

#include <limits>
#include <locale>

using namespace pcl_attention;
using Json = nlohmann::ordered_json;

namespace
{

class SegmentWriter : public testing::Test
{
protected:
  Scene scene_;
  SceneSegments result_;

  SegmentWriter ()
  {
    scene_.path = "scene.pcd";
    scene_.name = "scene";
    scene_.has_color = true;
    scene_.cloud = test::wallBefore<pcl::PointXYZRGB> (40, 30).makeShared ();
    scene_.valid_points = scene_.cloud->size ();
    scene_.stored_origin << 1.0f, 2.0f, 3.0f, 0.0f;
    result_.segments.resize (2);
    for (int i = 0; i < 2; ++i)
    {
      AttentionSegment& segment = result_.segments[i];
      segment.rank = i + 1;
      for (int row = 5; row < 15; ++row)
        for (int column = 5 + 5 * i; column < 15 + 5 * i; ++column)
          segment.indices.push_back (40 * row + column);
      segment.attention_point.column = 8 + 8 * i;
      segment.attention_point.row = 10;
      segment.attention_point.saliency = 0.1f;
      segment.attention_point.kind = i == 0 ? AttentionPointKind::junction : AttentionPointKind::coverage;
      segment.patches = {3, 1};
    }
    result_.segments[1].compactness = std::numeric_limits<float>::quiet_NaN ();
    result_.segments[1].growth_end = GrowthConstraint::color;
    result_.supporting_planes.resize (1);
    result_.supporting_planes[0].indices = {1, 2, 3};
    result_.supporting_planes[0].supports_objects = true;
  }
};

TEST_F (SegmentWriter, csvHasOneRowAPoint)
{
  (*scene_.cloud)[408].x = 0.1f;
  (*scene_.cloud)[408].y = -1e-7f;
  const std::string csv = attentionPointsCsv (scene_, result_.segments);
  EXPECT_EQ (csv.substr (0, csv.find ('\n', csv.find ('\n') + 1) + 1),
             "rank,column,row,x,y,z,saliency,kind,mask_points\n1,8,10,0.1,-1e-07,1,0.1,junction,100\n");
  EXPECT_NE (csv.find ("\n2,16,10,"), std::string::npos);
  EXPECT_NE (csv.find (",0.1,coverage,100\n"), std::string::npos);
  EXPECT_EQ (attentionPointsCsv (scene_, {}), "rank,column,row,x,y,z,saliency,kind,mask_points\n");
}

/** \brief Numbers as they are written in many places of the world. */
struct DecimalComma : std::numpunct<char>
{
  char
  do_decimal_point () const override
  {
    return (',');
  }
  char
  do_thousands_sep () const override
  {
    return ('.');
  }
  std::string
  do_grouping () const override
  {
    return ("\3");
  }
};

TEST_F (SegmentWriter, doesNotDependOnTheLocale)
{
  const NamedParameters parameters;
  const auto all = [&] {
    return (attentionPointsCsv (scene_, result_.segments) + segmentsJson (result_) +
            summaryJson (scene_, result_, parameters));
  };
  const std::string expected = all ();
  const std::locale before = std::locale::global (std::locale (std::locale::classic (), new DecimalComma));
  const std::string text = all ();
  std::locale::global (before);
  EXPECT_EQ (text, expected);
}

TEST_F (SegmentWriter, segmentsJsonHoldsEveryFieldOfTheContract)
{
  const Json json = Json::parse (segmentsJson (result_));
  ASSERT_EQ (json["segments"].size (), 2u);
  const Json& segment = json["segments"][1];
  for (const char* key :
       {"rank", "attention_point", "points", "plane", "box", "compactness", "confidence", "patches", "growth_end"})
    EXPECT_TRUE (segment.contains (key)) << key;
  EXPECT_EQ (segment["rank"], 2);
  EXPECT_EQ (segment["plane"].size (), 4u);
  EXPECT_EQ (segment["box"]["size"].size (), 3u);
  EXPECT_EQ (segment["box"]["orientation"]["w"], 1.0);
  EXPECT_EQ (segment["attention_point"]["kind"], "coverage");
  EXPECT_EQ (segment["patches"], Json ({3, 1}));
  EXPECT_EQ (segment["growth_end"], "color");
  EXPECT_TRUE (segment["compactness"].is_null ());
  ASSERT_EQ (json["supporting_planes"].size (), 1u);
  EXPECT_EQ (json["supporting_planes"][0]["points"], 3);
  EXPECT_EQ (json["supporting_planes"][0]["supports_objects"], true);

  const Json empty = Json::parse (segmentsJson ({}));
  EXPECT_TRUE (empty["segments"].is_array () && empty["segments"].empty ());
}

TEST_F (SegmentWriter, summaryHoldsParametersTimesAndCounts)
{
  result_.times.normals = 1.25;
  result_.times.patches = 2.5;
  const Json json = Json::parse (summaryJson (scene_, result_, presetParameters ("paper")));
  EXPECT_FALSE (json["version"].get<std::string> ().empty ());
  EXPECT_EQ (json["parameters"], parametersToJson (presetParameters ("paper")));
  for (const char* stage : {"normals", "saliency", "attention_points", "patches", "segmentation", "total"})
    EXPECT_TRUE (json["milliseconds"][stage].is_number ()) << stage;
  EXPECT_EQ (json["milliseconds"]["total"], 3.75);
  EXPECT_EQ (json["counts"]["segments"], 2);
  EXPECT_EQ (json["counts"]["attention_points"], 2);
  EXPECT_EQ (json["counts"]["points"], 1200);
}

TEST_F (SegmentWriter, theFirstSegmentThatClaimsAPointHasIt)
{
  const auto labels = segmentLabels (scene_, result_.segments);
  EXPECT_EQ (labels[40 * 10 + 4], 0u);
  EXPECT_EQ (labels[40 * 10 + 12], 1u);
  EXPECT_EQ (labels[40 * 10 + 15], 2u);
  EXPECT_EQ (segmentMask (scene_, result_.segments[1]) (12, 10), 255);
  EXPECT_EQ (segmentMask (scene_, result_.segments[1]) (9, 10), 0);
  EXPECT_EQ (maskFileName (1), "mask_0001.png");
  EXPECT_EQ (maskFileName (12345), "mask_12345.png");
}

TEST_F (SegmentWriter, labelsKeepTheCloudAndItsPose)
{
  const test::TemporaryFolder folder;
  for (const bool has_color : {true, false})
  {
    scene_.has_color = has_color;
    (*scene_.cloud)[7].x = std::numeric_limits<float>::quiet_NaN ();
    {
      OutputFolder output (folder / "", "scene");
      writeSceneSegments (scene_, result_, {}, output);
      output.commit ();
    }
    pcl::PCLPointCloud2 blob;
    ASSERT_EQ (pcl::io::loadPCDFile (folder / "scene/labels.pcd", blob), 0);
    EXPECT_EQ (pcl::getFieldIndex (blob, "rgba") >= 0, has_color);
    pcl::PointCloud<pcl::PointXYZL> cloud;
    ASSERT_EQ (pcl::io::loadPCDFile (folder / "scene/labels.pcd", cloud), 0);
    EXPECT_EQ (cloud.width, 40u);
    EXPECT_EQ (cloud.height, 30u);
    EXPECT_EQ (cloud.sensor_origin_, scene_.stored_origin);
    EXPECT_TRUE (std::isnan (cloud[7].x));
    EXPECT_EQ (cloud[8].x, (*scene_.cloud)[8].x);
    EXPECT_EQ (cloud (16, 10).label, 2u);
    const std::string header = test::readText (folder / "scene/labels.pcd");
    EXPECT_NE (header.find ("DATA binary_compressed"), std::string::npos);
  }
}

TEST_F (SegmentWriter, overviewDrawsOutlinesAndFixations)
{
  const Image<Color> image = drawOverview (scene_, result_.segments);
  EXPECT_EQ (image.width, 40);
  EXPECT_EQ (image.height, 30);
  EXPECT_EQ (image (5, 5), segmentColor (1));
  EXPECT_EQ (image (8, 10), segmentColor (1));
  EXPECT_EQ (image (16, 10), segmentColor (2));
  EXPECT_EQ (image (39, 29), (Color{0, 0, 0}));
  EXPECT_NE (segmentColor (1), segmentColor (2));
}

TEST_F (SegmentWriter, depthStandsInForColour)
{
  scene_.has_color = false;
  for (int row = 0; row < 15; ++row)
    for (int column = 0; column < 40; ++column)
      scene_.cloud->at (column, row).z = 2.0f;
  (*scene_.cloud)[0].x = std::numeric_limits<float>::quiet_NaN ();
  const Image<Color> image = backgroundImage (scene_);
  EXPECT_EQ (image (0, 0), (Color{0, 0, 0}));
  EXPECT_GT (image (20, 20)[0], image (20, 10)[0]);
  EXPECT_EQ (image (20, 20)[0], image (20, 20)[2]);
}

TEST (OverviewColours, differForManySegments)
{
  std::set<Color> colors;
  for (int rank = 1; rank <= 200; ++rank)
    colors.insert (segmentColor (rank));
  EXPECT_EQ (colors.size (), 200u);
}

} // namespace
