// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/parameters.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace pcl_attention
{

/** \brief The points as Python gave them: float32 in any memory layout; other types are converted. */
using Points = pybind11::array_t<float, pybind11::array::forcecast>;

/** \brief A frame on its way through the stages, made from NumPy arrays, which are read where they are. */
class Frame
{
public:
  /** \param[in] points (height, width, 3)
   * \param[in] arguments the keyword arguments rgb, mask, sensor_origin, sensor_orientation, saliency, fixations,
   * prior_..., threads, preset, parts, and every row of the parameter table
   * \throws pybind11::value_error or pybind11::type_error that says what is wrong and what would be right */
  Frame (const Points& points, const pybind11::kwargs& arguments);

  // The pipeline cannot be moved.
  Frame (const Frame&) = delete;
  Frame& operator= (const Frame&) = delete;

  Points points;
  int width{0}, height{0};
  AttentionPipeline pipeline;
};

/** \brief The parameters that the keyword arguments preset, parts and those of the parameter table ask for.
 * \throws pybind11::value_error or pybind11::type_error */
AttentionParameters parametersOf (const pybind11::kwargs& arguments);

} // namespace pcl_attention
