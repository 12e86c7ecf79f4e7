// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "systems/color_edges.h"

#include <cmath>
#include <cstdint>
#include <random>

/** \brief Drawn images whose right segments are known. */
namespace drawings
{

using pcl_attention::ColorImage;
using pcl_attention::EdgeMap;
using pcl_attention::Image;
using Mask = Image<std::uint8_t>;

/** \brief 1 where is_inside (column, row). */
template <typename IsInside>
Mask
draw (int width, int height, const IsInside& is_inside)
{
  Mask mask (width, height, 0);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      mask (column, row) = is_inside (column, row);
  return (mask);
}

inline Mask
drawDisc (int width, int height, double column, double row, double radius)
{
  return (draw (width, height, [=] (int x, int y) { return (std::hypot (x - column, y - row) <= radius); }));
}

/** \brief From the first to before the last column and row. */
inline Mask
drawRectangle (int width, int height, int left, int top, int right, int bottom)
{
  return (draw (width, height, [=] (int x, int y) { return (x >= left && x < right && y >= top && y < bottom); }));
}

/** \brief Both colours, with a camera's noise.
 * \param[in] noise standard deviation, of colours in 0..1 */
inline ColorImage
paint (const Mask& mask, const Eigen::Vector3f& inside, const Eigen::Vector3f& outside, float noise = 0.01f)
{
  std::mt19937 generator (1);
  std::normal_distribution<float> normal (0.0f, noise);
  ColorImage colors (mask.width, mask.height, outside);
  for (std::size_t i = 0; i < mask.size (); ++i)
  {
    const Eigen::Vector3f color = mask[i] ? inside : outside;
    colors[i] =
        (color.array () + Eigen::Array3f::NullaryExpr ([&] { return (normal (generator)); })).max (0.0f).min (1.0f);
  }
  return (colors);
}

/** \brief F of a mask. */
inline double
overlap (const Mask& mask, const Mask& truth)
{
  double common = 0, sum = 0;
  for (std::size_t i = 0; i < mask.size (); ++i)
  {
    common += mask[i] && truth[i];
    sum += mask[i] + truth[i];
  }
  return (2 * common / sum);
}

} // namespace drawings
