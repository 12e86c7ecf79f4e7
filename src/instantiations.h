// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_base.h>

#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

#define PCL_ATTENTION_POINT_TYPES                                                                                      \
  (pcl::PointXYZ) (pcl::PointXYZRGB) (pcl::PointXYZRGBA) (pcl::PointXYZRGBNormal) (pcl::PointXYZRGBL)

// The base is instantiated in attention_base.cpp alone. Implicit copies beside the derived classes would be hidden, as
// is this library's default, and the linker would hide the exported one with them.
#define PCL_INSTANTIATE_ExternAttentionBase(T) extern template class PCL_ATTENTION_EXPORTS pcl::AttentionBase<T>;
PCL_INSTANTIATE (ExternAttentionBase, PCL_ATTENTION_POINT_TYPES)
