// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/organized_cloud.h>

#include <gtest/gtest.h>

#include <limits>

using namespace pcl_attention;

namespace
{

TEST (ImageSize, isTakenUpToTheLimits)
{
  EXPECT_EQ (imageSizeProblem (1, 1), "");
  EXPECT_EQ (imageSizeProblem (16384, 4096), "");
  EXPECT_EQ (imageSizeProblem (4096, 16384), "");
  EXPECT_EQ (imageSizeProblem (8192, 8192), "");
}

TEST (ImageSize, isAProblemBeyond)
{
  const std::string limits = ", more than the 16384 a side and 67108864 in all that are taken";
  EXPECT_EQ (imageSizeProblem (16385, 1), "16385 x 1" + limits);
  EXPECT_EQ (imageSizeProblem (1, 16385), "1 x 16385" + limits);
  EXPECT_EQ (imageSizeProblem (8193, 8192), "8193 x 8192" + limits);
  constexpr auto largest = std::numeric_limits<std::uint64_t>::max ();
  EXPECT_NE (imageSizeProblem (largest, 2), "") << "the product of these overflows";
  EXPECT_NE (imageSizeProblem (std::uint64_t{1} << 32, std::uint64_t{1} << 32), "") << "and of these is 0";
}

} // namespace
