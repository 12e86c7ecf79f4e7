// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/asked_for.h"

#include <pcl/segmentation/attention_segmentation.h>
#include <pcl/segmentation/impl/organized_cloud.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <stdexcept>

namespace pcl_attention
{
namespace
{

using Cloud = pcl::PointCloud<pcl::PointXYZRGBL>;
using Color = std::array<std::uint8_t, 3>;

Color
meanColor (const Cloud& cloud, const pcl::Indices& pixels)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero ();
  for (const pcl::index_t pixel : pixels)
    sum += Eigen::Vector3d (cloud[pixel].r, cloud[pixel].g, cloud[pixel].b);
  sum /= static_cast<double> (pixels.size ());
  return {static_cast<std::uint8_t> (std::lround (sum.x ())), static_cast<std::uint8_t> (std::lround (sum.y ())),
          static_cast<std::uint8_t> (std::lround (sum.z ()))};
}

Color
nearestNamedColor (const Color& color)
{
  const auto& named = namedColors ();
  const float tolerance = AttentionPrior ().color_tolerance;
  return (std::max_element (named.begin (), named.end (),
                            [&] (const auto& a, const auto& b) {
                              return (colorSimilarity (a.second, color, tolerance) <
                                      colorSimilarity (b.second, color, tolerance));
                            })
              ->second);
}

/** \brief Distances from the viewpoint, ascending, metres. */
std::vector<float>
distances (const Cloud& cloud, const pcl::Indices& pixels)
{
  std::vector<float> values;
  for (const pcl::index_t pixel : pixels)
    values.push_back ((cloud[pixel].getVector3fMap () - cloud.sensor_origin_.head<3> ()).norm ());
  std::sort (values.begin (), values.end ());
  return (values);
}

PixelRegion
boundingRectangle (const pcl::Indices& pixels, int width)
{
  int left = width, right = 0, top = pixels.front () / width, bottom = top;
  for (const pcl::index_t pixel : pixels)
  {
    left = std::min (left, pixel % width);
    right = std::max (right, pixel % width);
    bottom = std::max (bottom, pixel / width);
  }
  return {left, top, right - left + 1, bottom - top + 1};
}

ValueRange
around (float value, float step)
{
  const float rounded = std::round (value / step) * step;
  return {std::max (0.0f, rounded - 0.5f * step), rounded + 0.5f * step};
}

/** \brief Rank of the first segment whose attention point lies on the region, see AskedForRanks. */
int
rankOf (pcl::AttentionSegmentation<pcl::PointXYZRGBL>& segmentation, const GroundTruth& truth, int region)
{
  pcl::AttentionSegment segment;
  int rank = 1;
  for (; segmentation.segmentNext (segment); ++rank)
    if (truth.region_of[segment.attention_point.row * truth.width + segment.attention_point.column] == region)
      return (rank);
  return (rank);
}

} // namespace

const std::vector<std::string>&
askedForNames ()
{
  static const std::vector<std::string> names{"map",        "region", "coarse_region", "exemplar", "color",
                                              "color_name", "size",   "coarse_size",   "distance", "coarse_distance"};
  return (names);
}

