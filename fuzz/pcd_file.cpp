// SPDX-License-Identifier: BSD-3-Clause
#include "input_file.h"

#include "evaluation/labelled_scene.h"
#include "scene_io.h"

#include <pcl/console/print.h>

#include <cstdint>

// PCD files as scenes and as labelled scenes, through PCL's reader.

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size)
{
  using namespace pcl_attention;
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  static const InputFolder folder;
  const std::string path = folder.write ("input.pcd", data, size);
  expectOneLine ([&] { readScene (path); });
  expectOneLine ([&] { loadLabelledScene (path); });
  return (0);
}
