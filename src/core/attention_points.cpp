// SPDX-License-Identifier: BSD-3-Clause
#include "largest_value.h"
#include "nonzero.h"

#include <pcl_attention/core/attention_points.h>
#include <pcl_attention/core/winner_take_all.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>

namespace pcl_attention
{

namespace
{

/** \brief The valid pixel of a line that is nearest to a point, or nothing. */
const Pixel*
nearestValid (const Pixel& point, const std::vector<Pixel>& line, const std::vector<std::uint8_t>& valid, int width)
{
  const Pixel* nearest = nullptr;
  int best = 0;
  for (const Pixel& pixel : line)
  {
    if (!valid[static_cast<std::size_t> (pixel.row) * width + pixel.column])
      continue;
    const int distance = (pixel.column - point.column) * (pixel.column - point.column) +
                         (pixel.row - point.row) * (pixel.row - point.row);
    if (!nearest || distance < best)
    {
      nearest = &pixel;
      best = distance;
    }
  }
  return (nearest);
}

} // namespace

const char*
toString (AttentionPointKind kind)
{
  switch (kind)
  {
    case AttentionPointKind::junction:
      return ("junction");
    case AttentionPointKind::midpoint:
      return ("midpoint");
    case AttentionPointKind::winner:
      return ("winner");
    case AttentionPointKind::coverage:
      return ("coverage");
    case AttentionPointKind::user:
      break;
  }
  return ("user");
}

std::vector<float>
meanSaliency (const Image<float>& saliency, const Image<int>& labels, int count)
{
  std::vector<double> sums (count, 0.0);
  std::vector<int> sizes (count, 0);
  for (std::size_t index = 0; index < labels.size (); ++index)
    if (labels[index] > 0)
    {
      sums[labels[index] - 1] += saliency[index];
      ++sizes[labels[index] - 1];
    }
  std::vector<float> means (count, 0.0f);
  for (int component = 0; component < count; ++component)
    if (sizes[component] > 0)
      means[component] = static_cast<float> (sums[component] / sizes[component]);
  return (means);
}

namespace
{

/** \brief WTA3D and WTA2D of paper V-A. */
void
extractWinners (const Image<float>& saliency, const std::vector<std::uint8_t>& valid, const AttentionPointParameters& parameters,
                AttentionPoints& result)
{
  result.components.assign (saliency.width, saliency.height, 0);
  result.skeleton.assign (saliency.width, saliency.height, 0);
  const int reach = parameters.winner_cell_size;
  for (const Winner& winner : findWinners (saliency, parameters.winner_cell_size, parameters.pixel_threshold, parameters.inhibition_width))
  {
    std::vector<Pixel> around;
    for (int row = winner.pixel.row - reach; row <= winner.pixel.row + reach; ++row)
      for (int column = winner.pixel.column - reach; column <= winner.pixel.column + reach; ++column)
        if (saliency.contains (column, row))
          around.push_back ({column, row});
    const Pixel* moved = nearestValid (winner.pixel, around, valid, saliency.width);
    if (moved)
      result.points.push_back ({moved->column, moved->row, winner.saliency, saliency (moved->column, moved->row),
                                AttentionPointKind::winner, 0});
  }
}

/** \brief TJ3D, paper III-C. */
void
extractFromSymmetryLines (const Image<float>& saliency, const std::vector<std::uint8_t>& valid,
                          const AttentionPointParameters& parameters, AttentionPoints& result)
{
  const int width = saliency.width, height = saliency.height;
  // Loops without branches and with ends of their own take several pixels at a time.
  Image<float> map (width, height);
  std::transform (saliency.data.begin (), saliency.data.end (), map.data.begin (), [] (float value) {
    return (((value > 0.0f) & (value <= std::numeric_limits<float>::max ())) ? value : 0.0f);
  });
  const float maximum = largestValue (map), threshold = parameters.pixel_threshold * maximum;
  Image<std::uint8_t> mask (width, height, 0);
  std::transform (map.data.begin (), map.data.end (), mask.data.begin (),
                  [threshold] (float value) { return (static_cast<std::uint8_t> (value > threshold)); });
  const int count = labelConnectedComponents (mask, result.components);
  result.mean_saliency = meanSaliency (map, result.components, count);

  std::vector<std::uint8_t> is_salient (count + 1, 0);
  for (int component = 0; component < count; ++component)
    is_salient[component + 1] = result.mean_saliency[component] > parameters.component_threshold * maximum;
  std::transform (result.components.data.begin (), result.components.data.end (), mask.data.begin (),
                  [component = is_salient.data ()] (int label) { return (component[label]); });
  result.skeleton = thin (mask);

  std::vector<std::vector<Pixel>> lines (count);
  forEachNonZero (result.skeleton.data.data (), result.skeleton.data.data () + result.skeleton.size (), [&] (std::ptrdiff_t index) {
    const int pixel = static_cast<int> (index);
    lines[result.components[pixel] - 1].push_back ({pixel % width, pixel / width});
  });

  for (int component = 0; component < count; ++component)
  {
    const std::vector<Pixel>& line = lines[component];
    if (static_cast<int> (line.size ()) < parameters.minimum_skeleton_length)
      continue;
    std::vector<Pixel> pixels = findJunctions (result.skeleton, line, parameters.junction_merge_radius);
    const AttentionPointKind kind = pixels.empty () ? AttentionPointKind::midpoint : AttentionPointKind::junction;
    if (pixels.empty ())
      pixels.push_back (findMidpoint (result.skeleton, line));
    if (!parameters.all_junctions)
      pixels = {*std::max_element (pixels.begin (), pixels.end (), [&] (const Pixel& a, const Pixel& b) {
        return (map (a.column, a.row) < map (b.column, b.row));
      })};
    for (const Pixel& pixel : pixels)
    {
      const Pixel* moved = nearestValid (pixel, line, valid, width);
      if (moved)
        result.points.push_back ({moved->column, moved->row, result.mean_saliency[component],
                                  map (moved->column, moved->row), kind, component + 1});
    }
  }

  const auto order = [] (const AttentionPoint& point) {
    return (std::make_tuple (-point.saliency, -point.point_saliency, point.row, point.column));
  };
  std::sort (result.points.begin (), result.points.end (),
             [&] (const AttentionPoint& a, const AttentionPoint& b) { return (order (a) < order (b)); });
  // Two junctions of a line may have moved to the same valid pixel.
  result.points.erase (std::unique (result.points.begin (), result.points.end (),
                                    [] (const AttentionPoint& a, const AttentionPoint& b) {
                                      return (a.row == b.row && a.column == b.column);
                                    }),
                       result.points.end ());
}

} // namespace

void
extractAttentionPoints (const Image<float>& saliency, const std::vector<std::uint8_t>& valid,
                        const AttentionPointParameters& parameters, AttentionPoints& result)
{
  result = AttentionPoints ();
  if (parameters.strategy == AttentionStrategy::symmetry_lines)
    extractFromSymmetryLines (saliency, valid, parameters, result);
  else
    extractWinners (saliency, valid, parameters, result);
}

} // namespace pcl_attention
