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

/** \brief Read a PNG file as 8-bit colour, whatever it holds; by libpng, as VTK 9.1's reader crashes on a file that is
 * cut short. \throws std::runtime_error with what is wrong, without the name of the file */
Image<Color> readColorPng (const std::string& path);

/** \brief What the header of a PNG file announces. */
struct PngHeader
{
  std::uint32_t width{0}, height{0}; /**< pixels */
  int bit_depth{0};                  /**< 1 to 16 */
  bool is_grey{false}, is_palette{false};
};

/** \brief \throws std::runtime_error with what is wrong, without the name of the file */
PngHeader readPngHeader (const std::string& path);

/** \brief Read the values of a grey PNG file, or the indices into the palette, as which label images are stored.
 * \throws std::runtime_error with what is wrong, without the name of the file */
Image<std::uint16_t> readIndexPng (const std::string& path);

/** \brief Read the values of a 16-bit grey PNG file, as which depth images are stored.
 * \throws std::runtime_error with what is wrong, without the name of the file */
Image<std::uint16_t> readDepthPng (const std::string& path);

} // namespace pcl_attention
