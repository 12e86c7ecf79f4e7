// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace pcl_attention
{
namespace
{

constexpr int left = 60, top = 12, plot_width = 480, plot_height = 280, legend_width = 250, line_height = 20;

/** \brief A coordinate, in tenths of a pixel. */
std::string
at (double value)
{
  std::array<char, 32> text;
  std::snprintf (text.data (), text.size (), "%.1f", value);
  return (text.data ());
}

/** \brief A number beside a grid line. */
std::string
tick (double value)
{
  std::array<char, 32> text;
  std::snprintf (text.data (), text.size (), "%.6g", std::round (1e4 * value) / 1e4);
  return (text.data ());
}

std::string
text (double x, double y, const std::string& anchor, const std::string& content, const std::string& more = "")
{
  return ("<text x=\"" + at (x) + "\" y=\"" + at (y) + "\" text-anchor=\"" + anchor + "\"" + more + ">" +
          escapeMarkup (content) + "</text>\n");
}

std::string
line (double x1, double y1, double x2, double y2, const std::string& style)
{
  return ("<line x1=\"" + at (x1) + "\" y1=\"" + at (y1) + "\" x2=\"" + at (x2) + "\" y2=\"" + at (y2) + "\" " + style +
          "/>\n");
}

std::string
rectangle (double x, double y, double width, double height, const std::string& color, const std::string& title = "")
{
  return ("<rect x=\"" + at (x) + "\" y=\"" + at (y) + "\" width=\"" + at (width) + "\" height=\"" + at (height) +
          "\" fill=\"" + color + "\"><title>" + escapeMarkup (title) + "</title></rect>\n");
}

std::string
svg (int width, int height, const std::string& content)
{
  const std::string size = std::to_string (width) + " " + std::to_string (height);
  return ("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size + "\" width=\"" + std::to_string (width) +
          "\" height=\"" + std::to_string (height) + "\" font-size=\"13\" font-family=\"sans-serif\">\n" + content +
          "</svg>\n");
}

std::string
strokeOf (const Curve& curve)
{
  return ("stroke=\"" + chartColor (curve.color) + "\" stroke-width=\"2\" fill=\"none\"" +
          (curve.dashed ? " stroke-dasharray=\"6 4\"" : ""));
}

/** \brief A round number of which at most six are in a range that starts at 0. */
double
roundStep (double range)
{
  const double power = std::pow (10.0, std::floor (std::log10 (range / 6)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (range / (factor * power) <= 6)
      return (factor * power);
  return (10 * power);
}

} // namespace

std::string
escapeMarkup (const std::string& text)
{
  std::string escaped;
  for (const char character : text)
    switch (character)
    {
    case '&':
      escaped += "&amp;";
      break;
    case '<':
      escaped += "&lt;";
      break;
    case '>':
      escaped += "&gt;";
      break;
    case '"':
      escaped += "&quot;";
      break;
    default:
      escaped += character;
    }
  return (escaped);
}

std::string
chartColor (int index)
{
  // Okabe and Ito's
  static const std::array<const char*, 8> colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                 "#e69f00", "#56b4e9", "#999999", "#000000"};
  return (colors[static_cast<std::size_t> (index) % colors.size ()]);
}

std::string
lineChart (const Axis& x, const Axis& y, const std::vector<Curve>& curves)
{
  const auto column = [&] (double value) { return (left + (value - x.from) / (x.to - x.from) * plot_width); };
  const auto row = [&] (double value) { return (top + (y.to - value) / (y.to - y.from) * plot_height); };
  const std::string grid = "stroke=\"#dddddd\"";
  std::string content;
  for (int i = 0; x.from + i * x.step <= x.to + 1e-9; ++i)
  {
    const double value = x.from + i * x.step;
    content += line (column (value), top, column (value), top + plot_height, grid) +
               text (column (value), top + plot_height + 18, "middle", tick (value));
  }
  for (int i = 0; y.from + i * y.step <= y.to + 1e-9; ++i)
  {
    const double value = y.from + i * y.step;
    content += line (left, row (value), left + plot_width, row (value), grid) +
               text (left - 8, row (value) + 4, "end", tick (value));
  }
  content += text (left + plot_width / 2.0, top + plot_height + 40, "middle", x.title) +
             text (-top - plot_height / 2.0, 16, "middle", y.title, " transform=\"rotate(-90)\"");
  const int legend = left + plot_width + 20;
  int legend_row = top + 10;
  for (const Curve& curve : curves)
  {
    std::string points;
    for (const auto& [px, py] : curve.points)
      points += at (column (px)) + "," + at (row (std::min (std::max (py, y.from), y.to))) + " ";
    content += "<polyline points=\"" + points + "\" " + strokeOf (curve) + "/>\n";
    for (const auto& [px, py] : curve.points)
      if (curve.markers && py >= y.from && py <= y.to)
        content += "<circle cx=\"" + at (column (px)) + "\" cy=\"" + at (row (py)) + "\" r=\"3.5\" fill=\"" +
                   chartColor (curve.color) + "\"><title>" + tick (px) + ": " + tick (py) + "</title></circle>\n";
    content += line (legend, legend_row, legend + 26, legend_row, strokeOf (curve)) +
               text (legend + 34, legend_row + 4, "start", curve.name);
    legend_row += line_height;
  }
  return (svg (legend + legend_width, std::max (top + plot_height + 50, legend_row), content));
}

std::string
barChart (const std::string& unit, const std::vector<Bar>& bars)
{
  constexpr int names = 130, bar_height = 18;
  double longest = 0;
  std::vector<std::string> stages;
  for (const Bar& bar : bars)
  {
    double sum = 0;
    for (const auto& [stage, value] : bar.parts)
    {
      sum += value;
      if (std::find (stages.begin (), stages.end (), stage) == stages.end ())
        stages.push_back (stage);
    }
    longest = std::max (longest, sum);
  }
  if (!(longest > 0))
    longest = 1;
  const double step = roundStep (longest), to = std::ceil (longest / step) * step;
  const auto column = [&] (double value) { return (names + value / to * plot_width); };
  const int bottom = top + static_cast<int> (bars.size ()) * (bar_height + 10);
  std::string content;
  for (int i = 0; i * step <= to + 1e-9 * to; ++i)
    content += line (column (i * step), top, column (i * step), bottom, "stroke=\"#dddddd\"") +
               text (column (i * step), bottom + 18, "middle", tick (i * step));
  content += text (names + plot_width / 2.0, bottom + 40, "middle", unit);
  for (std::size_t i = 0; i < bars.size (); ++i)
  {
    const double y = top + 4 + static_cast<double> (i) * (bar_height + 10);
    content += text (names - 8, y + 14, "end", bars[i].name);
    double sum = 0;
    for (const auto& [stage, value] : bars[i].parts)
    {
      const auto color = static_cast<int> (std::find (stages.begin (), stages.end (), stage) - stages.begin ());
      content += rectangle (column (sum), y, column (sum + value) - column (sum), bar_height, chartColor (color),
                            stage + ": " + tick (value) + " " + unit);
      sum += value;
    }
    content += text (column (sum) + 5, y + 14, "start", tick (std::round (10 * sum) / 10));
  }
  const int legend = names + plot_width + 70;
  for (std::size_t i = 0; i < stages.size (); ++i)
  {
    const double y = top + static_cast<double> (i) * line_height;
    content += rectangle (legend, y, 14, 14, chartColor (static_cast<int> (i))) +
               text (legend + 22, y + 12, "start", stages[i]);
  }
  return (svg (legend + 150, std::max (bottom + 50, top + static_cast<int> (stages.size ()) * line_height), content));
}

} // namespace pcl_attention
