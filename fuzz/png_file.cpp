// SPDX-License-Identifier: BSD-3-Clause
#include "input_file.h"

#include "evaluation/png_file.h"
#include "png_image.h"

#include <boost/crc.hpp>
#include <cstdint>

// PNG files as colour, depth and label images, as masks and as maps of a prior, through libpng.

namespace
{

/** \brief Make the chunks' checksums right, or hardly a change would get past them. */
void
mendChecksums (std::string& png)
{
  const auto number = [&] (std::size_t at) {
    std::size_t value = 0;
    for (std::size_t byte = 0; byte < 4; ++byte)
      value = value << 8 | static_cast<unsigned char> (png[at + byte]);
    return (value);
  };
  constexpr std::size_t signature = 8, around = 12; // length, type and checksum
  for (std::size_t begin = signature; begin + around <= png.size ();)
  {
    const std::size_t length = number (begin);
    if (length > png.size () - begin - around)
      return;
    boost::crc_32_type checksum;
    checksum.process_bytes (&png[begin + 4], length + 4);
    for (std::size_t byte = 0; byte < 4; ++byte)
      png[begin + 8 + length + byte] = static_cast<char> (checksum.checksum () >> (24 - 8 * byte));
    begin += around + length;
  }
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size)
{
  using namespace pcl_attention;
  static const InputFolder folder;
  std::string png (reinterpret_cast<const char*> (data), size);
  if (size % 4 != 0) // some stay as they are
    mendChecksums (png);
  const std::string path = folder.write ("input.png", png.data (), png.size ());
  expectOneLine ([&] { readPngHeader (path); });
  expectOneLine ([&] { readColorPng (path); });
  expectOneLine ([&] { readIndexPng (path); });
  expectOneLine ([&] { readDepthPng (path); });
  expectOneLine ([&] { readGreyPng (path, 8, 6); });
  return (0);
}
