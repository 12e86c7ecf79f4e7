// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/metrics.h"

#include "evaluation/matching.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace pcl_attention
{
namespace
{

/** \brief How the segments of a label image and the regions of the ground truth overlap, in valid pixels. */
struct LabelOverlap
{
  std::map<std::uint32_t, int> index_of_label; ///< labels of at least one valid pixel, without 0
  std::vector<std::size_t> segment_pixels;
  Eigen::MatrixXd common; ///< pixels, segments x regions
  Eigen::MatrixXd f;      ///< F of each pair
};

LabelOverlap
overlapOfLabels (const GroundTruth& truth, const std::vector<std::uint32_t>& labels)
{
  if (labels.size () != truth.region_of.size ())
    throw std::invalid_argument ("the label image has another size than the ground truth");

  const auto isCounted = [&] (std::size_t pixel) {
    return (labels[pixel] != 0 && truth.region_of[pixel] != GroundTruth::invalid);
  };

  LabelOverlap overlap;
  for (std::size_t pixel = 0; pixel < labels.size (); ++pixel)
  {
    if (isCounted (pixel))
      overlap.index_of_label.emplace (labels[pixel], static_cast<int> (overlap.index_of_label.size ()));
  }
  const int segments = static_cast<int> (overlap.index_of_label.size ());
  const int regions = static_cast<int> (truth.regions.size ());
  overlap.segment_pixels.assign (segments, 0);
  overlap.common = Eigen::MatrixXd::Zero (segments, regions);
  for (std::size_t pixel = 0; pixel < labels.size (); ++pixel)
  {
    if (!isCounted (pixel))
      continue;
    const int segment = overlap.index_of_label[labels[pixel]];
    ++overlap.segment_pixels[segment];
    if (truth.region_of[pixel] >= 0)
      ++overlap.common (segment, truth.region_of[pixel]);
  }

  overlap.f.resize (segments, regions);
  for (int segment = 0; segment < segments; ++segment)
  {
    for (int region = 0; region < regions; ++region)
      overlap.f (segment, region) = overlapOf (static_cast<std::size_t> (overlap.common (segment, region)),
                                               overlap.segment_pixels[segment], truth.regions[region].pixels)
                                        .f;
  }
  return (overlap);
}

Overlap
matchedOverlap (const GroundTruth& truth, const LabelOverlap& labels)
{
  Overlap overlap;
  const bool predicted = !labels.segment_pixels.empty (), present = !truth.regions.empty ();
  if (!predicted || !present)
  {
    overlap.precision = predicted ? 0 : 1;
    overlap.recall = present ? 0 : 1;
    overlap.f = predicted == present ? 1 : 0;
    return (overlap);
  }

  const std::vector<int> region_of_segment = assignMaximum (labels.f);
  double common = 0;
  std::size_t segment_pixels = 0, region_pixels = 0;
  for (std::size_t segment = 0; segment < labels.segment_pixels.size (); ++segment)
  {
    segment_pixels += labels.segment_pixels[segment];
    if (region_of_segment[segment] >= 0)
      common += labels.common (segment, region_of_segment[segment]);
  }
  for (const Region& region : truth.regions)
    region_pixels += region.pixels;
  return (overlapOf (static_cast<std::size_t> (common), segment_pixels, region_pixels));
}

/** \brief Where the attention point of a segment lies. */
int
regionAt (const GroundTruth& truth, const PredictedSegment& segment)
{
  if (segment.column >= truth.width || segment.row < 0 || segment.row >= truth.height)
    throw std::invalid_argument ("an attention point lies outside of the image");
  return (truth.region_of[static_cast<std::size_t> (segment.row) * truth.width + segment.column]);
}

/** \brief Overlap of one mask with every region. */
std::vector<Overlap>
overlapsOfMask (const GroundTruth& truth, const pcl::Indices& mask)
{
  std::size_t mask_pixels = 0;
  std::vector<std::size_t> common (truth.regions.size (), 0);
  for (const auto pixel : mask)
  {
    if (pixel < 0 || static_cast<std::size_t> (pixel) >= truth.region_of.size ())
      throw std::invalid_argument ("a mask lies outside of the image");
    const int region = truth.region_of[pixel];
    mask_pixels += region != GroundTruth::invalid;
    if (region >= 0)
      ++common[region];
  }
  std::vector<Overlap> overlaps (truth.regions.size ());
  for (std::size_t region = 0; region < overlaps.size (); ++region)
    overlaps[region] = overlapOf (common[region], mask_pixels, truth.regions[region].pixels);
  return (overlaps);
}

/** \brief Enter a segment, in order of attention, into the score of the region its point lies on. */
void
addSegment (RegionScore& score, const SegmentScore& segment)
{
  if (!score.attended ())
  {
    score.first_rank = segment.rank;
    score.first = segment.overlap;
    score.best = segment.overlap;
  }
  if (segment.overlap.f > score.best.f)
    score.best = segment.overlap;
  ++score.points;
  score.all_f += (segment.overlap.f - score.all_f) / score.points;
}

/** \brief part / whole, NaN for nothing of nothing. */
double
ratio (std::size_t part, std::size_t whole)
{
  return (whole == 0 ? std::numeric_limits<double>::quiet_NaN () : static_cast<double> (part) / whole);
}

} // namespace

Overlap
overlapOf (std::size_t common, std::size_t predicted, std::size_t truth)
{
  Overlap overlap;
  if (common == 0)
    return (overlap);
  overlap.precision = static_cast<double> (common) / predicted;
  overlap.recall = static_cast<double> (common) / truth;
  overlap.f = 2 * overlap.precision * overlap.recall / (overlap.precision + overlap.recall);
  return (overlap);
}

Overlap
labelImageOverlap (const GroundTruth& truth, const std::vector<std::uint32_t>& labels)
{
  return (matchedOverlap (truth, overlapOfLabels (truth, labels)));
}

SceneScore
scoreScene (const GroundTruth& truth, const ScenePrediction& prediction)
{
  if (prediction.width != truth.width || prediction.height != truth.height)
    throw std::invalid_argument ("the prediction has another size than the ground truth");

  SceneScore score;
  score.kind = truth.kind;
  for (const Region& region : truth.regions)
  {
    score.regions.emplace_back ();
    score.regions.back ().region = region;
  }

  for (const PredictedSegment& segment : prediction.segments)
  {
    const std::vector<Overlap> overlaps = overlapsOfMask (truth, segment.mask);
    for (std::size_t region = 0; region < overlaps.size (); ++region)
      score.regions[region].best_of_scene_f = std::max (score.regions[region].best_of_scene_f, overlaps[region].f);
    if (segment.column < 0)
      continue;

    SegmentScore segment_score;
    segment_score.rank = static_cast<int> (score.segments.size ()) + 1;
    segment_score.region = regionAt (truth, segment);
    segment_score.confidence = segment.confidence;
    if (segment_score.region >= 0)
    {
      segment_score.overlap = overlaps[segment_score.region];
      addSegment (score.regions[segment_score.region], segment_score);
    }
    score.segments.push_back (segment_score);
  }

  const LabelOverlap labels = overlapOfLabels (truth, prediction.labels);
  score.overlap = matchedOverlap (truth, labels);
  for (std::size_t region = 0; region < truth.regions.size (); ++region)
  {
    const Region& at = truth.regions[region];
    const auto segment = labels.index_of_label.find (
        prediction.labels[static_cast<std::size_t> (at.center_row) * truth.width + at.center_column]);
    if (segment != labels.index_of_label.end ())
      score.regions[region].center_f = labels.f (segment->second, region);
  }
  return (score);
}

Summary
summarize (const std::string& group, GroundTruthKind kind, const std::vector<SceneScore>& scenes)
{
  Summary summary;
  summary.group = group;
  summary.kind = kind;
  summary.scenes = scenes.size ();

  std::vector<double> attended_first, attended_best, attended_all, strict_first, strict_best, strict_all;
  std::vector<double> best_of_scene, center, precision, recall, f, confidence, confident_f;
  std::size_t within_5 = 0, within_10 = 0, within_objects = 0, on_objects = 0, on_support = 0;
  for (const SceneScore& scene : scenes)
  {
    const int objects = static_cast<int> (scene.regions.size ());
    for (const RegionScore& region : scene.regions)
    {
      strict_first.push_back (region.first.f);
      strict_best.push_back (region.best.f);
      strict_all.push_back (region.all_f);
      best_of_scene.push_back (region.best_of_scene_f);
      center.push_back (region.center_f);
      if (!region.attended ())
        continue;
      attended_first.push_back (region.first.f);
      attended_best.push_back (region.best.f);
      attended_all.push_back (region.all_f);
      within_5 += region.first_rank <= 5;
      within_10 += region.first_rank <= 10;
      within_objects += region.first_rank <= objects;
    }
    for (const SegmentScore& segment : scene.segments)
    {
      on_objects += segment.region >= 0;
      on_support += segment.region == GroundTruth::support;
      if (!std::isnan (segment.confidence))
      {
        confidence.push_back (segment.confidence);
        confident_f.push_back (segment.overlap.f);
      }
    }
    summary.points += scene.segments.size ();
    precision.push_back (scene.overlap.precision);
    recall.push_back (scene.overlap.recall);
    f.push_back (scene.overlap.f);
  }
  summary.objects = strict_first.size ();
  summary.attended = attended_first.size ();

  summary.attended_first = distributionOf (attended_first);
  summary.attended_best = distributionOf (attended_best);
  summary.attended_all = distributionOf (attended_all);
  summary.strict_first = distributionOf (strict_first);
  summary.strict_best = distributionOf (strict_best);
  summary.strict_all = distributionOf (strict_all);
  summary.best_of_scene = distributionOf (best_of_scene);
  summary.center = distributionOf (center);

  summary.coverage = ratio (summary.attended, summary.objects);
  summary.hits_within_5 = ratio (within_5, summary.objects);
  summary.hits_within_10 = ratio (within_10, summary.objects);
  summary.hits_within_objects = ratio (within_objects, summary.objects);

  summary.points_per_scene = ratio (summary.points, summary.scenes);
  summary.points_per_object = ratio (on_objects, summary.attended);
  summary.points_on_objects = ratio (on_objects, summary.points);
  summary.points_on_support = ratio (on_support, summary.points);
  summary.points_on_invalid = ratio (summary.points - on_objects - on_support, summary.points);
  summary.points_duplicate = ratio (on_objects - summary.attended, summary.points);

  summary.overlap.precision = distributionOf (precision).mean;
  summary.overlap.recall = distributionOf (recall).mean;
  summary.overlap.f = distributionOf (f).mean;
  summary.confidence_correlation = spearmanCorrelation (confidence, confident_f);
  return (summary);
}

std::vector<Summary>
summarizeByCategory (GroundTruthKind kind, const std::vector<SceneScore>& scenes)
{
  std::vector<SceneScore> of_kind;
  std::copy_if (scenes.begin (), scenes.end (), std::back_inserter (of_kind),
                [kind] (const SceneScore& scene) { return (scene.kind == kind); });

  std::vector<std::string> categories;
  std::map<std::string, std::vector<SceneScore>> scenes_of_category;
  for (const SceneScore& scene : of_kind)
  {
    if (scenes_of_category.count (scene.category) == 0)
      categories.push_back (scene.category);
    scenes_of_category[scene.category].push_back (scene);
  }

  std::vector<Summary> summaries{summarize ("overall", kind, of_kind)};
  if (categories.size () < 2)
    return (summaries);
  for (const std::string& category : categories)
    summaries.push_back (summarize (category, kind, scenes_of_category[category]));
  return (summaries);
}

} // namespace pcl_attention
