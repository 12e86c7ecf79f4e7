// SPDX-License-Identifier: BSD-3-Clause
// Paper III-C: connected components and skeletons, on drawn pictures.
#include "pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl_attention;
using pictures::Picture;
using pictures::picture;

namespace
{

std::vector<Pixel>
pixelsOf (const Picture& image)
{
  std::vector<Pixel> pixels;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      if (image (column, row))
        pixels.push_back ({column, row});
  return (pixels);
}

std::vector<Pixel>
junctionsOf (const Picture& skeleton, float merge_radius = 3.0f)
{
  return (findJunctions (skeleton, pixelsOf (skeleton), merge_radius));
}

double
distance (const Pixel& a, double column, double row)
{
  return (std::hypot (a.column - column, a.row - row));
}

/** \brief As many lines as regions, each within its own. */
void
expectSameRegions (const Picture& mask, const Picture& skeleton)
{
  ASSERT_EQ (skeleton.width, mask.width);
  ASSERT_EQ (skeleton.height, mask.height);
  Image<int> regions;
  const int count = pictures::floodFill (mask, regions);
  Image<int> lines;
  EXPECT_EQ (pictures::floodFill (skeleton, lines), count) << "a region was split or lost";
  std::vector<int> pixels (count + 1, 0);
  for (std::size_t index = 0; index < mask.size (); ++index)
    if (skeleton[index])
    {
      ASSERT_TRUE (mask[index]) << "outside the mask";
      ++pixels[regions[index]];
    }
  for (int region = 1; region <= count; ++region)
    EXPECT_GT (pixels[region], 0);
}

/** \brief What every skeleton must be. */
void
expectSkeleton (const Picture& mask, const Picture& skeleton)
{
  expectSameRegions (mask, skeleton);
  // A pixel of a full square stays only if it holds a neighbour of its own, or if a hole would open in its place.
  for (int row = 0; row + 1 < skeleton.height; ++row)
    for (int column = 0; column + 1 < skeleton.width; ++column)
    {
      if (!skeleton (column, row) || !skeleton (column + 1, row) || !skeleton (column, row + 1) ||
          !skeleton (column + 1, row + 1))
        continue;
      for (int r = row; r <= row + 1; ++r)
        for (int c = column; c <= column + 1; ++c)
        {
          const bool inside = skeleton.contains (c - 1, r) && skeleton (c - 1, r) && skeleton.contains (c + 1, r) &&
                              skeleton (c + 1, r) && skeleton.contains (c, r - 1) && skeleton (c, r - 1) &&
                              skeleton.contains (c, r + 1) && skeleton (c, r + 1);
          if (inside)
            continue;
          Picture without (3, 3, 0);
          for (int dr = -1; dr <= 1; ++dr)
            for (int dc = -1; dc <= 1; ++dc)
              without (dc + 1, dr + 1) =
                  (dc != 0 || dr != 0) && skeleton.contains (c + dc, r + dr) && skeleton (c + dc, r + dr);
          Image<int> labels;
          EXPECT_GT (pictures::floodFill (without, labels), 1)
              << "the pixel " << c << " " << r << " of a full square could go\n"
              << pictures::draw (skeleton);
        }
    }
}

void
expectStable (const Picture& skeleton)
{
  EXPECT_EQ (thin (skeleton).data, skeleton.data) << "thinning a skeleton changes it\n" << pictures::draw (skeleton);
}

Picture
randomPicture (unsigned seed, int width, int height, double density)
{
  std::mt19937 random (seed);
  std::bernoulli_distribution set (density);
  Picture image (width, height, 0);
  for (auto& value : image.data)
    value = set (random);
  return (image);
}

Picture
randomBlobs (unsigned seed, int width, int height)
{
  std::mt19937 random (seed);
  std::uniform_real_distribution<double> uniform (0.0, 1.0);
  Picture image (width, height, 0);
  for (int blob = 0; blob < 12; ++blob)
  {
    const double x = width * uniform (random), y = height * uniform (random), a = 1 + 12 * uniform (random),
                 b = 1 + 12 * uniform (random);
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        if (std::pow ((column - x) / a, 2) + std::pow ((row - y) / b, 2) < 1.0)
          image (column, row) = 1;
  }
  return (image);
}

/** \brief The algorithm as Zhang and Suen printed it, all pixels of the image in every half-iteration. */
Picture
zhangSuen (Picture image)
{
  const auto at = [&] (int column, int row) { return (image.contains (column, row) && image (column, row) ? 1 : 0); };
  bool changed = true;
  while (changed)
  {
    changed = false;
    for (const bool first : {true, false})
    {
      std::vector<Pixel> removed;
      for (const Pixel& pixel : pixelsOf (image))
      {
        const int c = pixel.column, r = pixel.row;
        const int p2 = at (c, r - 1), p3 = at (c + 1, r - 1), p4 = at (c + 1, r), p5 = at (c + 1, r + 1),
                  p6 = at (c, r + 1), p7 = at (c - 1, r + 1), p8 = at (c - 1, r), p9 = at (c - 1, r - 1);
        const int b = p2 + p3 + p4 + p5 + p6 + p7 + p8 + p9;
        const int a = (p2 < p3) + (p3 < p4) + (p4 < p5) + (p5 < p6) + (p6 < p7) + (p7 < p8) + (p8 < p9) + (p9 < p2);
        if (b >= 2 && b <= 6 && a == 1 && (first ? p2 * p4 * p6 : p2 * p4 * p8) == 0 &&
            (first ? p4 * p6 * p8 : p2 * p6 * p8) == 0)
          removed.push_back (pixel);
      }
      for (const Pixel& pixel : removed)
        image (pixel.column, pixel.row) = 0;
      changed = changed || !removed.empty ();
    }
  }
  return (image);
}

Picture
bar (int width, int height, int left, int top, int right, int bottom)
{
  Picture image (width, height, 0);
  for (int row = top; row <= bottom; ++row)
    for (int column = left; column <= right; ++column)
      image (column, row) = 1;
  return (image);
}

Picture
both (Picture a, const Picture& b)
{
  for (std::size_t index = 0; index < a.size (); ++index)
    a[index] |= b[index];
  return (a);
}

} // namespace

