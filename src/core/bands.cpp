// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/bands.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pcl_attention
{

void
forEachBand (int height, int band_height, [[maybe_unused]] int threads, const std::function<void (int begin, int end)>& work)
{
  const auto bands = static_cast<std::size_t> ((height + band_height - 1) / band_height);
  std::exception_ptr error; // none may leave a thread of the team
  std::mutex mutex;
  const auto band = [&] (std::size_t index) {
    const int begin = static_cast<int> (index) * band_height;
    try
    {
      work (begin, std::min (height, begin + band_height));
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock (mutex);
      error = std::current_exception ();
    }
  };
#ifdef _OPENMP
  if (omp_in_parallel ())
  {
    std::atomic<std::size_t> next{0}; // tasks begin in any order; where the bands differ the largest are the first
#pragma omp taskloop grainsize(1) shared(next)
    for (std::size_t index = 0; index < bands; ++index)
      band (next++);
  }
  else
  {
    const int team = threads > 0 ? threads : omp_get_num_procs ();
#pragma omp parallel for num_threads(team) schedule(dynamic, 1)
    for (std::size_t index = 0; index < bands; ++index)
      band (index);
  }
#else
  for (std::size_t index = 0; index < bands; ++index)
    band (index);
#endif
  if (error)
    std::rethrow_exception (error);
}

} // namespace pcl_attention
