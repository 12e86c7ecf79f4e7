// SPDX-License-Identifier: BSD-3-Clause
#include "input_file.h"

#include "depth_camera.h"
#include "parameter_io.h"

#include <cstdint>

// JSON files of parameters and of a camera.

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size)
{
  using namespace pcl_attention;
  static const InputFolder folder;
  const std::string path = folder.write ("input.json", data, size);
  expectOneLine ([&] { readParameters (path); });
  expectOneLine ([&] { readDepthCamera (path); });
  return (0);
}
