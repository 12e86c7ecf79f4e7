// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl_attention
{

/** \brief At most 400 pixels, which tell what a patch is like: evenly spread, and out of step with its rows. */
inline pcl::Indices
evenSamples (const pcl::Indices& pixels)
{
  constexpr double golden = 0.6180339887498949;
  const std::size_t count = std::min<std::size_t> (400, pixels.size ());
  pcl::Indices samples;
  samples.reserve (count);
  for (std::size_t sample = 0; sample < count; ++sample)
  {
    double whole;
    const double place = static_cast<double> (sample), shift = std::modf (place * golden, &whole);
    samples.push_back (pixels[static_cast<std::size_t> ((place + shift) * static_cast<double> (pixels.size ()) /
                                                        static_cast<double> (count))]);
  }
  return (samples);
}

} // namespace pcl_attention
