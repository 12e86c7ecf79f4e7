// SPDX-License-Identifier: BSD-3-Clause
// Paper III-C: attention points of a saliency map.
#include "pictures.h"
#include <pcl_attention/core/attention_points.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace pcl_attention;

namespace
{

/** \brief A map drawn in tenths: '1' is 0.1, '9' is 0.9, '#' is 1, '.' is 0. */
Image<float>
map (const std::vector<std::string>& rows)
{
  Image<float> image (static_cast<int> (rows.front ().size ()), static_cast<int> (rows.size ()), 0.0f);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
    {
      const char c = rows[row][column];
      image (column, row) = c == '#' ? 1.0f : (c == '.' ? 0.0f : 0.1f * static_cast<float> (c - '0'));
    }
  return (image);
}

AttentionPoints
pointsOf (const Image<float>& saliency, const AttentionPointParameters& parameters = AttentionPointParameters (),
          std::vector<std::uint8_t> valid = {})
{
  if (valid.empty ())
    valid.assign (saliency.size (), 1);
  AttentionPoints result;
  extractAttentionPoints (saliency, valid, parameters, result);
  return (result);
}

AttentionPointParameters
literal ()
{
  AttentionPointParameters parameters;
  parameters.pixel_threshold = 0.0f;
  return (parameters);
}

std::vector<Pixel>
pixelsOf (const AttentionPoints& result)
{
  std::vector<Pixel> pixels;
  for (const AttentionPoint& point : result.points)
    pixels.push_back ({point.column, point.row});
  return (pixels);
}

} // namespace

TEST (MeanSaliency, IsTheMeanOverEachComponent)
{
  const Image<float> saliency = map ({"12.8", "3..4"});
  Image<int> labels (4, 2, 0);
  labels.data = {1, 1, 0, 2, 1, 0, 0, 2};
  const std::vector<float> means = meanSaliency (saliency, labels, 3);
  ASSERT_EQ (means.size (), 3u);
  EXPECT_FLOAT_EQ (means[0], 0.2f); // (.1 + .2 + .3) / 3
  EXPECT_FLOAT_EQ (means[1], 0.6f); // (.8 + .4) / 2
  EXPECT_EQ (means[2], 0.0f);       // no pixel
}

TEST (AttentionPoints, AreTheMiddlesOfSimpleLinesInOrderOfTheirMeans)
{
  const AttentionPoints result =
      pointsOf (map ({".........", ".555.....", ".........", ".....###.", ".........", ".777.....", "........."}));
  ASSERT_EQ (result.points.size (), 3u);
  EXPECT_EQ (pixelsOf (result), (std::vector<Pixel>{{6, 3}, {2, 5}, {2, 1}}));
  EXPECT_FLOAT_EQ (result.points[0].saliency, 1.0f);
  EXPECT_FLOAT_EQ (result.points[1].saliency, 0.7f);
  EXPECT_FLOAT_EQ (result.points[2].saliency, 0.5f);
  for (const AttentionPoint& point : result.points)
  {
    EXPECT_EQ (point.kind, AttentionPointKind::midpoint);
    EXPECT_EQ (result.components (point.column, point.row), point.component);
    EXPECT_FLOAT_EQ (result.mean_saliency[point.component - 1], point.saliency);
  }
}

TEST (AttentionPoints, ThetaSalLeavesOutFaintComponents)
{
  // Means: 1, .3 and .2 of the maximum.
  const Image<float> saliency = map ({"###..333..222"});
  AttentionPointParameters parameters;
  parameters.component_threshold = 0.1f;
  EXPECT_EQ (pointsOf (saliency, parameters).points.size (), 3u);
  parameters.component_threshold = 0.25f;
  const AttentionPoints two = pointsOf (saliency, parameters);
  EXPECT_EQ (pixelsOf (two), (std::vector<Pixel>{{1, 0}, {6, 0}}));
  // The component stays visible in the result, its line does not.
  EXPECT_EQ (two.mean_saliency.size (), 3u);
  EXPECT_EQ (two.components (11, 0), 3);
  EXPECT_EQ (two.skeleton (11, 0), 0);
  parameters.component_threshold = 0.35f;
  EXPECT_EQ (pointsOf (saliency, parameters).points.size (), 1u);
}

TEST (AttentionPoints, ThetaSalIsAboutTheMeanNotThePeak)
{
  // A peak of .9 within a faint component: (.9 + 5 * .2) / 6 = .317.
  AttentionPointParameters parameters;
  parameters.component_threshold = 0.35f;
  EXPECT_EQ (pointsOf (map ({"###..229222"}), parameters).points.size (), 1u);
  parameters.component_threshold = 0.3f;
  const AttentionPoints result = pointsOf (map ({"###..229222"}), parameters);
  ASSERT_EQ (result.points.size (), 2u);
  EXPECT_NEAR (result.points[1].saliency, 1.9 / 6.0, 1e-6);
}

TEST (AttentionPoints, ThePixelThresholdSeparatesWhatIsConnectedAboveZero)
{
  const Image<float> saliency = map ({"###1#1###"});
  EXPECT_EQ (pointsOf (saliency, literal ()).points.size (), 1u); // S > 0: one component
  AttentionPointParameters parameters;
  parameters.pixel_threshold = 0.15f;
  EXPECT_EQ (pointsOf (saliency, parameters).points.size (), 3u);
  // Relative to the maximum, whatever the map's scale.
  Image<float> small = saliency;
  for (float& value : small.data)
    value *= 1e-3f;
  EXPECT_EQ (pixelsOf (pointsOf (small, parameters)), pixelsOf (pointsOf (saliency, parameters)));
}

