// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief An attention point and its segment. */
struct PredictedSegment
{
  int column = -1; ///< the attention point, pixels; negative: a segment without an attention point, attends nothing
  int row = -1;
  std::string kind; ///< junction, midpoint, winner, coverage, user, or empty
  double confidence = std::numeric_limits<double>::quiet_NaN (); ///< 0 to 1; NaN: not given
  pcl::Indices mask; ///< row-major pixel indices, each once; masks of different segments may overlap
};

/** \brief All that a system says about a scene. */
struct ScenePrediction
{
  int width = 0;                          ///< pixels
  int height = 0;                         ///< pixels
  std::vector<PredictedSegment> segments; ///< in order of attention: the segment of rank r is segments[r - 1]
  std::vector<std::uint32_t>
      labels; ///< per pixel, row-major: 0 = no object, else a segment, by any number (usually its rank)
};

/** \brief Label image: every pixel belongs to the first segment (in order of attention) whose mask claims it. */
std::vector<std::uint32_t> labelsOfMasks (int width, int height, const std::vector<PredictedSegment>& segments);

/** \brief Prediction of a system without attention: each label of the image is a segment without an attention point. */
ScenePrediction predictionOfLabels (int width, int height, std::vector<std::uint32_t> labels);

} // namespace pcl_attention
