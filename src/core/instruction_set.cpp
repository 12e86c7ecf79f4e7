// SPDX-License-Identifier: BSD-3-Clause
#include "instruction_set.h"

#include <algorithm>
#include <atomic>

namespace pcl_attention
{

namespace baseline
{
extern const LaneKernels kernels;
}
#ifdef PCL_ATTENTION_DISPATCH
namespace avx2
{
extern const LaneKernels kernels;
}
namespace avx512
{
extern const LaneKernels kernels;
}
#endif

namespace
{

struct Available
{
  const char* name;
  const LaneKernels* kernels;
};

std::vector<Available>
available ()
{
  std::vector<Available> sets{{"baseline", &baseline::kernels}};
#ifdef PCL_ATTENTION_DISPATCH
  __builtin_cpu_init ();
  if (__builtin_cpu_supports ("avx2"))
    sets.push_back ({"avx2", &avx2::kernels});
  if (__builtin_cpu_supports ("avx512f") && __builtin_cpu_supports ("avx512dq") && __builtin_cpu_supports ("avx512bw") &&
      __builtin_cpu_supports ("avx512vl"))
    sets.push_back ({"avx512", &avx512::kernels});
#endif
  return (sets);
}

std::atomic<const LaneKernels*>&
chosen ()
{
  static std::atomic<const LaneKernels*> kernels{available ().back ().kernels};
  return (kernels);
}

} // namespace

const LaneKernels&
laneKernels ()
{
  return (*chosen ().load ());
}

std::vector<std::string>
instructionSets ()
{
  std::vector<std::string> names;
  for (const Available& set : available ())
    names.emplace_back (set.name);
  return (names);
}

bool
useInstructionSet (const std::string& name)
{
  const std::vector<Available> sets = available ();
  const auto set = std::find_if (sets.begin (), sets.end (), [&] (const Available& s) { return (s.name == name); });
  if (set == sets.end ())
    return (false);
  chosen () = set->kernels;
  return (true);
}

} // namespace pcl_attention
