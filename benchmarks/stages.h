// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scenes.h"

#include <pcl_attention/core/pipeline.h>

#include <memory>

namespace pcl_attention
{

/** \brief A scene with what each stage makes of it, so that the next stage can be measured on its own. */
struct Frame
{
  explicit Frame (const SceneCloud::ConstPtr& scene);

  SceneCloud::ConstPtr scene;
  OrganizedCloud cloud;
  NormalImage normals;
  std::vector<PyramidLevel> coarser;
  SaliencyMaps saliency;
  AttentionPoints points;
  PlanarPatches patches;
};

/** \brief Register the stages, each on one thread, and the whole frame. The frames must outlive the measurements. */
void
measureStages (const std::vector<Frame>& frames);

} // namespace pcl_attention
