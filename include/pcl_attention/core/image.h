// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_attention
{

/** \brief A row-major image of any value. */
template <typename T>
struct Image
{
  int width{0};        /**< columns */
  int height{0};       /**< rows */
  std::vector<T> data; /**< width * height values, row by row */

  Image () = default;
  Image (int columns, int rows, const T& value = T ()) { assign (columns, rows, value); }

  void
  assign (int columns, int rows, const T& value = T ())
  {
    width = columns;
    height = rows;
    data.assign (static_cast<std::size_t> (columns) * rows, value);
  }

  /** \brief Set the size; the values are not defined. */
  void
  resize (int columns, int rows)
  {
    width = columns;
    height = rows;
    data.resize (static_cast<std::size_t> (columns) * rows);
  }

  std::size_t
  size () const { return (data.size ()); }

  bool
  contains (int column, int row) const { return (column >= 0 && column < width && row >= 0 && row < height); }

  T&
  operator() (int column, int row) { return (data[static_cast<std::size_t> (row) * width + column]); }

  const T&
  operator() (int column, int row) const { return (data[static_cast<std::size_t> (row) * width + column]); }

  T&
  operator[] (std::size_t index) { return (data[index]); }

  const T&
  operator[] (std::size_t index) const { return (data[index]); }
};

} // namespace pcl_attention
