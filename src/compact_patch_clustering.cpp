// SPDX-License-Identifier: BSD-3-Clause
#include "instantiations.h"
#include <pcl/segmentation/impl/compact_patch_clustering.hpp>

PCL_INSTANTIATE (CompactPatchClustering, PCL_ATTENTION_POINT_TYPES)
