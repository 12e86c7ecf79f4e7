// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/export.h>

#include <functional>

namespace pcl_attention
{

/** \brief Work on an image in bands of rows, several at a time. A stage that runs beside another one shares its bands with the
  * threads of that team, as they become free.
  * \param[in] height rows of the image
  * \param[in] band_height rows of a band: the bands do not depend on the number of threads; they begin in their order
  * \param[in] threads number of threads, 0: all processors, unless the caller is one of a team already
  * \param[in] work takes the first row of a band and the one behind its last; what it throws is thrown when all bands are done */
PCL_ATTENTION_EXPORTS void
forEachBand (int height, int band_height, int threads, const std::function<void (int begin, int end)>& work);

} // namespace pcl_attention
