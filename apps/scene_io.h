// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth_camera.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <limits>
#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief A scene as read from its file, ready for pcl::AttentionSegmentation. */
struct Scene
{
  std::string path;
  std::string name; /**< the file's stem */
  /** \brief Organized; NaN where not valid; black without colour. The sensor pose is one that sees the points. */
  pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud;
  bool has_color{false};
  bool has_labels{false}; /**< its PCD file has a field "label", in the order of the cloud's points */
  std::size_t valid_points{0};
  Eigen::Vector4f stored_origin{Eigen::Vector4f::Zero ()}; /**< sensor pose as it stands in the file */
  Eigen::Quaternionf stored_orientation{Eigen::Quaternionf::Identity ()};
  /** \brief What the user should know about the data, one line each: nothing here keeps the scene from being used. */
  std::vector<std::string> notes;

  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

/** \brief What a file does not tell about itself. */
struct SceneOptions
{
  int image_width{0}; /**< columns of a cloud that is stored as one row although it holds the whole image row by row; 0:
                        not known */
  DepthCamera camera; /**< of a depth image, or to organize an unorganized cloud by */
  std::string color; /**< for depth images: the colour image, or a folder with one of the same name; empty: no colour */
  float max_range{std::numeric_limits<float>::infinity ()}; /**< points farther before the sensor are holes, metres */
};

/** \brief Read a scene: a PCD or PLY file with x, y, z and optionally colour, or a 16-bit grey PNG file with depths.
 * What is not organized is organized by the options: by image_width as it is stored, or by the camera, where of the
 * points of a pixel the nearest is taken. \throws std::runtime_error: one line that names the file, what is wrong and
 * what to do about it */
Scene readScene (const std::string& path, const SceneOptions& options = {});

/** \brief A scene of a cloud that came another way, as from a camera, with the checks of \ref readScene.
 * \param[in] name of the scene, and its path in messages
 * \param[in] has_color whether the points have more than black for a colour
 * \param[in] max_range see \ref SceneOptions
 * \throws std::runtime_error: one line that names the scene and what is wrong */
Scene makeSceneOf (const pcl::PointCloud<pcl::PointXYZRGB>::Ptr& cloud, const std::string& name, bool has_color,
                   float max_range = std::numeric_limits<float>::infinity ());

} // namespace pcl_attention
