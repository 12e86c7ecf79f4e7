// SPDX-License-Identifier: BSD-3-Clause
// Cuts against the cheapest of all divisions, each tried.
#include "systems/graph_cut.h"

#include <gtest/gtest.h>

#include <random>

namespace pcl_attention
{
namespace
{

TEST (GraphCut, isTheCheapestOfAllDivisions)
{
  constexpr int nodes = 9;
  std::mt19937 generator (7);
  std::uniform_real_distribution<double> cost (0.0, 1.0);
  std::uniform_int_distribution<int> node (0, nodes - 1);
  for (int round = 0; round < 50; ++round)
  {
    GraphCut cut (nodes);
    std::vector<double> when_outside (nodes), when_inside (nodes);
    for (int i = 0; i < nodes; ++i)
    {
      cut.tieToInside (i, when_outside[i] = cost (generator));
      cut.tieToOutside (i, when_inside[i] = cost (generator));
    }
    std::vector<std::vector<double>> divided (nodes, std::vector<double> (nodes, 0.0)); // [inside][outside]
    for (int link = 0; link < 16; ++link)
    {
      const int first = node (generator), second = node (generator);
      if (first == second)
        continue;
      const double there = 0.5 * cost (generator), back = 0.5 * cost (generator);
      cut.connect (first, second, there, back);
      divided[first][second] += there;
      divided[second][first] += back;
    }
    const auto costOf = [&] (unsigned int division) {
      double sum = 0;
      for (int i = 0; i < nodes; ++i)
      {
        const bool inside = division >> i & 1;
        sum += inside ? when_inside[i] : when_outside[i];
        for (int j = 0; j < nodes && inside; ++j)
          sum += division >> j & 1 ? 0.0 : divided[i][j];
      }
      return (sum);
    };
    unsigned int cheapest = 0;
    for (unsigned int division = 1; division < 1u << nodes; ++division)
      if (costOf (division) < costOf (cheapest))
        cheapest = division;

    const std::vector<std::uint8_t> inside = cut.solve ();
    unsigned int found = 0;
    for (int i = 0; i < nodes; ++i)
      found |= static_cast<unsigned int> (inside[i]) << i;
    EXPECT_NEAR (costOf (found), costOf (cheapest), 1e-9) << "round " << round;
  }
}

TEST (GraphCut, undecidedNodesAreInside)
{
  GraphCut cut (3);
  cut.tieToInside (0, 1.0);
  cut.tieToOutside (1, 1.0);
  cut.connect (0, 1, 0.5, 0.5);
  EXPECT_EQ (cut.solve (), (std::vector<std::uint8_t>{1, 0, 1}));
}

} // namespace
} // namespace pcl_attention
