// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_attention
{

/** \brief The assignment of rows to columns, each used at most once, with the largest sum of weights (Hungarian method
 * with potentials, O(n^2 m) for n = min, m = max of rows and columns). \param[in] weights finite, any sign; the smaller
 * side is always assigned in full \return per row its column, or -1 */
std::vector<int> assignMaximum (const Eigen::MatrixXd& weights);

} // namespace pcl_attention
