// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief A labelled cloud with what reports call it. */
struct LabelledScene
{
  std::string name;                              ///< stem of the file, e.g. "learn7"
  std::string category;                          ///< see sceneCategory
  pcl::PointCloud<pcl::PointXYZRGBL>::Ptr cloud; ///< organized, metres
};

/** \brief The category a scene is reported under.
 *
 * learn0..learn44 are named by mOSD's numbering: 0-16 "boxes", 17-24 "stacked", 25-32 "occluded", 33-44 "cylindric".
 * Every other scene goes under the name of its folder.
 * \param[in] path the scene's file; it need not exist */
std::string sceneCategory (const std::string& path);

/** \brief The scenes that a list of files and folders stands for: files as they are, a folder's files (not those of its
 * subfolders) by name. \param[in] extensions of the files that are taken from a folder
 * \throws std::runtime_error that names the path which does not exist, the folder without such a file, or the two scenes
 * of the same stem (results are found by stem) */
std::vector<std::string> listScenes (const std::vector<std::string>& paths,
                                     const std::vector<std::string>& extensions = {".pcd"});

/** \brief Read a PCD file with the fields x, y, z and label (4-byte integer); colour is read where there is any.
 *
 * Some scenes of mOSD are stored unorganized. With exactly 640 * 480 points they are taken as 640x480 in row-major
 * order. \throws std::runtime_error that names the file: unreadable, a field missing, empty, or unorganized with
 * another size */
LabelledScene loadLabelledScene (const std::string& path);

} // namespace pcl_attention
