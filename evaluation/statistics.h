// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace pcl_attention
{

/** \brief Mean and standard deviation of a population (divided by n); NaN without values. */
struct Distribution
{
  double mean = std::numeric_limits<double>::quiet_NaN ();
  double deviation = std::numeric_limits<double>::quiet_NaN ();
};

/** \brief Distribution of the values, which must not be NaN. */
Distribution distributionOf (const std::vector<double>& values);

/** \brief Spearman's rank correlation; tied values share the mean of their ranks.
 * \return -1 to 1; NaN for fewer than two pairs or where one side is constant
 * \throws std::invalid_argument if the sizes differ */
double spearmanCorrelation (const std::vector<double>& first, const std::vector<double>& second);

} // namespace pcl_attention
