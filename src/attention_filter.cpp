// SPDX-License-Identifier: BSD-3-Clause
#include "instantiations.h"
#include <pcl/segmentation/impl/attention_filter.hpp>

PCL_INSTANTIATE (AttentionFilter, PCL_ATTENTION_POINT_TYPES)
