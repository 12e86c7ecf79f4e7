// SPDX-License-Identifier: BSD-3-Clause
// Counts the pixels of a PNG file that have a colour, for the tests of the viewer's pictures.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <png.h>
#include <vector>

/** \brief Usage: count_pixels PNG LEFT TOP WIDTH HEIGHT RED GREEN BLUE TOLERANCE; a negative width or height takes all.
 * Prints how many pixels of the rectangle differ from the colour by at most the tolerance in every channel. */
int
main (int argc, char** argv)
{
  if (argc != 10)
    return (2);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file (&image, argv[1]) == 0)
  {
    std::fprintf (stderr, "%s: %s\n", argv[1], image.message);
    return (1);
  }
  image.format = PNG_FORMAT_RGB;
  std::vector<png_byte> pixels (PNG_IMAGE_SIZE (image));
  if (png_image_finish_read (&image, nullptr, pixels.data (), 0, nullptr) == 0)
    return (1);
  int values[8];
  for (int k = 0; k < 8; ++k)
    values[k] = std::atoi (argv[2 + k]);
  const int image_width = static_cast<int> (image.width), image_height = static_cast<int> (image.height);
  const int right = values[2] < 0 ? image_width : std::min (values[0] + values[2], image_width);
  const int bottom = values[3] < 0 ? image_height : std::min (values[1] + values[3], image_height);
  int count = 0;
  for (int row = values[1]; row < bottom; ++row)
    for (int column = values[0]; column < right; ++column)
    {
      const png_byte* pixel = &pixels[3 * (static_cast<std::size_t> (row) * image_width + column)];
      bool same = true;
      for (int channel = 0; channel < 3; ++channel)
        same &= std::abs (pixel[channel] - values[4 + channel]) <= values[7];
      count += same;
    }
  std::printf ("%d\n", count);
  return (0);
}
