// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief Register a measurement of the time for one frame, the mean over all of them, in wall time (Time) and in the time
  * of all threads together (CPU).
  * \param[in] frames must outlive the measurement
  * \param[in] work takes one of the frames */
template <typename Frame, typename Work> void
measure (const std::string& name, const std::vector<Frame>& frames, const Work& work)
{
  benchmark::RegisterBenchmark (name.c_str (),
                                [&frames, work] (benchmark::State& state) {
                                  while (state.KeepRunningBatch (static_cast<benchmark::IterationCount> (frames.size ())))
                                    for (const Frame& frame : frames)
                                      work (frame);
                                })
      ->Unit (benchmark::kMillisecond)
      ->MeasureProcessCPUTime ()
      ->UseRealTime ();
}

} // namespace pcl_attention
