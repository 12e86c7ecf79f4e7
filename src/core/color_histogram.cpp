// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/color_histogram.h>

#include <algorithm>

namespace pcl_attention
{

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
  if (a.total <= 0.0f || b.total <= 0.0f)
    return (0.0f);
  float sum = 0.0f;
  for (std::size_t bin = 0; bin < a.counts.size (); ++bin)
  {
    const float share_a = a.counts[bin] / a.total, share_b = b.counts[bin] / b.total;
    if (share_a + share_b > 0.0f)
      sum += (share_a - share_b) * (share_a - share_b) / (share_a + share_b);
  }
  return (0.5f * sum);
}

float
colorContrast (const ColorHistogram& a, const ColorHistogram& b)
{
  return (a.total > 0.0f && b.total > 0.0f ? 2.0f * chiSquare (a, b) - 1.0f : 0.0f);
}

} // namespace pcl_attention
