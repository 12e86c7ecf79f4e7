// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace pcl_attention
{

/** \brief The shortest text that reads back as the same number, whatever the locale: 0.1f is "0.1". */
template <typename Number>
std::string
numberText (Number value)
{
  std::array<char, 64> text;
  const auto end = std::to_chars (text.data (), text.data () + text.size (), value).ptr;
  return (std::string (text.data (), end));
}

/** \brief A float as the double that has its shortest text, so that JSON shows 0.1 instead of 0.10000000149011612. */
inline double
shortestDouble (float value)
{
  const std::string text = numberText (value);
  double result = value;
  std::from_chars (text.data (), text.data () + text.size (), result);
  return (result);
}

} // namespace pcl_attention
