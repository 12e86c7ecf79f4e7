// SPDX-License-Identifier: BSD-3-Clause
#include "patch_groups.h"
#include "point_at.h"

#include <pcl_attention/core/attention_prior.h>
#include <pcl_attention/core/compact_clustering.h>

#include <Eigen/Eigenvalues>
#include <pcl/point_types_conversion.h>

#include <algorithm>
#include <cmath>

namespace pcl_attention
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

Eigen::Vector3f
labOf (const Color& color)
{
  pcl::PointXYZRGB point;
  point.r = color[0];
  point.g = color[1];
  point.b = color[2];
  pcl::PointXYZLAB lab;
  pcl::PointXYZRGBtoXYZLAB (point, lab);
  return {lab.L, lab.a, lab.b};
}

float
labSimilarity (const Eigen::Vector3f& a, const Eigen::Vector3f& b, float tolerance)
{
  const Eigen::Vector3f difference = (a - b).cwiseProduct (Eigen::Vector3f (0.5f, 1.0f, 1.0f)) / tolerance;
  return (1.0f / (1.0f + difference.squaredNorm ()));
}

std::string
rangeProblem (const char* name, const std::optional<ValueRange>& range)
{
  // Negated so that NaN is refused as well.
  if (range && !(range->minimum >= 0.0f && range->minimum <= range->maximum))
    return (std::string ("the ") + name + " of the prior is from " + std::to_string (range->minimum) + " to " +
            std::to_string (range->maximum) + " m, but must be from 0 up, the smaller value first");
  return ("");
}

/** \brief Match of every pixel to the parts that a pixel has: all but the size and the colours of an exemplar. */
Image<float>
pixelMatch (const OrganizedCloud& cloud, const Eigen::Isometry3f& sensor_pose, const AttentionPrior& prior)
{
  Image<float> match (cloud.width, cloud.height, 1.0f);
  if (!prior.map.data.empty ())
    match = prior.map;
  if (prior.region)
  {
    const PixelRegion& region = *prior.region;
    for (int row = 0; row < cloud.height; ++row)
      for (int column = 0; column < cloud.width; ++column)
        if (column < region.column || column - region.column >= region.width || row < region.row ||
            row - region.row >= region.height)
          match (column, row) = 0.0f;
  }
  if (prior.box || prior.distance)
    for (std::size_t index = 0; index < cloud.size (); ++index)
    {
      const Eigen::Vector3f point = pointAt (cloud, index);
      if ((prior.box && !prior.box->contains (sensor_pose * point)) ||
          (prior.distance && !prior.distance->contains (point.norm ())))
        match[index] = 0.0f;
    }
  if (prior.color)
  {
    const Eigen::Vector3f asked = labOf (*prior.color);
    for (std::size_t index = 0; index < cloud.size (); ++index)
      match[index] *=
        labSimilarity (labOf ({cloud.red[index], cloud.green[index], cloud.blue[index]}), asked, prior.color_tolerance);
  }
  return (match);
}

/** \brief Match of a whole piece to the parts that only a piece has: its size and its colours together. */
float
pieceMatch (const OrganizedCloud& cloud, const pcl::Indices& pixels, const AttentionPrior& prior)
{
  float match = 1.0f;
  if (prior.size)
  {
    // Noise and occlusion change a length: what is a little too short or too long still matches.
    const float length = longestSide (cloud, pixels);
    const float ratio = length < prior.size->minimum   ? length / prior.size->minimum
                        : length > prior.size->maximum ? prior.size->maximum / length
                                                       : 1.0f;
    match *= ratio * ratio;
  }
  if (prior.color_exemplar)
  {
    ColorHistogram colors;
    for (const pcl::index_t pixel : pixels)
      colors.add (colorBin (cloud.red[pixel], cloud.green[pixel], cloud.blue[pixel]));
    const float likeness = 1.0f - chiSquare (colors, *prior.color_exemplar);
    match *= likeness * likeness;
  }
  return (match);
}

} // namespace

float
longestSide (const OrganizedCloud& cloud, const pcl::Indices& pixels)
{
  if (pixels.empty ())
    return (0.0f);
  Eigen::Vector3f mean = Eigen::Vector3f::Zero ();
  for (const pcl::index_t pixel : pixels)
    mean += pointAt (cloud, pixel) / static_cast<float> (pixels.size ());
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero ();
  for (const pcl::index_t pixel : pixels)
    covariance += (pointAt (cloud, pixel) - mean) * (pointAt (cloud, pixel) - mean).transpose ();
  const Eigen::Vector3f axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> (covariance).eigenvectors ().col (2);
  float low = 0.0f, high = 0.0f;
  for (const pcl::index_t pixel : pixels)
  {
    const float along = axis.dot (pointAt (cloud, pixel) - mean);
    low = std::min (low, along);
    high = std::max (high, along);
  }
  return (high - low);
}

