// SPDX-License-Identifier: BSD-3-Clause
#include "image_outline.h"
#include "point_at.h"

#include <boost/geometry/algorithms/area.hpp>
#include <boost/geometry/algorithms/convex_hull.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <algorithm>
#include <limits>

namespace pcl_attention
{

namespace
{

/** \brief Row and column, in the order that Boost sorts by. */
using Corner = boost::geometry::model::d2::point_xy<int>;

constexpr std::pair<int, int> nothing{std::numeric_limits<int>::max (), std::numeric_limits<int>::min ()};

int
floorOfQuotient (int numerator, int positive)
{
  const int quotient = numerator / positive;
  return (numerator % positive < 0 ? quotient - 1 : quotient);
}

void
reachTo (int first, int last, std::pair<int, int>& columns)
{
  columns.first = std::min (columns.first, first);
  columns.second = std::max (columns.second, last + 1);
}

/** \brief Let the rows of a polygon's edge reach to it. */
void
reachTo (Corner from, Corner to, RowSpans& spans)
{
  if (from.x () > to.x ())
    std::swap (from, to);
  const int width = to.y () - from.y (), height = to.x () - from.x ();
  for (int row = from.x (); row <= to.x (); ++row)
  {
    const int shift = height == 0 ? 0 : (row - from.x ()) * width;
    reachTo (from.y () - floorOfQuotient (-shift, std::max (1, height)), from.y () + floorOfQuotient (shift, std::max (1, height)),
             spans.columns[row - spans.first_row]);
  }
}

/** \brief What lies between the outermost columns of all in each row. */
RowSpans
united (const std::vector<const RowSpans*>& all)
{
  RowSpans spans;
  int first = std::numeric_limits<int>::max (), last = -1;
  for (const RowSpans* one : all)
  {
    first = std::min (first, one->first_row);
    last = std::max (last, one->first_row + static_cast<int> (one->columns.size ()) - 1);
  }
  if (last < first)
    return (spans);
  spans.first_row = first;
  spans.columns.assign (last + 1 - first, nothing);
  for (const RowSpans* one : all)
    for (std::size_t row = 0; row < one->columns.size (); ++row)
      if (const auto& [begin, end] = one->columns[row]; begin < end)
        reachTo (begin, end - 1, spans.columns[one->first_row - first + static_cast<int> (row)]);
  return (spans);
}

} // namespace

RowSpans
rowsOf (const pcl::Indices& pixels, int width)
{
  RowSpans spans;
  if (pixels.empty ())
    return (spans);
  spans.first_row = pixels.front () / width;
  spans.columns.resize (pixels.back () / width + 1 - spans.first_row);
  for (std::size_t i = 0; i < pixels.size (); ++i)
    if (isRowEnd (pixels, i, width))
    {
      auto& [begin, end] = spans.columns[pixels[i] / width - spans.first_row];
      const int column = pixels[i] % width;
      if (begin == end)
        begin = column;
      end = column + 1;
    }
  return (spans);
}

RowSpans
convexOutline (const std::vector<const RowSpans*>& all)
{
  RowSpans spans = united (all);
  boost::geometry::model::multi_point<Corner> ends;
  for (std::size_t row = 0; row < spans.columns.size (); ++row)
    if (const auto& [begin, end] = spans.columns[row]; begin < end)
      for (const int column : {begin, end - 1})
        ends.emplace_back (spans.first_row + static_cast<int> (row), column);
  boost::geometry::model::ring<Corner> corners; // closed
  boost::geometry::convex_hull (ends, corners);
  if (boost::geometry::area (corners) == 0.0)
    return {};
  std::fill (spans.columns.begin (), spans.columns.end (), nothing);
  for (std::size_t corner = 1; corner < corners.size (); ++corner)
    reachTo (corners[corner - 1], corners[corner], spans);
  return (spans);
}

} // namespace pcl_attention
