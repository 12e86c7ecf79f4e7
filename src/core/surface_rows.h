// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lane_kernels.h"

#include <pcl_attention/core/organized_cloud.h>

#include <algorithm>

namespace pcl_attention
{

/** \brief A ring of padded rows of points and normals, at first all zeros. */
class SurfaceRows
{
public:
  /** \param[in] count rows that are kept at a time
    * \param[in] before,behind columns of padding */
  SurfaceRows (int count, int width, int before, int behind)
  : before_ (before),
    stride_ (width + before + behind),
    rows_ (count),
    memory_ (static_cast<std::size_t> (stride_) * SurfaceRow::channels_size * count)
  {
    float* channel = memory_.data () + before;
    for (SurfaceRow& row : rows_)
      for (float*& pointer : row.channels)
      {
        pointer = channel;
        channel += stride_;
      }
  }

  /** \brief Set a row to zeros, as it is outside the image. */
  void
  clear (int position)
  {
    float* const first = at (position).channels[0] - before_;
    std::fill_n (first, static_cast<std::size_t> (stride_) * SurfaceRow::channels_size, 0.0f);
  }

  /** \param[in] position in the ring, taken modulo its size */
  const SurfaceRow&
  at (int position) const { return (rows_[position % rows_.size ()]); }

private:
  int before_, stride_;
  std::vector<SurfaceRow> rows_;
  std::vector<float> memory_;
};

inline StoredRow
storedRow (const OrganizedCloud& cloud, const NormalImage& normals, int row)
{
  const std::size_t at = static_cast<std::size_t> (row) * cloud.width;
  return {&cloud.x[at],   &cloud.y[at],   &cloud.z[at],     &normals.x[at],
          &normals.y[at], &normals.z[at], &cloud.valid[at], &normals.valid[at]};
}

} // namespace pcl_attention
