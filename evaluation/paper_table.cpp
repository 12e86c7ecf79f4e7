// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/paper_table.h"

#include <map>

namespace pcl_attention
{

const PaperRow*
paperRow (const std::string& system)
{
  static const std::map<std::string, PaperRow> rows{
      {"M09+TJ3D", {{{.59, .07}, {.60, .06}, {.59, .07}}, {{.76, .05}, {.78, .04}, {.76, .05}}}},
      {"M09+WTA2D", {{{.54, .07}, {.65, .05}, {.52, .06}}, {{.68, .07}, {.85, .02}, {.72, .05}}}},
      {"M09+WTA3D", {{{.57, .07}, {.62, .06}, {.58, .06}}, {{.74, .05}, {.80, .04}, {.75, .05}}}},
      {"M11", {{{.57, .08}, {.66, .06}, {.62, .07}}, {{.82, .06}, {.88, .03}, {.86, .04}}}},
      {"G10", {{{.47, .08}, {.50, .08}, {.47, .08}}, {{.66, .08}, {.71, .06}, {.68, .07}}}},
      {"proposed", {{{.80, .05}, {.81, .04}, {.80, .04}}, {{.964, .010}, {.974, .010}, {.970, .011}}}}};
  const auto row = rows.find (system == "paper" ? "proposed" : system);
  return (row == rows.end () ? nullptr : &row->second);
}

} // namespace pcl_attention
