// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_io.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pcl_attention
{

/** \brief The error of reading a scene, one line, without the file's name, which it must start with; empty without one. */
inline std::string
errorOfReading (const std::string& file, const SceneOptions& options)
{
  try
  {
    readScene (file, options);
  }
  catch (const std::runtime_error& error)
  {
    const std::string message = error.what ();
    EXPECT_EQ (message.find (file + ": "), 0u) << message;
    EXPECT_EQ (message.find ('\n'), std::string::npos) << message;
    return (message.substr (file.size () + 2));
  }
  return ("");
}

} // namespace pcl_attention
