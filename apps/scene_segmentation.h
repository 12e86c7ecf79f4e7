// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "prior_flags.h"
#include "scene_io.h"
#include <pcl_attention/core/parameters.h>

#include <vector>

namespace pcl_attention
{

/** \brief Everything that is found in a scene. */
struct SceneSegments
{
  std::vector<AttentionSegment> segments; /**< ranks 1, 2, ... */
  std::vector<SupportingPlane> supporting_planes;
  StageTimes times;
  std::size_t extracted_points{0}; /**< attention points of the saliency map, before any is skipped */
  std::size_t patches{0};
  NamedPrior prior; /**< what was asked for */
};

/** \brief Run pcl::AttentionSegmentation; without colour on points without colour.
 * \param[in] threads 0: all processors
 * \param[in] prior what is asked for
 * \throws std::runtime_error that names the scene */
SceneSegments segmentScene (const Scene& scene, const AttentionParameters& parameters, unsigned int threads,
                            const NamedPrior& prior = {});

} // namespace pcl_attention
