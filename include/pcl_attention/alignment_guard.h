// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/version.h>

#include <Eigen/Core>

// Eigen's alignment, and with it the way memory is allocated, follows the architecture flags. What one side allocated
// and the other frees aborts with "double free" where the two differ: better no program than such a one.
#if EIGEN_MAX_ALIGN_BYTES != PCL_ATTENTION_EIGEN_ALIGNMENT ||                                                          \
    (EIGEN_DEFAULT_ALIGN_BYTES != PCL_ATTENTION_EIGEN_ALIGNMENT && !EIGEN_MALLOC_ALREADY_ALIGNED)
// clang-format off
#error "pcl_attention and PCL were built with another Eigen alignment than this program: compile it with their flags. \
Debian's are without -march=native, -mavx and the like, or with -DEIGEN_MAX_ALIGN_BYTES=16 -DEIGEN_MALLOC_ALREADY_ALIGNED=1 added."
// clang-format on
#endif
