// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/patch_graph.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
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
  std::vector<int> parent (count + 1);
  std::iota (parent.begin (), parent.end (), 0);
  const auto root = [&] (int label) {
    while (parent[label] != label)
      label = parent[label] = parent[parent[label]];
    return (label);
  };
  for (const auto& [labels, border] : graph.borders)
    if (!isExcluded (labels.first) && !isExcluded (labels.second) && leads (border))
      parent[root (labels.second)] = root (labels.first);

  std::vector<int> group (parent.size (), 0), group_of_root (parent.size (), 0);
  int groups = 0;
  for (int label = 1; label < static_cast<int> (group.size ()); ++label)
  {
    if (isExcluded (label))
      continue;
    int& number = group_of_root[root (label)];
    if (number == 0)
      number = ++groups;
    group[label] = number;
  }
  return (group);
}

} // namespace pcl_attention