TEST (ConnectedComponents, TouchOverCorners)
{
  Image<int> labels;
  EXPECT_EQ (labelConnectedComponents (picture ({"#...#", ".#...", "..#..", "#...#"}), labels), 4);
  EXPECT_EQ (labels.data, (std::vector<int>{1, 0, 0, 0, 2, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 3, 0, 0, 0, 4}));
  EXPECT_EQ (labelConnectedComponents (picture ({"#.#", ".#.", "#.#"}), labels), 1);
}

TEST (ConnectedComponents, DoNotWrapAroundTheImage)
{
  Image<int> labels;
  EXPECT_EQ (labelConnectedComponents (picture ({"..#", "#..", "..#"}), labels), 3);
}

TEST (ConnectedComponents, OfNothingAndOfEverything)
{
  Image<int> labels;
  EXPECT_EQ (labelConnectedComponents (Picture (), labels), 0);
  EXPECT_EQ (labelConnectedComponents (Picture (4, 3, 0), labels), 0);
  EXPECT_EQ (labels.data, std::vector<int> (12, 0));
  EXPECT_EQ (labelConnectedComponents (Picture (4, 3, 255), labels), 1);
  EXPECT_EQ (labels.data, std::vector<int> (12, 1));
}

TEST (ConnectedComponents, EqualAFloodFillOnRandomPictures)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const Picture image = randomPicture (seed, 17 + static_cast<int> (seed), 41, 0.1 + 0.01 * seed);
    Image<int> labels, expected;
    EXPECT_EQ (labelConnectedComponents (image, labels), pictures::floodFill (image, expected));
    EXPECT_EQ (labels.data, expected.data);
  }
}