std::string
validate (const AttentionPrior& prior, int width, int height, bool has_color)
{
  const std::string size = std::to_string (width) + " x " + std::to_string (height);
  const Image<float>& map = prior.map;
  if (!map.data.empty () && (map.width != width || map.height != height || map.size () != static_cast<std::size_t> (width) * height))
    return ("the map of the prior is " + std::to_string (map.width) + " x " + std::to_string (map.height) +
            ", but the cloud is " + size + ": give one value per point, row by row");
  for (const float value : map.data)
    if (!(value >= 0.0f && value <= 1.0f))
      return ("the map of the prior holds " + std::to_string (value) + ", but must be from 0 to 1");
  if (prior.region)
  {
    const PixelRegion& region = *prior.region;
    if (region.width < 1 || region.height < 1 || region.column >= width || region.row >= height ||
        region.column < 1 - region.width || region.row < 1 - region.height)
      return ("the region of the prior has " + std::to_string (region.width) + " x " + std::to_string (region.height) +
              " pixels from column " + std::to_string (region.column) + ", row " + std::to_string (region.row) +
              " on: none of them is in the cloud of " + size);
  }
  if (prior.box && (prior.box->isEmpty () || !prior.box->min ().allFinite () || !prior.box->max ().allFinite ()))
    return ("the box of the prior is empty or not finite: give its smaller corner first, in metres");
  if ((prior.color || prior.color_exemplar) && !has_color)
    return ("the prior asks for a colour, but the cloud has none");
  if (prior.color_exemplar && !(prior.color_exemplar->total > 0.0f))
    return ("the colour exemplar of the prior has no pixels");
  if (!(prior.color_tolerance > 0.0f))
    return ("the colour tolerance of the prior is " + std::to_string (prior.color_tolerance) + ", but must be above 0");
  if (!(prior.floor > 0.0f && prior.floor <= 1.0f))
    return ("the floor of the prior is " + std::to_string (prior.floor) + ", but must be above 0, up to 1");
  const std::string problem = rangeProblem ("size", prior.size);
  return (problem.empty () ? rangeProblem ("distance", prior.distance) : problem);
}

const std::vector<std::pair<std::string, Color>>&
namedColors ()
{
  static const std::vector<std::pair<std::string, Color>> colors{
    {"black", {30, 30, 30}},    {"grey", {128, 128, 128}},  {"white", {230, 230, 230}}, {"red", {180, 35, 40}},
    {"orange", {225, 115, 35}}, {"yellow", {225, 195, 50}}, {"green", {50, 130, 65}},   {"blue", {45, 85, 165}},
    {"purple", {105, 60, 130}}, {"pink", {225, 150, 165}},  {"brown", {110, 75, 45}}};
  return (colors);
}

float
colorSimilarity (const Color& a, const Color& b, float tolerance)
{
  return (labSimilarity (labOf (a), labOf (b), tolerance));
}

std::vector<int>
groupPatches (const PlanarPatches& patches, const PatchGraph& graph, const std::vector<std::uint8_t>& excluded)
{
  const ClusteringParameters like_growth; // whatever the preset, a piece is what the default would not part
  return (groupsOf (graph, patches.patches.size (), excluded, [&] (const PatchBorder& border) {
    return (border.connectedShare () >= like_growth.minimum_connection && border.convexity () >= like_growth.minimum_convexity);
  }));
}

Image<float>
priorWeights (const OrganizedCloud& cloud, const PlanarPatches& patches, const std::vector<int>& piece_of_label,
              const Eigen::Isometry3f& sensor_pose, const AttentionPrior& prior)
{
  Image<float> weights = pixelMatch (cloud, sensor_pose, prior);
  std::vector<pcl::Indices> pieces (*std::max_element (piece_of_label.begin (), piece_of_label.end ()) + 1);
  for (std::size_t index = 0; index < weights.size (); ++index)
    pieces[piece_of_label[patches.labels[index]]].push_back (static_cast<pcl::index_t> (index));
  if (prior.size || prior.color_exemplar)
    for (const pcl::index_t pixel : pieces.front ())
      weights[pixel] = 0.0f;
  for (std::size_t piece = 1; piece < pieces.size (); ++piece)
  {
    double sum = 0.0;
    for (const pcl::index_t pixel : pieces[piece])
      sum += weights[pixel];
    const auto mean = static_cast<float> (sum / static_cast<double> (pieces[piece].size ()));
    const float match = mean * pieceMatch (cloud, pieces[piece], prior);
    for (const pcl::index_t pixel : pieces[piece])
      weights[pixel] = match;
  }
  for (float& weight : weights.data)
    weight = std::max (weight, prior.floor);
  return (weights);
}

void
extractAttentionPoints (const Image<float>& saliency, const Image<float>& weights, const std::vector<std::uint8_t>& valid,
                        const AttentionPointParameters& parameters, AttentionPoints& result)
{
  Image<float> weighted = saliency;
  for (std::size_t index = 0; index < weighted.size (); ++index)
    weighted[index] *= weights[index];
  extractAttentionPoints (weighted, valid, parameters, result);
  AttentionPoints plain;
  extractAttentionPoints (saliency, valid, parameters, plain);

  std::vector<std::uint8_t> is_known (valid.size (), 0);
  for (const AttentionPoint& point : result.points)
    is_known[static_cast<std::size_t> (point.row) * saliency.width + point.column] = 1;
  for (AttentionPoint point : plain.points)
  {
    const std::size_t index = static_cast<std::size_t> (point.row) * saliency.width + point.column;
    if (is_known[index])
      continue;
    point.saliency *= weights[index];
    point.point_saliency *= weights[index];
    point.component = 0;
    result.points.push_back (point);
  }
  for (AttentionPoint& point : result.points)
    point.weight = weights (point.column, point.row);
  std::stable_sort (result.points.begin (), result.points.end (), [] (const AttentionPoint& a, const AttentionPoint& b) {
    return (a.saliency > b.saliency);
  });
  sortByWeight (result.points);
}

float
weightStep (float weight)
{
  return (std::floor (-2.0f * std::log2 (weight)));
}

void
sortByWeight (std::vector<AttentionPoint>& points)
{
  std::stable_sort (points.begin (), points.end (), [] (const AttentionPoint& a, const AttentionPoint& b) {
    return (weightStep (a.weight) < weightStep (b.weight));
  });
}

} // namespace pcl_attention
