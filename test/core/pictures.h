// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/skeleton.h>

#include <cstdint>
#include <string>
#include <vector>

/** \brief Small pictures drawn as text, and a flood fill of their own. */
namespace pictures
{

using pcl_attention::Image;
using Picture = Image<std::uint8_t>;

/** \brief '#' is foreground. */
inline Picture
picture (const std::vector<std::string>& rows)
{
  Picture image (static_cast<int> (rows.front ().size ()), static_cast<int> (rows.size ()), 0);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      image (column, row) = rows[row][column] == '#';
  return (image);
}

inline Picture
picture (std::initializer_list<const char*> rows)
{
  return (picture (std::vector<std::string> (rows.begin (), rows.end ())));
}

inline std::string
draw (const Picture& image)
{
  std::string text;
  for (int row = 0; row < image.height; ++row)
  {
    for (int column = 0; column < image.width; ++column)
      text += image (column, row) ? '#' : '.';
    text += '\n';
  }
  return (text);
}

/** \brief Components by the simplest means: the smallest index spreads until nothing changes; then numbered in reading
 * order. \param[in] neighbors 4 or 8 \return their number */
inline int
floodFill (const Picture& image, Image<int>& labels, int neighbors = 8)
{
  Image<int> smallest (image.width, image.height, -1);
  for (std::size_t index = 0; index < image.size (); ++index)
    if (image[index])
      smallest[index] = static_cast<int> (index);
  bool changed = true;
  while (changed)
  {
    changed = false;
    for (int row = 0; row < image.height; ++row)
      for (int column = 0; column < image.width; ++column)
        for (int r = row - 1; r <= row + 1; ++r)
          for (int c = column - 1; c <= column + 1; ++c)
            if (image (column, row) && image.contains (c, r) && image (c, r) &&
                (neighbors == 8 || r == row || c == column) && smallest (c, r) < smallest (column, row))
            {
              smallest (column, row) = smallest (c, r);
              changed = true;
            }
  }
  labels.assign (image.width, image.height, 0);
  int count = 0;
  for (std::size_t index = 0; index < image.size (); ++index)
    if (image[index])
      labels[index] = smallest[index] == static_cast<int> (index) ? ++count : labels[smallest[index]];
  return (count);
}

inline int
floodFill (const Picture& image, int neighbors)
{
  Image<int> labels;
  return (floodFill (image, labels, neighbors));
}

} // namespace pictures
