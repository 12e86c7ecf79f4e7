// SPDX-License-Identifier: BSD-3-Clause
#include "even_samples.h"

#include <pcl_attention/core/color_histogram.h>

#include <Eigen/Core>

#include <algorithm>

namespace pcl_attention
{

namespace
{

template <std::size_t Bins> float
distance (const Histogram<Bins>& a, const Histogram<Bins>& b)
{
  if (a.total <= 0.0f || b.total <= 0.0f)
    return (0.0f);
  constexpr float rounding = 1e-6f; // what is left of a bin whose counts were taken away again, even below 0
  using Shares = Eigen::Array<float, Bins, 1>;
  const Shares share_a = Eigen::Map<const Shares> (a.counts.data ()) / a.total;
  const Shares share_b = Eigen::Map<const Shares> (b.counts.data ()) / b.total;
  return (0.5f * ((share_a - share_b).square () / (share_a + share_b).max (rounding)).sum ());
}

} // namespace

HexconeHistogram::Shares
HexconeHistogram::sharesOf (std::uint8_t red, std::uint8_t green, std::uint8_t blue)
{
  constexpr float half_root_of_3 = 0.8660254f;
  const float r = red, g = green, b = blue, largest = std::max ({r, g, b, 1.0f});
  const float across = (r - 0.5f * (g + b)) / largest, along = half_root_of_3 * (g - b) / largest;
  const auto split = [] (float share, int cells) {
    const float place = share * static_cast<float> (cells - 1);
    const int cell = std::min (static_cast<int> (place), cells - 2);
    return (std::pair<int, float> (cell, place - static_cast<float> (cell)));
  };
  const auto [i, i_share] = split (0.5f + 0.5f * across, side);
  const auto [j, j_share] = split (0.5f + 0.5f * along, side);
  const auto [k, k_share] = split (largest / 255.0f, values);
  Shares color;
  std::size_t place = 0;
  for (const auto& [i_cell, of_i] : {std::pair<int, float> (i, 1.0f - i_share), {i + 1, i_share}})
    for (const auto& [j_cell, of_j] : {std::pair<int, float> (j, 1.0f - j_share), {j + 1, j_share}})
      for (const auto& [k_cell, of_k] : {std::pair<int, float> (k, 1.0f - k_share), {k + 1, k_share}})
      {
        color.cells[place] = (i_cell * side + j_cell) * values + k_cell;
        color.shares[place++] = of_i * of_j * of_k;
      }
  return (color);
}

void
HexconeHistogram::add (const Shares& color, float weight)
{
  for (std::size_t place = 0; place < color.cells.size (); ++place)
    counts[static_cast<std::size_t> (color.cells[place])] += weight * color.shares[place];
  total += weight;
}

HexconeHistogram
colorsOf (const OrganizedCloud& cloud, const pcl::Indices& pixels)
{
  HexconeHistogram colors;
  if (!cloud.hasColor () || pixels.empty ())
    return (colors);
  const pcl::Indices samples = evenSamples (pixels);
  const float weight = static_cast<float> (pixels.size ()) / static_cast<float> (samples.size ());
  for (const pcl::index_t index : samples)
    colors.add (cloud.red[index], cloud.green[index], cloud.blue[index], weight);
  return (colors);
}

int
colorBin (std::uint8_t red, std::uint8_t green, std::uint8_t blue)
{
  const int largest = std::max ({red, green, blue}), smallest = std::min ({red, green, blue});
  const int chroma = largest - smallest;
  float hue = 0.0f; // in sixths of the circle
  if (chroma > 0)
  {
    // Divided: the product with 1 / chroma may fall short of a bin's lower end.
    const auto divisor = static_cast<float> (chroma);
    if (largest == red)
      hue = static_cast<float> (green - blue) / divisor;
    else if (largest == green)
      hue = 2.0f + static_cast<float> (blue - red) / divisor;
    else
      hue = 4.0f + static_cast<float> (red - green) / divisor;
    if (hue < 0.0f)
      hue += 6.0f;
  }
  const float saturation = largest > 0 ? static_cast<float> (chroma) / static_cast<float> (largest) : 0.0f;
  const float value = static_cast<float> (largest) / 255.0f;
  const auto bin = [] (float share, int bins) { return (std::min (static_cast<int> (share * bins), bins - 1)); };
  return ((bin (hue / 6.0f, ColorHistogram::hue_bins) * ColorHistogram::saturation_bins +
           bin (saturation, ColorHistogram::saturation_bins)) * ColorHistogram::value_bins +
          bin (value, ColorHistogram::value_bins));
}

std::vector<std::uint8_t>
colorBins (const OrganizedCloud& cloud)
{
  std::vector<std::uint8_t> bins;
  if (!cloud.hasColor ())
    return (bins);
  bins.resize (cloud.size ());
  for (std::size_t index = 0; index < cloud.size (); ++index)
    bins[index] = static_cast<std::uint8_t> (colorBin (cloud.red[index], cloud.green[index], cloud.blue[index]));
  return (bins);
}

float
chiSquare (const ColorHistogram& a, const ColorHistogram& b)
{
  return (distance (a, b));
}

float
chiSquare (const HexconeHistogram& a, const HexconeHistogram& b)
{
  return (distance (a, b));
}

float
colorContrast (const HexconeHistogram& a, const HexconeHistogram& b)
{
  constexpr float neither = 0.3f;
  return (a.total > 0.0f && b.total > 0.0f ? std::clamp (chiSquare (a, b) / neither - 1.0f, -1.0f, 1.0f) : 0.0f);
}

} // namespace pcl_attention
