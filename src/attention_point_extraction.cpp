// SPDX-License-Identifier: BSD-3-Clause
#include "instantiations.h"
#include <pcl/segmentation/impl/attention_point_extraction.hpp>

PCL_INSTANTIATE (AttentionPointExtraction, PCL_ATTENTION_POINT_TYPES)
