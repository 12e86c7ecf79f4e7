// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/export.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief The largest image that is taken: columns or rows, and pixels in all. Indices, sums and squares of pixels stay far
  * from the largest int. */
constexpr std::uint64_t longest_side = 1 << 14, most_pixels = 1 << 26;

/** \brief Check the size of an image before anything is allocated for it.
  * \return empty, or how large it is and may be: "20000 x 2, more than the 16384 a side and 67108864 in all that are taken" */
PCL_ATTENTION_EXPORTS std::string
imageSizeProblem (std::uint64_t columns, std::uint64_t rows);

/** \brief What every stage works on: an organized cloud as flat arrays in the sensor's own frame (x right, y down, z forward
  * from the viewpoint, metres), so that "towards the viewer" is the same direction in every stage. */
struct OrganizedCloud
{
  int width{0};
  int height{0};
  std::vector<float> x, y, z;      /**< metres; 0 where not valid */
  std::vector<std::uint8_t> valid; /**< 1 where the point is finite and selected by the indices */
  std::vector<std::uint8_t> red, green, blue; /**< 0..255; empty when the cloud has no colour */

  std::size_t
  size () const { return (valid.size ()); }

  bool
  hasColor () const { return (!red.empty ()); }

  /** \brief Set the size; the points' values are not defined, and there are no colours. */
  void
  resize (int columns, int rows)
  {
    width = columns;
    height = rows;
    const std::size_t count = static_cast<std::size_t> (columns) * rows;
    x.resize (count);
    y.resize (count);
    z.resize (count);
    valid.resize (count);
    red.clear ();
    green.clear ();
    blue.clear ();
  }

  /** \brief Set the size and mark every point as not valid. */
  void
  reset (int columns, int rows)
  {
    width = columns;
    height = rows;
    const std::size_t count = static_cast<std::size_t> (columns) * rows;
    x.assign (count, 0.0f);
    y.assign (count, 0.0f);
    z.assign (count, 0.0f);
    valid.assign (count, 0);
    red.clear ();
    green.clear ();
    blue.clear ();
  }
};

/** \brief Unit normals towards the viewpoint and surface curvature, of the same size as their cloud. */
struct NormalImage
{
  std::vector<float> x, y, z;      /**< unit length; 0 where not valid */
  std::vector<float> curvature;    /**< l0 / (l0 + l1 + l2) of the neighbourhood's covariance, in [0, 1/3] */
  std::vector<std::uint8_t> valid; /**< 1 where a normal is known */

  std::size_t
  size () const { return (valid.size ()); }

  /** \brief Set the size; the values are not defined. */
  void
  resize (std::size_t count)
  {
    x.resize (count);
    y.resize (count);
    z.resize (count);
    curvature.resize (count);
    valid.resize (count);
  }

  /** \brief Set the size and mark every normal as not valid. */
  void
  reset (std::size_t count)
  {
    x.assign (count, 0.0f);
    y.assign (count, 0.0f);
    z.assign (count, 0.0f);
    curvature.assign (count, 0.0f);
    valid.assign (count, 0);
  }
};

} // namespace pcl_attention
