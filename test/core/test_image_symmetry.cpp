// SPDX-License-Identifier: BSD-3-Clause
// The symmetry of the colour image, which paper V-A compares with (WTA2D).
#include <pcl_attention/core/image_symmetry.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl_attention;

namespace
{

Image<float>
noise (int width, int height)
{
  std::mt19937 random (7);
  Image<float> image (width, height);
  for (float& value : image.data)
    value = static_cast<float> (random () % 256);
  return (image);
}

/** \brief A disc of one grey on another. */
Image<float>
disc (int width, int height, int column, int row, int radius)
{
  Image<float> image (width, height, 40.0f);
  for (int r = 0; r < height; ++r)
    for (int c = 0; c < width; ++c)
      if ((c - column) * (c - column) + (r - row) * (r - row) <= radius * radius)
        image (c, r) = 200.0f;
  return (image);
}

/** \brief The formula of Kootstra et al. word by word, in double precision, angle by angle. */
double
transcription (const Image<float>& grey, int column, int row, const ImageSymmetryParameters& parameters)
{
  const auto at = [] (const Image<double>& image, int c, int r) {
    return (image (std::clamp (c, 0, image.width - 1), std::clamp (r, 0, image.height - 1)));
  };
  Image<double> wide (grey.width, grey.height), smooth (grey.width, grey.height);
  std::copy (grey.data.begin (), grey.data.end (), wide.data.begin ());
  for (int r = 0; r < grey.height; ++r)
    for (int c = 0; c < grey.width; ++c)
      for (int down = -1; down <= 1; ++down)
        for (int across = -1; across <= 1; ++across)
          smooth (c, r) += at (wide, c + across, r + down) / ((down == 0 ? 2 : 4) * (across == 0 ? 2 : 4));
  struct Gradient
  {
    double magnitude, direction;
  };
  const auto gradient = [&] (int c, int r) {
    double x = 0.0, y = 0.0;
    for (int step = -1; step <= 1; ++step)
    {
      const double weight = step == 0 ? 2.0 : 1.0;
      x += weight * (at (smooth, c + 1, r + step) - at (smooth, c - 1, r + step));
      y += weight * (at (smooth, c + step, r + 1) - at (smooth, c + step, r - 1));
    }
    return (Gradient{std::hypot (x, y), std::atan2 (y, x)});
  };
  double sum = 0.0;
  for (int r = 0; r < grey.height; ++r)
    for (int c = 0; c < grey.width; ++c)
    {
      const int opposite_column = 2 * column - c, opposite_row = 2 * row - r;
      const double radius = std::hypot (c - column, r - row);
      if (!grey.contains (opposite_column, opposite_row) || radius < parameters.inner_radius || radius > parameters.outer_radius)
        continue;
      const Gradient a = gradient (c, r), b = gradient (opposite_column, opposite_row);
      const double line = std::atan2 (r - row, c - column), first = a.direction - line, second = b.direction - line;
      const double distance = 2.0 * radius;
      sum += (1.0 - std::cos (first + second)) * (1.0 - std::cos (first - second)) * std::log (1.0 + a.magnitude) *
             std::log (1.0 + b.magnitude) *
             std::exp (-distance * distance / (2.0 * parameters.pair_distance * parameters.pair_distance));
    }
  return (0.5 * sum); // every pair was met from both ends
}

/** \brief A cloud of the colours alone. */
OrganizedCloud
cloudOf (const Image<float>& grey)
{
  OrganizedCloud cloud;
  cloud.reset (grey.width, grey.height);
  cloud.red.resize (grey.size ());
  std::transform (grey.data.begin (), grey.data.end (), cloud.red.begin (),
                  [] (float value) { return (static_cast<std::uint8_t> (value)); });
  cloud.green = cloud.blue = cloud.red;
  return (cloud);
}

} // namespace

TEST (ImageSymmetry, isThePublishedFormula)
{
  const Image<float> grey = noise (48, 40);
  ImageSymmetryParameters parameters;
  parameters.inner_radius = 3;
  parameters.outer_radius = 8;
  const Image<float> symmetry = isotropicSymmetry (grey, parameters, 1);
  for (const auto& [column, row] : {std::pair<int, int> (24, 20), {0, 0}, {2, 5}, {47, 39}, {40, 12}})
  {
    const double expected = transcription (grey, column, row, parameters);
    EXPECT_NEAR (symmetry (column, row), expected, 1e-4 * std::max (1.0, expected)) << column << ", " << row;
  }
}

