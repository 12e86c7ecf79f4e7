// SPDX-License-Identifier: BSD-3-Clause
// Paper eq. 11 and 12: HSV histograms and their chi-square distance.
#include <pcl_attention/core/color_histogram.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace pcl_attention;

namespace
{

int
binOf (int hue, int saturation, int value)
{
  return ((hue * ColorHistogram::saturation_bins + saturation) * ColorHistogram::value_bins + value);
}

/** \brief The bin of a colour in whole numbers, without any rounding. */
int
exactBin (int red, int green, int blue)
{
  const int largest = std::max ({red, green, blue}), chroma = largest - std::min ({red, green, blue});
  const int value_bin = std::min (4 * largest / 255, 3);
  if (chroma == 0)
    return (binOf (0, 0, value_bin));
  // Hue is sixths / chroma * 60 degrees, and a bin is 45 degrees wide.
  int sixths;
  if (largest == red)
    sixths = green - blue + (green < blue ? 6 * chroma : 0);
  else if (largest == green)
    sixths = blue - red + 2 * chroma;
  else
    sixths = red - green + 4 * chroma;
  return (binOf (8 * sixths / (6 * chroma), std::min (4 * chroma / largest, 3), value_bin));
}

} // namespace

TEST (ColorBin, EqualsExactArithmeticForEveryColour)
{
  int different = 0;
  for (int red = 0; red < 256; ++red)
    for (int green = 0; green < 256; ++green)
      for (int blue = 0; blue < 256; ++blue)
      {
        const int bin = colorBin (static_cast<std::uint8_t> (red), static_cast<std::uint8_t> (green),
                                  static_cast<std::uint8_t> (blue));
        const int exact = exactBin (red, green, blue);
        if (bin != exact && different++ < 5)
          ADD_FAILURE () << red << " " << green << " " << blue << " has bin " << bin << ", not " << exact;
      }
  EXPECT_EQ (different, 0);
}

TEST (ColorBin, OfPrimariesByHand)
{
  EXPECT_EQ (colorBin (0, 0, 0), binOf (0, 0, 0));
  EXPECT_EQ (colorBin (255, 255, 255), binOf (0, 0, 3));
  EXPECT_EQ (colorBin (100, 100, 100), binOf (0, 0, 1)); // value .39
  EXPECT_EQ (colorBin (255, 0, 0), binOf (0, 3, 3));     // 0 degrees
  EXPECT_EQ (colorBin (255, 255, 0), binOf (1, 3, 3));   // 60 of 45 a bin
  EXPECT_EQ (colorBin (0, 255, 0), binOf (2, 3, 3));     // 120
  EXPECT_EQ (colorBin (0, 255, 255), binOf (4, 3, 3));   // 180, the lower end of the fifth bin
  EXPECT_EQ (colorBin (0, 0, 255), binOf (5, 3, 3));     // 240
  EXPECT_EQ (colorBin (255, 0, 255), binOf (6, 3, 3));   // 300
  EXPECT_EQ (colorBin (255, 0, 1), binOf (7, 3, 3));     // just under 360
  EXPECT_EQ (colorBin (200, 100, 100), binOf (0, 2, 3)); // saturation a half
  EXPECT_EQ (colorBin (60, 120, 60), binOf (2, 2, 1));   // value .47
}

TEST (ColorBins, OfACloudAreThoseOfItsPixelsAndNoneWithoutColour)
{
  OrganizedCloud cloud;
  cloud.reset (2, 1);
  EXPECT_TRUE (colorBins (cloud).empty ());
  cloud.red = {255, 0};
  cloud.green = {0, 0};
  cloud.blue = {0, 255};
  const std::vector<std::uint8_t> bins = colorBins (cloud);
  ASSERT_EQ (bins.size (), 2u);
  EXPECT_EQ (bins[0], binOf (0, 3, 3));
  EXPECT_EQ (bins[1], binOf (5, 3, 3));
}

