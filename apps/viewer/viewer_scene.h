// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/ground_truth.h"
#include "png_image.h"
#include "scene_io.h"
#include <pcl_attention/core/organized_cloud.h>

#include <Eigen/Geometry>

#include <memory>
#include <string>

namespace pcl_attention
{

/** \brief A scene as the viewer holds it: what was read, the same in the sensor's own frame, and its labels. */
struct ViewerScene
{
  Scene scene;
  OrganizedCloud cloud;                     /**< in the sensor's frame, metres */
  Eigen::Isometry3f sensor_pose;            /**< from the sensor's frame to the cloud's */
  float focal_length{0.0f};                 /**< pixels; estimated from the points */
  Image<Color> background;                  /**< the colours, or depth in grey */
  std::shared_ptr<const GroundTruth> truth; /**< null for a scene without labels */

  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

using ViewerScenePtr = std::shared_ptr<const ViewerScene>;

/** \brief Prepare a scene for the viewer.
 * \param[in] truth its labels, or null */
ViewerScenePtr makeViewerScene (Scene&& scene, const std::shared_ptr<const GroundTruth>& truth = nullptr);

/** \brief Read a scene as \ref readScene, and the labels that a PCD file has.
 * \throws std::runtime_error: one line that names the file, what is wrong and what to do about it */
ViewerScenePtr readViewerScene (const std::string& path, const SceneOptions& options);

/** \brief The labelled scene that is shown when the user brings none. */
ViewerScenePtr renderViewerScene ();

} // namespace pcl_attention
