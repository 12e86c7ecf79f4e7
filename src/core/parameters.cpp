// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/parameters.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace pcl_attention
{

namespace
{

/** \brief The shortest text that reads back as the same parameter. */
std::string
formatNumber (double value)
{
  std::array<char, 64> text;
  char* const end = text.data () + text.size ();
  const bool whole = std::abs (value) < 1e15 && value == std::floor (value);
  const auto result = whole ? std::to_chars (text.data (), end, static_cast<long long> (value))
                            : std::to_chars (text.data (), end, static_cast<float> (value), std::chars_format::general);
  return (std::string (text.data (), result.ptr));
}

/** \brief Makes rows that read and write one field of one stage. */
template <typename Stage>
class Rows
{
public:
  Rows (std::vector<ParameterDescription>& table, std::string stage_name, Stage AttentionParameters::*stage)
  : table_ (table), stage_name_ (std::move (stage_name)), stage_ (stage)
  {}

  template <typename T> Rows&
  number (const char* name, T Stage::*field, double minimum, double maximum, const char* unit, const char* source,
          const char* help)
  {
    return (add ({name, stage_name_, unit, source, help, minimum, maximum, std::is_integral<T>::value, {}, {}, {}}, field));
  }

  template <typename T> Rows&
  choice (const char* name, T Stage::*field, std::vector<std::string> choices, const char* source, const char* help)
  {
    const double maximum = static_cast<double> (choices.size () - 1);
    return (add ({name, stage_name_, "", source, help, 0.0, maximum, true, std::move (choices), {}, {}}, field));
  }

  Rows&
  toggle (const char* name, bool Stage::*field, const char* source, const char* help)
  {
    return (choice (name, field, {"off", "on"}, source, help));
  }

private:
  template <typename T> Rows&
  add (ParameterDescription row, T Stage::*field)
  {
    const auto stage = stage_;
    row.get = [=] (const AttentionParameters& parameters) { return (static_cast<double> ((parameters.*stage).*field)); };
    row.set = [=] (AttentionParameters& parameters, double value) { (parameters.*stage).*field = static_cast<T> (value); };
    table_.push_back (std::move (row));
    return (*this);
  }

  std::vector<ParameterDescription>& table_;
  std::string stage_name_;
  Stage AttentionParameters::*stage_;
};

template <typename Stage> Rows<Stage>
rowsOf (std::vector<ParameterDescription>& table, const char* stage_name, Stage AttentionParameters::*stage)
{
  return (Rows<Stage> (table, stage_name, stage));
}

std::vector<ParameterDescription>
makeTable ()
{
  using P = AttentionParameters;
  std::vector<ParameterDescription> table;

  rowsOf (table, "normals", &P::normals)
    .choice ("normal_method", &NormalParameters::method, {"gated_window", "integral_image"}, "III-A",
             "plane fit within a depth-gated window, or PCL's integral images")
    .number ("normal_radius", &NormalParameters::radius, 1, 15, "pixels", "III-A", "half width of the window")
    .number ("normal_depth_gate", &NormalParameters::depth_gate, 1e-4, 1.0, "m", "",
             "neighbours beyond this depth difference are not fitted together");

  rowsOf (table, "saliency", &P::saliency)
    .number ("window_radius", &SaliencyParameters::window_radius, 1, 8, "pixels", "III-A, N(p)",
             "offsets +-1..radius without the centre row and column")
    .number ("levels", &SaliencyParameters::levels, 1, 8, "", "III-B, eq. 9", "levels of the pyramid")
    .number ("saliency_columns", &SaliencyParameters::maximum_columns, 0, 16384, "pixels", "",
             "of the finest level that counts: what the windows of larger ones see is noise; 0: all count")
    .number ("distance_scale", &SaliencyParameters::distance_scale, 0, 1e6, "1/m", "eq. 3",
             "units of the exponentials: 1000 is millimetres")
    .toggle ("convexity_gate", &SaliencyParameters::convexity_gate, "",
             "symmetry only where both halves' normals point away from the plane")
    .number ("blur_radius", &SaliencyParameters::blur_radius, 0, 15, "pixels", "", "box blur of every level map; 0: off")
    .number ("level_threshold", &SaliencyParameters::level_threshold, 0, 1, "share", "",
             "of a level's maximum, under which its values become 0; 0: off")
    .toggle ("normalize_levels", &SaliencyParameters::normalize_levels, "eq. 9", "divide every level by its maximum")
    .number ("saliency_floor", &SaliencyParameters::saliency_floor, 0, 4, "", "",
             "absolute symmetry under which a value is noise, whatever the maximum");

  rowsOf (table, "attention_points", &P::attention_points)
    .choice ("strategy", &AttentionPointParameters::strategy, {"symmetry_lines", "winner_take_all", "image_winner_take_all"}, "III-C, V-A",
             "how attention points are chosen: TJ3D, WTA3D or WTA2D")
    .number ("pixel_threshold", &AttentionPointParameters::pixel_threshold, 0, 1, "share", "III-C",
             "of the map's maximum, that a pixel or a winner's cell must exceed; 0: S > 0 as printed")
    .number ("component_threshold", &AttentionPointParameters::component_threshold, 0, 1, "share", "III-C, theta_sal",
             "of the map's maximum, that a component's mean must exceed")
    .toggle ("all_junctions", &AttentionPointParameters::all_junctions, "III-C",
             "every junction of a component, or only the most salient one")
    .number ("junction_merge_radius", &AttentionPointParameters::junction_merge_radius, 0, 100, "pixels", "",
             "junctions nearer than this are one")
    .number ("minimum_skeleton_length", &AttentionPointParameters::minimum_skeleton_length, 1, 10000, "pixels", "",
             "shorter skeletons give no point")
    .number ("winner_cell_size", &AttentionPointParameters::winner_cell_size, 1, 64, "pixels", "V-A, WTA",
             "of the map's square that a neuron of the winner-take-all network sees")
    .number ("inhibition_width", &AttentionPointParameters::inhibition_width, 0.1, 10, "cells", "V-A, WTA",
             "standard deviation of the inhibition of return around a winner");

  rowsOf (table, "image_symmetry", &P::image_symmetry)
    .number ("image_levels", &ImageSymmetryParameters::levels, 1, 6, "", "V-A, WTA2D", "scales: 1/2, 1/4, ... of the image's size")
    .number ("image_inner_radius", &ImageSymmetryParameters::inner_radius, 1, 100, "pixels", "V-A, WTA2D",
             "pixels opposite each other are at least so far from their centre")
    .number ("image_outer_radius", &ImageSymmetryParameters::outer_radius, 1, 100, "pixels", "V-A, WTA2D", "... and at most")
    .number ("image_pair_distance", &ImageSymmetryParameters::pair_distance, 0.1, 1000, "pixels", "V-A, WTA2D",
             "standard deviation of a pair's weight over its distance");

  rowsOf (table, "patches", &P::patches)
    .choice ("patch_method", &PatchParameters::method, {"grid_growing", "region_growing"}, "IV-A",
             "growth over the pixel grid, or PCL's region growing; they differ in the order of points of equal curvature")
    .choice ("plane_model", &PatchParameters::plane_model, {"initial", "running"}, "IV-A",
             "compare with the seed's plane, or with the patch's mean so far")
    .number ("patch_maximum_angle", &PatchParameters::maximum_angle, 0, 1.5708, "radians", "IV-A",
             "between a point's normal and the patch's")
    .number ("patch_maximum_distance", &PatchParameters::maximum_distance, 1e-5, 1, "m", "IV-A",
             "of a point from the patch's plane")
    .number ("patch_maximum_step", &PatchParameters::maximum_step, 1e-5, 10, "m", "IV-A",
             "between neighbouring pixels; beyond it a depth edge ends the patch")
    .number ("patch_minimum_size", &PatchParameters::minimum_size, 1, 100000, "pixels", "IV-A", "smaller clusters are noise")
    .number ("patch_reassign_distance", &PatchParameters::reassign_distance, 0, 1, "m", "IV-A",
             "left-over points join a neighbouring patch nearer than this; 0: off");

  rowsOf (table, "patch_graph", &P::patch_graph)
    .number ("border_maximum_gap", &PatchGraphParameters::maximum_gap, 0, 100, "pixels", "",
             "borders are found across at most this many pixels without a patch")
    .number ("border_connection_distance", &PatchGraphParameters::connection_distance, 0, 1, "m", "",
             "border points nearer than this are connected in 3D ...")
    .number ("border_connection_noise", &PatchGraphParameters::connection_noise, 0, 100, "", "",
             "... plus this many standard deviations of the depth there")
    .number ("border_gap_slack", &PatchGraphParameters::gap_slack, 0, 100, "pixels", "",
             "added to that distance for every pixel of a gap, in pixel widths at its depth")
    .number ("border_sample_distance", &PatchGraphParameters::sample_distance, 1, 50, "pixels", "",
             "convexity is judged between points this far inside either side")
    .number ("step_tolerance", &PatchGraphParameters::step_tolerance, 0, 1, "m", "",
             "patches whose planes miss their common border by more are a step apart and not connected ...")
    .number ("step_roughness", &PatchGraphParameters::step_roughness, 0, 100, "", "",
             "... plus this many times how far their points lie off their planes; 0: off")
    .number ("step_color", &PatchGraphParameters::step_color, 0, 1, "share", "",
             "within a patch that limit is larger by this where both sides look alike, smaller where colours differ; "
             "half of that between patches")
    .number ("cut_color", &PatchGraphParameters::cut_color, 0, 2, "", "",
             "a patch is looked for a step first along the line that parts its colours best, from this chi-square on; above 1: off");

  rowsOf (table, "support", &P::support)
    .number ("support_minimum_area", &SupportParameters::minimum_area, 0, 100, "m^2", "", "of a supporting plane")
    .number ("support_tolerance", &SupportParameters::tolerance, 0, 1, "m", "", "of a point of it from the plane ...")
    .number ("support_noise_tolerance", &SupportParameters::noise_tolerance, 0, 100, "", "",
             "... plus this many standard deviations of the depth there")
    .number ("support_minimum_confidence", &SupportParameters::minimum_confidence, 0, 1, "", "",
             "a supporting plane under this confidence is none")
    .number ("background_area", &SupportParameters::background_area, 0, 1000, "m^2", "",
             "a plane at least this large that reaches the image border is background")
    .number ("background_share", &SupportParameters::background_share, 0, 1, "share", "",
             "and so is one that covers this share of the valid points");

  rowsOf (table, "clustering", &P::clustering)
    .choice ("initial_patches", &ClusteringParameters::initial_patches, {"within_radius", "connected"}, "IV-B",
             "all patches near the attention point, or only those connected to the one at it")
    .number ("initial_radius", &ClusteringParameters::initial_radius, 0, 100, "pixels", "IV-B", "around the attention point")
    .choice ("color_constraint", &ClusteringParameters::color_constraint, {"off", "nearer_object", "as_printed"},
             "eq. 11, 12", "add patches with CS_in < CS_out, or CS_out < CS_in as printed")
    .number ("compactness_threshold", &ClusteringParameters::compactness_threshold, 0, 10, "m", "eq. 13, 14, theta_com",
             "mean distance of the points to the visible faces of the hull")
    .number ("compactness_noise", &ClusteringParameters::compactness_noise, 0, 100, "", "eq. 13",
             "added to the threshold, standard deviations of the depth at the patch: noise moves a hull outwards")
    .number ("compactness_samples", &ClusteringParameters::compactness_samples, 3, 100000, "", "eq. 13",
             "points of a patch that the mean is taken over, at most")
    .choice ("hull_method", &ClusteringParameters::hull_method, {"growing", "qhull"}, "IV-B.2",
             "hull of an object: kept and extended, or anew by pcl::ConvexHull")
    .choice ("face_distance", &ClusteringParameters::face_distance, {"triangle", "plane"}, "eq. 14",
             "distance of a point to a face of the hull: to the face itself, or to its plane")
    .number ("minimum_connection", &ClusteringParameters::minimum_connection, 0, 1, "share", "",
             "of the common border that is connected in 3D; 0: off")
    .number ("minimum_convexity", &ClusteringParameters::minimum_convexity, -2, 2, "", "",
             "of the common border, -2 concave, 2 convex; -2: off")
    .toggle ("stay_off_support", &ClusteringParameters::stay_off_support, "", "patches of a supporting plane are not added")
    .number ("color_convexity", &ClusteringParameters::color_convexity, 0, 2, "", "",
             "how much more convexity differing colours ask for, and like colours spare")
    .number ("color_compactness", &ClusteringParameters::color_compactness, 0, 1, "share", "",
             "how much smaller the compactness threshold is for other colours")
    .number ("color_contact", &ClusteringParameters::color_contact, 0, 1, "share", "",
             "of the shorter outline over which a large patch of other colours has to be connected")
    .toggle ("recognize_hollows", &ClusteringParameters::recognize_hollows, "",
             "patches that curve inwards together are one hollow, concave as their borders are")
    .number ("minimum_hollowness", &ClusteringParameters::minimum_hollowness, -1, 1, "", "",
             "mean cosine between the normals of a hollow's patch and the direction to its middle")
    .toggle ("separate_floors", &ClusteringParameters::separate_floors, "",
             "borders of a hollow are not as concave where a patch is a plane, as the flat floor of a pot; on with -parts")
    .number ("certain_hollowness", &ClusteringParameters::certain_hollowness, 0, 1, "", "",
             "the same of what is the inside of a bowl for certain, its negative of an outside")
    .number ("certain_size", &ClusteringParameters::certain_size, 1, 1000000, "pixels", "",
             "the shape of fewer pixels says nothing")
    .number ("rim_convexity", &ClusteringParameters::rim_convexity, -2, 2, "", "",
             "where a border is more convex, the inside of a hollow turns over its rim and ends; 2: off")
    .number ("surface_tolerance", &ClusteringParameters::surface_tolerance, 0, 1, "m", "",
             "of the points of a rim from its plane, and of planes that go on behind an occluder from each other")
    .number ("handle_width", &ClusteringParameters::handle_width, 0, 1, "m", "", "what is wider is no handle")
    .number ("handle_size", &ClusteringParameters::handle_size, 1, 1000, "", "",
             "nor is what is larger than this part (1 / n) of the object")
    .number ("occluded_distance", &ClusteringParameters::occluded_distance, 0, 100, "m", "",
             "pieces of an object behind an occluder are no farther apart")
    .number ("joined_color", &ClusteringParameters::joined_color, 0, 1, "", "",
             "chi-square of the colours of pieces behind an occluder of which one face goes on, and of a handle and its object")
    .number ("contour_width", &ClusteringParameters::contour_width, 0, 16, "pixels", "",
             "an object gets the points at its contour that have its colours and not those around it, so far off at most; 0: off")
    .number ("smoothed_contour_width", &ClusteringParameters::smoothed_contour_width, 0, 16, "pixels", "",
             "the same where the sensor smooths its depth: an object ends where colours do, so far off at most; 0: as with others")
    .toggle ("join_hollows", &ClusteringParameters::join_hollows, "",
             "join the inside of a hollow and the wall before it; off with -parts")
    .toggle ("join_handles", &ClusteringParameters::join_handles, "",
             "join a thin piece that hangs on an object and on nothing else; off with -parts")
    .toggle ("join_occluded", &ClusteringParameters::join_occluded, "",
             "join pieces of one object that an occluder separates; off with -parts");

  rowsOf (table, "segmentation", &P::segmentation)
    .toggle ("prefer_supported", &SegmentationParameters::prefer_supported, "",
             "what stands on the supporting plane first, then the rest, each by saliency")
    .toggle ("ignore_surroundings", &SegmentationParameters::ignore_surroundings, "",
             "what lies below a certain supporting plane, or stands beside it, is no object, unless something is asked for")
    .toggle ("inhibition_of_return", &SegmentationParameters::inhibition_of_return, "",
             "skip attention points that lie in an earlier segment or lead to one again")
    .number ("full_size", &SegmentationParameters::full_size, 0, 100, "m^2", "",
             "smaller segments are less salient by as much; 0: off")
    .number ("fixation_margin", &SegmentationParameters::fixation_margin, 0, 50, "pixels", "",
             "a fixation nearer than this to its segment's contour moves inside; 0: off")
    .toggle ("coverage", &SegmentationParameters::coverage, "", "unclaimed patches become attention points after all others")
    .number ("coverage_size", &SegmentationParameters::coverage_size, 1, 10000000, "pixels", "", "smaller patches do not")
    .number ("minimum_certain_area", &SegmentationParameters::minimum_certain_area, 0, 100, "m^2", "",
             "segments whose frontal area times their confidence is smaller are no objects; 0: off, as with -parts")
    .number ("minimum_segment_size", &SegmentationParameters::minimum_segment_size, 1, 10000000, "pixels", "",
             "smaller segments are no objects");
  return (table);
}

std::string
describeRange (const ParameterDescription& row)
{
  if (!row.choices.empty ())
  {
    std::string text = "one of";
    for (const std::string& choice : row.choices)
      text += " " + choice;
    return (text);
  }
  return ((row.integer ? "a whole number from " : "a number from ") + formatNumber (row.minimum) + " to " +
          formatNumber (row.maximum) + (row.unit.empty () ? "" : " " + row.unit));
}

bool
inRange (const ParameterDescription& row, double value)
{
  // A field of type float holds the ends of its range rounded to either side.
  const double minimum = std::min (row.minimum, static_cast<double> (static_cast<float> (row.minimum)));
  const double maximum = std::max (row.maximum, static_cast<double> (static_cast<float> (row.maximum)));
  return (std::isfinite (value) && value >= minimum && value <= maximum && (!row.integer || value == std::floor (value)));
}

} // namespace

std::string
ParameterDescription::toString (const AttentionParameters& parameters) const
{
  const double value = get (parameters);
  if (!choices.empty () && inRange (*this, value))
    return (choices[static_cast<std::size_t> (value)]);
  return (formatNumber (value));
}

std::string
ParameterDescription::parse (const std::string& text, AttentionParameters& parameters) const
{
  double value = std::numeric_limits<double>::quiet_NaN ();
  if (choices.empty ())
  {
    std::istringstream stream (text);
    stream.imbue (std::locale::classic ());
    if (!(stream >> value) || !stream.eof ())
      value = std::numeric_limits<double>::quiet_NaN ();
  }
  else
  {
    for (std::size_t index = 0; index < choices.size (); ++index)
      if (text == choices[index])
        value = static_cast<double> (index);
  }
  if (!inRange (*this, value))
    return (name + " is '" + text + "', but must be " + describeRange (*this));
  set (parameters, value);
  return ("");
}

const std::vector<ParameterDescription>&
parameterTable ()
{
  static const std::vector<ParameterDescription> table = makeTable ();
  return (table);
}

std::string
validate (const AttentionParameters& parameters)
{
  for (const ParameterDescription& row : parameterTable ())
    if (!inRange (row, row.get (parameters)))
      return (row.name + " is " + row.toString (parameters) + ", but must be " + describeRange (row));
  if (parameters.image_symmetry.inner_radius > parameters.image_symmetry.outer_radius)
    return ("image_inner_radius is " + std::to_string (parameters.image_symmetry.inner_radius) +
            ", but must not exceed image_outer_radius, which is " + std::to_string (parameters.image_symmetry.outer_radius));
  return ("");
}

} // namespace pcl_attention
