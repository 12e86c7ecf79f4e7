// SPDX-License-Identifier: BSD-3-Clause
// Paper V-A: the winner-take-all network on a saliency map.
#include <pcl_attention/core/attention_points.h>
#include <pcl_attention/core/winner_take_all.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace pcl_attention;

namespace
{

constexpr int cell = 16;
constexpr float width = 0.6f;

/** \brief Add a square blob. */
void
addBlob (Image<float>& map, int column, int row, int radius, float value)
{
  for (int r = row - radius; r <= row + radius; ++r)
    for (int c = column - radius; c <= column + radius; ++c)
      map (c, r) = value;
}

std::vector<Pixel>
pixelsOf (const std::vector<Winner>& winners)
{
  std::vector<Pixel> pixels;
  for (const Winner& winner : winners)
    pixels.push_back (winner.pixel);
  return (pixels);
}

} // namespace

TEST (WinnerTakeAll, looksAtTheMostSalientFirst)
{
  Image<float> map (320, 240, 0.0f);
  addBlob (map, 40, 40, 5, 0.5f);
  addBlob (map, 200, 120, 5, 1.0f);
  addBlob (map, 280, 200, 5, 0.25f);
  const std::vector<Winner> winners = findWinners (map, cell, 0.0f, width);
  EXPECT_EQ (pixelsOf (winners), (std::vector<Pixel>{{200, 120}, {40, 40}, {280, 200}}));
  // A blob of 121 pixels in a cell of 256; those of 40 and 200 lie in the middle of theirs.
  EXPECT_NEAR (winners[1].saliency, 0.5 * 121 / 256, 1e-6);
}

TEST (WinnerTakeAll, chargesByTheMapsOwnScale)
{
  Image<float> map (320, 240, 0.0f), scaled = map;
  addBlob (map, 40, 40, 5, 0.5f);
  addBlob (map, 200, 120, 5, 1.0f);
  for (std::size_t index = 0; index < map.size (); ++index)
    scaled[index] = 1000.0f * map[index];
  EXPECT_EQ (pixelsOf (findWinners (map, cell, 0.0f, width)), pixelsOf (findWinners (scaled, cell, 0.0f, width)));
}

TEST (WinnerTakeAll, cannotFireWithTooLittle)
{
  // A neuron's voltage rises to input / leak = 0.1 V * share of the maximum at most, and it fires at 1 mV.
  for (const auto& [share, count] : {std::pair<float, std::size_t> (0.008f, 1), {0.02f, 2}})
  {
    Image<float> map (320, 240, 0.0f);
    addBlob (map, 40, 40, 5, 1.0f);
    addBlob (map, 200, 120, 5, share);
    EXPECT_EQ (findWinners (map, cell, 0.0f, width).size (), count) << share;
  }
}

TEST (WinnerTakeAll, leavesOutWhatIsUnderTheThreshold)
{
  Image<float> map (320, 240, 0.0f);
  addBlob (map, 40, 40, 5, 1.0f);
  addBlob (map, 200, 120, 5, 0.3f);
  EXPECT_EQ (findWinners (map, cell, 0.25f, width).size (), 2u);
  EXPECT_EQ (findWinners (map, cell, 0.35f, width).size (), 1u);
}

TEST (WinnerTakeAll, leavesOutWhatJustReachesTheThreshold)
{
  Image<float> map (320, 240, 0.0f);
  addBlob (map, 40, 40, 5, 1.0f);
  addBlob (map, 200, 120, 5, 0.5f);
  EXPECT_EQ (findWinners (map, cell, 0.5f, width).size (), 1u);
}

TEST (WinnerTakeAll, takesTheMeanOfTheCellThatTheImageLeaves)
{
  // 24 pixels are a cell and a half.
  Image<float> map (24, cell, 0.0f);
  for (int row = 0; row < cell; ++row)
    for (int column = cell; column < 24; ++column)
      map (column, row) = 0.75f;
  const std::vector<Winner> winners = findWinners (map, cell, 0.0f, width);
  ASSERT_EQ (winners.size (), 1u);
  EXPECT_EQ (winners[0].saliency, 0.75f);
}

TEST (WinnerTakeAll, inhibitsTheReturnAndTheNeighbours)
{
  // A plateau is alike everywhere: the next winner is out of the inhibition, which reaches about three widths.
  const std::vector<Winner> winners = findWinners (Image<float> (640, 480, 1.0f), cell, 0.0f, width);
  ASSERT_GT (winners.size (), 3u);
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j)
    {
      const Pixel &a = winners[i].pixel, &b = winners[j].pixel;
      EXPECT_GT (std::hypot (a.column - b.column, a.row - b.row), 2.0 * cell);
    }
}

TEST (WinnerTakeAll, wideInhibitionLeavesFewerWinners)
{
  const Image<float> map (640, 480, 1.0f);
  EXPECT_LT (findWinners (map, cell, 0.0f, 2.0f).size (), findWinners (map, cell, 0.0f, width).size ());
}

TEST (WinnerTakeAll, endsWhereNothingIsSalient)
{
  EXPECT_TRUE (findWinners (Image<float> (64, 48, 0.0f), cell, 0.0f, width).empty ());
  EXPECT_TRUE (findWinners (Image<float> (), cell, 0.0f, width).empty ());
  Image<float> map (64, 48, std::numeric_limits<float>::quiet_NaN ());
  map (20, 20) = -1.0f;
  EXPECT_TRUE (findWinners (map, cell, 0.0f, width).empty ());
  map (40, 24) = 1.0f;
  EXPECT_EQ (pixelsOf (findWinners (map, cell, 0.0f, width)), (std::vector<Pixel>{{40, 24}}));
}

TEST (WinnerTakeAll, givesPointsOnValidPixels)
{
  Image<float> map (320, 240, 0.0f);
  addBlob (map, 40, 40, 5, 0.5f);
  addBlob (map, 200, 120, 5, 1.0f);
  addBlob (map, 280, 200, 5, 0.75f);
  std::vector<std::uint8_t> valid (map.size (), 1);
  valid[120 * 320 + 200] = 0;
  for (int row = 150; row < 240; ++row) // far around the third
    for (int column = 230; column < 320; ++column)
      valid[row * 320 + column] = 0;
  AttentionPointParameters parameters;
  parameters.strategy = AttentionStrategy::winner_take_all;
  AttentionPoints result;
  extractAttentionPoints (map, valid, parameters, result);
  ASSERT_EQ (result.points.size (), 2u);
  EXPECT_EQ (result.points[0].row * 320 + result.points[0].column, 119 * 320 + 200);
  EXPECT_EQ (result.points[0].kind, AttentionPointKind::winner);
  EXPECT_EQ (result.points[0].point_saliency, 1.0f);
  EXPECT_EQ (result.points[1].column, 40);
  EXPECT_EQ (result.components.size (), map.size ());
}
