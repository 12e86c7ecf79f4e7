// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/export.h>

#include <pcl/types.h>

#include <utility>
#include <vector>

namespace pcl_attention
{

/** \brief What lies between two columns in some rows of an image. */
struct RowSpans
{
  int first_row{0};
  std::vector<std::pair<int, int>> columns; /**< of every row the first one and the one behind the last, equal where nothing is */

  bool
  contains (int column, int row) const
  {
    const int place = row - first_row;
    return (place >= 0 && place < static_cast<int> (columns.size ()) && column >= columns[place].first &&
            column < columns[place].second);
  }
};

/** \brief Some pixels and all between them in a row.
  * \param[in] pixels ascending
  * \param[in] width of the image */
PCL_ATTENTION_EXPORTS RowSpans
rowsOf (const pcl::Indices& pixels, int width);

/** \brief The pixels within the convex hull of all; none where that has no area. */
PCL_ATTENTION_EXPORTS RowSpans
convexOutline (const std::vector<const RowSpans*>& all);

} // namespace pcl_attention
