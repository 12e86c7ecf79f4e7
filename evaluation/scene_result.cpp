// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/scene_result.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace pcl_attention
{
namespace
{

using Json = nlohmann::ordered_json;

/** \brief A whole number that fits; Json itself would convert whatever number there is. */
template <typename Integer>
Integer
integerFromJson (const Json& json)
{
  const auto value = json.is_number_integer () ? json.get<std::int64_t> () : -1;
  const auto fitting = static_cast<Integer> (value);
  if (!json.is_number_integer () || static_cast<std::int64_t> (fitting) != value ||
      (value < 0 && std::is_unsigned<Integer>::value))
    throw std::runtime_error ("not a whole number that fits");
  return (fitting);
}

Json
overlapToJson (const Overlap& overlap)
{
  return (Json{overlap.precision, overlap.recall, overlap.f});
}

Overlap
overlapFromJson (const Json& json)
{
  Overlap overlap;
  overlap.precision = json.at (0).get<double> ();
  overlap.recall = json.at (1).get<double> ();
  overlap.f = json.at (2).get<double> ();
  return (overlap);
}

Json
segmentToJson (const SegmentScore& segment)
{
  return {{"rank", segment.rank},
          {"region", segment.region},
          {"overlap", overlapToJson (segment.overlap)},
          {"confidence", std::isnan (segment.confidence) ? Json () : Json (segment.confidence)}};
}

SegmentScore
segmentFromJson (const Json& json)
{
  SegmentScore segment;
  segment.rank = integerFromJson<int> (json.at ("rank"));
  segment.region = integerFromJson<int> (json.at ("region"));
  segment.overlap = overlapFromJson (json.at ("overlap"));
  const Json& confidence = json.at ("confidence");
  segment.confidence = confidence.is_null () ? std::numeric_limits<double>::quiet_NaN () : confidence.get<double> ();
  return (segment);
}

Json
regionToJson (const RegionScore& score)
{
  return {{"label", score.region.label},
          {"pixels", score.region.pixels},
          {"center", {score.region.center_column, score.region.center_row}},
          {"points", score.points},
          {"first_rank", score.first_rank},
          {"first", overlapToJson (score.first)},
          {"best", overlapToJson (score.best)},
          {"all_f", score.all_f},
          {"best_of_scene_f", score.best_of_scene_f},
          {"center_f", score.center_f}};
}

RegionScore
regionFromJson (const Json& json)
{
  RegionScore score;
  score.region.label = integerFromJson<std::uint32_t> (json.at ("label"));
  score.region.pixels = integerFromJson<std::size_t> (json.at ("pixels"));
  score.region.center_column = integerFromJson<int> (json.at ("center").at (0));
  score.region.center_row = integerFromJson<int> (json.at ("center").at (1));
  score.points = integerFromJson<int> (json.at ("points"));
  score.first_rank = integerFromJson<int> (json.at ("first_rank"));
  score.first = overlapFromJson (json.at ("first"));
  score.best = overlapFromJson (json.at ("best"));
  score.all_f = json.at ("all_f").get<double> ();
  score.best_of_scene_f = json.at ("best_of_scene_f").get<double> ();
  score.center_f = json.at ("center_f").get<double> ();
  return (score);
}

Json
scoreToJson (const SceneScore& score)
{
  Json segments = Json::array (), regions = Json::array ();
  for (const SegmentScore& segment : score.segments)
    segments.push_back (segmentToJson (segment));
  for (const RegionScore& region : score.regions)
    regions.push_back (regionToJson (region));
  return {{"scene", score.name},
          {"category", score.category},
          {"ground_truth", toString (score.kind)},
          {"overlap", overlapToJson (score.overlap)},
          {"segments", segments},
          {"regions", regions}};
}

SceneScore
scoreFromJson (const Json& json)
{
  SceneScore score;
  score.name = json.at ("scene").get<std::string> ();
  score.category = json.at ("category").get<std::string> ();
  score.kind = groundTruthKindFromName (json.at ("ground_truth").get<std::string> ());
  score.overlap = overlapFromJson (json.at ("overlap"));
  for (const Json& segment : json.at ("segments"))
    score.segments.push_back (segmentFromJson (segment));
  for (const Json& region : json.at ("regions"))
    score.regions.push_back (regionFromJson (region));
  return (score);
}

} // namespace

Json
sceneResultToJson (const SceneResult& result)
{
  Json scores = Json::array (), milliseconds = Json::object ();
  for (const SceneScore& score : result.scores)
    scores.push_back (scoreToJson (score));
  for (const auto& [stage, time] : result.milliseconds)
    milliseconds[stage] = time;
  return {{"checksum", result.checksum}, {"milliseconds", milliseconds}, {"scores", scores}};
}

SceneResult
sceneResultFromJson (const Json& json)
{
  SceneResult result;
  result.checksum = json.at ("checksum").get<std::string> ();
  for (const auto& [stage, time] : json.at ("milliseconds").items ())
    result.milliseconds.emplace_back (stage, time.get<double> ());
  for (const Json& score : json.at ("scores"))
    result.scores.push_back (scoreFromJson (score));
  return (result);
}

} // namespace pcl_attention
