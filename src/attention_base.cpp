// SPDX-License-Identifier: BSD-3-Clause
#include "instantiations.h"
#include <pcl/segmentation/impl/attention_base.hpp>

PCL_INSTANTIATE (AttentionBase, PCL_ATTENTION_POINT_TYPES)
