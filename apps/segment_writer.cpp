// SPDX-License-Identifier: BSD-3-Clause
#include "segment_writer.h"

#include "number_text.h"
#include "overview_image.h"
#include "png_image.h"
#include <pcl_attention/version.h>

#include <nlohmann/json.hpp>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace pcl_attention
{

namespace
{

using Json = nlohmann::ordered_json;

/** \brief JSON has no NaN: what is not known is null. */
Json
toJson (float value)
{
  return (std::isfinite (value) ? Json (shortestDouble (value)) : Json ());
}

template <int size>
Json
toJson (const Eigen::Matrix<float, size, 1>& vector)
{
  Json json = Json::array ();
  for (int i = 0; i < size; ++i)
    json.push_back (toJson (vector[i]));
  return (json);
}

Json
toJson (const AttentionPoint& point)
{
  return (Json{{"column", point.column},
               {"row", point.row},
               {"kind", toString (point.kind)},
               {"saliency", toJson (point.saliency)},
               {"point_saliency", toJson (point.point_saliency)},
               {"weight", toJson (point.weight)}});
}

Json
toJson (const OrientedBox& box)
{
  const Eigen::Quaternionf& q = box.orientation;
  return (Json{
      {"center", toJson<3> (box.center)},
      {"orientation", {{"w", toJson (q.w ())}, {"x", toJson (q.x ())}, {"y", toJson (q.y ())}, {"z", toJson (q.z ())}}},
      {"size", toJson<3> (box.size)}});
}

Json
toJson (const AttentionSegment& segment)
{
  return (Json{{"rank", segment.rank},
               {"attention_point", toJson (segment.attention_point)},
               {"points", segment.indices.size ()},
               {"plane", toJson<4> (segment.plane)},
               {"box", toJson (segment.box)},
               {"compactness", toJson (segment.compactness)},
               {"confidence", toJson (segment.confidence)},
               {"patches", segment.patches},
               {"growth_end", toString (segment.growth_end)}});
}

Json
toJson (const SupportingPlane& plane)
{
  return (Json{{"coefficients", toJson<4> (plane.coefficients)},
               {"area", toJson (plane.area)},
               {"confidence", toJson (plane.confidence)},
               {"points", plane.indices.size ()},
               {"supports_objects", plane.supports_objects}});
}

/** \brief Milliseconds; a thousandth of them is all that a clock can tell. */
double
rounded (double milliseconds)
{
  return (std::round (milliseconds * 1e3) / 1e3);
}

template <typename PointT>
std::string
labelledCloud (const Scene& scene, const std::vector<std::uint32_t>& labels)
{
  pcl::PCLPointCloud2 blob;
  {
    // Gone when the file is encoded, which is when the program needs most memory.
    pcl::PointCloud<PointT> cloud;
    pcl::copyPointCloud (*scene.cloud, cloud);
    for (std::size_t i = 0; i < cloud.size (); ++i)
      cloud[i].label = labels[i];
    pcl::toPCLPointCloud2 (cloud, blob);
  }
  return (encodePcd (scene, blob));
}

} // namespace

std::string
encodePcd (const Scene& scene, const pcl::PCLPointCloud2& points)
{
  std::ostringstream stream;
  stream.imbue (std::locale::classic ());
  if (pcl::PCDWriter ().writeBinaryCompressed (stream, points, scene.stored_origin, scene.stored_orientation) != 0)
    throw std::runtime_error (scene.path + ": its points cannot be encoded as PCD");
  return (stream.str ());
}

std::string
maskFileName (int rank)
{
  std::array<char, 32> name{};
  std::snprintf (name.data (), name.size (), "mask_%04d.png", rank);
  return (name.data ());
}

std::string
attentionPointsCsv (const Scene& scene, const std::vector<AttentionSegment>& segments)
{
  std::string csv = "rank,column,row,x,y,z,saliency,kind,mask_points\n";
  for (const AttentionSegment& segment : segments)
  {
    const AttentionPoint& fixation = segment.attention_point;
    const pcl::PointXYZRGB& point = scene.cloud->at (fixation.column, fixation.row);
    csv += numberText (segment.rank) + ',' + numberText (fixation.column) + ',' + numberText (fixation.row) + ',' +
           numberText (point.x) + ',' + numberText (point.y) + ',' + numberText (point.z) + ',' +
           numberText (fixation.saliency) + ',' + toString (fixation.kind) + ',' +
           numberText (segment.indices.size ()) + '\n';
  }
  return (csv);
}

std::string
segmentsJson (const SceneSegments& result)
{
  Json json{{"segments", Json::array ()}, {"supporting_planes", Json::array ()}};
  for (const AttentionSegment& segment : result.segments)
    json["segments"].push_back (toJson (segment));
  for (const SupportingPlane& plane : result.supporting_planes)
    json["supporting_planes"].push_back (toJson (plane));
  return (json.dump (2) + '\n');
}

std::string
summaryJson (const Scene& scene, const SceneSegments& result, const NamedParameters& parameters)
{
  const StageTimes& times = result.times;
  Json json{{"version", PCL_ATTENTION_VERSION},
                  {"parameters", parametersToJson (parameters)},
                  {"milliseconds",
                   {{"normals", rounded (times.normals)},
                    {"saliency", rounded (times.saliency)},
                    {"attention_points", rounded (times.attention_points)},
                    {"patches", rounded (times.patches)},
                    {"segmentation", rounded (times.segmentation)},
                    {"total", rounded (times.total ())}}},
                  {"counts",
                   {{"attention_points", result.segments.size ()},
                    {"segments", result.segments.size ()},
                    {"extracted_points", result.extracted_points},
                    {"patches", result.patches},
                    {"supporting_planes", result.supporting_planes.size ()},
                    {"points", scene.cloud->size ()},
                    {"valid_points", scene.valid_points}}}};
  const Json prior = priorToJson (result.prior);
  if (!prior.empty ())
    json["prior"] = prior;
  return (json.dump (2) + '\n');
}

Image<std::uint8_t>
segmentMask (const Scene& scene, const AttentionSegment& segment)
{
  Image<std::uint8_t> mask (static_cast<int> (scene.cloud->width), static_cast<int> (scene.cloud->height));
  for (const pcl::index_t index : segment.indices)
    mask[index] = 255;
  return (mask);
}

std::vector<std::uint32_t>
segmentLabels (const Scene& scene, const std::vector<AttentionSegment>& segments)
{
  std::vector<std::uint32_t> labels (scene.cloud->size (), 0);
  for (const AttentionSegment& segment : segments)
    for (const pcl::index_t index : segment.indices)
      if (labels[index] == 0)
        labels[index] = static_cast<std::uint32_t> (segment.rank);
  return (labels);
}

void
writeSceneSegments (const Scene& scene, const SceneSegments& result, const NamedParameters& parameters,
                    OutputFolder& folder)
{
  folder.write ("attention_points.csv", attentionPointsCsv (scene, result.segments));
  folder.write ("segments.json", segmentsJson (result));
  for (const AttentionSegment& segment : result.segments)
    folder.write (maskFileName (segment.rank), encodePng (segmentMask (scene, segment)));
  const std::vector<std::uint32_t> labels = segmentLabels (scene, result.segments);
  folder.write ("labels.pcd", scene.has_color ? labelledCloud<pcl::PointXYZRGBL> (scene, labels)
                                              : labelledCloud<pcl::PointXYZL> (scene, labels));
  folder.write ("overview.png", encodePng (drawOverview (scene, result.segments)));
  folder.write ("summary.json", summaryJson (scene, result, parameters));
}

} // namespace pcl_attention
