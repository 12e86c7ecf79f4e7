// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/prediction.h"

#include <map>

namespace pcl_attention
{

std::vector<std::uint32_t>
labelsOfMasks (int width, int height, const std::vector<PredictedSegment>& segments)
{
  std::vector<std::uint32_t> labels (static_cast<std::size_t> (width) * height, 0);
  for (std::size_t segment = 0; segment < segments.size (); ++segment)
  {
    for (const auto pixel : segments[segment].mask)
    {
      if (labels.at (pixel) == 0)
        labels[pixel] = static_cast<std::uint32_t> (segment + 1);
    }
  }
  return (labels);
}

ScenePrediction
predictionOfLabels (int width, int height, std::vector<std::uint32_t> labels)
{
  ScenePrediction prediction;
  prediction.width = width;
  prediction.height = height;
  std::map<std::uint32_t, PredictedSegment> segment_of_label;
  for (std::size_t pixel = 0; pixel < labels.size (); ++pixel)
  {
    if (labels[pixel] != 0)
      segment_of_label[labels[pixel]].mask.push_back (static_cast<pcl::index_t> (pixel));
  }
  for (auto& [label, segment] : segment_of_label)
    prediction.segments.push_back (std::move (segment));
  prediction.labels = std::move (labels);
  return (prediction);
}

} // namespace pcl_attention
