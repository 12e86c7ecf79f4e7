// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lane_kernels.h"

#include <Eigen/Core>

#include <cstddef>

namespace pcl_attention
{

/** \brief Points in arrays, as the inner loops take them. */
class FlatPoints
{
public:
  template <typename Scalar>
  FlatPoints (const Eigen::Matrix<Scalar, 3, 1>* points, std::size_t count)
  : coordinates_ (Eigen::Map<const Eigen::Matrix<Scalar, 3, Eigen::Dynamic>> (
                    count == 0 ? nullptr : points->data (), 3, static_cast<Eigen::Index> (count)).transpose ().template cast<float> ())
  {
  }

  std::size_t
  size () const { return (static_cast<std::size_t> (coordinates_.rows ())); }

  /** \brief Without normals and marks of validity. */
  PointArrays
  arrays () const
  {
    return {coordinates_.col (0).data (), coordinates_.col (1).data (), coordinates_.col (2).data (), nullptr, nullptr, nullptr, nullptr};
  }

private:
  Eigen::MatrixX3f coordinates_;
};

} // namespace pcl_attention
