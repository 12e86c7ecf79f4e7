// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/statistics.h"

#include <string>

namespace pcl_attention
{

/** \brief F over the objects of one data set, as a row of the paper's Table I has it. */
struct PaperFigures
{
  Distribution all, best, first;
};

/** \brief A row of the paper's Table I. */
struct PaperRow
{
  PaperFigures tosd, willow;
};

/** \brief The row of a system, or nullptr if the paper has none.
 * \param[in] system e.g. "M09+TJ3D"; "proposed" and "paper" are the paper's proposed algorithm */
const PaperRow* paperRow (const std::string& system);

} // namespace pcl_attention
