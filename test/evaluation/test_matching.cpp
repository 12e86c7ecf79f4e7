// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace pcl_attention
{
namespace
{

/** \brief The largest sum over all ways to assign the smaller side, tried one by one. */
double
bruteForceMaximum (const Eigen::MatrixXd& weights)
{
  if (weights.rows () > weights.cols ())
    return (bruteForceMaximum (weights.transpose ()));
  std::vector<int> columns (weights.cols ());
  std::iota (columns.begin (), columns.end (), 0);
  double best = -std::numeric_limits<double>::infinity ();
  do
  {
    double sum = 0;
    for (int row = 0; row < weights.rows (); ++row)
      sum += weights (row, columns[row]);
    best = std::max (best, sum);
  } while (std::next_permutation (columns.begin (), columns.end ()));
  return (best);
}

/** \brief Sum of an assignment, after checking that it is one-to-one and complete on the smaller side. */
double
checkedSum (const Eigen::MatrixXd& weights, const std::vector<int>& column_of_row)
{
  EXPECT_EQ (column_of_row.size (), static_cast<std::size_t> (weights.rows ()));
  std::set<int> used;
  double sum = 0;
  for (std::size_t row = 0; row < column_of_row.size (); ++row)
  {
    const int column = column_of_row[row];
    if (column == -1)
      continue;
    EXPECT_GE (column, 0);
    EXPECT_LT (column, weights.cols ());
    EXPECT_TRUE (used.insert (column).second) << "column " << column << " is used twice";
    sum += weights (static_cast<int> (row), column);
  }
  EXPECT_EQ (used.size (), static_cast<std::size_t> (std::min (weights.rows (), weights.cols ())));
  return (sum);
}

TEST (AssignMaximum, takesTheBestSumRatherThanTheBestPair)
{
  Eigen::MatrixXd weights (2, 2);
  weights << .9, .8, .8, .1;
  EXPECT_EQ (assignMaximum (weights), (std::vector<int>{1, 0}));
}

TEST (AssignMaximum, leavesOutWhatHasNoPartner)
{
  Eigen::MatrixXd weights (3, 1);
  weights << .2, .7, .4;
  EXPECT_EQ (assignMaximum (weights), (std::vector<int>{-1, 0, -1}));
  EXPECT_EQ (assignMaximum (weights.transpose ()), (std::vector<int>{1}));
}

TEST (AssignMaximum, nothingToAssign)
{
  EXPECT_TRUE (assignMaximum (Eigen::MatrixXd (0, 0)).empty ());
  EXPECT_TRUE (assignMaximum (Eigen::MatrixXd (0, 3)).empty ());
  EXPECT_EQ (assignMaximum (Eigen::MatrixXd (2, 0)), (std::vector<int>{-1, -1}));
}

TEST (AssignMaximum, agreesWithBruteForceOnRandomMatrices)
{
  std::mt19937 generator (1);
  std::uniform_int_distribution<int> size (1, 6), small_integer (0, 3);
  std::uniform_real_distribution<double> real (-1, 1);
  for (int trial = 0; trial < 600; ++trial)
  {
    Eigen::MatrixXd weights (size (generator), size (generator));
    // every other matrix is full of ties
    for (int i = 0; i < weights.size (); ++i)
      weights.data ()[i] = trial % 2 == 0 ? real (generator) : small_integer (generator);
    SCOPED_TRACE (testing::Message () << "trial " << trial << "\n" << weights);
    ASSERT_NEAR (checkedSum (weights, assignMaximum (weights)), bruteForceMaximum (weights), 1e-12);
  }
}

TEST (AssignMaximum, findsAPermutationAmongManySegments)
{
  const int size = 200;
  std::vector<int> permutation (size);
  std::iota (permutation.begin (), permutation.end (), 0);
  std::mt19937 generator (2);
  std::shuffle (permutation.begin (), permutation.end (), generator);
  std::uniform_real_distribution<double> noise (0, .4);
  Eigen::MatrixXd weights (size, size);
  for (int i = 0; i < weights.size (); ++i)
    weights.data ()[i] = noise (generator);
  for (int row = 0; row < size; ++row)
    weights (row, permutation[row]) += .5;
  EXPECT_EQ (assignMaximum (weights), permutation);
}

} // namespace
} // namespace pcl_attention
