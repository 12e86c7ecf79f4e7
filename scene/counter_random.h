// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

namespace pcl_attention
{

/** \brief Random numbers as a function of seed, stream and counter: any of them can be had in any order, by any thread,
 * and unlike the distributions of the standard library they are the same on every platform. */
class CounterRandom
{
public:
  explicit CounterRandom (std::uint64_t seed, std::uint64_t stream = 0) : key_ (mix (mix (seed) + stream)) {}

  std::uint64_t
  bits (std::uint64_t counter) const
  {
    return (mix (key_ + counter * 0x9e3779b97f4a7c15U));
  }

  /** \return in [0, 1) */
  double
  uniform (std::uint64_t counter) const
  {
    return (static_cast<double> (bits (counter) >> 11) * 0x1p-53);
  }

  /** \return mean 0, deviation 1: the sum of four uniform numbers, which needs no function that rounds differently
   * elsewhere */
  double
  normal (std::uint64_t counter) const
  {
    const std::uint64_t b = bits (counter);
    const auto sum = static_cast<double> ((b & 0xffff) + (b >> 16 & 0xffff) + (b >> 32 & 0xffff) + (b >> 48));
    return ((sum - 2.0 * 65535.0) * (std::sqrt (3.0) / 65536.0));
  }

private:
  /** \brief The finalizer of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014). */
  static std::uint64_t
  mix (std::uint64_t x)
  {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9U;
    x = (x ^ x >> 27) * 0x94d049bb133111ebU;
    return (x ^ x >> 31);
  }

  std::uint64_t key_;
};

} // namespace pcl_attention