TEST (AttentionPoints, LiterallyAboveZeroTakesTheFaintestPixel)
{
  Image<float> saliency (9, 1, 0.0f);
  saliency[0] = 1.0f;
  saliency[4] = 1e-20f;
  AttentionPointParameters parameters = literal ();
  parameters.component_threshold = 0.0f;
  EXPECT_EQ (pixelsOf (pointsOf (saliency, parameters)), (std::vector<Pixel>{{0, 0}, {4, 0}}));
}

TEST (AttentionPoints, AnEmptyMapHasNone)
{
  for (const AttentionPointParameters& parameters : {AttentionPointParameters (), literal ()})
  {
    EXPECT_TRUE (pointsOf (Image<float> (8, 6, 0.0f), parameters).points.empty ());
    EXPECT_TRUE (pointsOf (Image<float> (), parameters).points.empty ());
  }
}

TEST (AttentionPoints, WhatIsNotANumberOrNegativeCountsAsZero)
{
  Image<float> saliency = map ({"###......", ".........", "...###..."});
  saliency (0, 2) = std::numeric_limits<float>::quiet_NaN ();
  saliency (8, 0) = std::numeric_limits<float>::infinity ();
  saliency (8, 2) = -std::numeric_limits<float>::infinity ();
  saliency (6, 1) = -7.0f;
  const AttentionPoints result = pointsOf (saliency);
  EXPECT_EQ (pixelsOf (result), (std::vector<Pixel>{{1, 0}, {4, 2}}));
  for (const float mean : result.mean_saliency)
    EXPECT_FLOAT_EQ (mean, 1.0f);
}

TEST (AttentionPoints, TiesGoToTheirOwnSaliencyThenRowThenColumn)
{
  // Four lines of mean .5; the last has .7 in its middle.
  const AttentionPoints result =
      pointsOf (map ({"......555..", "...........", "555....555.", "...........", "474........"}));
  ASSERT_EQ (result.points.size (), 4u);
  for (const AttentionPoint& point : result.points)
    EXPECT_NEAR (point.saliency, 0.5f, 1e-6f);
  EXPECT_EQ (pixelsOf (result), (std::vector<Pixel>{{1, 4}, {7, 0}, {1, 2}, {8, 2}}));
  EXPECT_FLOAT_EQ (result.points[0].point_saliency, 0.7f);
}

TEST (AttentionPoints, AllJunctionsOrTheMostSalientOne)
{
  Image<float> saliency =
      map ({"5...5.....5...5", ".5.5.......5.5.", "..5.........5..", "..5.........5..", "...555555555..."});
  saliency (12, 2) = 0.6f;
  const AttentionPoints all = pointsOf (saliency);
  EXPECT_EQ (pixelsOf (all), (std::vector<Pixel>{{12, 2}, {2, 2}}));
  for (const AttentionPoint& point : all.points)
    EXPECT_EQ (point.kind, AttentionPointKind::junction);
  AttentionPointParameters parameters;
  parameters.all_junctions = false;
  EXPECT_EQ (pixelsOf (pointsOf (saliency, parameters)), (std::vector<Pixel>{{12, 2}}));
}

TEST (AttentionPoints, LieOnValidPixelsOnly)
{
  const Image<float> saliency = map ({"555555555"});
  std::vector<std::uint8_t> valid (9, 1);
  valid[4] = valid[5] = 0;
  EXPECT_EQ (pixelsOf (pointsOf (saliency, {}, valid)), (std::vector<Pixel>{{3, 0}}));
  valid.assign (9, 0);
  EXPECT_TRUE (pointsOf (saliency, {}, valid).points.empty ());
  // Both junctions move to the only valid pixel, which is listed once.
  const Image<float> two = map ({"...5.....5...", "...5.....5...", "...5.....5...", "5555555555555"});
  valid.assign (two.size (), 0);
  valid[3 * 13 + 6] = 1;
  EXPECT_EQ (pixelsOf (pointsOf (two, {}, valid)), (std::vector<Pixel>{{6, 3}}));
}

TEST (AttentionPoints, ShortSkeletonsGiveNoneIfAskedFor)
{
  AttentionPointParameters parameters;
  parameters.minimum_skeleton_length = 4;
  EXPECT_EQ (pixelsOf (pointsOf (map ({"###..####"}), parameters)).size (), 1u);
  parameters.minimum_skeleton_length = 1;
  EXPECT_EQ (pixelsOf (pointsOf (map ({"#...###.."}), parameters)).size (), 2u);
}

TEST (AttentionPoints, KindsHaveNames)
{
  EXPECT_STREQ (toString (AttentionPointKind::junction), "junction");
  EXPECT_STREQ (toString (AttentionPointKind::midpoint), "midpoint");
  EXPECT_STREQ (toString (AttentionPointKind::winner), "winner");
  EXPECT_STREQ (toString (AttentionPointKind::coverage), "coverage");
  EXPECT_STREQ (toString (AttentionPointKind::user), "user");
}
