// SPDX-License-Identifier: BSD-3-Clause
#include "input_file.h"

#include "scene_io.h"

#include <pcl/console/print.h>

#include <cstdint>

// PLY files as scenes, through PCL's reader.

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size)
{
  using namespace pcl_attention;
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  static const InputFolder folder;
  static const DepthCamera camera{10.0, 10.0, 3.5, 2.5, 8, 6};
  SceneOptions options;
  options.camera = camera;
  const std::string path = folder.write ("input.ply", data, size);
  expectOneLine ([&] { readScene (path, options); });
  return (0);
}
