// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/metrics.h"
#include "evaluation/prediction_of_segments.h"

#include <pcl/segmentation/attention_segmentation.h>
#include <pcl_attention/core/parameters.h>

namespace pcl_attention::test
{

/** \brief Segment a labelled cloud and score the result. */
inline SceneScore
score (const pcl::PointCloud<pcl::PointXYZRGBL>::Ptr& cloud, const AttentionParameters& parameters, GroundTruthKind kind)
{
  pcl::AttentionSegmentation<pcl::PointXYZRGBL> segmentation (parameters);
  segmentation.setNumberOfThreads (0);
  segmentation.setInputCloud (cloud);
  std::vector<pcl::AttentionSegment> segments;
  segmentation.segment (segments);
  return (scoreScene (makeGroundTruth (*cloud, kind),
                      predictionOfSegments (static_cast<int> (cloud->width), static_cast<int> (cloud->height), segments)));
}

} // namespace pcl_attention::test
