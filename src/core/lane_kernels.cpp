// SPDX-License-Identifier: BSD-3-Clause
#include "lanes.h"
#include "lane_kernels.h"

namespace pcl_attention::PCL_ATTENTION_INSTRUCTION_SET
{

extern const LaneKernels kernels;
const LaneKernels kernels{lane_count, rowMoments, fitRow,       symmetryOfRow, fillRow,       fillSplitRow,
                          halveRow,   pointsNear, pointsOver,   nearestPlane,  lowestHeight,  farthestPoints};

} // namespace pcl_attention::PCL_ATTENTION_INSTRUCTION_SET
