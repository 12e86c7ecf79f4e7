// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/image.h>

#include <array>
#include <string>

namespace pcl_attention
{

/** \brief Red, green and blue, 0..255. */
using Color = std::array<std::uint8_t, 3>;

/** \brief The content of an 8-bit PNG file. pcl::io::saveCharPNGFile writes to a file only and does not tell whether it
 * could. \throws std::runtime_error */
std::string encodePng (const Image<std::uint8_t>& image);
std::string encodePng (const Image<Color>& image);

} // namespace pcl_attention
