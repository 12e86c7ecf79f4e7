// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace pcl_attention
{
namespace
{

/** \brief Ranks from 1; tied values share the mean of theirs. */
std::vector<double>
ranksOf (const std::vector<double>& values)
{
  std::vector<std::size_t> order (values.size ());
  std::iota (order.begin (), order.end (), 0);
  std::sort (order.begin (), order.end (), [&] (std::size_t a, std::size_t b) { return (values[a] < values[b]); });
  std::vector<double> ranks (values.size ());
  for (std::size_t begin = 0, end = 0; begin < order.size (); begin = end)
  {
    while (end < order.size () && values[order[end]] == values[order[begin]])
      ++end;
    for (std::size_t i = begin; i < end; ++i)
      ranks[order[i]] = (begin + 1 + end) / 2.0;
  }
  return (ranks);
}

} // namespace

Distribution
distributionOf (const std::vector<double>& values)
{
  Distribution distribution;
  if (values.empty ())
    return (distribution);
  const double count = static_cast<double> (values.size ());
  distribution.mean = std::accumulate (values.begin (), values.end (), 0.0) / count;
  double squares = 0;
  for (const double value : values)
    squares += (value - distribution.mean) * (value - distribution.mean);
  distribution.deviation = std::sqrt (squares / count);
  return (distribution);
}

double
spearmanCorrelation (const std::vector<double>& first, const std::vector<double>& second)
{
  if (first.size () != second.size ())
    throw std::invalid_argument ("spearmanCorrelation: different numbers of values");

  // Pearson's correlation of the ranks: unlike 1 - 6 sum d^2 / (n^3 - n) it is right with ties too.
  const std::vector<double> first_ranks = ranksOf (first), second_ranks = ranksOf (second);
  const double mean = (first.size () + 1) / 2.0;
  double covariance = 0, first_variance = 0, second_variance = 0;
  for (std::size_t i = 0; i < first.size (); ++i)
  {
    const double a = first_ranks[i] - mean, b = second_ranks[i] - mean;
    covariance += a * b;
    first_variance += a * a;
    second_variance += b * b;
  }
  if (first_variance == 0 || second_variance == 0)
    return (std::numeric_limits<double>::quiet_NaN ());
  return (covariance / std::sqrt (first_variance * second_variance));
}

} // namespace pcl_attention
