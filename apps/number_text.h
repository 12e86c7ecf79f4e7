// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

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

/** \brief The numbers of a text that holds nothing else, parted by a character; none if one of them is not finite, or does
 * not fit into the type. */
template <typename Number>
std::vector<Number>
numbersOf (const std::string& text, char separator = ',')
{
  std::vector<Number> numbers;
  const char *position = text.data (), *const end = position + text.size ();
  while (true)
  {
    Number number{};
    const auto [next, error] = std::from_chars (position, end, number);
    if (error != std::errc () || !std::isfinite (static_cast<double> (number)))
      return {};
    numbers.push_back (number);
    if (next == end)
      return (numbers);
    if (*next != separator)
      return {};
    position = next + 1;
  }
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
