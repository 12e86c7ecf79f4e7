// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/image.h>

#include <algorithm>

namespace pcl_attention
{

/** \brief The largest of values from 0 up. */
inline float
largestValue (const Image<float>& map)
{
  // Several at a time, so that none waits for the one before.
  constexpr std::size_t lanes = 16;
  float maxima[lanes] = {};
  std::size_t index = 0;
  for (; index + lanes <= map.size (); index += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane)
      maxima[lane] = map[index + lane] > maxima[lane] ? map[index + lane] : maxima[lane];
  for (; index < map.size (); ++index)
    maxima[0] = std::max (maxima[0], map[index]);
  return (*std::max_element (maxima, maxima + lanes));
}

} // namespace pcl_attention
