// SPDX-License-Identifier: BSD-3-Clause
#include "ply_header.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

namespace pcl_attention
{

namespace
{

[[noreturn]] void
fail (const std::string& message)
{
  throw std::runtime_error (message);
}

/** \brief Bytes that a property takes at least: of a list, its length. */
std::uint64_t
propertySize (const std::string& type, bool ascii)
{
  static const std::map<std::string, std::uint64_t> sizes{
      {"char", 1},  {"uchar", 1},  {"short", 2},   {"ushort", 2},  {"int", 4},   {"uint", 4},
      {"float", 4}, {"double", 8}, {"int8", 1},    {"uint8", 1},   {"int16", 2}, {"uint16", 2},
      {"int32", 4}, {"uint32", 4}, {"float32", 4}, {"float64", 8}, {"list", 1}};
  const auto size = sizes.find (type);
  if (size == sizes.end ())
    fail ("damaged PLY header: unknown type '" + type + "'");
  return (ascii ? 2 : size->second); // a digit and a blank
}

} // namespace

void
checkPlyHeader (const std::string& path)
{
  std::ifstream file (path, std::ios::binary);
  if (!file)
    fail (std::string ("cannot be opened: ") + std::strerror (errno));
  const std::uint64_t file_size = std::filesystem::file_size (path);
  constexpr std::streamsize longest_header = 1 << 16;
  std::string text (longest_header, '\0');
  file.read (text.data (), longest_header);
  text.resize (static_cast<std::size_t> (file.gcount ()));
  if (text.empty ())
    fail ("an empty file");
  if (text.compare (0, 3, "ply") != 0)
    fail ("not a PLY file");

  std::istringstream lines (text);
  bool ascii = true, is_vertex = false, is_image = false, has_red = false;
  std::uint64_t count = 0, element_size = 0, needed = 0, vertices = 0, columns = 0, rows = 0;
  const auto finish_element = [&] {
    if (element_size > 0 && count > file_size / element_size)
      fail ("truncated: the header announces " + std::to_string (count) + " elements, more than the file can hold");
    needed += count * element_size;
    count = element_size = 0;
  };
  for (std::string line; std::getline (lines, line);)
  {
    std::istringstream words (line);
    std::string word, type;
    words >> word >> type;
    // PCL keeps such numbers in signed 32-bit integers.
    const auto readNumber = [&] (std::uint64_t& number) {
      if (!(words >> number) || number > static_cast<std::uint64_t> (std::numeric_limits<std::int32_t>::max ()))
        fail ("damaged PLY header: '" + line + "'");
    };
    if (line.compare (0, word.size (), word) != 0) // a blank before it, on which PCL's reader ends the program
      fail ("damaged PLY header: '" + line + "'");
    if (word == "format")
      ascii = type == "ascii";
    else if (word == "element")
    {
      finish_element ();
      readNumber (count);
      is_vertex = type == "vertex";
      if (is_vertex && vertices > 0)
        fail ("damaged PLY header: points twice");
      if (is_vertex)
        vertices = count;
    }
    else if (word == "property")
    {
      if (is_vertex && type == "list")
        fail ("its points have a list as a property, on which PCL's reader ends the program: leave it out");
      element_size += propertySize (type, ascii);
      std::string name;
      words >> name;
      const bool is_color = is_vertex && (type == "uchar" || type == "uint8");
      has_red = has_red || (is_color && (name == "red" || name == "diffuse_red"));
      // PCL's reader puts these into the place that it has made for red.
      for (const char* other : {"green", "blue", "alpha", "diffuse_green", "diffuse_blue"})
        if (is_color && !has_red && name == other)
          fail ("damaged PLY header: " + name + " without red before it");
    }
    else if (word == "obj_info" && (type.compare (0, 8, "num_cols") == 0 || type.compare (0, 8, "num_rows") == 0))
    {
      if (vertices > 0) // PCL's reader has made room for its points by then
        fail ("damaged PLY header: '" + line + "' after the points");
      readNumber (type[4] == 'c' ? columns : rows);
      is_image = true;
    }
    else if (word == "end_header")
    {
      finish_element ();
      if (vertices == 0)
        fail ("no points");
      const std::uint64_t available = lines.eof () ? 0 : file_size - static_cast<std::uint64_t> (lines.tellg ());
      if (is_image && vertices > columns * rows)
        fail ("damaged PLY header: " + std::to_string (vertices) + " points in an image of " + std::to_string (columns) + " x " +
              std::to_string (rows));
      if (columns * rows > available) // a pixel takes the number of its points, which is none or one
        fail ("truncated: the header announces an image of " + std::to_string (columns) + " x " + std::to_string (rows) +
              " points, more than the file can hold");
      if (needed > available + 1) // the last blank may be lacking
        fail ("truncated: the header announces " + std::to_string (vertices) + " points, more than the file can hold");
      return;
    }
    else if (!word.empty () && word != "ply" && word != "comment" && word != "obj_info")
      fail ("damaged PLY header: '" + line + "'");
  }
  fail ("truncated: the PLY header has no end");
}

} // namespace pcl_attention
