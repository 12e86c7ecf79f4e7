// SPDX-License-Identifier: BSD-3-Clause
#include "input_file.h"

#include "evaluation/results.h"
#include "png_image.h"

#include <pcl/console/print.h>

#include <cstdint>
#include <cstdio>

// Results of anyone for a scene of 8 x 6 pixels: the input is the file PCL_ATTENTION_FUZZED_FILE among good ones.

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size)
{
  using namespace pcl_attention;
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  static const InputFolder folder;
  static const bool is_prepared = [] {
    const std::string points = "rank,column,row,kind\n1,2,3,junction\n2,7,5,user\n3,0,0,winner\n";
    folder.write ("attention_points.csv", points.data (), points.size ());
    const std::string mask = encodePng (Image<std::uint8_t> (8, 6, 255));
    for (const char* name : {"mask_0001.png", "mask_0002.png", "mask_0003.png"})
      folder.write (name, mask.data (), mask.size ());
    return (true);
  }();
  static_cast<void> (is_prepared);
  folder.write (PCL_ATTENTION_FUZZED_FILE, data, size);
  expectOneLine ([] { readResults (folder.path (), 8, 6); });
  return (0);
}