TEST (CrossingNumber, ByHand)
{
  const auto at_center = [] (std::initializer_list<const char*> rows) {
    return (crossingNumber (picture (rows), 1, 1));
  };
  EXPECT_EQ (at_center ({"...", ".#.", "..."}), 0);
  EXPECT_EQ (at_center ({"...", ".##", "..."}), 1);
  EXPECT_EQ (at_center ({"..#", ".##", "..."}), 1);
  EXPECT_EQ (at_center ({"...", "###", "..."}), 2);
  EXPECT_EQ (at_center ({"#..", ".#.", "..#"}), 2);
  EXPECT_EQ (at_center ({".#.", ".##", "..."}), 2);
  EXPECT_EQ (at_center ({"#.#", ".#.", ".#."}), 3);
  EXPECT_EQ (at_center ({"...", "###", ".#."}), 3);
  EXPECT_EQ (at_center ({"#.#", ".#.", "#.#"}), 4);
  EXPECT_EQ (at_center ({".#.", "###", ".#."}), 4);
  EXPECT_EQ (at_center ({"###", "###", "###"}), 0);
  // At the image's corner, what lies outside is background.
  EXPECT_EQ (crossingNumber (picture ({"##", ".."}), 0, 0), 1);
}

TEST (Thinning, LeavesABarsMiddleLine)
{
  const Picture mask = bar (40, 15, 3, 5, 36, 9), skeleton = thin (mask);
  expectSkeleton (mask, skeleton);
  int length = 0;
  for (const Pixel& pixel : pixelsOf (skeleton))
  {
    EXPECT_NEAR (pixel.row, 7, 1) << pictures::draw (skeleton);
    ++length;
  }
  EXPECT_GE (length, 28);
  EXPECT_TRUE (junctionsOf (skeleton).empty ());
  const Pixel middle = findMidpoint (skeleton, pixelsOf (skeleton));
  EXPECT_NEAR (middle.column, 19.5, 1.5);
  EXPECT_NEAR (middle.row, 7, 1);
}

TEST (Thinning, LeavesADiagonalBarsMiddleLine)
{
  Picture mask (50, 50, 0);
  for (int row = 0; row < 50; ++row)
    for (int column = 0; column < 50; ++column)
      mask (column, row) = std::abs (column - row) <= 3 && column + row >= 10 && column + row <= 88;
  const Picture skeleton = thin (mask);
  expectSkeleton (mask, skeleton);
  for (const Pixel& pixel : pixelsOf (skeleton))
    EXPECT_LE (std::abs (pixel.column - pixel.row), 2);
  EXPECT_LT (distance (findMidpoint (skeleton, pixelsOf (skeleton)), 24.5, 24.5), 2.5);
}

TEST (Thinning, KeepsAtLeastOnePixelOfEveryThing)
{
  for (const auto& rows : std::vector<std::vector<std::string>>{{"...", ".#.", "..."},
                                                                {"....", ".##.", ".##.", "...."},
                                                                {"###", "###", "###"},
                                                                {"##"},
                                                                {"#"},
                                                                {"#", "#"},
                                                                {"##", "##"},
                                                                {"##..", "##..", "..##", "..##"},
                                                                {".##.", "####", "####", ".##."},
                                                                {"#.#.#.#"}})
  {
    const Picture mask = picture (rows), skeleton = thin (mask);
    expectSkeleton (mask, skeleton);
    expectStable (skeleton);
  }
}

TEST (Thinning, KeepsWhatIsThinAlready)
{
  for (const auto& rows : std::vector<std::vector<std::string>>{{".....", ".###.", "....."},
                                                                {"#....", ".#...", "..#..", "...##"},
                                                                {"#...#", ".#.#.", "..#..", "..#..", "..#.."},
                                                                {".##.", "#..#", "#..#", ".##."}})
    EXPECT_EQ (thin (picture (rows)).data, picture (rows).data);
}

