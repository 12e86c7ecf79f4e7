// SPDX-License-Identifier: BSD-3-Clause
#include "whole_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

namespace pcl_attention
{

namespace
{

/** \brief Processes of two machines may have the same number and write into the same folder. */
std::string
hostName ()
{
  std::array<char, 65> name{};
  gethostname (name.data (), name.size () - 1);
  return (name.data ());
}

} // namespace

void
writeWholeFile (const std::string& path, const std::string& content)
{
  // A device, say, is written to and not replaced.
  std::error_code ignored;
  const bool is_special = std::filesystem::exists (path, ignored) && !std::filesystem::is_regular_file (path, ignored);
  const std::string part = is_special ? path : path + ".part-" + hostName () + "-" + std::to_string (getpid ());
  errno = 0;
  std::ofstream stream (part, std::ios::binary);
  stream.write (content.data (), static_cast<std::streamsize> (content.size ()));
  stream.close ();
  if (stream && (is_special || std::rename (part.c_str (), path.c_str ()) == 0))
    return;
  const int error = errno == 0 ? EIO : errno;
  if (!is_special)
    std::remove (part.c_str ());
  throw std::runtime_error (path + ": cannot be written: " + std::strerror (error));
}

} // namespace pcl_attention
