// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/organized_cloud.h>

#include <pcl/types.h>

#include <array>
#include <vector>

namespace pcl_attention
{

/** \brief How much there is of each of so many kinds. */
template <std::size_t Bins>
struct Histogram
{
  std::array<float, Bins> counts{};
  float total{0.0f};

  void
  add (int bin, float weight = 1.0f)
  {
    counts[bin] += weight;
    total += weight;
  }

  Histogram&
  operator+= (const Histogram& other)
  {
    for (std::size_t bin = 0; bin < Bins; ++bin)
      counts[bin] += other.counts[bin];
    total += other.total;
    return (*this);
  }

  Histogram&
  operator-= (const Histogram& other)
  {
    for (std::size_t bin = 0; bin < Bins; ++bin)
      counts[bin] -= other.counts[bin];
    total -= other.total;
    return (*this);
  }
};

/** \brief A histogram over hue (8 bins), saturation (4) and value (4), as counts (paper IV-B.1). */
struct ColorHistogram : Histogram<8 * 4 * 4>
{
  static constexpr int hue_bins = 8, saturation_bins = 4, value_bins = 4;
};

/** \brief A histogram over the hexcone that HSV is made of: hue and saturation as a point of its hexagon (9 x 9 cells), and the value
  * (2). Where the paper's bins part greys by hues that are noise, they lie together here; and a colour between cells counts in all
  * that are next to it, so that a shade more of light does not make another colour of it. */
struct PCL_ATTENTION_EXPORTS HexconeHistogram : Histogram<9 * 9 * 2>
{
  static constexpr int side = 9, values = 2;

  /** \brief The eight cells that a colour lies between, and how much of it counts in each: in all 1. */
  struct Shares
  {
    std::array<int, 8> cells;
    std::array<float, 8> shares;
  };

  static Shares
  sharesOf (std::uint8_t red, std::uint8_t green, std::uint8_t blue);

  void
  add (const Shares& color, float weight = 1.0f);

  void
  add (std::uint8_t red, std::uint8_t green, std::uint8_t blue, float weight = 1.0f) { add (sharesOf (red, green, blue), weight); }
};

/** \brief The histogram's bin of a colour; hue in [0, 360) degrees, saturation and value in [0, 1], upper ends inclusive. */
PCL_ATTENTION_EXPORTS int
colorBin (std::uint8_t red, std::uint8_t green, std::uint8_t blue);

/** \brief Bin of every pixel of a cloud; empty for a cloud without colour. */
PCL_ATTENTION_EXPORTS std::vector<std::uint8_t>
colorBins (const OrganizedCloud& cloud);

/** \brief Colours of a patch, from at most 400 of its pixels; empty for a cloud without colour. */
PCL_ATTENTION_EXPORTS HexconeHistogram
colorsOf (const OrganizedCloud& cloud, const pcl::Indices& pixels);

/** \brief Chi-square distance of two normalised histograms, 1/2 sum (a-b)^2/(a+b), in [0, 1] (paper eq. 11 and 12).
  * 0 if one of them is empty: nothing is known against it. */
PCL_ATTENTION_EXPORTS float
chiSquare (const ColorHistogram& a, const ColorHistogram& b);
PCL_ATTENTION_EXPORTS float
chiSquare (const HexconeHistogram& a, const HexconeHistogram& b);

/** \brief The same as a cue that speaks for or against, in [-1, 1]: -1 for the same colours, 0 at a chi-square of .3, 1 from .6; 0 if a
  * histogram is empty. Of neighbouring patches in recordings of tables half of those of one object are nearer than .15, nine of ten
  * nearer than .46, half of those of two objects farther than .44. */
PCL_ATTENTION_EXPORTS float
colorContrast (const HexconeHistogram& a, const HexconeHistogram& b);

} // namespace pcl_attention
