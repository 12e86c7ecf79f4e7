// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pcl_attention
{

/** \brief One axis of a chart. */
struct Axis
{
  std::string title;
  double from = 0, to = 1, step = 0.2; ///< range, and distance of the grid lines
};

/** \brief One line of a chart. */
struct Curve
{
  std::string name;
  std::vector<std::pair<double, double>> points;
  int color = 0; ///< index of a palette that colour-blind people can tell apart
  bool dashed = false;
  bool markers = true; ///< a dot at every point
};

/** \brief Times of the stages of one system. */
struct Bar
{
  std::string name;
  std::vector<std::pair<std::string, double>> parts; ///< stacked from left to right, each at least 0
};

/** \brief A text in which nothing is taken for markup. */
std::string escapeMarkup (const std::string& text);

/** \brief The colour of a curve or a part, e.g. "#0072b2". */
std::string chartColor (int index);

/** \brief Curves over a grid with a legend, as an SVG element. */
std::string lineChart (const Axis& x, const Axis& y, const std::vector<Curve>& curves);

/** \brief Stacked horizontal bars with a legend of the parts, as an SVG element.
 * \param[in] unit of the parts */
std::string barChart (const std::string& unit, const std::vector<Bar>& bars);

} // namespace pcl_attention
