// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/ground_truth.h"

#include <pcl/common/point_tests.h>

#include <limits>
#include <map>
#include <stdexcept>

namespace pcl_attention
{
namespace
{

constexpr std::uint32_t first_object_label = 20;

/** \brief The region's own pixel closest to the mean of its pixels: the mean may lie outside of a bent region. */
void
findCenters (GroundTruth& truth)
{
  std::vector<double> mean_column (truth.regions.size (), 0), mean_row (truth.regions.size (), 0);
  for (std::size_t pixel = 0; pixel < truth.region_of.size (); ++pixel)
  {
    const int region = truth.region_of[pixel];
    if (region < 0)
      continue;
    mean_column[region] += pixel % truth.width;
    mean_row[region] += pixel / truth.width;
  }
  for (std::size_t region = 0; region < truth.regions.size (); ++region)
  {
    mean_column[region] /= truth.regions[region].pixels;
    mean_row[region] /= truth.regions[region].pixels;
  }

  std::vector<double> nearest (truth.regions.size (), std::numeric_limits<double>::infinity ());
  for (std::size_t pixel = 0; pixel < truth.region_of.size (); ++pixel)
  {
    const int region = truth.region_of[pixel];
    if (region < 0)
      continue;
    const int column = static_cast<int> (pixel % truth.width), row = static_cast<int> (pixel / truth.width);
    const double dx = column - mean_column[region], dy = row - mean_row[region];
    const double distance = dx * dx + dy * dy;
    if (distance < nearest[region])
    {
      nearest[region] = distance;
      truth.regions[region].center_column = column;
      truth.regions[region].center_row = row;
    }
  }
}

} // namespace

std::string
toString (GroundTruthKind kind)
{
  return (kind == GroundTruthKind::objects ? "objects" : "parts");
}

GroundTruthKind
groundTruthKindFromName (const std::string& name)
{
  for (const GroundTruthKind kind : {GroundTruthKind::objects, GroundTruthKind::parts})
    if (name == toString (kind))
      return (kind);
  throw std::invalid_argument ("no ground truth \"" + name + "\"");
}

GroundTruth
makeGroundTruth (const pcl::PointCloud<pcl::PointXYZRGBL>& cloud, GroundTruthKind kind)
{
  if (cloud.empty () || cloud.size () != static_cast<std::size_t> (cloud.width) * cloud.height)
    throw std::invalid_argument ("makeGroundTruth: the cloud is empty or its size is not width * height");

  GroundTruth truth;
  truth.kind = kind;
  truth.width = static_cast<int> (cloud.width);
  truth.height = static_cast<int> (cloud.height);

  const auto regionLabel = [kind] (std::uint32_t label) {
    return (kind == GroundTruthKind::objects ? label / 10 : label);
  };
  const auto isOnObject = [] (const pcl::PointXYZRGBL& point) {
    return (pcl::isXYZFinite (point) && point.label >= first_object_label);
  };

  std::map<std::uint32_t, std::size_t> pixels_of_label;
  for (const auto& point : cloud)
  {
    if (isOnObject (point))
      ++pixels_of_label[regionLabel (point.label)];
  }
  std::map<std::uint32_t, int> index_of_label;
  for (const auto& [label, pixels] : pixels_of_label)
  {
    index_of_label[label] = static_cast<int> (truth.regions.size ());
    Region region;
    region.label = label;
    region.pixels = pixels;
    truth.regions.push_back (region);
  }

  truth.region_of.reserve (cloud.size ());
  for (const auto& point : cloud)
  {
    if (isOnObject (point))
      truth.region_of.push_back (index_of_label[regionLabel (point.label)]);
    else if (!pcl::isXYZFinite (point))
      truth.region_of.push_back (GroundTruth::invalid);
    else
      truth.region_of.push_back (point.label == 0 ? GroundTruth::unlabelled : GroundTruth::support);
  }
  findCenters (truth);
  return (truth);
}

} // namespace pcl_attention
