// SPDX-License-Identifier: BSD-3-Clause
#include "systems/star_cut.h"

#include "systems/gaussian_mixture.h"
#include "systems/graph_cut.h"

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <cmath>

namespace pcl_attention
{

namespace
{

constexpr double never = 1e7; // more than all other costs of an image together

/** \brief Mean colours of square blocks. */
ColorImage
reduce (const ColorImage& colors, int factor)
{
  const int width = (colors.width + factor - 1) / factor, height = (colors.height + factor - 1) / factor;
  ColorImage reduced (width, height, Eigen::Vector3f::Zero ());
  Image<int> counts (width, height, 0);
  for (int row = 0; row < colors.height; ++row)
    for (int column = 0; column < colors.width; ++column)
    {
      reduced (column / factor, row / factor) += colors (column, row);
      ++counts (column / factor, row / factor);
    }
  for (std::size_t i = 0; i < reduced.size (); ++i)
    reduced[i] /= static_cast<float> (counts[i]);
  return (reduced);
}

/** \brief Square blocks with a pixel of the mask. */
Image<std::uint8_t>
reduce (const Image<std::uint8_t>& mask, int factor)
{
  Image<std::uint8_t> reduced ((mask.width + factor - 1) / factor, (mask.height + factor - 1) / factor, 0);
  for (int row = 0; row < mask.height; ++row)
    for (int column = 0; column < mask.width; ++column)
      if (mask (column, row))
        reduced (column / factor, row / factor) = 1;
  return (reduced);
}

GaussianMixture
mixtureOf (const ColorImage& colors, const Image<std::uint8_t>& stroke, int components)
{
  std::vector<Eigen::Vector3f> samples;
  for (std::size_t i = 0; i < colors.size (); ++i)
    if (stroke[i])
      samples.push_back (colors[i]);
  return (GaussianMixture (samples, components));
}

/** \brief Call visit (first, second, distance) for the neighbours to the right and below of every pixel; diagonals,
 * too, if asked for. */
template <typename Visit>
void
forEachNeighbors (int width, int height, bool diagonals, const Visit& visit)
{
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      const int pixel = row * width + column;
      if (column + 1 < width)
        visit (pixel, pixel + 1, 1.0f);
      if (row + 1 < height)
        visit (pixel, pixel + width, 1.0f);
      if (!diagonals || row + 1 == height)
        continue;
      if (column + 1 < width)
        visit (pixel, pixel + width + 1, std::sqrt (2.0f));
      if (column > 0)
        visit (pixel, pixel + width - 1, std::sqrt (2.0f));
    }
}

/** \brief The next pixel on the shortest path from every pixel to the stroke; the pixel itself on the stroke. */
std::vector<std::int32_t>
shortestPaths (const ColorImage& colors, const Image<std::uint8_t>& stroke, float geodesic)
{
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                   boost::no_property, std::int32_t, std::int32_t>;
  const auto pixels = static_cast<std::int32_t> (colors.size ());
  double squared_distances = 0, squared_differences = 0;
  forEachNeighbors (colors.width, colors.height, true, [&] (int first, int second, float distance) {
    squared_distances += distance * distance;
    squared_differences += (colors[first] - colors[second]).squaredNorm ();
  });
  // A picture of one colour has paths as the crow flies.
  const auto scale = static_cast<float> (squared_differences > 0 ? squared_distances / squared_differences : 0.0);

  std::vector<std::pair<std::int32_t, std::int32_t>> ends;
  std::vector<float> length_of;
  forEachNeighbors (colors.width, colors.height, true, [&] (int first, int second, float distance) {
    const float difference = (colors[first] - colors[second]).squaredNorm ();
    const float length = std::sqrt ((1 - geodesic) * distance * distance + geodesic * scale * difference);
    ends.emplace_back (first, second);
    ends.emplace_back (second, first);
    length_of.insert (length_of.end (), 2, length);
  });
  const std::int32_t start = pixels; // before all pixels of the stroke
  for (std::int32_t pixel = 0; pixel < pixels; ++pixel)
    if (stroke[pixel])
    {
      ends.emplace_back (start, pixel);
      length_of.push_back (0.0f);
    }

  // The graph sorts its edges by the node they leave, and takes no property of its own along here: lengths are found
  // through the order.
  std::vector<std::int32_t> order (ends.size ());
  {
    std::vector<std::int32_t> next (pixels + 2, 0);
    for (const auto& end : ends)
      ++next[end.first + 1];
    for (std::int32_t node = 0; node <= pixels; ++node)
      next[node + 1] += next[node];
    for (std::size_t i = 0; i < ends.size (); ++i)
      order[next[ends[i].first]++] = static_cast<std::int32_t> (i);
  }
  std::vector<std::pair<std::int32_t, std::int32_t>> sorted_ends (ends.size ());
  std::vector<float> lengths (ends.size ());
  for (std::size_t i = 0; i < order.size (); ++i)
  {
    sorted_ends[i] = ends[order[i]];
    lengths[i] = length_of[order[i]];
  }
  const Graph graph (boost::edges_are_sorted, sorted_ends.begin (), sorted_ends.end (), pixels + 1);
  std::vector<std::int32_t> predecessor (pixels + 1);
  std::vector<float> distance (pixels + 1);
  const auto node_index = boost::get (boost::vertex_index, graph);
  boost::dijkstra_shortest_paths (
      graph, start,
      boost::weight_map (boost::make_iterator_property_map (lengths.begin (), boost::get (boost::edge_index, graph)))
          .predecessor_map (boost::make_iterator_property_map (predecessor.begin (), node_index))
          .distance_map (boost::make_iterator_property_map (distance.begin (), node_index)));
  for (std::int32_t pixel = 0; pixel < pixels; ++pixel)
    if (predecessor[pixel] == start)
      predecessor[pixel] = pixel;
  predecessor.pop_back ();
  return (predecessor);
}

} // namespace

