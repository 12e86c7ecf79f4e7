// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/core/nonzero.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

using namespace pcl_attention;

TEST (NonZero, IsFoundAtEveryPlaceOfEveryLength)
{
  for (std::size_t length = 0; length < 27; ++length)
    for (std::size_t begin = 0; begin <= length; ++begin)
      for (std::size_t place = begin; place <= length; ++place)
      {
        std::vector<std::uint8_t> values (length + 1, 0); // the one behind the end is not to be found
        values[place] = 200;
        values[length] = 1;
        if (begin > 0)
          values[begin - 1] = 1; // nor is the one before the begin
        EXPECT_EQ (findNonZero (values.data () + begin, values.data () + length) - values.data (), static_cast<std::ptrdiff_t> (place));
      }
}

TEST (NonZero, AreVisitedInOrder)
{
  const std::vector<std::uint8_t> values{0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 255};
  std::vector<std::ptrdiff_t> places;
  forEachNonZero (values.data (), values.data () + values.size (), [&places] (std::ptrdiff_t place) { places.push_back (place); });
  EXPECT_EQ (places, (std::vector<std::ptrdiff_t>{1, 13, 14, 18}));
}
