// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lane_kernels.h"

#include <pcl_attention/export.h>

#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief The inner loops in use: those of the widest instruction set that the processor has, unless \ref useInstructionSet
  * said otherwise. */
const LaneKernels&
laneKernels ();

/** \brief What \ref useInstructionSet takes here, the narrowest first: "baseline", "avx2", "avx512". */
PCL_ATTENTION_EXPORTS std::vector<std::string>
instructionSets ();

/** \brief Use the inner loops of this instruction set, for tests and measurements: the results are the same. Not while anything
  * is being computed.
  * \return false when it is not among \ref instructionSets */
PCL_ATTENTION_EXPORTS bool
useInstructionSet (const std::string& name);

} // namespace pcl_attention
