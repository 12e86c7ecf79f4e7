// SPDX-License-Identifier: BSD-3-Clause
#include "instantiations.h"
#include <pcl/segmentation/impl/attention_filter.hpp>

// What the filter calls of these two classes would be hidden here, and the linker would hide the exported ones with it.
#define PCL_INSTANTIATE_ExternClasses(T)                                                                               \
  extern template class PCL_ATTENTION_EXPORTS pcl::AttentionSegmentation<T>;                                           \
  extern template class PCL_ATTENTION_EXPORTS pcl::SymmetrySaliencyEstimation<T>;
PCL_INSTANTIATE (ExternClasses, PCL_ATTENTION_POINT_TYPES)

PCL_INSTANTIATE (AttentionFilter, PCL_ATTENTION_POINT_TYPES)
