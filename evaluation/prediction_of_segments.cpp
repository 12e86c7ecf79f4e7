// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/prediction_of_segments.h"

namespace pcl_attention
{

ScenePrediction
predictionOfSegments (int width, int height, const std::vector<AttentionSegment>& segments)
{
  ScenePrediction prediction;
  prediction.width = width;
  prediction.height = height;
  for (const AttentionSegment& segment : segments)
  {
    PredictedSegment predicted;
    predicted.column = segment.attention_point.column;
    predicted.row = segment.attention_point.row;
    predicted.kind = toString (segment.attention_point.kind);
    predicted.confidence = segment.confidence;
    predicted.mask = segment.indices;
    prediction.segments.push_back (std::move (predicted));
  }
  prediction.labels = labelsOfMasks (width, height, prediction.segments);
  return (prediction);
}

} // namespace pcl_attention
