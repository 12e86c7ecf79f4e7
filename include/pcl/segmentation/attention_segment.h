// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/pipeline.h>

namespace pcl
{

/** \brief One object: its points, the fixation it grew from, plane, box, compactness and why growth ended.
 * See \ref pcl_attention::AttentionSegment for every field. */
using AttentionSegment = pcl_attention::AttentionSegment;

/** \brief A fixation; see \ref pcl_attention::AttentionPoint. */
using AttentionPoint = pcl_attention::AttentionPoint;

/** \brief A supporting plane; see \ref pcl_attention::SupportingPlane. */
using SupportingPlane = pcl_attention::SupportingPlane;

} // namespace pcl
