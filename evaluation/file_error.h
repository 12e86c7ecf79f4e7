// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace pcl_attention
{

/** \brief \throws std::runtime_error that names the file */
[[noreturn]] inline void
fail (const std::filesystem::path& file, const std::string& message)
{
  throw std::runtime_error (file.string () + ": " + message);
}

/** \brief "320x240" */
inline std::string
imageSizeText (int width, int height)
{
  return (std::to_string (width) + "x" + std::to_string (height));
}

} // namespace pcl_attention
