// SPDX-License-Identifier: BSD-3-Clause
#include "drawings.h"

#include <gtest/gtest.h>

namespace pcl_attention
{
namespace
{

using drawings::drawRectangle;
using drawings::paint;

constexpr int width = 80, height = 60, middle = 40;

/** \brief Two colours left and right of the middle column. */
ColorImage
twoHalves (const Eigen::Vector3f& left, const Eigen::Vector3f& right)
{
  return (paint (drawRectangle (width, height, 0, 0, middle, height), left, right));
}

/** \brief One line along the middle, and nothing elsewhere. */
void
expectLineInTheMiddle (const ColorImage& colors)
{
  const EdgeMap edges = detectColorEdges (colors);
  for (int row = 5; row < height - 5; ++row)
  {
    int on_line = 0;
    for (int column = 0; column < width; ++column)
      if (edges.strength (column, row) > 0)
      {
        EXPECT_NEAR (column, middle - 0.5, 2) << row;
        EXPECT_NEAR (edges.direction (column, row), M_PI_2, M_PI / 8) << row;
        ++on_line;
      }
    EXPECT_GE (on_line, 1) << row;
    EXPECT_LE (on_line, 2) << row;
  }
}

TEST (LabOf, knownColors)
{
  const Eigen::Vector3f white = labOf ({1, 1, 1}), red = labOf ({1, 0, 0}), grey = labOf ({0.5f, 0.5f, 0.5f});
  EXPECT_NEAR ((white - Eigen::Vector3f (100, 0, 0)).norm (), 0, 0.1);
  EXPECT_NEAR ((red - Eigen::Vector3f (53.24f, 80.09f, 67.20f)).norm (), 0, 0.1);
  EXPECT_NEAR ((grey - Eigen::Vector3f (53.39f, 0, 0)).norm (), 0, 0.1);
  EXPECT_NEAR (labOf ({0, 0, 0}).norm (), 0, 0.1);
}

TEST (ColorEdges, brightnessChanges)
{
  expectLineInTheMiddle (twoHalves ({0.6f, 0.6f, 0.6f}, {0.3f, 0.3f, 0.3f}));
}

TEST (ColorEdges, colorChangesAtTheSameBrightness)
{
  const Eigen::Vector3f reddish (0.60f, 0.40f, 0.40f), greenish (0.359f, 0.483f, 0.40f);
  ASSERT_NEAR (labOf (reddish).x (), labOf (greenish).x (), 1.0f);
  expectLineInTheMiddle (twoHalves (reddish, greenish));
}

TEST (ColorEdges, oneColorHasNone)
{
  const EdgeMap edges = detectColorEdges (twoHalves ({0.5f, 0.4f, 0.3f}, {0.5f, 0.4f, 0.3f}));
  for (const float strength : edges.strength.data)
    EXPECT_EQ (strength, 0.0f);
}

TEST (ColorEdges, textureChangesWithTheSameBrightnesses)
{
  // Stripes of three pixels, lying on the left and upright on the right.
  ColorImage colors = twoHalves ({0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f});
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      colors (column, row).array () += (column < middle ? row : column) % 6 < 3 ? 0.15f : -0.15f;
  const EdgeMap edges = detectColorEdges (colors);
  const auto strongest = [&edges] (int row, int first_column, int last_column) {
    float value = 0;
    for (int column = first_column; column <= last_column; ++column)
      value = std::max (value, edges.strength (column, row));
    return (value);
  };
  double border = 0, left = 0, right = 0;
  for (int row = 15; row < height - 15; ++row)
  {
    border += strongest (row, middle - 3, middle + 2) / (height - 30);
    left += strongest (row, 18, 23) / (height - 30);
    right += strongest (row, width - 24, width - 19) / (height - 30);
  }
  EXPECT_GT (border, 1.5 * std::max (left, right));
}

TEST (ColorEdges, threadsChangeNothing)
{
  const ColorImage colors = twoHalves ({0.6f, 0.3f, 0.3f}, {0.3f, 0.3f, 0.6f});
  EXPECT_EQ (detectColorEdges (colors, {}, 1).strength.data, detectColorEdges (colors, {}, 3).strength.data);
}

} // namespace
} // namespace pcl_attention
