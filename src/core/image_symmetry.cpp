// SPDX-License-Identifier: BSD-3-Clause

#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/image_symmetry.h>
#include <pcl_attention/core/pyramid.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_attention
{

namespace
{

/** \brief Gradients of an image: direction as a unit vector, logarithm of the magnitude; all 0 where there is none. */
struct Gradients
{
  Image<float> x, y, strength;
};

/** \brief A line through a pixel, and how much the pair of pixels at its ends counts. */
struct PairOfPixels
{
  int column, row;              /**< from the centre to one of them; the other lies opposite */
  float direction_x, direction_y; /**< unit length */
  float weight;
};

Image<float>
greyOf (const OrganizedCloud& cloud)
{
  Image<float> grey (cloud.width, cloud.height);
  for (std::size_t index = 0; index < cloud.size (); ++index)
    grey[index] = 0.299f * cloud.red[index] + 0.587f * cloud.green[index] + 0.114f * cloud.blue[index];
  return (grey);
}

/** \brief The pixel there, or outside the image the nearest one in it. */
template <typename T> T
nearest (const Image<T>& image, int column, int row)
{
  return (image (std::clamp (column, 0, image.width - 1), std::clamp (row, 0, image.height - 1)));
}

Image<float>
smooth (const Image<float>& image)
{
  constexpr float kernel[3] = {0.25f, 0.5f, 0.25f};
  Image<float> result (image.width, image.height, 0.0f);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      for (int r = -1; r <= 1; ++r)
        for (int c = -1; c <= 1; ++c)
          result (column, row) += kernel[r + 1] * kernel[c + 1] * nearest (image, column + c, row + r);
  return (result);
}

/** \brief Mean of two by two pixels. */
Image<float>
halveImage (const Image<float>& image)
{
  Image<float> half ((image.width + 1) / 2, (image.height + 1) / 2);
  for (int row = 0; row < half.height; ++row)
    for (int column = 0; column < half.width; ++column)
      half (column, row) = 0.25f * (nearest (image, 2 * column, 2 * row) + nearest (image, 2 * column + 1, 2 * row) +
                                    nearest (image, 2 * column, 2 * row + 1) + nearest (image, 2 * column + 1, 2 * row + 1));
  return (half);
}

/** \brief 3 x 3 Sobel gradients of the smoothed image. */
Gradients
gradientsOf (const Image<float>& grey)
{
  const Image<float> image = smooth (grey);
  const Image<float> none (image.width, image.height, 0.0f);
  Gradients gradients{none, none, none};
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
    {
      const auto at = [&] (int c, int r) { return (nearest (image, column + c, row + r)); };
      const float x = (at (1, -1) + 2.0f * at (1, 0) + at (1, 1)) - (at (-1, -1) + 2.0f * at (-1, 0) + at (-1, 1));
      const float y = (at (-1, 1) + 2.0f * at (0, 1) + at (1, 1)) - (at (-1, -1) + 2.0f * at (0, -1) + at (1, -1));
      const float magnitude = std::sqrt (x * x + y * y);
      if (magnitude <= 0.0f)
        continue;
      gradients.x (column, row) = x / magnitude;
      gradients.y (column, row) = y / magnitude;
      gradients.strength (column, row) = std::log1p (magnitude);
    }
  return (gradients);
}

/** \brief One of every two opposite pixels in the ring. */
std::vector<PairOfPixels>
pairsOf (const ImageSymmetryParameters& parameters)
{
  std::vector<PairOfPixels> pairs;
  const int reach = parameters.outer_radius;
  for (int row = 0; row <= reach; ++row)
    for (int column = row == 0 ? 1 : -reach; column <= reach; ++column)
    {
      const auto squared = static_cast<float> (column * column + row * row);
      if (squared < static_cast<float> (parameters.inner_radius * parameters.inner_radius) ||
          squared > static_cast<float> (reach * reach))
        continue;
      const float length = std::sqrt (squared), distance = 2.0f * length / parameters.pair_distance;
      pairs.push_back ({column, row, static_cast<float> (column) / length, static_cast<float> (row) / length,
                        std::exp (-0.5f * distance * distance)});
    }
  return (pairs);
}

} // namespace

Image<float>
isotropicSymmetry (const Image<float>& grey, const ImageSymmetryParameters& parameters, int threads)
{
  const Gradients gradients = gradientsOf (grey);
  const std::vector<PairOfPixels> pairs = pairsOf (parameters);
  const int width = grey.width, height = grey.height;
  Image<float> symmetry (width, height, 0.0f);
  constexpr int band_height = 8;
  forEachBand (height, band_height, threads, [&] (int begin, int end) {
    for (int row = begin; row < end; ++row)
      for (const PairOfPixels& pair : pairs)
      {
        if (row - pair.row < 0 || row + pair.row >= height)
          continue;
        const int reach = std::abs (pair.column);
        const auto first = static_cast<std::ptrdiff_t> (row + pair.row) * width + pair.column;
        const auto second = static_cast<std::ptrdiff_t> (row - pair.row) * width - pair.column;
        float* const sums = &symmetry[static_cast<std::size_t> (row) * width];
        const float *const x = gradients.x.data.data (), *const y = gradients.y.data.data (), *const strength = gradients.strength.data.data ();
        for (int column = reach; column < width - reach; ++column)
        {
          const std::ptrdiff_t i = first + column, j = second + column;
          // With c and s the cosines and sines of g_i and g_j the two factors multiply to (1 - c_i c_j)^2 - (s_i s_j)^2.
          const float cosines = (x[i] * pair.direction_x + y[i] * pair.direction_y) * (x[j] * pair.direction_x + y[j] * pair.direction_y);
          const float sines = (y[i] * pair.direction_x - x[i] * pair.direction_y) * (y[j] * pair.direction_x - x[j] * pair.direction_y);
          sums[column] += pair.weight * strength[i] * strength[j] * ((1.0f - cosines) * (1.0f - cosines) - sines * sines);
        }
      }
  });
  return (symmetry);
}

Image<float>
computeImageSaliency (const OrganizedCloud& cloud, const ImageSymmetryParameters& parameters, int threads)
{
  Image<float> saliency (cloud.width, cloud.height, 0.0f);
  if (!cloud.hasColor ())
    return (saliency);
  Image<float> grey = greyOf (cloud);
  std::vector<std::pair<int, int>> sizes;
  for (int level = 0; level < parameters.levels; ++level)
  {
    sizes.emplace_back (grey.width, grey.height);
    grey = halveImage (grey);
    Image<float> map = isotropicSymmetry (grey, parameters, threads);
    const auto [least, most] = std::minmax_element (map.data.begin (), map.data.end ());
    const float minimum = *least, range = *most - minimum;
    if (range <= 0.0f)
      continue;
    for (float& value : map.data)
      value = (value - minimum) / range;
    for (auto size = sizes.rbegin (); size != sizes.rend (); ++size)
      map = doubleSize (map, size->first, size->second, threads);
    for (std::size_t index = 0; index < saliency.size (); ++index)
      saliency[index] += map[index];
  }
  const float maximum = *std::max_element (saliency.data.begin (), saliency.data.end ());
  if (maximum > 0.0f)
    for (float& value : saliency.data)
      value /= maximum;
  return (saliency);
}

} // namespace pcl_attention
