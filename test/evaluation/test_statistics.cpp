// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace pcl_attention
{
namespace
{

TEST (DistributionOf, meanAndDeviationOfThePopulation)
{
  const Distribution distribution = distributionOf ({2, 4, 4, 4, 5, 5, 7, 9});
  EXPECT_DOUBLE_EQ (distribution.mean, 5);
  EXPECT_DOUBLE_EQ (distribution.deviation, 2);
}

TEST (DistributionOf, oneValueDoesNotDeviateAndNoValueHasNoMean)
{
  EXPECT_DOUBLE_EQ (distributionOf ({3}).mean, 3);
  EXPECT_DOUBLE_EQ (distributionOf ({3}).deviation, 0);
  EXPECT_TRUE (std::isnan (distributionOf ({}).mean));
  EXPECT_TRUE (std::isnan (distributionOf ({}).deviation));
}

TEST (SpearmanCorrelation, onlyTheOrderMatters)
{
  EXPECT_DOUBLE_EQ (spearmanCorrelation ({1, 2, 3, 4}, {1, 10, 100, 1000}), 1);
  EXPECT_DOUBLE_EQ (spearmanCorrelation ({1, 2, 3, 4}, {8, 4, 2, 1}), -1);
  // without ties 1 - 6 sum d^2 / (n^3 - n): d = 1, 1, 1, 1
  EXPECT_DOUBLE_EQ (spearmanCorrelation ({1, 2, 3, 4}, {2, 1, 4, 3}), .6);
}

TEST (SpearmanCorrelation, tiesShareTheMeanOfTheirRanks)
{
  // ranks 1, 2.5, 2.5, 4 and 1, 2, 3, 4: covariance 4.5, variances 4.5 and 5
  EXPECT_DOUBLE_EQ (spearmanCorrelation ({1, 2, 2, 3}, {1, 2, 3, 4}), 4.5 / std::sqrt (4.5 * 5));
  // ranks 1.5, 1.5, 3.5, 3.5 and 4, 2, 2, 2: covariance -2, variances 4 and 3
  EXPECT_DOUBLE_EQ (spearmanCorrelation ({0, 0, 1, 1}, {9, 5, 5, 5}), -2 / std::sqrt (4. * 3));
}

TEST (SpearmanCorrelation, isUndefinedWithoutVariation)
{
  EXPECT_TRUE (std::isnan (spearmanCorrelation ({}, {})));
  EXPECT_TRUE (std::isnan (spearmanCorrelation ({1}, {2})));
  EXPECT_TRUE (std::isnan (spearmanCorrelation ({1, 1, 1}, {1, 2, 3})));
  EXPECT_THROW (spearmanCorrelation ({1}, {1, 2}), std::invalid_argument);
}

} // namespace
} // namespace pcl_attention
