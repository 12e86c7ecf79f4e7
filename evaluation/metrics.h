// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/ground_truth.h"
#include "evaluation/prediction.h"
#include "evaluation/statistics.h"

#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief Precision, recall and F = 2PR / (P + R), each 0 to 1; all 0 where nothing overlaps. */
struct Overlap
{
  double precision = 0;
  double recall = 0;
  double f = 0;
};

/** \brief Overlap of two pixel sets from their sizes (paper, section V.B).
 * \param[in] common    pixels in both
 * \param[in] predicted pixels of the mask
 * \param[in] truth     pixels of the ground truth */
Overlap overlapOf (std::size_t common, std::size_t predicted, std::size_t truth);

/** \brief Score of one segment. */
struct SegmentScore
{
  int rank = 0;                               ///< position in order of attention, from 1
  int region = GroundTruth::Surface::invalid; ///< where the attention point lies: index of a region, or a Surface
  Overlap overlap;                            ///< of its mask with that region; 0 where the point lies on none
  double confidence = 0;                      ///< 0 to 1; NaN: not given
};

/** \brief Score of one object (or part). */
struct RegionScore
{
  Region region;
  int points = 0;             ///< attention points that lie on it
  int first_rank = 0;         ///< the lowest rank of those; 0: unattended
  Overlap first;              ///< of the segment of the lowest rank; 0 if unattended, as the next two
  Overlap best;               ///< of the segment with the largest F among those whose point lies on it
  double all_f = 0;           ///< mean F over the segments whose point lies on it
  double best_of_scene_f = 0; ///< largest F over all segments of the scene, wherever their points lie
  double center_f = 0;        ///< F of the segment that the label image has at the object's centre pixel; 0 without one

  bool
  attended () const
  {
    return (first_rank > 0);
  }
};

/** \brief Scores of one scene on one ground truth. */
struct SceneScore
{
  std::string name, category;
  GroundTruthKind kind = GroundTruthKind::objects;
  std::vector<SegmentScore> segments; ///< those with an attention point, in order of attention
  std::vector<RegionScore> regions;   ///< in the order of GroundTruth::regions
  Overlap overlap;                    ///< of the label image as a whole, see labelImageOverlap
};

/** \brief Overlap P/R/F of a label image, as on OSD in the literature (Xie et al., "The Best of Both Modes", CoRL
 * 2019).
 *
 * Segments c_i and objects g_j are matched one to one so that the sum of their pairwise F is largest; then
 * P = sum |c_i and g(c_i)| / sum |c_i|, R = sum |c_i and g(c_i)| / sum |g_j|. Only valid pixels count.
 * By that paper's convention P is 1 without a segment, R is 1 without an object, and F is 0 if just one of them is
 * absent, 1 if both are. */
Overlap labelImageOverlap (const GroundTruth& truth, const std::vector<std::uint32_t>& labels);

/** \brief Score a scene.
 *
 * Only valid pixels (finite coordinates) of a mask count.
 * \throws std::invalid_argument if the prediction has another size than the ground truth, or a mask index, an attention
 * point or the label image lies outside of it */
SceneScore scoreScene (const GroundTruth& truth, const ScenePrediction& prediction);

/** \brief Scores over all objects of a group of scenes. A figure without anything to average is NaN. */
struct Summary
{
  std::string group;
  GroundTruthKind kind = GroundTruthKind::objects;
  std::size_t scenes = 0, objects = 0, attended = 0, points = 0;

  // F over objects: "attended" averages over the objects with an attention point, as the paper's Table I does; in
  // "strict" an unattended object counts as 0.
  Distribution attended_first, attended_best, attended_all;
  Distribution strict_first, strict_best, strict_all;
  Distribution best_of_scene, center; ///< see RegionScore, over all objects

  double coverage = 0;            ///< share of the objects that have an attention point
  double hits_within_5 = 0;       ///< share of the objects with one among the scene's first 5 points
  double hits_within_10 = 0;      ///< ... first 10 points
  double hits_within_objects = 0; ///< ... first n points, n the scene's number of objects

  double points_per_scene = 0;
  double points_per_object = 0; ///< points on objects / attended objects
  double points_on_objects = 0; ///< share of the points
  double points_on_support = 0; ///< share of the points on labels 1-19
  double points_on_invalid = 0; ///< share of the points on label 0 or without valid coordinates
  double points_duplicate = 0;  ///< share of the points on an object that an earlier point lies on

  Overlap overlap;                   ///< labelImageOverlap, each of P, R, F averaged over the scenes
  double confidence_correlation = 0; ///< Spearman, of confidence and F over the segments with both an attention point
                                     ///< and a confidence; F is 0 for a point on no object
};

/** \brief Summary of the scenes given. */
Summary summarize (const std::string& group, GroundTruthKind kind, const std::vector<SceneScore>& scenes);

/** \brief Summary of all scenes of a ground truth ("overall"), then of each category in order of appearance if there
 * are at least two. */
std::vector<Summary> summarizeByCategory (GroundTruthKind kind, const std::vector<SceneScore>& scenes);

} // namespace pcl_attention