AttentionPrior
priorFor (const Cloud& cloud, const GroundTruth& truth, int region, AskedFor asked_for)
{
  pcl::Indices pixels;
  for (std::size_t pixel = 0; pixel < truth.region_of.size (); ++pixel)
    if (truth.region_of[pixel] == region)
      pixels.push_back (static_cast<pcl::index_t> (pixel));

  AttentionPrior prior;
  switch (asked_for)
  {
    case AskedFor::map:
      prior.map.assign (truth.width, truth.height, 0.0f);
      for (const pcl::index_t pixel : pixels)
        prior.map[pixel] = 1.0f;
      break;
    case AskedFor::region:
      prior.region = boundingRectangle (pixels, truth.width);
      break;
    case AskedFor::coarse_region:
    {
      const int columns = std::max (1, truth.width / 4), rows = std::max (1, truth.height / 3);
      const Region& at = truth.regions[region];
      prior.region = PixelRegion{at.center_column / columns * columns, at.center_row / rows * rows, columns, rows};
      break;
    }
    case AskedFor::exemplar:
      prior.color_exemplar.emplace ();
      for (const pcl::index_t pixel : pixels)
        prior.color_exemplar->add (colorBin (cloud[pixel].r, cloud[pixel].g, cloud[pixel].b));
      break;
    case AskedFor::color:
      prior.color = meanColor (cloud, pixels);
      break;
    case AskedFor::color_name:
      prior.color = nearestNamedColor (meanColor (cloud, pixels));
      break;
    case AskedFor::size:
    {
      const float side = longestSide (gather (cloud, nullptr), pixels);
      prior.size = ValueRange{0.9f * side, 1.1f * side};
      break;
    }
    case AskedFor::coarse_size:
      prior.size = around (longestSide (gather (cloud, nullptr), pixels), 0.05f);
      break;
    case AskedFor::distance:
    {
      const std::vector<float> values = distances (cloud, pixels);
      prior.distance = ValueRange{values[values.size () / 20], values[values.size () - 1 - values.size () / 20]};
      break;
    }
    case AskedFor::coarse_distance:
    {
      const std::vector<float> values = distances (cloud, pixels);
      double sum = 0.0;
      for (const float value : values)
        sum += value;
      prior.distance = around (static_cast<float> (sum / static_cast<double> (values.size ())), 0.1f);
      break;
    }
  }
  return (prior);
}

std::vector<std::vector<AskedForRanks>>
rankAskedFor (const LabelledScene& scene, const std::vector<AskedFor>& kinds, const AttentionParameters& parameters,
              unsigned int threads)
{
  const GroundTruth truth = makeGroundTruth (*scene.cloud, GroundTruthKind::objects);
  pcl::AttentionSegmentation<pcl::PointXYZRGBL> segmentation (parameters);
  segmentation.setNumberOfThreads (threads);
  segmentation.setInputCloud (scene.cloud);
  const auto rankWith = [&] (const AttentionPrior& prior, int region) {
    segmentation.setAttentionPrior (prior);
    const int rank = rankOf (segmentation, truth, region);
    if (!segmentation.getPipeline ())
      throw std::runtime_error (scene.name + ": could not be segmented, see above");
    return (rank);
  };
  std::vector<std::vector<AskedForRanks>> ranks (kinds.size ());
  for (int region = 0; region < static_cast<int> (truth.regions.size ()); ++region)
  {
    const int without = rankWith ({}, region);
    for (std::size_t kind = 0; kind < kinds.size (); ++kind)
      ranks[kind].push_back ({without, rankWith (priorFor (*scene.cloud, truth, region, kinds[kind]), region)});
  }
  return (ranks);
}

void
printAskedFor (std::ostream& stream, const std::vector<AskedFor>& kinds,
               const std::vector<std::vector<AskedForRanks>>& ranks)
{
  stream << "Mean rank of the asked-for object without and with the prior, and share of them that come first\n"
         << "  " << std::left << std::setw (16) << "asked for" << std::right << "  objects  without     with  "
         << "first without  first with\n"
         << std::fixed << std::setprecision (3);
  for (std::size_t kind = 0; kind < kinds.size (); ++kind)
  {
    double without = 0, with = 0, first_without = 0, first_with = 0;
    for (const AskedForRanks& rank : ranks[kind])
    {
      without += rank.without;
      with += rank.with;
      first_without += rank.without == 1;
      first_with += rank.with == 1;
    }
    const auto count = static_cast<double> (ranks[kind].size ());
    stream << "  " << std::left << std::setw (16) << askedForNames ()[static_cast<std::size_t> (kinds[kind])]
           << std::right << std::setw (9) << ranks[kind].size () << std::setw (9) << without / count << std::setw (9)
           << with / count << std::setw (15) << first_without / count << std::setw (12) << first_with / count << '\n';
  }
}

} // namespace pcl_attention
