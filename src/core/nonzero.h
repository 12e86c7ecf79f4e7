// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
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

/** \brief Visit the runs of values that are not 0, each by its first place and the one behind its last. */
template <typename Visit> void
forEachRun (const std::uint8_t* begin, const std::uint8_t* end, const Visit& visit)
{
  for (const std::uint8_t* at = begin; (at = findNonZero (at, end)) != end;)
  {
    const std::uint8_t* const run = at;
    const void* const zero = std::memchr (run, 0, static_cast<std::size_t> (end - run));
    at = zero ? static_cast<const std::uint8_t*> (zero) : end;
    visit (run - begin, at - begin);
  }
}

/** \brief Visit the places of all values that are not 0. */
template <typename Visit> void
forEachNonZero (const std::uint8_t* begin, const std::uint8_t* end, const Visit& visit)
{
  forEachRun (begin, end, [&visit] (std::ptrdiff_t first, std::ptrdiff_t behind) {
    for (; first < behind; ++first)
      visit (first);
  });
}

} // namespace pcl_attention
