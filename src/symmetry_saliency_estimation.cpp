// SPDX-License-Identifier: BSD-3-Clause
#include "instantiations.h"
#include <pcl/segmentation/impl/symmetry_saliency_estimation.hpp>

PCL_INSTANTIATE (SymmetrySaliencyEstimation, PCL_ATTENTION_POINT_TYPES)
