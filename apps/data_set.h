// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/labelled_scene.h"
#include "scene_io.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief What a data set does not tell about itself. */
struct DataSetOptions
{
  SceneOptions scene; /**< the camera of depth images */
  /** \brief Values of label images that are no objects; empty: 0, and in OCID's layout 1, and 2 below a folder "table".
   */
  std::vector<std::uint16_t> support_labels;
};

/** \brief A labelled scene that is not read yet. */
struct SceneSource
{
  std::string name;                          /**< different for all scenes of an evaluation, without a slash */
  std::string category;                      /**< what it is reported under */
  std::string points;                        /**< PCD file, or depth image */
  std::string color;                         /**< of a depth image */
  std::string labels;                        /**< label image; empty: the PCD file has labels, or there are masks */
  std::vector<std::string> masks;            /**< an image an object */
  std::vector<std::uint16_t> support_labels; /**< values of the label image that are no objects */

  /** \brief All that it is read from. */
  std::vector<std::string> files () const;
};

/** \brief The scenes that a list of files and folders stands for, checked as far as can be without reading them whole.
 *
 * | layout | files |
 * |---|---|
 * | labelled clouds | *.pcd with a field label |
 * | clouds with masks (Willow) | *.pcd without one; beside each, or in masks/, NAME_*.png: an object each, not 0 on it
 * | | OSD 0.2 | image_color/, annotation/ (labels) and disparity/ or depth/ (16 bit), or pcd/ instead | | OCID | at any
 * depth: folders with rgb/, label/ and depth/ (16 bit), or pcd/ instead |
 *
 * Depth images are taken where the camera is known, else the clouds.
 * \throws std::runtime_error: a line for each file that is missing or wrong */
std::vector<SceneSource> listSceneSources (const std::vector<std::string>& paths, const DataSetOptions& options);

/** \brief Read a scene. Labels of images become those of labelled clouds: 1 where there is no object, else 20 + 10
 * value. \throws std::runtime_error that names the file and what is wrong with it */
LabelledScene loadScene (const SceneSource& source, const DataSetOptions& options);

} // namespace pcl_attention