TEST (ImageSymmetry, isLargestInTheMiddleOfADisc)
{
  const Image<float> symmetry = isotropicSymmetry (disc (120, 90, 70, 40, 11), {}, 1);
  const auto best = static_cast<int> (std::max_element (symmetry.data.begin (), symmetry.data.end ()) - symmetry.data.begin ());
  EXPECT_EQ (best % 120, 70);
  EXPECT_EQ (best / 120, 40);
}

TEST (ImageSymmetry, ofOneColorIsNone)
{
  const Image<float> symmetry = isotropicSymmetry (Image<float> (60, 50, 90.0f), {}, 1);
  EXPECT_EQ (*std::max_element (symmetry.data.begin (), symmetry.data.end ()), 0.0f);
  const Image<float> saliency = computeImageSaliency (cloudOf (Image<float> (60, 50, 90.0f)), {}, 1);
  EXPECT_EQ (*std::max_element (saliency.data.begin (), saliency.data.end ()), 0.0f);
}

TEST (ImageSymmetry, ofTheMirrorImageIsTheMirrorImage)
{
  const Image<float> grey = noise (50, 40);
  Image<float> mirrored = grey;
  for (int row = 0; row < grey.height; ++row)
    std::reverse (mirrored.data.begin () + row * 50, mirrored.data.begin () + (row + 1) * 50);
  const Image<float> symmetry = isotropicSymmetry (grey, {}, 1), of_mirrored = isotropicSymmetry (mirrored, {}, 1);
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 50; ++column)
      ASSERT_NEAR (symmetry (column, row), of_mirrored (49 - column, row), 1e-4f * (1.0f + symmetry (column, row)));
}

TEST (ImageSymmetry, doesNotDependOnTheThreads)
{
  const OrganizedCloud cloud = cloudOf (noise (130, 97));
  const Image<float> saliency = computeImageSaliency (cloud, {}, 1);
  for (const int threads : {2, 3, 8})
    EXPECT_EQ (computeImageSaliency (cloud, {}, threads).data, saliency.data);
}

TEST (ImageSaliency, findsDiscsOfEveryScale)
{
  // Rings of 7 to 17 pixels at half and at a quarter of the size.
  for (const int radius : {20, 48})
  {
    const Image<float> saliency = computeImageSaliency (cloudOf (disc (320, 240, 150, 110, radius)), {}, 1);
    const auto best = static_cast<int> (std::max_element (saliency.data.begin (), saliency.data.end ()) - saliency.data.begin ());
    EXPECT_EQ (saliency[best], 1.0f);
    EXPECT_NEAR (best % 320, 150, 8) << radius;
    EXPECT_NEAR (best / 320, 110, 8) << radius;
  }
}

TEST (ImageSaliency, weighsColorsByTheirLuma)
{
  // On black a blue disc is the darkest, a green one the brightest of the same value.
  const Image<float> left = disc (320, 240, 60, 120, 20), middle = disc (320, 240, 160, 120, 20), right = disc (320, 240, 260, 120, 20);
  const float background = left (0, 0);
  OrganizedCloud cloud = cloudOf (Image<float> (320, 240, 0.0f));
  for (std::size_t index = 0; index < cloud.size (); ++index)
  {
    cloud.red[index] = left[index] != background ? 200 : 0;
    cloud.green[index] = middle[index] != background ? 200 : 0;
    cloud.blue[index] = right[index] != background ? 200 : 0;
  }
  const Image<float> saliency = computeImageSaliency (cloud, {}, 1);
  EXPECT_GT (saliency (160, 120), saliency (60, 120));
  EXPECT_GT (saliency (60, 120), saliency (260, 120));
}

TEST (ImageSaliency, ofACloudWithoutColorsIsNone)
{
  OrganizedCloud cloud;
  cloud.reset (40, 30);
  EXPECT_EQ (computeImageSaliency (cloud, {}, 1).data, std::vector<float> (1200, 0.0f));
}
