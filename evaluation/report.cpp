// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace pcl_attention
{
namespace
{

/** \brief A table of text: the first row is the heading, the first column is aligned to the left. */
void
printTable (std::ostream& stream, const std::vector<std::vector<std::string>>& rows)
{
  std::vector<std::size_t> widths (rows.front ().size (), 0);
  for (const auto& row : rows)
  {
    for (std::size_t column = 0; column < row.size (); ++column)
      widths[column] = std::max (widths[column], row[column].size ());
  }
  for (const auto& row : rows)
  {
    stream << "  " << std::left << std::setw (static_cast<int> (widths[0])) << row[0] << std::right;
    for (std::size_t column = 1; column < row.size (); ++column)
      stream << "  " << std::setw (static_cast<int> (widths[column])) << row[column];
    stream << '\n';
  }
}

std::string
csvPair (const Distribution& distribution)
{
  return (csvNumber (distribution.mean) + ',' + csvNumber (distribution.deviation));
}

} // namespace

std::string
figureText (double value)
{
  if (std::isnan (value))
    return ("-");
  std::ostringstream stream;
  stream << std::fixed << std::setprecision (3) << value;
  return (stream.str ());
}

std::string
figureText (const Distribution& distribution)
{
  if (std::isnan (distribution.mean))
    return ("-");
  return (figureText (distribution.mean) + " +-" + figureText (distribution.deviation));
}

std::string
csvText (const std::string& text)
{
  if (text.find_first_of (",\"\r\n") == std::string::npos)
    return (text);
  std::string result = "\"";
  for (const char character : text)
    result += character == '"' ? std::string ("\"\"") : std::string (1, character);
  return (result + '"');
}

std::string
csvNumber (double number)
{
  if (std::isnan (number))
    return ("");
  std::ostringstream stream;
  stream << std::setprecision (6) << number;
  return (stream.str ());
}

void
printTables (std::ostream& stream, const std::vector<Summary>& summaries)
{
  if (summaries.empty ())
    return;
  const std::string kind = toString (summaries.front ().kind);
  std::vector<std::vector<std::string>> segments{
      {"", kind, "attended", "first", "best", "all", "strict first", "strict best", "strict all"}};
  std::vector<std::vector<std::string>> attention{{"", "coverage", "within 5", "within 10", "within n", "points/scene",
                                                   "points/object", "on " + kind, "on support", "on invalid",
                                                   "duplicate"}};
  std::vector<std::vector<std::string>> labels{
      {"", "scenes", "overlap P", "overlap R", "overlap F", "best of scene", "centre F", "confidence rho"}};
  for (const Summary& s : summaries)
  {
    segments.push_back ({s.group, std::to_string (s.objects), std::to_string (s.attended), figureText (s.attended_first),
                         figureText (s.attended_best), figureText (s.attended_all), figureText (s.strict_first),
                         figureText (s.strict_best), figureText (s.strict_all)});
    attention.push_back ({s.group, figureText (s.coverage), figureText (s.hits_within_5), figureText (s.hits_within_10),
                          figureText (s.hits_within_objects), figureText (s.points_per_scene), figureText (s.points_per_object),
                          figureText (s.points_on_objects), figureText (s.points_on_support), figureText (s.points_on_invalid),
                          figureText (s.points_duplicate)});
    labels.push_back ({s.group, std::to_string (s.scenes), figureText (s.overlap.precision), figureText (s.overlap.recall),
                       figureText (s.overlap.f), figureText (s.best_of_scene), figureText (s.center),
                       figureText (s.confidence_correlation)});
  }
  stream << "Ground truth: " << kind
         << (summaries.front ().kind == GroundTruthKind::objects ? " (label / 10)\n\n" : " (raw label)\n\n");
  stream << "F, mean +-deviation over the " << kind
         << " with an attention point; strict: over all, 0 without a point\n";
  printTable (stream, segments);
  stream << "\nAttention: share of the " << kind << " hit by any, the first 5, 10, n = " << kind
         << " in the scene points; where the points lie\n";
  printTable (stream, attention);
  stream << "\nOverlap of the label image (Hungarian matching); F of the best segment of the scene, of the segment "
            "under the "
            "centre\n";
  printTable (stream, labels);
  stream << '\n';
}

std::string
summaryCsvHeader ()
{
  std::string header = "ground_truth,group,scenes,objects,attended,points";
  for (const char* name : {"attended_first", "attended_best", "attended_all", "strict_first", "strict_best",
                           "strict_all", "best_of_scene", "center"})
    header += std::string (",") + name + "_f," + name + "_f_deviation";
  return (header +
          ",coverage,hits_within_5,hits_within_10,hits_within_objects,points_per_scene,points_per_object,"
          "points_on_objects,points_on_support,points_on_invalid,points_duplicate,overlap_precision,overlap_recall,"
          "overlap_f,confidence_correlation");
}

std::string
summaryCsvRow (const Summary& s)
{
  std::ostringstream stream;
  stream << toString (s.kind) << ',' << csvText (s.group) << ',' << s.scenes << ',' << s.objects << ',' << s.attended
         << ',' << s.points;
  for (const Distribution& distribution : {s.attended_first, s.attended_best, s.attended_all, s.strict_first,
                                           s.strict_best, s.strict_all, s.best_of_scene, s.center})
    stream << ',' << csvPair (distribution);
  for (const double number :
       {s.coverage, s.hits_within_5, s.hits_within_10, s.hits_within_objects, s.points_per_scene, s.points_per_object,
        s.points_on_objects, s.points_on_support, s.points_on_invalid, s.points_duplicate, s.overlap.precision,
        s.overlap.recall, s.overlap.f, s.confidence_correlation})
    stream << ',' << csvNumber (number);
  return (stream.str ());
}

std::string
objectCsvHeader ()
{
  return ("scene,category,ground_truth,object,pixels,center_column,center_row,attended,points,first_rank,"
          "first_precision,first_recall,first_f,best_f,all_f,best_of_scene_f,center_f");
}

std::string
objectCsvRow (const SceneScore& scene, const RegionScore& r)
{
  std::ostringstream stream;
  stream << csvText (scene.name) << ',' << csvText (scene.category) << ',' << toString (scene.kind) << ','
         << r.region.label << ',' << r.region.pixels << ',' << r.region.center_column << ',' << r.region.center_row
         << ',' << (r.attended () ? 1 : 0) << ',' << r.points << ',';
  if (r.attended ())
    stream << r.first_rank;
  for (const double number :
       {r.first.precision, r.first.recall, r.first.f, r.best.f, r.all_f, r.best_of_scene_f, r.center_f})
    stream << ',' << csvNumber (number);
  return (stream.str ());
}

void
writeSummaryCsv (std::ostream& stream, const std::vector<Summary>& summaries)
{
  stream << summaryCsvHeader () << '\n';
  for (const Summary& summary : summaries)
    stream << summaryCsvRow (summary) << '\n';
}

void
writeObjectsCsv (std::ostream& stream, const std::vector<SceneScore>& scenes)
{
  stream << objectCsvHeader () << '\n';
  for (const SceneScore& scene : scenes)
    for (const RegionScore& region : scene.regions)
      stream << objectCsvRow (scene, region) << '\n';
}

} // namespace pcl_attention
