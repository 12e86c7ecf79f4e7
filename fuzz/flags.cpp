// SPDX-License-Identifier: BSD-3-Clause
#include "input_file.h"

#include "depth_camera.h"
#include "evaluation/labelled_scene.h"
#include "number_text.h"
#include "parameter_io.h"

#include <cstdint>
#include <cstdlib>

// Texts of flags: of parameters, of a camera, numbers of priors; and the names of scenes.

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size)
{
  using namespace pcl_attention;
  if (size < 1)
    return (0);
  const std::string text (reinterpret_cast<const char*> (data + 1), size - 1);
  const std::vector<ParameterDescription>& table = parameterTable ();
  const ParameterDescription& row = table[data[0] % table.size ()];
  AttentionParameters parameters;
  if (row.parse (text, parameters).empty ())
  {
    // What is taken is in range, and reads back as it was.
    AttentionParameters again;
    if (!row.parse (row.toString (parameters), again).empty () || row.get (again) != row.get (parameters))
      std::abort ();
  }
  expectOneLine ([&] { presetParameters (text); });
  // A text that names a file is that file, which is another target's.
  if (text.find ('/') == std::string::npos && text.find (".json") == std::string::npos && text.find ('\n') == std::string::npos)
    expectOneLine ([&] { readDepthCamera (text); });
  for (const float number : numbersOf<float> (text))
    if (!std::isfinite (number))
      std::abort ();
  numbersOf<int> (text);
  numbersOf<std::uint8_t> (text);
  numbersOf<double> (text);
  if (!text.empty () && text.find ('\0') == std::string::npos)
    sceneCategory (text);
  return (0);
}
