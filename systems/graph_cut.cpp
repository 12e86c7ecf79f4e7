// SPDX-License-Identifier: BSD-3-Clause
#include "systems/graph_cut.h"

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <cmath>

namespace pcl_attention
{

std::vector<std::uint8_t>
GraphCut::solve () const
{
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                   boost::no_property, std::int32_t, std::int32_t>;
  using Edge = boost::graph_traits<Graph>::edge_descriptor;
  const auto source = static_cast<std::int32_t> (ties_.size ()), sink = source + 1;

  std::vector<Link> links = links_;
  for (std::int32_t node = 0; node < source; ++node)
    if (ties_[node] > 0)
      links.push_back ({source, node, ties_[node], 0.0});
    else if (ties_[node] < 0)
      links.push_back ({node, sink, -ties_[node], 0.0});

  // Every link is two edges, each the other's reverse; the graph wants them by the node they leave.
  std::vector<std::int32_t> next (sink + 2, 0);
  for (const Link& link : links)
  {
    ++next[link.first + 1];
    ++next[link.second + 1];
  }
  for (std::int32_t node = 0; node <= sink; ++node)
    next[node + 1] += next[node];
  std::vector<std::pair<std::int32_t, std::int32_t>> ends (2 * links.size ());
  std::vector<Edge> reverse (ends.size ());
  std::vector<double> capacity (ends.size ());
  for (const Link& link : links)
  {
    const std::int32_t there = next[link.first]++, back = next[link.second]++;
    ends[there] = {link.first, link.second};
    ends[back] = {link.second, link.first};
    capacity[there] = link.first_inside;
    capacity[back] = link.second_inside;
    reverse[there] = Edge (link.second, back);
    reverse[back] = Edge (link.first, there);
  }
  const Graph graph (boost::edges_are_sorted, ends.begin (), ends.end (), sink + 1);

  const auto node_index = boost::get (boost::vertex_index, graph);
  const auto edge_index = boost::get (boost::edge_index, graph);
  std::vector<double> residual (capacity.size ());
  std::vector<Edge> predecessor (sink + 1);
  std::vector<boost::default_color_type> color (sink + 1);
  std::vector<std::int32_t> distance (sink + 1);
  boost::boykov_kolmogorov_max_flow (graph, boost::make_iterator_property_map (capacity.begin (), edge_index),
                                     boost::make_iterator_property_map (residual.begin (), edge_index),
                                     boost::make_iterator_property_map (reverse.begin (), edge_index),
                                     boost::make_iterator_property_map (predecessor.begin (), node_index),
                                     boost::make_iterator_property_map (color.begin (), node_index),
                                     boost::make_iterator_property_map (distance.begin (), node_index), node_index,
                                     source, sink);

  // What the sink's search tree has not reached is inside.
  std::vector<std::uint8_t> inside (ties_.size ());
  for (std::int32_t node = 0; node < source; ++node)
    inside[node] = color[node] != boost::white_color;
  return (inside);
}

} // namespace pcl_attention
