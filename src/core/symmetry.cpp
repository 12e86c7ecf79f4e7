// SPDX-License-Identifier: BSD-3-Clause
#include "instruction_set.h"
#include "surface_rows.h"

#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/symmetry.h>

#include <memory>

namespace pcl_attention
{

namespace
{

/** \brief Room for the samples of a window, aligned for every instruction set. */
class SampleMemory
{
public:
  explicit SampleMemory (std::size_t count) : memory_ (count + alignment / sizeof (float))
  {
    void* first = memory_.data ();
    std::size_t space = memory_.size () * sizeof (float);
    first_ = static_cast<float*> (std::align (alignment, count * sizeof (float), first, space));
  }

  float*
  data () { return (first_); }

private:
  static constexpr std::size_t alignment = 64;
  std::vector<float> memory_;
  float* first_;
};

} // namespace

void
computeSymmetry (const OrganizedCloud& cloud, const NormalImage& normals, const SaliencyParameters& parameters, int threads,
                 SymmetryMap& map)
{
  map.symmetry.resize (cloud.width, cloud.height);
  map.winning_axis.resize (cloud.width, cloud.height);
  const LaneKernels& kernels = laneKernels ();
  const int radius = parameters.window_radius;
  const SymmetrySettings settings{radius, parameters.distance_scale, parameters.convexity_gate};
  constexpr int band_height = 24;
  forEachBand (cloud.height, band_height, threads, [&] (int begin, int end) {
    SurfaceRows ring (2 * radius + 1, cloud.width, radius, radius + kernels.lanes);
    SampleMemory samples (static_cast<std::size_t> (4 * radius * radius) * 6 * kernels.lanes);
    std::vector<const SurfaceRow*> around (2 * radius + 1);
    int filled = begin - radius;
    for (int row = begin; row < end; ++row)
    {
      for (; filled <= row + radius; ++filled)
        if (filled >= 0 && filled < cloud.height)
          kernels.fillRow (storedRow (cloud, normals, filled), cloud.width, ring.at (filled + radius));
        else
          ring.clear (filled + radius);
      for (int step = 0; step <= 2 * radius; ++step)
        around[step] = &ring.at (row + step);
      const std::size_t at = static_cast<std::size_t> (row) * cloud.width;
      kernels.symmetryOfRow (around.data (), cloud.width, settings, samples.data (), &map.symmetry[at], &map.winning_axis[at]);
    }
  });
}

} // namespace pcl_attention
