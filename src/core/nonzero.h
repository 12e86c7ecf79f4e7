// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace pcl_attention
{

/** \brief The first value that is not 0, or the end; eight at a time, as most of an image is 0. */
inline const std::uint8_t*
findNonZero (const std::uint8_t* begin, const std::uint8_t* end)
{
  for (std::uint64_t word = 0; end - begin >= static_cast<std::ptrdiff_t> (sizeof (word)); begin += sizeof (word))
  {
    std::memcpy (&word, begin, sizeof (word));
    if (word != 0)
      break;
  }
  return (std::find_if (begin, end, [] (std::uint8_t value) { return (value != 0); }));
}

/** \brief Visit the places of all values that are not 0. */
template <typename Visit> void
forEachNonZero (const std::uint8_t* begin, const std::uint8_t* end, const Visit& visit)
{
  for (const std::uint8_t* at = findNonZero (begin, end); at != end; at = findNonZero (at + 1, end))
    visit (at - begin);
}

} // namespace pcl_attention
