// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output_folder.h"
#include "parameter_io.h"
#include "scene_segmentation.h"

#include <pcl/PCLPointCloud2.h>

#include <string>

namespace pcl_attention
{

/** \brief Write all files of a scene: attention_points.csv, segments.json, mask_0001.png ..., labels.pcd, overview.png
 * and summary.json. \throws std::runtime_error that names the file */
void writeSceneSegments (const Scene& scene, const SceneSegments& result, const NamedParameters& parameters,
                         OutputFolder& folder);

/** \brief Rank, pixel, point in metres, saliency, kind and size of every segment's attention point, with a header. */
std::string attentionPointsCsv (const Scene& scene, const std::vector<AttentionSegment>& segments);

/** \brief The segments and the supporting planes as JSON. */
std::string segmentsJson (const SceneSegments& result);

/** \brief Version, parameters, milliseconds and counts as JSON. */
std::string summaryJson (const Scene& scene, const SceneSegments& result, const NamedParameters& parameters);

/** \brief The content of a compressed PCD file, with the sensor pose that the scene's file has.
 * \throws std::runtime_error that names the scene */
std::string encodePcd (const Scene& scene, const pcl::PCLPointCloud2& points);

/** \brief "mask_0001.png" */
std::string maskFileName (int rank);

/** \brief 255 on the segment. */
Image<std::uint8_t> segmentMask (const Scene& scene, const AttentionSegment& segment);

/** \brief Per point 0, or the rank of the first segment that claims it. */
std::vector<std::uint32_t> segmentLabels (const Scene& scene, const std::vector<AttentionSegment>& segments);

} // namespace pcl_attention
