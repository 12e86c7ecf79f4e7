// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace pcl_attention
{

/** \brief A folder in memory, where there is one, for inputs that are read from files. */
class InputFolder
{
public:
  InputFolder ()
  {
    namespace fs = std::filesystem;
    const fs::path memory = "/dev/shm";
    folder_ = (fs::is_directory (memory) ? memory : fs::temp_directory_path ()) /
              ("pcl_attention-fuzz-" + std::to_string (getpid ()));
    fs::create_directories (folder_);
  }
  ~InputFolder ()
  {
    std::error_code ignored;
    std::filesystem::remove_all (folder_, ignored);
  }
  InputFolder (const InputFolder&) = delete;
  InputFolder& operator= (const InputFolder&) = delete;

  /** \brief Write a file.
   * \return its path */
  std::string
  write (const std::string& name, const void* data, std::size_t size) const
  {
    const std::string path = (folder_ / name).string ();
    std::FILE* const file = std::fopen (path.c_str (), "wb");
    // An empty input has no address.
    if (!file || (size > 0 && std::fwrite (data, 1, size, file) != size) || std::fclose (file) != 0)
      std::abort (); // or the input would not be what is tested
    return (path);
  }

  std::string
  path () const
  {
    return (folder_.string ());
  }

private:
  std::filesystem::path folder_;
};

/** \brief Read something that refuses a bad file by an exception with one line. */
template <typename Function>
void
expectOneLine (const Function& read)
{
  try
  {
    read ();
  }
  catch (const std::exception& error)
  {
    const std::string message = error.what ();
    if (message.empty () || message.find ('\n') != std::string::npos)
      std::abort ();
  }
}

} // namespace pcl_attention
