// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_model.h"

#include <pcl_attention/core/parameters.h>

#include <pcl/common/io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace pcl_attention
{

namespace
{

/** \brief printf into a string. */
template <typename... Values>
std::string
format (const char* pattern, Values... values)
{
  std::array<char, 256> text;
  std::snprintf (text.data (), text.size (), pattern, values...);
  return (text.data ());
}

const ParameterDescription&
rowOf (const std::string& name)
{
  const std::vector<ParameterDescription>& table = parameterTable ();
  return (*std::find_if (table.begin (), table.end (),
                         [&] (const ParameterDescription& row) { return (row.name == name); }));
}

std::string
counted (std::size_t count, const char* one, const char* many)
{
  return (std::to_string (count) + ' ' + (count == 1 ? one : many));
}

std::string
milliseconds (const char* stage, double value)
{
  return (value > 0.0 ? format ("%s %.0f", stage, value) : format ("%s -", stage));
}

} // namespace

const std::vector<std::string>&
viewNames ()
{
  static const std::vector<std::string> names{"color", "saliency", "points", "patches", "segments"};
  return (names);
}

const std::vector<Knob>&
knobs ()
{
  static const std::vector<Knob> table{{"compactness_threshold", "compactness theta_com", 0.0, 0.02, 0.0005},
                                       {"minimum_convexity", "least convexity", -2.0, 1.0, 0.05},
                                       {"color_constraint", "colour constraint", 0.0, 2.0, 1.0},
                                       {"window_radius", "symmetry window", 1.0, 8.0, 1.0},
                                       {"levels", "pyramid levels", 1.0, 6.0, 1.0},
                                       {"convexity_gate", "convexity gate", 0.0, 1.0, 1.0},
                                       {"strategy", "attention", 0.0, 2.0, 1.0}};
  return (table);
}

std::string
describeStep (const GrowthStep& step)
{
  const std::string patch = "Patch " + std::to_string (step.patch);
  const double value = step.value, limit = step.limit;
  switch (step.refused_by)
  {
  case GrowthConstraint::none:
    return (patch + " accepted\n" + format ("compactness %.1f mm, under %.1f mm", 1e3 * value, 1e3 * limit));
  case GrowthConstraint::connection:
    return (patch + " refused by connection\n" +
            format ("%.0f %% connected, %.0f %% needed", 1e2 * value, 1e2 * limit));
  case GrowthConstraint::convexity:
    return (patch + " refused by convexity\n" +
            (value < limit ? format ("%.2f, at least %.2f: short by %.2f", value, limit, limit - value)
                           : format ("%.2f, at most %.2f at the rim of an inside", value, limit)));
  case GrowthConstraint::color:
    return (patch + " refused by colour\n" + format ("%.2f from the object, %.2f from the rest", value, limit));
  case GrowthConstraint::compactness:
    return (patch + " refused by compactness\n" +
            format ("%.1f mm, under %.1f mm: %.1f mm too much", 1e3 * value, 1e3 * limit, 1e3 * (value - limit)));
  case GrowthConstraint::support:
    return (patch + " refused by support\nit belongs to a plane of the background");
  }
  return (patch);
}

ViewerModel::ViewerModel (const NamedParameters& parameters)
    : parameters_ (parameters), initial_parameters_ (parameters), results_ (std::make_shared<const AttentionResults> ())
{
}

bool
ViewerModel::setResults (const AttentionResultsPtr& results)
{
  const bool other_scene = results->scene != results_->scene;
  results_ = results;
  if (other_scene)
  {
    clearSelection ();
    own_points_.clear ();
    select_own_ = false;
  }
  bool all_found = true;
  // Results may answer an older request, with other fixations than there are by now.
  const auto is_at = [] (const AttentionSegment& segment, const AttentionPoint& point) {
    return (segment.attention_point.column == point.column && segment.attention_point.row == point.row);
  };
  for (const AttentionSegment& segment : results->own_segments)
  {
    const auto point = std::find_if (own_points_.begin (), own_points_.end (),
                                     [&] (const AttentionPoint& own) { return (is_at (segment, own)); });
    if (!segment.indices.empty () || point == own_points_.end ())
      continue;
    select_own_ = select_own_ && point + 1 != own_points_.end ();
    own_points_.erase (point);
    all_found = false;
  }
  collectSegments ();
  if (results->complete && select_own_ && !results->own_segments.empty () &&
      is_at (results->own_segments.back (), own_points_.back ()))
  {
    selection_ = static_cast<int> (segments_.size ()) - 1;
    step_ = -1;
    select_own_ = false;
  }
  if (results->complete && selection_ >= static_cast<int> (segments_.size ()))
    clearSelection ();
  const AttentionSegment* segment = selected ();
  if (segment && step_ > static_cast<int> (segment->steps.size ()))
    step_ = -1;
  if (results->saliency && saliency_level_ > static_cast<int> (results->saliency->levels.size ()))
    saliency_level_ = 0;
  return (all_found);
}

void
ViewerModel::collectSegments ()
{
  segments_ = results_->segments;
  scores_.clear ();
  for (std::size_t k = 0; k < results_->scores.size () && k < segments_.size (); ++k)
    scores_.push_back (results_->scores[k]);
  for (std::size_t k = 0; k < results_->own_segments.size (); ++k)
  {
    const AttentionSegment& segment = results_->own_segments[k];
    if (segment.indices.empty ())
      continue;
    segments_.push_back (segment);
    if (!results_->scores.empty ())
      scores_.push_back (results_->scores[results_->segments.size () + k]);
  }
}

AttentionRequest
ViewerModel::request () const
{
  AttentionRequest request;
  request.parameters = parameters_.values;
  request.scene = results_->scene;
  request.own_points = own_points_;
  return (request);
}

double
ViewerModel::knobValue (const Knob& knob) const
{
  return (std::clamp (rowOf (knob.parameter).get (parameters_.values), knob.low, knob.high));
}

std::string
ViewerModel::knobText (const Knob& knob) const
{
  const ParameterDescription& row = rowOf (knob.parameter);
  const double value = row.get (parameters_.values);
  if (row.unit == "m")
    return (format ("%.1f mm", 1e3 * value));
  if (knob.parameter == "minimum_convexity" && value <= -2.0)
    return ("off");
  if (row.choices.empty () && !row.integer)
    return (format ("%.2f", value));
  std::string text = row.toString (parameters_.values);
  std::replace (text.begin (), text.end (), '_', ' ');
  return (text);
}

bool
ViewerModel::setKnob (const Knob& knob, double value)
{
  const double raster = knob.low + std::round ((value - knob.low) / knob.step) * knob.step;
  const ParameterDescription& row = rowOf (knob.parameter);
  AttentionParameters changed = parameters_.values;
  row.set (changed, std::clamp (raster, knob.low, knob.high));
  const bool differs = row.get (changed) != row.get (parameters_.values);
  parameters_.values = changed;
  return (differs);
}

void
ViewerModel::loadParameters (const std::string& path)
{
  parameters_ = readParameters (path);
}

double
ViewerModel::score (std::size_t index) const
{
  return (index < scores_.size () ? scores_[index] : -1.0);
}

const AttentionSegment*
ViewerModel::selected () const
{
  return (selection_ >= 0 && selection_ < static_cast<int> (segments_.size ()) ? &segments_[selection_] : nullptr);
}

void
ViewerModel::selectNext (int direction)
{
  // None is one more place in the round.
  const int places = static_cast<int> (segments_.size ()) + 1;
  selection_ = (selection_ + 1 + direction + places) % places - 1;
  step_ = -1;
}

void
ViewerModel::clearSelection ()
{
  selection_ = step_ = -1;
}

void
ViewerModel::stepNext (int direction)
{
  if (!selected ())
    selectNext (1);
  const AttentionSegment* segment = selected ();
  if (!segment)
    return;
  const int places = static_cast<int> (segment->steps.size ()) + 2; // the start, every step, the whole object
  step_ = (step_ + 1 + direction + places) % places - 1;
}

GrowthState
ViewerModel::growth () const
{
  GrowthState state;
  const AttentionSegment* segment = selected ();
  if (!segment || step_ < 0)
    return (state);
  // The patches of a segment are those it started with, then those that were accepted, then those that were joined.
  const auto accepted = [] (const GrowthStep& step) { return (step.refused_by == GrowthConstraint::none); };
  const auto first = std::find_if (segment->steps.begin (), segment->steps.end (), accepted);
  for (const int patch : segment->patches)
  {
    if (first != segment->steps.end () ? patch == first->patch : !state.patches.empty ())
      break;
    state.patches.push_back (patch);
  }
  for (int k = 0; k + 1 < step_; ++k)
    if (accepted (segment->steps[k]))
      state.patches.push_back (segment->steps[k].patch);
  if (step_ > 0)
    state.step = &segment->steps[step_ - 1];
  return (state);
}

void
ViewerModel::addFixation (int column, int row)
{
  AttentionPoint point;
  point.column = column;
  point.row = row;
  point.kind = AttentionPointKind::user;
  if (results_->saliency && results_->saliency->saliency.contains (column, row))
    point.point_saliency = results_->saliency->saliency (column, row);
  own_points_.push_back (point);
  select_own_ = true;
}

bool
ViewerModel::undoFixation ()
{
  if (own_points_.empty ())
    return (false);
  own_points_.pop_back ();
  select_own_ = false;
  return (true);
}

void
ViewerModel::nextSaliencyLevel ()
{
  if (results_->saliency)
    saliency_level_ = (saliency_level_ + 1) % (static_cast<int> (results_->saliency->levels.size ()) + 1);
}

std::string
ViewerModel::sceneText () const
{
  if (!results_->scene)
    return ("");
  const ViewerScene& scene = *results_->scene;
  std::string text =
      scene.scene.name + "  " + std::to_string (scene.cloud.width) + " x " + std::to_string (scene.cloud.height);
  if (!results_->complete)
    return (text + "  " +
            (!results_->normals            ? "normals"
             : !results_->saliency         ? "saliency"
             : !results_->attention_points ? "attention points"
             : !results_->patches          ? "patches"
                                           : "objects") +
            " ...");
  text += "  " + counted (segments_.size (), "object", "objects");
  if (!own_points_.empty ())
    text += ", " + std::to_string (own_points_.size ()) + " of them yours";
  if (!scores_.empty ())
  {
    double sum = 0.0;
    for (const double score : scores_)
      sum += score;
    text += format (", mean F %.2f", sum / static_cast<double> (scores_.size ()));
  }
  return (text);
}

std::string
ViewerModel::timesText () const
{
  const StageTimes& times = results_->times;
  return (milliseconds ("normals", times.normals) + "  " + milliseconds ("saliency", times.saliency) + "  " +
          milliseconds ("points", times.attention_points) + "  " + milliseconds ("patches", times.patches) + "  " +
          milliseconds ("growth", times.segmentation) + format (" ms;  last change %.0f ms", results_->milliseconds));
}

std::string
ViewerModel::objectText () const
{
  const AttentionSegment* segment = selected ();
  if (!segment)
  {
    if (!results_->complete)
      return ("");
    if (segments_.empty ())
      return ("No object found.\nShift + click: one at a point of your own");
    return (counted (segments_.size (), "object", "objects") + "\nRight, Left: next, previous object\n" +
            "Down, Up: its growth step by step\nShift + click: your own fixation\nh: all keys");
  }
  std::string text = format ("Object %d of %d, %s", segment->rank, static_cast<int> (segments_.size ()),
                             toString (segment->attention_point.kind));
  if (const double f = score (static_cast<std::size_t> (selection_)); f >= 0.0)
    text += format (", F %.2f", f);
  if (step_ >= 0)
  {
    const GrowthState state = growth ();
    text += format ("\nStep %d of %d, ", step_, static_cast<int> (segment->steps.size ())) +
            counted (state.patches.size (), "patch", "patches") + "\n";
    return (text + (state.step ? describeStep (*state.step) : std::string ("Growth starts at the fixation")));
  }
  text += format ("\n%d points in %d patches", static_cast<int> (segment->indices.size ()),
                  static_cast<int> (segment->patches.size ()));
  const Eigen::Vector3f size = 1e2f * segment->box.size;
  text += format ("\n%.1f x %.1f x %.1f cm", static_cast<double> (size.x ()), static_cast<double> (size.y ()),
                  static_cast<double> (size.z ()));
  text += format ("\ncompactness %.1f mm, confidence %.2f", 1e3 * static_cast<double> (segment->compactness),
                  static_cast<double> (segment->confidence));
  if (segment->growth_end == GrowthConstraint::none)
    return (text + "\nended with no neighbour left");
  return (text + "\nended mostly by " + toString (segment->growth_end));
}

SceneSegments
ViewerModel::sceneSegments () const
{
  SceneSegments result;
  result.segments = segments_;
  result.supporting_planes = results_->supporting_planes;
  result.times = results_->times;
  result.extracted_points = results_->attention_points ? results_->attention_points->points.size () : 0;
  result.patches = results_->patches ? results_->patches->patches.size () : 0;
  return (result);
}

pcl::PointCloud<pcl::PointXYZRGB>
ViewerModel::selectedCloud () const
{
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  if (const AttentionSegment* segment = selected ())
  {
    pcl::copyPointCloud (*results_->scene->scene.cloud, segment->indices, cloud);
    cloud.sensor_origin_ = results_->scene->scene.stored_origin;
    cloud.sensor_orientation_ = results_->scene->scene.stored_orientation;
  }
  return (cloud);
}

} // namespace pcl_attention
