// SPDX-License-Identifier: BSD-3-Clause
// Paper eq. 11 and 12: HSV histograms and their chi-square distance.
#include <pcl_attention/core/color_histogram.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
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

TEST (HexconeHistogram, AColorCountsInTheCellsAroundIt)
{
  // Of 9 x 9 x 2 cells white is in the middle of the hexagon and at full value, black there at none, red at the right end.
  const auto cell = [] (int across, int along, int value) { return (static_cast<std::size_t> ((across * 9 + along) * 2 + value)); };
  HexconeHistogram white, black, red, grey, pink;
  white.add (255, 255, 255);
  EXPECT_FLOAT_EQ (white.counts[cell (4, 4, 1)], 1.0f);
  black.add (0, 0, 0, 2.0f);
  EXPECT_NEAR (black.counts[cell (4, 4, 0)], 2.0f, 0.01f);
  EXPECT_FLOAT_EQ (black.total, 2.0f);
  red.add (255, 0, 0);
  EXPECT_FLOAT_EQ (red.counts[cell (8, 4, 1)], 1.0f);
  grey.add (51, 51, 51);
  EXPECT_FLOAT_EQ (grey.counts[cell (4, 4, 0)], 0.8f) << "a value of 1/5";
  EXPECT_FLOAT_EQ (grey.counts[cell (4, 4, 1)], 0.2f);
  pink.add (255, 150, 150); // saturation .412: 1.647 cells off the middle
  EXPECT_NEAR (pink.counts[cell (5, 4, 1)], 0.353f, 1e-3f);
  EXPECT_NEAR (pink.counts[cell (6, 4, 1)], 0.647f, 1e-3f);
  HexconeHistogram blue;
  blue.add (0, 0, 255); // at -1/2 across and -sqrt (3) / 2 along: cells 2 and .536
  EXPECT_NEAR (blue.counts[cell (2, 0, 1)], 0.464f, 1e-3f);
  EXPECT_NEAR (blue.counts[cell (2, 1, 1)], 0.536f, 1e-3f);
}

TEST (HexconeHistogram, EveryColorCountsOnceAndNothingIsNegative)
{
  for (int red = 0; red < 256; red += 15)
    for (int green = 0; green < 256; green += 17)
      for (int blue = 0; blue < 256; blue += 51)
      {
        HexconeHistogram one;
        one.add (static_cast<std::uint8_t> (red), static_cast<std::uint8_t> (green), static_cast<std::uint8_t> (blue));
        EXPECT_NEAR (std::accumulate (one.counts.begin (), one.counts.end (), 0.0), 1.0, 1e-5);
        EXPECT_GE (*std::min_element (one.counts.begin (), one.counts.end ()), 0.0f);
      }
}

TEST (HexconeHistogram, GreysAreAlikeWhateverTheirHue)
{
  // A little noise gives a grey any hue. Cells off the middle: .129 across, and -.0645 across with -.112 along; shares .871 and .129
  // against .831, .105, .057 and .007 have a chi-square of .150.
  HexconeHistogram reddish, bluish;
  reddish.add (124, 120, 120);
  bluish.add (120, 120, 124);
  EXPECT_NEAR (chiSquare (reddish, bluish), 0.150f, 0.002f);
  ColorHistogram red_bin, blue_bin;
  red_bin.add (colorBin (124, 120, 120));
  blue_bin.add (colorBin (120, 120, 124));
  EXPECT_FLOAT_EQ (chiSquare (red_bin, blue_bin), 1.0f);
}

TEST (ColorsOf, SamplesStandForAllPixels)
{
  OrganizedCloud cloud;
  cloud.width = 100;
  cloud.height = 50;
  pcl::Indices pixels;
  for (int index = 0; index < 5000; ++index)
    pixels.push_back (index);
  EXPECT_EQ (colorsOf (cloud, pixels).total, 0.0f) << "no colours";
  for (auto* channel : {&cloud.red, &cloud.green, &cloud.blue})
    channel->assign (5000, 0);
  for (int index = 0; index < 5000; ++index)
    (index % 100 < 75 ? cloud.red : cloud.blue)[index] = 255;
  const HexconeHistogram colors = colorsOf (cloud, pixels);
  HexconeHistogram red;
  red.add (255, 0, 0);
  const auto most = std::max_element (red.counts.begin (), red.counts.end ()) - red.counts.begin ();
  EXPECT_NEAR (colors.total, 5000.0f, 0.1f);
  EXPECT_NEAR (colors.counts[most] / colors.total, 0.75f, 0.02f);
  EXPECT_EQ (colorsOf (cloud, {}).total, 0.0f);
}

TEST (ColorContrast, ByHand)
{
  HexconeHistogram red, half, mostly, blue;
  red.add (255, 0, 0, 4.0f);
  half.add (255, 0, 0);
  half.add (0, 0, 255);
  mostly.add (255, 0, 0, 3.0f);
  mostly.add (0, 0, 255);
  blue.add (0, 0, 255);
  // Shares 1 and 1/2: 1/2 ((1/2)^2 / (3/2) + 1/2) = 1/3. Shares 1 and 3/4: 1/2 ((1/4)^2 / (7/4) + 1/4) = 1/7.
  EXPECT_NEAR (colorContrast (red, half), 1.0 / 3 / 0.3 - 1.0, 1e-5);
  EXPECT_NEAR (colorContrast (mostly, red), 1.0 / 7 / 0.3 - 1.0, 1e-5);
  EXPECT_FLOAT_EQ (colorContrast (red, red), -1.0f);
  EXPECT_FLOAT_EQ (colorContrast (red, blue), 1.0f) << "not more, although chi-square is 1";
}

TEST (ColorContrast, NothingIsKnownWithoutColors)
{
  HexconeHistogram a;
  a.add (255, 0, 0);
  EXPECT_EQ (colorContrast (a, HexconeHistogram ()), 0.0f);
  EXPECT_EQ (colorContrast (HexconeHistogram (), a), 0.0f);
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

TEST (ChiSquare, OfWhatIsTakenAwayStaysBetweenZeroAndOne)
{
  // What is left of a bin after that may be a little less than nothing.
  std::mt19937 random (5);
  std::uniform_int_distribution<int> level (0, 255);
  for (int round = 0; round < 50; ++round)
  {
    HexconeHistogram first, second;
    const auto addRandom = [&] (HexconeHistogram& colors) {
      const int grey = level (random);
      colors.add (static_cast<std::uint8_t> (grey), static_cast<std::uint8_t> (grey * 7 / 8), static_cast<std::uint8_t> (level (random)));
    };
    for (int k = 0; k < 100; ++k)
    {
      addRandom (first);
      addRandom (second);
    }
    HexconeHistogram rest = first;
    rest += second;
    rest -= first;
    HexconeHistogram red;
    red.add (255, 0, 0);
    EXPECT_NEAR (chiSquare (rest, second), 0.0f, 1e-4f);
    EXPECT_LE (chiSquare (rest, first), 1.0f + 1e-5f);
    EXPECT_NEAR (chiSquare (rest, red), chiSquare (second, red), 1e-4f);
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
