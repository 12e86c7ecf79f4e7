// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "png_image.h"
#include "viewer_model.h"

#include <string>

namespace pcl_attention
{

// What the viewer saves, each in a folder that is made if need be. All throw std::runtime_error that names the file.

/** \brief A name that is not taken: folder/stem_0001.extension, folder/stem_0002.extension, ...
 * \param[in] extension without its dot; empty for a folder */
std::string unusedPath (const std::string& folder, const std::string& stem, const std::string& extension);

/** \brief Save the points of the selected object as folder/<scene>_object_0003.pcd, 3 being its rank.
 * \return the path */
std::string saveSelectedObject (const ViewerModel& model, const std::string& folder);

/** \brief Save all results as pcl_attention_segment would, in folder/<scene>/.
 * \return the path */
std::string saveResults (const ViewerModel& model, const std::string& folder);

/** \brief Save the parameters as folder/parameters.json.
 * \return the path */
std::string saveParameters (const ViewerModel& model, const std::string& folder);

/** \brief Save an image as PNG. */
void savePicture (const Image<Color>& picture, const std::string& path);

} // namespace pcl_attention
