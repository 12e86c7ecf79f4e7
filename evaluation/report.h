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

/** \brief The names of \ref writeSummaryCsv's values, and the values of one summary: without the end of the line. */
std::string summaryCsvHeader ();
std::string summaryCsvRow (const Summary& summary);

/** \brief The same for \ref writeObjectsCsv. */
std::string objectCsvHeader ();
std::string objectCsvRow (const SceneScore& scene, const RegionScore& region);

/** \brief A number for a CSV file, six digits, empty for NaN. */
std::string csvNumber (double number);

/** \brief A text for a CSV file, quoted where it must be (RFC 4180). */
std::string csvText (const std::string& text);

/** \brief A figure with three decimals, with its deviation where it has one; what there is no figure for is a dash. */
std::string figureText (double value);
std::string figureText (const Distribution& distribution);

} // namespace pcl_attention