TEST (ChiSquare, ByHand)
{
  // Shares (3/4, 1/4, 0) and (1/4, 1/4, 1/2): 1/2 (1/4 / 1 + 0 + 1/4 / (1/2)) = 3/8.
  ColorHistogram a, b;
  a.add (0, 3.0f);
  a.add (1);
  b.add (0);
  b.add (1);
  b.add (127, 2.0f);
  EXPECT_FLOAT_EQ (chiSquare (a, b), 0.375f);
  EXPECT_FLOAT_EQ (chiSquare (b, a), 0.375f);
}

TEST (ChiSquare, OfIdenticalIsZeroWhateverTheirSize)
{
  ColorHistogram a;
  a.add (5, 3.0f);
  a.add (17, 8.0f);
  ColorHistogram twice = a;
  twice += a;
  EXPECT_FLOAT_EQ (twice.total, 22.0f);
  EXPECT_FLOAT_EQ (chiSquare (a, a), 0.0f);
  EXPECT_NEAR (chiSquare (a, twice), 0.0f, 1e-7f);
}

TEST (ChiSquare, OfDisjointIsOneAndOfEmptyIsZero)
{
  ColorHistogram a, b;
  a.add (5, 3.0f);
  b.add (6);
  b.add (7, 0.5f);
  EXPECT_FLOAT_EQ (chiSquare (a, b), 1.0f);
  EXPECT_EQ (chiSquare (a, ColorHistogram ()), 0.0f);
  EXPECT_EQ (chiSquare (ColorHistogram (), a), 0.0f);
  EXPECT_EQ (chiSquare (ColorHistogram (), ColorHistogram ()), 0.0f);
}

TEST (ColorContrast, ByHand)
{
  ColorHistogram a, b, other;
  a.add (0, 3.0f);
  a.add (1);
  b.add (0);
  b.add (1);
  b.add (127, 2.0f);
  other.add (6);
  EXPECT_FLOAT_EQ (colorContrast (a, b), -0.25f) << "2 * 3/8 - 1";
  EXPECT_FLOAT_EQ (colorContrast (a, a), -1.0f);
  EXPECT_FLOAT_EQ (colorContrast (a, other), 1.0f);
}

TEST (ColorContrast, NothingIsKnownWithoutColors)
{
  ColorHistogram a;
  a.add (0, 3.0f);
  EXPECT_EQ (colorContrast (a, ColorHistogram ()), 0.0f);
  EXPECT_EQ (colorContrast (ColorHistogram (), a), 0.0f);
}

TEST (ChiSquare, OfRandomHistogramsIsSymmetricAndBetweenZeroAndOne)
{
  std::mt19937 random (3);
  std::uniform_int_distribution<int> bin (0, 127), count (0, 50);
  for (int round = 0; round < 200; ++round)
  {
    ColorHistogram a, b;
    for (int k = 0; k < 20; ++k)
    {
      a.add (bin (random), static_cast<float> (count (random)));
      b.add (bin (random), static_cast<float> (count (random)));
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < a.counts.size (); ++k)
    {
      const double p = a.counts[k] / static_cast<double> (a.total), q = b.counts[k] / static_cast<double> (b.total);
      sum += p + q > 0.0 ? 0.5 * (p - q) * (p - q) / (p + q) : 0.0;
    }
    EXPECT_NEAR (chiSquare (a, b), sum, 1e-5);
    EXPECT_FLOAT_EQ (chiSquare (a, b), chiSquare (b, a));
    EXPECT_LE (chiSquare (a, b), 1.0f + 1e-6f);
  }
}

TEST (ColorHistogramSums, TakingAwayUndoesAdding)
{
  ColorHistogram a, b;
  a.add (1, 2.0f);
  b.add (1);
  b.add (2, 4.0f);
  ColorHistogram sum = a;
  sum += b;
  EXPECT_FLOAT_EQ (sum.counts[1], 3.0f);
  EXPECT_FLOAT_EQ (sum.counts[2], 4.0f);
  EXPECT_FLOAT_EQ (sum.total, 7.0f);
  sum -= b;
  EXPECT_EQ (sum.counts, a.counts);
  EXPECT_EQ (sum.total, a.total);
}
