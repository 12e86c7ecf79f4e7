// SPDX-License-Identifier: BSD-3-Clause
#include "instantiations.h"
#include <pcl/segmentation/impl/planar_patch_extraction.hpp>

PCL_INSTANTIATE (PlanarPatchExtraction, PCL_ATTENTION_POINT_TYPES)
