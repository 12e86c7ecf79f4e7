// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/png_file.h"

#include "evaluation/file_error.h"

#include <png.h>

namespace pcl_attention
{

Image<std::uint8_t>
readGreyPng (const std::string& file, int width, int height)
{
  // libpng itself: VTK 9.1's reader crashes on a file that is cut short
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file (&image, file.c_str ()) == 0)
    fail (file, std::string ("not a readable PNG file: ") + image.message);
  const bool is_grey = image.format == PNG_FORMAT_GRAY;
  const int image_width = static_cast<int> (image.width), image_height = static_cast<int> (image.height);
  if (!is_grey || image_width != width || image_height != height)
  {
    png_image_free (&image);
    fail (file, is_grey ? imageSizeText (image_width, image_height) + " pixels, the scene has " +
                              imageSizeText (width, height)
                        : "not an 8-bit grey image");
  }
  Image<std::uint8_t> values (width, height);
  if (png_image_finish_read (&image, nullptr, values.data.data (), 0, nullptr) == 0)
    fail (file, std::string ("not a readable PNG file: ") + image.message);

  return (values);
}

} // namespace pcl_attention
