// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

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
  const int bands = (height + band_height - 1) / band_height;
  const auto band = [&] (int index) { work (index * band_height, std::min (height, (index + 1) * band_height)); };
#ifdef _OPENMP
  if (omp_in_parallel ())
  {
#pragma omp taskloop grainsize(1)
    for (int index = 0; index < bands; ++index)
      band (index);
    return;
  }
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
#endif
  for (int index = 0; index < bands; ++index)
    band (index);
}

} // namespace pcl_attention
