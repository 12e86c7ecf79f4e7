// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/ground_truth.h"
#include "png_image.h"
#include "scene_io.h"
#include <pcl_attention/core/organized_cloud.h>

#include <Eigen/Geometry>
#include <pcl/io/image_grabber.h>

#include <memory>
#include <string>
#include <vector>

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

/** \brief Where the depth and colour images of a scene are, and the camera they were taken with. */
struct DepthImages
{
  std::string depth, color;              /**< PNG files: 16-bit depth, and 8-bit colour registered to it or empty */
  double focal_length_x{0.0};            /**< pixels; 0: that of a Kinect, 525 / 640 of the width */
  double focal_length_y{0.0};            /**< pixels; 0: as focal_length_x */
  double center_x{-1.0}, center_y{-1.0}; /**< principal point, pixels; negative: the middle of the image */
  double depth_scale{0.001};             /**< metres of one unit of depth */
};

/** \brief Prepare a scene for the viewer.
 * \param[in] truth its labels, or null */
ViewerScenePtr makeViewerScene (Scene&& scene, const std::shared_ptr<const GroundTruth>& truth = nullptr);

/** \brief Read an organized PCD file, with labels where it has some.
 * \param[in] image_width see \ref readScene
 * \throws std::runtime_error: one line that names the file, what is wrong and what to do about it */
ViewerScenePtr readViewerScene (const std::string& path, int image_width);

/** \brief Read a depth image and its colours as a cloud, by pcl::ImageGrabber.
 * \throws std::runtime_error: one line that names the file, what is wrong and what to do about it */
ViewerScenePtr readDepthImages (const DepthImages& images);

/** \brief PCL's grabber of some depth images of one camera and their colours. It takes the rows of an image from below:
 * its clouds stand on their heads until they are turned by \ref turnUpright. \param[in] frame_rate frames per second;
 * 0: as they are asked for \throws std::runtime_error: one line that names the file, what is wrong and what to do about
 * it */
std::unique_ptr<pcl::ImageGrabber<pcl::PointXYZRGBA>> makeImageGrabber (const std::vector<DepthImages>& images,
                                                                        float frame_rate);

/** \brief Turn what that grabber gives: rows from above, y downwards. */
void turnUpright (pcl::PointCloud<pcl::PointXYZRGB>& cloud);

/** \brief The labelled scene that is shown when the user brings none. */
ViewerScenePtr renderViewerScene ();

} // namespace pcl_attention
