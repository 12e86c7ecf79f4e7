// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/patch_graph.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_attention
{

/** \brief Number the groups of patches that borders lead from one to another.
  * \param[in] count of patches
  * \param[in] excluded 1 at [label] for patches of no group; may be empty
  * \param[in] leads whether a \ref PatchBorder does
  * \return of label k at [k], from 1 in the order of the labels; 0 for those of no group, and for 0 */
template <typename Leads>
std::vector<int>
groupsOf (const PatchGraph& graph, std::size_t count, const std::vector<std::uint8_t>& excluded, const Leads& leads)
{
  const auto isExcluded = [&] (int label) { return (!excluded.empty () && excluded[label]); };
  boost::disjoint_sets_with_storage<> linked (count + 1);
  for (const auto& [labels, border] : graph.borders)
    if (!isExcluded (labels.first) && !isExcluded (labels.second) && leads (border))
      linked.union_set (labels.first, labels.second);

  std::vector<int> group (count + 1, 0), group_of_set (count + 1, 0);
  int groups = 0;
  for (int label = 1; label < static_cast<int> (group.size ()); ++label)
  {
    if (isExcluded (label))
      continue;
    int& number = group_of_set[linked.find_set (label)];
    if (number == 0)
      number = ++groups;
    group[label] = number;
  }
  return (group);
}

} // namespace pcl_attention
