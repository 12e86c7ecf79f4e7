// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/organized_cloud.h>

#include <algorithm>

namespace pcl_attention
{

std::string
imageSizeProblem (std::uint64_t columns, std::uint64_t rows)
{
  if (columns <= longest_side && rows <= longest_side && columns * rows <= most_pixels)
    return ("");
  return (std::to_string (columns) + " x " + std::to_string (rows) + ", more than the " + std::to_string (longest_side) +
          " a side and " + std::to_string (most_pixels) + " in all that are taken");
}

} // namespace pcl_attention
