// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pcl_attention
{

/** \brief Work on an image in bands of rows, several at a time. A stage that runs beside another one shares its bands with the
  * threads of that team, as they become free.
  * \param[in] height rows of the image
  * \param[in] band_height rows of a band: the bands do not depend on the number of threads
  * \param[in] threads number of threads, unless the caller is one of a team already
  * \param[in] work takes the first row of a band and the one behind its last, and throws nothing */
template <typename Work> void
forEachBand (int height, int band_height, [[maybe_unused]] int threads, const Work& work)
{
  const auto bands = static_cast<std::size_t> ((height + band_height - 1) / band_height);
  const auto band = [&] (std::size_t index) {
    const int begin = static_cast<int> (index) * band_height;
    work (begin, std::min (height, begin + band_height));
  };
#ifdef _OPENMP
  if (omp_in_parallel ())
  {
#pragma omp taskloop grainsize(1)
    for (std::size_t index = 0; index < bands; ++index)
      band (index);
    return;
  }
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
#endif
  for (std::size_t index = 0; index < bands; ++index)
    band (index);
}

} // namespace pcl_attention
