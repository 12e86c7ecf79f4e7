// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "png_image.h"
#include "scene_io.h"
#include <pcl_attention/core/compact_clustering.h>

#include <vector>

namespace pcl_attention
{

/** \brief The colours of a scene, or its depth in grey where it has none: near is bright, no depth is black. */
Image<Color> backgroundImage (const Scene& scene);

/** \brief The colour that a segment is drawn in; different for up to 256 of them. */
Color segmentColor (int rank);

/** \brief The scene with the outline of every segment and its numbered attention point, as in the paper's figure 2e.
 * Drawn without a display. */
Image<Color> drawOverview (const Scene& scene, const std::vector<AttentionSegment>& segments);

} // namespace pcl_attention
