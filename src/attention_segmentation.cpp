// SPDX-License-Identifier: BSD-3-Clause
#include "instantiations.h"
#include <pcl/segmentation/impl/attention_segmentation.hpp>

PCL_INSTANTIATE (AttentionSegmentation, PCL_ATTENTION_POINT_TYPES)
