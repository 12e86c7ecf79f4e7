// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace pcl_attention
{

/** \brief The cheapest division of nodes into inside and outside: a minimum cut, by the maximum flow of Boykov and
 * Kolmogorov (PAMI 2004) in Boost.Graph.
 *
 * Costs are at least 0. Where several divisions are the cheapest, nodes are inside rather than outside. */
class GraphCut
{
public:
  explicit GraphCut (int nodes) : ties_ (nodes, 0.0) {}

  /** \brief A node costs this much when it is outside; calls add up. */
  void
  tieToInside (int node, double cost)
  {
    ties_[node] += cost;
  }

  /** \brief A node costs this much when it is inside; calls add up. */
  void
  tieToOutside (int node, double cost)
  {
    ties_[node] -= cost;
  }

  /** \brief Two different nodes cost this much when they are divided.
   * \param[in] first_inside cost of the first inside and the second outside
   * \param[in] second_inside cost of the second inside and the first outside */
  void
  connect (int first, int second, double first_inside, double second_inside)
  {
    links_.push_back ({first, second, first_inside, second_inside});
  }

  /** \return 1 for every node that is inside, else 0 */
  std::vector<std::uint8_t> solve () const;

private:
  struct Link
  {
    int first, second;
    double first_inside, second_inside;
  };

  std::vector<double> ties_; // what both ties share is paid in any case: only their difference counts
  std::vector<Link> links_;
};

} // namespace pcl_attention
