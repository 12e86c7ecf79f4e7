// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/metrics.h"

#include <ostream>
#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief Tables for people: F of the segments, attention, and label image, a line a group.
 * \param[in] summaries of one ground truth */
void printTables (std::ostream& stream, const std::vector<Summary>& summaries);

/** \brief The same for programs: one row a summary with all its figures; what is NaN is left empty. */
void writeSummaryCsv (std::ostream& stream, const std::vector<Summary>& summaries);

/** \brief One row an object (or part) of every scene. */
void writeObjectsCsv (std::ostream& stream, const std::vector<SceneScore>& scenes);

} // namespace pcl_attention
