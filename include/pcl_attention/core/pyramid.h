// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/image.h>
#include <pcl_attention/core/organized_cloud.h>

namespace pcl_attention
{

/** \brief Halve a cloud and its normals with the binomial kernel [1 3 3 1] over valid points only (paper III-B). The kernel lies
  * between the pixels 2c and 2c+1, so that halving commutes with mirroring wherever the size is even.
  * A coarse point is valid when the fine pixels under it are valid by at least half of the kernel's weight. */
PCL_ATTENTION_EXPORTS void
halve (const OrganizedCloud& cloud, const NormalImage& normals, int threads, OrganizedCloud& half_cloud,
       NormalImage& half_normals);

/** \brief A level of the pyramid above the finest. */
struct PyramidLevel
{
  OrganizedCloud cloud;
  NormalImage normals;
};

/** \brief Columns or rows that are left of some after halving them again and again. */
inline int
halvedSize (int size, int times)
{
  for (; times > 0; --times)
    size = (size + 1) / 2;
  return (size);
}

/** \brief Halve again and again.
  * \param[in] count how many times, from 0
  * \return the levels, the half size first */
PCL_ATTENTION_EXPORTS std::vector<PyramidLevel>
coarserLevels (const OrganizedCloud& cloud, const NormalImage& normals, int count, int threads);

/** \brief Bilinear up-sampling of a pyramid level's map to the next finer size (inverse of \ref halve's sampling).
  * \param[in] width,height the finer size */
PCL_ATTENTION_EXPORTS Image<float>
doubleSize (const Image<float>& map, int width, int height, int threads);

/** \brief Mean over a (2 radius + 1) square, over the pixels inside the image. */
PCL_ATTENTION_EXPORTS Image<float>
boxBlur (const Image<float>& map, int radius, int threads);

} // namespace pcl_attention
