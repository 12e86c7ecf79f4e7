// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/image.h>

#include <string>

namespace pcl_attention
{

/** \brief Read an 8-bit grey PNG file that has to have the size of a scene.
 * \throws std::runtime_error that names the file: unreadable, not 8-bit grey, or of another size */
Image<std::uint8_t> readGreyPng (const std::string& file, int width, int height);

} // namespace pcl_attention
