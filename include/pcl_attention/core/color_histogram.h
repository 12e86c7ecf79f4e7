// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/organized_cloud.h>

#include <array>
#include <vector>

namespace pcl_attention
{

/** \brief A histogram over hue (8 bins), saturation (4) and value (4), as counts (paper IV-B.1). */
struct ColorHistogram
{
  static constexpr int hue_bins = 8, saturation_bins = 4, value_bins = 4;
  std::array<float, hue_bins * saturation_bins * value_bins> counts{};
  float total{0.0f};

  void
  add (int bin, float weight = 1.0f)
  {
    counts[bin] += weight;
    total += weight;
  }

  ColorHistogram&
  operator+= (const ColorHistogram& other)
  {
    for (std::size_t bin = 0; bin < counts.size (); ++bin)
      counts[bin] += other.counts[bin];
    total += other.total;
    return (*this);
  }

  ColorHistogram&
  operator-= (const ColorHistogram& other)
  {
    for (std::size_t bin = 0; bin < counts.size (); ++bin)
      counts[bin] -= other.counts[bin];
    total -= other.total;
    return (*this);
  }
};

/** \brief The histogram's bin of a colour; hue in [0, 360) degrees, saturation and value in [0, 1], upper ends inclusive. */
PCL_ATTENTION_EXPORTS int
colorBin (std::uint8_t red, std::uint8_t green, std::uint8_t blue);

/** \brief Bin of every pixel of a cloud; empty for a cloud without colour. */
PCL_ATTENTION_EXPORTS std::vector<std::uint8_t>
colorBins (const OrganizedCloud& cloud);

/** \brief Chi-square distance of two normalised histograms, 1/2 sum (a-b)^2/(a+b), in [0, 1] (paper eq. 11 and 12).
  * 0 if one of them is empty: nothing is known against it. */
PCL_ATTENTION_EXPORTS float
chiSquare (const ColorHistogram& a, const ColorHistogram& b);

/** \brief The same as a cue that speaks for or against: -1 for the same colours, 1 for none in common, 0 if a histogram is empty. */
PCL_ATTENTION_EXPORTS float
colorContrast (const ColorHistogram& a, const ColorHistogram& b);

} // namespace pcl_attention
