// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/pcd_header.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace pcl_attention
{

namespace
{

constexpr std::size_t longest_header = 1 << 16;
constexpr std::uint64_t largest_point = 1 << 16;
// LZF, the compression of PCD files, makes at most 264 bytes out of 3.
constexpr std::uint64_t largest_compression = 88;

[[noreturn]] void
fail (const std::string& message)
{
  throw std::runtime_error (message);
}

std::vector<std::string>
splitWords (const std::string& line)
{
  std::istringstream stream (line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back (word);
  return (words);
}

std::uint64_t
parseNumber (const std::vector<std::string>& words, std::size_t index, std::uint64_t minimum, std::uint64_t maximum)
{
  std::uint64_t value = 0;
  const std::string text = index < words.size () ? words[index] : "";
  const auto [end, error] = std::from_chars (text.data (), text.data () + text.size (), value);
  if (error != std::errc () || end != text.data () + text.size () || value < minimum || value > maximum)
    fail ("damaged PCD header: " + words[0] + " is '" + text + "'");
  return (value);
}

const std::array<std::string, 11> header_entries{"VERSION", "FIELDS",    "COLUMNS", "SIZE", "TYPE", "COUNT", "WIDTH",
                                                 "HEIGHT",  "VIEWPOINT", "POINTS",  "DATA"};

/** \brief Refuse points that PCL's reader would take for more of the header: it goes on after DATA as long as lines are
 * empty, comments or begin like entries.
 * \param[in] text of the file
 * \param[in] begin of the points */
void
checkEndOfHeader (const std::string& text, std::size_t begin)
{
  while (begin < text.size ())
  {
    begin = text.find_first_not_of (" \t\n\v\f\r", begin);
    if (begin == std::string::npos)
      break;
    if (std::any_of (header_entries.begin (), header_entries.end (), [&] (const std::string& entry) {
          return (text.compare (begin, entry.size (), entry) == 0);
        }))
      fail ("damaged: the points begin like a header");
    if (text[begin] != '#')
      return;
    begin = std::min (text.find ('\n', begin), text.size ());
  }
  if (text.size () == longest_header)
    fail ("damaged: the points begin like comments");
}

/** \brief The header's lines up to DATA, in the order the format prescribes; PCL's reader needs this order as well, but
 * does not check it. */
class HeaderParser
{
public:
  /** \brief \return false after the last line */
  bool
  parse (const std::string& line)
  {
    const std::vector<std::string> words = splitWords (line);
    if (words.empty () && !line.empty ())
      fail ("damaged PCD header: a line of blanks"); // where PCL's reader ends it
    if (words.empty () || words[0][0] == '#')
      return (true);
    const std::string name = words[0] == "COLUMNS" ? "FIELDS" : words[0];
    const auto entry = std::find (header_entries.begin (), header_entries.end (), name);
    if (entry == header_entries.end ())
      fail (has_entries_ ? "damaged PCD header: unknown entry" : "not a PCD file");
    // PCL parts words at blanks, tabulators and carriage returns alone.
    if (std::any_of (line.begin (), line.end (), [] (unsigned char letter) {
          return (letter < ' ' && letter != '\t' && letter != '\r');
        }))
      fail ("damaged PCD header: a control character");
    if (has_entries_ && entry <= last_entry_)
      fail ("damaged PCD header: " + name + " is out of order");
    has_entries_ = true;
    last_entry_ = entry;
    if (name == "FIELDS")
    {
      for (std::size_t i = 1; i < words.size (); ++i)
      {
        header.fields.emplace_back ();
        header.fields.back ().name = words[i];
      }
    }
    else if (name == "SIZE")
      forEachField (words, [&] (PcdHeader::Field& field, std::size_t i) { field.size = parseNumber (words, i, 1, 8); });
    else if (name == "TYPE")
      forEachField (words, [&] (PcdHeader::Field& field, std::size_t i) { field.type = words[i][0]; });
    else if (name == "COUNT")
      forEachField (words, [&] (PcdHeader::Field& field, std::size_t i) {
        field.count = parseNumber (words, i, 1, largest_point);
      });
    else if (name == "WIDTH")
      header.width = parseNumber (words, 1, 0, largest_cloud);
    else if (name == "HEIGHT")
      header.height = parseNumber (words, 1, 0, largest_cloud);
    else if (name == "POINTS")
      header.points = parseNumber (words, 1, 0, largest_cloud);
    else if (name == "DATA")
    {
      data_type = words.size () > 1 ? words[1] : "";
      return (false);
    }
    return (true);
  }

  PcdHeader header;
  std::string data_type;

private:
  // pcl::index_t is a signed 32-bit integer.
  static constexpr std::uint64_t largest_cloud = std::numeric_limits<std::int32_t>::max ();

  template <typename Function>
  void
  forEachField (const std::vector<std::string>& words, Function function)
  {
    if (words.size () != header.fields.size () + 1)
      fail ("damaged PCD header: " + words[0] + " and FIELDS differ in length");
    for (std::size_t i = 0; i < header.fields.size (); ++i)
      function (header.fields[i], i + 1);
  }

  bool has_entries_{false};
  std::array<std::string, 11>::const_iterator last_entry_{};
};

void
checkFileSize (std::istream& file, std::uint64_t data_begin, std::uint64_t file_size, const std::string& data_type,
               const PcdHeader& header)
{
  const std::uint64_t available = file_size - data_begin;
  const std::uint64_t needed = header.points * header.point_size;
  const std::string announced = "the header announces " + std::to_string (header.points) + " points";
  if (data_type == "ascii")
  {
    std::uint64_t values = 0;
    for (const PcdHeader::Field& field : header.fields)
      values += field.count;
    // A value takes a digit and a blank, only the last one may lack the blank.
    if (header.points * values * 2 > available + 1)
      fail ("truncated: " + announced + ", more than the file can hold");
  }
  else if (data_type == "binary")
  {
    if (needed > available)
      fail ("truncated: " + announced + ", the file holds " + std::to_string (available / header.point_size));
  }
  else if (data_type == "binary_compressed")
  {
    std::array<std::uint32_t, 2> sizes{}; // compressed and not compressed
    file.seekg (static_cast<std::streamoff> (data_begin));
    if (!file.read (reinterpret_cast<char*> (sizes.data ()), sizeof (sizes)) || sizes[0] > available - sizeof (sizes))
      fail ("truncated: " + announced + ", the file ends before the last of them");
    if (sizes[1] != needed || needed > sizes[0] * largest_compression)
      fail ("damaged: " + announced + ", the compressed data are of another size");
  }
  else
    fail ("damaged PCD header: DATA is '" + data_type + "', neither ascii nor binary nor binary_compressed");
}

} // namespace

PcdHeader
checkPcdHeader (const std::string& path)
{
  std::ifstream file (path, std::ios::binary);
  std::string text (longest_header, '\0');
  if (!file)
    fail (std::string ("cannot be opened: ") + std::strerror (errno));
  file.read (&text[0], static_cast<std::streamsize> (text.size ()));
  text.resize (static_cast<std::size_t> (file.gcount ()));
  file.clear ();
  file.seekg (0, std::ios::end);
  const auto file_size = static_cast<std::uint64_t> (file.tellg ());
  if (text.empty ())
    fail ("an empty file");

  HeaderParser parser;
  std::size_t begin = 0;
  for (bool more = true; more;)
  {
    const std::size_t end = text.find ('\n', begin);
    if (end == std::string::npos)
      fail (begin == 0 ? "not a PCD file" : "truncated: the PCD header has no end");
    more = parser.parse (text.substr (begin, end - begin));
    begin = end + 1;
  }
  checkEndOfHeader (text, begin);

  PcdHeader& header = parser.header;
  if (header.width == 0 && header.height == 0) // as in files before version 0.7
  {
    header.width = header.points;
    header.height = 1;
  }
  if (header.width * header.height != header.points)
    fail ("damaged PCD header: WIDTH " + std::to_string (header.width) + " x HEIGHT " + std::to_string (header.height) +
          " is not POINTS " + std::to_string (header.points));
  for (const PcdHeader::Field& field : header.fields)
    header.point_size += field.size * field.count;
  if (header.point_size == 0 || header.point_size > largest_point)
    fail ("damaged PCD header: a point has " + std::to_string (header.point_size) + " bytes");
  if (header.points > 0)
    checkFileSize (file, begin, file_size, parser.data_type, header);
  return (header);
}

} // namespace pcl_attention