TEST (Thinning, LeavesNothingToThinOfRaggedNoise)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE (seed);
    const Picture mask = randomPicture (seed, 60, 50, 0.3 + 0.015 * seed), skeleton = thin (mask);
    expectSameRegions (mask, skeleton);
    expectStable (skeleton);
  }
}

TEST (Thinning, KeepsTheNumberOfRegionsOfRandomBlobs)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE (seed);
    const Picture mask = randomBlobs (seed, 80, 60), skeleton = thin (mask);
    expectSkeleton (mask, skeleton);
    expectStable (skeleton);
    if (HasFailure ())
      return;
  }
}

TEST (Thinning, IsThatOfZhangAndSuenWithoutItsCorners)
{
  int compared = 0;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE (seed);
    const Picture mask = randomBlobs (seed, 80, 60), printed = zhangSuen (mask), skeleton = thin (mask);
    // Where the printed algorithm loses a region, the two have to differ.
    if (pictures::floodFill (mask, 8) != pictures::floodFill (printed, 8))
      continue;
    ++compared;
    for (int row = 0; row < 60; ++row)
      for (int column = 0; column < 80; ++column)
      {
        if (skeleton (column, row))
        {
          ASSERT_TRUE (printed (column, row));
        }
        else if (printed (column, row))
        {
          // A corner has neighbours above or below it, and beside it.
          const bool vertical = (row > 0 && printed (column, row - 1)) || (row < 59 && printed (column, row + 1));
          const bool beside = (column > 0 && printed (column - 1, row)) || (column < 79 && printed (column + 1, row));
          ASSERT_TRUE (vertical && beside) << column << " " << row;
        }
      }
  }
  EXPECT_GT (compared, 40);
}

TEST (Thinning, KeepsTheNumberOfRegionsOfRandomPixels)
{
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE (seed);
    const Picture mask = randomPicture (seed, 24, 20, 0.2 + 0.0035 * seed);
    expectSameRegions (mask, thin (mask));
    if (HasFailure ())
      return;
  }
}

TEST (Thinning, KeepsTheNumberOfRegionsOfEveryPictureOfFourByFourPixels)
{
  for (int bits = 0; bits < 65536; ++bits)
  {
    Picture mask (4, 4, 0);
    for (int bit = 0; bit < 16; ++bit)
      mask[bit] = bits >> bit & 1;
    SCOPED_TRACE (pictures::draw (mask));
    expectSkeleton (mask, thin (mask));
    if (HasFailure ())
      return;
  }
}

TEST (Thinning, KeepsTheHoleOfARing)
{
  Picture mask (41, 41, 0);
  for (int row = 0; row < 41; ++row)
    for (int column = 0; column < 41; ++column)
    {
      const double radius = std::hypot (column - 20, row - 20);
      mask (column, row) = radius >= 10 && radius <= 16;
    }
  const Picture skeleton = thin (mask);
  expectSkeleton (mask, skeleton);
  Picture background (41, 41, 0);
  for (std::size_t index = 0; index < skeleton.size (); ++index)
    background[index] = !skeleton[index];
  EXPECT_EQ (pictures::floodFill (background, 4), 2) << pictures::draw (skeleton);
  for (const Pixel& pixel : pixelsOf (skeleton))
    EXPECT_NEAR (distance (pixel, 20, 20), 13.0, 2.0);
}

