// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace pcl_attention
{

/** \brief Takes values from the bytes of an input, one after the other; after their end all are 0. */
class ByteReader
{
public:
  ByteReader (const std::uint8_t* data, std::size_t size) : position_ (data), end_ (data + size) {}

  bool
  isAtEnd () const
  {
    return (position_ == end_);
  }

  template <typename Value>
  Value
  take ()
  {
    Value value{};
    const std::size_t size = std::min (sizeof (Value), static_cast<std::size_t> (end_ - position_));
    if (size > 0)
      std::memcpy (&value, position_, size);
    position_ += size;
    return (value);
  }

  /** \brief A number from 0 up to one less than this, at most 256. */
  int
  below (int count)
  {
    return (take<std::uint8_t> () % count);
  }

  bool
  flag ()
  {
    return (below (2) == 1);
  }

  /** \brief Any float: mostly a coordinate from -2 to 2, often one that is special. */
  float
  number ()
  {
    using Limits = std::numeric_limits<float>;
    constexpr float special[] = {Limits::quiet_NaN (), Limits::infinity (), -Limits::infinity (), 0.0f,
                                 -0.0f,                1.0f,                -1.0f,                Limits::max (),
                                 -Limits::max (),      Limits::min (),      Limits::denorm_min (), Limits::epsilon (),
                                 1e6f,                 1e-6f,               1e18f,                1e-18f};
    constexpr int n_special = sizeof (special) / sizeof (special[0]);
    const int tag = take<std::uint8_t> ();
    if (tag < n_special)
      return (special[tag]);
    if (tag < 32)
      return (take<float> ());
    return (static_cast<float> (tag - 144) / 56.0f + static_cast<float> (take<std::uint8_t> ()) / 16384.0f);
  }

private:
  const std::uint8_t *position_, *end_;
};

} // namespace pcl_attention
