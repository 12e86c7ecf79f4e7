// SPDX-License-Identifier: BSD-3-Clause
#include "instantiations.h"
#include <pcl/segmentation/impl/image_symmetry_saliency_estimation.hpp>

PCL_INSTANTIATE (ImageSymmetrySaliencyEstimation, PCL_ATTENTION_POINT_TYPES)
