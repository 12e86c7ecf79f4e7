// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/image.h>
#include <pcl_attention/export.h>

#include <vector>

namespace pcl_attention
{

/** \brief Pixel coordinates. */
struct Pixel
{
  int column{0};
  int row{0};

  bool
  operator== (const Pixel& other) const { return (column == other.column && row == other.row); }
};

/** \brief 8-connected components of the non-zero pixels (paper III-C).
  * \param[in] mask non-zero is foreground
  * \param[out] labels 0 = background, else 1, 2, ... in the order of each component's first pixel
  * \return number of components */
PCL_ATTENTION_EXPORTS int
labelConnectedComponents (const Image<std::uint8_t>& mask, Image<int>& labels);

/** \brief Thin every foreground region to lines one pixel wide: Zhang and Suen 1984, then removal of the corners that
  * 8-connectivity does not need. Components stay connected, and none disappears. */
PCL_ATTENTION_EXPORTS Image<std::uint8_t>
thin (const Image<std::uint8_t>& mask);

/** \brief Number of 0-to-1 transitions around a pixel; 3 or more is a junction, 1 an end, 2 inside a line. */
PCL_ATTENTION_EXPORTS int
crossingNumber (const Image<std::uint8_t>& skeleton, int column, int row);

/** \brief Junctions of one skeleton (paper III-C): pixels with a crossing number of at least 3; those nearer than
  * merge_radius pixels to each other become one, the pixel nearest to their mean.
  * \param[in] skeleton thin lines
  * \param[in] pixels the pixels of one component's skeleton */
PCL_ATTENTION_EXPORTS std::vector<Pixel>
findJunctions (const Image<std::uint8_t>& skeleton, const std::vector<Pixel>& pixels, float merge_radius);

/** \brief Mid-point of a simple line: the pixel half way along it between its two ends; on a closed line the pixel farthest
  * up, then left; on a branched one the middle of its longest path. */
PCL_ATTENTION_EXPORTS Pixel
findMidpoint (const Image<std::uint8_t>& skeleton, const std::vector<Pixel>& pixels);

} // namespace pcl_attention
