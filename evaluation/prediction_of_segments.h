// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/prediction.h"

#include <pcl/segmentation/attention_segment.h>

namespace pcl_attention
{

/** \brief Segments in the form that is scored; the label image gives every pixel to the first segment that claims it.
 * \param[in] width,height of the segmented cloud, pixels */
ScenePrediction predictionOfSegments (int width, int height, const std::vector<AttentionSegment>& segments);

} // namespace pcl_attention
