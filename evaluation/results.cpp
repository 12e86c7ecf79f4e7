// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/results.h"

#include "evaluation/file_error.h"
#include "evaluation/pcd_file.h"
#include "evaluation/png_file.h"

#include <nlohmann/json.hpp>
#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace pcl_attention
{
namespace
{

std::vector<std::string>
splitRow (std::string line)
{
  if (!line.empty () && line.back () == '\r')
    line.pop_back ();
  std::vector<std::string> cells;
  std::stringstream stream (line + ',');
  for (std::string cell; std::getline (stream, cell, ',');)
    cells.push_back (cell);
  return (cells);
}

/** \brief The attention points of a scene, as segments without masks yet. */
std::vector<PredictedSegment>
readAttentionPoints (const fs::path& file, int width, int height)
{
  std::ifstream stream (file);
  std::string line;
  if (!stream)
    fail (file, "missing or not readable");
  if (!std::getline (stream, line))
    fail (file, "empty, not even a header");
  const std::vector<std::string> header = splitRow (line);
  const auto columnOf = [&] (const std::string& name) -> std::size_t {
    return (std::find (header.begin (), header.end (), name) - header.begin ());
  };
  for (const char* name : {"rank", "column", "row"})
  {
    if (columnOf (name) == header.size ())
      fail (file, std::string ("the header has no column \"") + name + "\"");
  }

  std::vector<PredictedSegment> segments;
  for (int line_number = 2; std::getline (stream, line); ++line_number)
  {
    const std::string place = "line " + std::to_string (line_number) + ": ";
    const std::vector<std::string> cells = splitRow (line);
    if (cells.size () != header.size ())
      fail (file,
            place + std::to_string (cells.size ()) + " values, the header has " + std::to_string (header.size ()));
    const auto integer = [&] (const std::string& name) {
      const std::string& cell = cells[columnOf (name)];
      int value = 0;
      const auto result = std::from_chars (cell.data (), cell.data () + cell.size (), value);
      if (result.ec != std::errc () || result.ptr != cell.data () + cell.size ())
        fail (file, place + name + " is not an integer: \"" + cell + "\"");
      return (value);
    };
    PredictedSegment segment;
    segment.column = integer ("column");
    segment.row = integer ("row");
    if (integer ("rank") != static_cast<int> (segments.size ()) + 1)
      fail (file, place + "the ranks are not 1, 2, ... in this order");
    if (segment.column < 0 || segment.column >= width || segment.row < 0 || segment.row >= height)
      fail (file, place + "the point lies outside of the " + imageSizeText (width, height) + " image");
    if (columnOf ("kind") != header.size ())
      segment.kind = cells[columnOf ("kind")];
    segments.push_back (segment);
  }
  return (segments);
}

fs::path
maskFile (const fs::path& folder, std::size_t rank)
{
  std::array<char, 32> name;
  std::snprintf (name.data (), name.size (), "mask_%04zu.png", rank);
  return (folder / name.data ());
}

pcl::Indices
readMask (const fs::path& file, int width, int height)
{
  if (!fs::is_regular_file (file))
    fail (file, "missing");

  const Image<std::uint8_t> values = readGreyPng (file.string (), width, height);
  pcl::Indices mask;
  for (std::size_t pixel = 0; pixel < values.size (); ++pixel)
  {
    if (values[pixel] == 255)
      mask.push_back (static_cast<pcl::index_t> (pixel));
    else if (values[pixel] != 0)
      fail (file, "has a grey value other than 0 and 255: " + std::to_string (values[pixel]));
  }
  return (mask);
}

std::vector<std::uint32_t>
readLabels (const fs::path& file, int width, int height)
{
  pcl::PCLPointCloud2 raw;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  readPcdFile (file.string (), raw, origin, orientation);
  const pcl::PCLPointField* field = findField (raw, "label");
  if (!field || field->datatype != pcl::PCLPointField::UINT32)
    fail (file, "no 4-byte unsigned field \"label\"");
  // one row of as many points is the same image, as in the scenes that are stored unorganized
  const bool same_size =
      raw.width == static_cast<std::uint32_t> (width) && raw.height == static_cast<std::uint32_t> (height);
  const bool one_row = raw.height == 1 && raw.width == static_cast<std::uint32_t> (width) * height;
  if (!same_size && !one_row)
    fail (file, imageSizeText (static_cast<int> (raw.width), static_cast<int> (raw.height)) + " points, the scene has " +
                    imageSizeText (width, height));

  pcl::PointCloud<pcl::Label> cloud;
  pcl::fromPCLPointCloud2 (raw, cloud);
  std::vector<std::uint32_t> labels;
  labels.reserve (cloud.size ());
  for (const pcl::Label& point : cloud)
    labels.push_back (point.label);
  return (labels);
}

void
readConfidences (const fs::path& file, std::vector<PredictedSegment>& segments)
{
  using nlohmann::json;
  std::ifstream stream (file);
  const json document = json::parse (stream, nullptr, false);
  if (document.is_discarded ())
    fail (file, "not valid JSON");
  const json* rows = &document;
  if (document.is_object () && document.contains ("segments"))
    rows = &document["segments"];
  if (!rows->is_array ())
    fail (file, "no array of segments");
  for (const json& row : *rows)
  {
    if (!row.is_object () || !row.contains ("confidence"))
      continue;
    if (!row.contains ("rank") || !row["rank"].is_number_integer ())
      fail (file, "a confidence without a rank");
    const auto rank = row["rank"].get<std::int64_t> ();
    if (rank < 1 || rank > static_cast<std::int64_t> (segments.size ()))
      fail (file, "rank " + std::to_string (rank) + " is not in attention_points.csv");
    const json& confidence = row["confidence"];
    if (confidence.is_null ())
      continue;
    if (!confidence.is_number () || confidence.get<double> () < 0 || confidence.get<double> () > 1)
      fail (file, "the confidence of rank " + std::to_string (rank) + " is not a number from 0 to 1");
    segments[rank - 1].confidence = confidence.get<double> ();
  }
}

} // namespace

ScenePrediction
readResults (const std::string& folder, int width, int height)
{
  const fs::path path (folder);
  if (!fs::is_directory (path))
    fail (path, "no such folder of results");

  ScenePrediction prediction;
  prediction.width = width;
  prediction.height = height;
  prediction.segments = readAttentionPoints (path / "attention_points.csv", width, height);
  for (std::size_t rank = 1; rank <= prediction.segments.size (); ++rank)
    prediction.segments[rank - 1].mask = readMask (maskFile (path, rank), width, height);
  const fs::path surplus = maskFile (path, prediction.segments.size () + 1);
  if (fs::exists (surplus))
    fail (surplus, "a mask of a rank that attention_points.csv does not have");

  if (fs::exists (path / "segments.json"))
    readConfidences (path / "segments.json", prediction.segments);
  if (fs::exists (path / "labels.pcd"))
    prediction.labels = readLabels (path / "labels.pcd", width, height);
  else
    prediction.labels = labelsOfMasks (width, height, prediction.segments);
  return (prediction);
}

} // namespace pcl_attention