Image<std::uint8_t>
segmentFromStrokes (const ColorImage& full_colors, const Image<std::uint8_t>& full_object,
                    const Image<std::uint8_t>& full_background, const StarCutParameters& parameters)
{
  const ColorImage colors = reduce (full_colors, parameters.reduction);
  const Image<std::uint8_t> object = reduce (full_object, parameters.reduction);
  Image<std::uint8_t> background = reduce (full_background, parameters.reduction);
  for (std::size_t i = 0; i < object.size (); ++i)
    if (object[i])
      background[i] = 0;

  GraphCut cut (static_cast<int> (colors.size ()));
  const GaussianMixture of_object = mixtureOf (colors, object, parameters.mixture_components);
  const GaussianMixture of_background = mixtureOf (colors, background, parameters.mixture_components);
  const auto likelihood = [&parameters] (const GaussianMixture& mixture, const Eigen::Vector3f& color) {
    return (parameters.uniform_share + (1 - parameters.uniform_share) * mixture.density (color));
  };
  // A block stands for as many pixels, a contour between two blocks is as long as the block.
  const auto length = static_cast<double> (parameters.reduction);
  for (std::size_t i = 0; i < colors.size (); ++i)
  {
    const auto node = static_cast<int> (i);
    if (object[i])
      cut.tieToInside (node, never);
    else if (background[i])
      cut.tieToOutside (node, never);
    else
    {
      const float inside = likelihood (of_object, colors[i]), outside = likelihood (of_background, colors[i]);
      const auto cost = [&] (float posterior) {
        return (length * length * std::min (parameters.greatest_unary, -std::log (std::max (posterior, 1e-30f))));
      };
      cut.tieToOutside (node, cost (inside / (inside + outside)));
      cut.tieToInside (node, cost (outside / (inside + outside)));
    }
  }

  double squared_differences = 0;
  int neighbors = 0;
  forEachNeighbors (colors.width, colors.height, false, [&] (int first, int second, float) {
    squared_differences += (colors[first] - colors[second]).squaredNorm ();
    ++neighbors;
  });
  const double beta = squared_differences > 0 ? neighbors / (0.5 * squared_differences) : 0.0;
  forEachNeighbors (colors.width, colors.height, false, [&] (int first, int second, float) {
    const double cost =
        length * parameters.contrast * std::exp (-beta * (colors[first] - colors[second]).squaredNorm ());
    cut.connect (first, second, cost, cost);
  });

  if (parameters.star_constraint)
  {
    const std::vector<std::int32_t> parents = shortestPaths (colors, object, parameters.geodesic);
    for (std::size_t i = 0; i < parents.size (); ++i)
      if (parents[i] != static_cast<std::int32_t> (i))
        cut.connect (static_cast<int> (i), parents[i], never, 0.0);
  }

  const std::vector<std::uint8_t> inside = cut.solve ();
  Image<std::uint8_t> mask (full_colors.width, full_colors.height);
  for (int row = 0; row < mask.height; ++row)
    for (int column = 0; column < mask.width; ++column)
      mask (column, row) = inside[row / parameters.reduction * colors.width + column / parameters.reduction];
  return (mask);
}

} // namespace pcl_attention