TEST (Junctions, OfATAndAPlusLieWhereTheirBarsMeet)
{
  const Picture plus = both (bar (41, 41, 4, 18, 36, 22), bar (41, 41, 18, 4, 22, 36));
  const Picture plus_skeleton = thin (plus);
  expectSkeleton (plus, plus_skeleton);
  const std::vector<Pixel> center = junctionsOf (plus_skeleton);
  ASSERT_EQ (center.size (), 1u) << pictures::draw (plus_skeleton);
  EXPECT_LE (distance (center[0], 20, 20), 1.5);

  const Picture tee = both (bar (41, 41, 4, 6, 36, 10), bar (41, 41, 18, 6, 22, 36));
  const Picture tee_skeleton = thin (tee);
  expectSkeleton (tee, tee_skeleton);
  const std::vector<Pixel> stem = junctionsOf (tee_skeleton);
  ASSERT_EQ (stem.size (), 1u) << pictures::draw (tee_skeleton);
  EXPECT_NEAR (stem[0].column, 20, 1.01);
  // The corner of a T pulls its junction towards the stem.
  EXPECT_NEAR (stem[0].row, 8.5, 1.51);
}

TEST (Junctions, OfThinLinesAreTheirVeryPixels)
{
  EXPECT_EQ (junctionsOf (picture ({"..#..", "..#..", "#####", "..#..", "..#.."})), (std::vector<Pixel>{{2, 2}}));
  EXPECT_EQ (junctionsOf (picture ({"#...#", ".#.#.", "..#..", "..#..", "..#.."})), (std::vector<Pixel>{{2, 2}}));
}

TEST (Junctions, AnLAndARingHaveNone)
{
  const Picture l = both (bar (41, 41, 6, 6, 10, 34), bar (41, 41, 6, 30, 34, 34));
  const Picture skeleton = thin (l);
  expectSkeleton (l, skeleton);
  EXPECT_TRUE (junctionsOf (skeleton).empty ()) << pictures::draw (skeleton);
  EXPECT_TRUE (junctionsOf (picture ({".###.", "#...#", "#...#", ".###."})).empty ());
}

TEST (Junctions, NearerThanTheMergeRadiusAreOne)
{
  // Two stems 4 pixels apart.
  const Picture image = picture ({"...#...#...", "...#...#...", "...#...#...", "###########"});
  EXPECT_EQ (junctionsOf (image, 3.0f), (std::vector<Pixel>{{3, 3}, {7, 3}}));
  EXPECT_EQ (junctionsOf (image, 4.0f).size (), 1u);
  EXPECT_EQ (junctionsOf (image, 0.0f).size (), 2u);
  // Of three in a row the middle one is nearest to their mean.
  const Picture three = picture ({"..#..#..#..", "..#..#..#..", "..#..#..#..", "###########"});
  EXPECT_EQ (junctionsOf (three, 3.0f), (std::vector<Pixel>{{5, 3}}));
  EXPECT_EQ (junctionsOf (three, 2.9f).size (), 3u);
}

TEST (Midpoint, OfLinesByHand)
{
  const auto middle = [] (const Picture& image) { return (findMidpoint (image, pixelsOf (image))); };
  EXPECT_EQ (middle (picture ({"#####"})), (Pixel{2, 0}));
  EXPECT_EQ (middle (picture ({"#"})), (Pixel{0, 0}));
  const Pixel of_two = middle (picture ({"##"}));
  EXPECT_EQ (of_two.row, 0);
  // Along the line, not in the middle of its box: 5 pixels down, 9 across.
  EXPECT_EQ (middle (picture ({"#.........", "#.........", "#.........", "#.........", ".#########"})).row, 4);
  const Pixel of_l = middle (picture ({"#......", "#......", "#......", ".######"}));
  EXPECT_LE (distance (of_l, 2, 3), 1.0);
}

TEST (Midpoint, OfAClosedLineIsItsUppermostPixelThenTheLeftmost)
{
  const Picture ring = picture ({"......", "..##..", ".#..#.", ".#..#.", "..##.."});
  EXPECT_EQ (findMidpoint (ring, pixelsOf (ring)), (Pixel{2, 1}));
}

TEST (Midpoint, OfABranchedLineIsTheMiddleOfItsLongestPath)
{
  const Picture image = picture ({"...#.......", "...#.......", "###########"});
  EXPECT_EQ (findMidpoint (image, pixelsOf (image)), (Pixel{5, 2}));
}
