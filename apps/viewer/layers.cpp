// SPDX-License-Identifier: BSD-3-Clause
#include "layers.h"

#include "overview_image.h"
#include "segment_writer.h"

#include <pcl/common/colors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace pcl_attention
{

namespace
{

constexpr Color good{80, 220, 100}, bad{240, 60, 60}, missed{80, 140, 255}, grown{70, 170, 230},
    depth_edge{70, 110, 255};
constexpr Color line_color{255, 225, 60}, candidate_color{255, 255, 255};
constexpr float edge_share = 0.5f; // a border with fewer connected pairs is mostly a depth edge

Color
blend (const Color& a, const Color& b, float share)
{
  Color result{};
  for (std::size_t channel = 0; channel < 3; ++channel)
    result[channel] = static_cast<std::uint8_t> (
        std::lround (static_cast<float> (a[channel]) * (1.0f - share) + static_cast<float> (b[channel]) * share));
  return (result);
}

Color
grey (const Color& color, float brightness)
{
  const float luminance = 0.3f * static_cast<float> (color[0]) + 0.59f * static_cast<float> (color[1]) +
                          0.11f * static_cast<float> (color[2]);
  const auto value = static_cast<std::uint8_t> (std::lround (brightness * luminance));
  return {value, value, value};
}

/** \brief Red for concave, yellow for flat, green for convex. */
Color
convexityColor (float convexity)
{
  constexpr float full = 0.5f; // from there on a border is clearly the one or the other
  constexpr Color flat{250, 220, 70};
  const float share = std::clamp (convexity / full, -1.0f, 1.0f);
  return (share < 0.0f ? blend (flat, bad, -share) : blend (flat, good, share));
}

Color
patchColor (int label)
{
  const pcl::RGB color = pcl::GlasbeyLUT::at (static_cast<unsigned int> (label) % pcl::GlasbeyLUT::size ());
  return {color.r, color.g, color.b};
}

void
paintNormals (const NormalImage& normals, Image<Color>& picture)
{
  const auto channel = [] (float value) {
    return (static_cast<std::uint8_t> (std::lround (127.5f * (std::clamp (value, -1.0f, 1.0f) + 1.0f))));
  };
  for (std::size_t i = 0; i < picture.size (); ++i)
    picture[i] = normals.valid[i] ? Color{channel (normals.x[i]), channel (-normals.y[i]), channel (-normals.z[i])}
                                  : Color{40, 40, 40};
}

void
paintSaliency (const ViewerModel& model, Image<Color>& picture)
{
  const AttentionResults& results = model.results ();
  const int level = model.saliencyLevel ();
  const Image<float>& map = level > 0                ? results.saliency->levels[level - 1].symmetry
                            : results.image_saliency ? *results.image_saliency
                                                     : results.saliency->saliency;
  float maximum = 1.0f;
  if (level > 0)
    maximum = std::max (1e-9f, *std::max_element (map.data.begin (), map.data.end ()));
  for (int row = 0; row < picture.height; ++row)
    for (int column = 0; column < picture.width; ++column)
    {
      // A coarse level has one value for a square of pixels.
      const int map_column = std::min (column * map.width / picture.width, map.width - 1);
      const int map_row = std::min (row * map.height / picture.height, map.height - 1);
      const float saliency = std::clamp (map (map_column, map_row) / maximum, 0.0f, 1.0f);
      Color& pixel = picture (column, row);
      pixel = blend (grey (pixel, 0.55f), saliencyColor (saliency), std::min (1.0f, 2.5f * saliency));
    }
}

void
paintPatches (const ViewerModel& model, Image<Color>& picture)
{
  const AttentionResults& results = model.results ();
  const Image<int>& labels = results.patches->labels;
  std::vector<Color> colors (results.patches->patches.size () + 1, Color{45, 45, 45});
  std::vector<float> shares (colors.size (), 0.75f);
  std::vector<std::uint8_t> background (colors.size (), 0);
  for (const SupportingPlane& plane : results.supporting_planes)
    for (const pcl::index_t index : plane.indices)
      background[labels[index]] = 1;
  for (std::size_t k = 1; k < colors.size (); ++k)
    colors[k] = patchColor (static_cast<int> (k));
  if (model.step () >= 0)
  {
    const GrowthState state = model.growth ();
    shares.assign (shares.size (), 0.0f);
    const auto mark = [&] (int label, const Color& color) {
      colors[label] = color;
      shares[label] = 0.8f;
      background[label] = 0;
    };
    for (const int label : state.patches)
      mark (label, grown);
    if (state.step)
      mark (state.step->patch, state.step->refused_by == GrowthConstraint::none ? good : bad);
  }
  for (std::size_t i = 0; i < picture.size (); ++i)
  {
    const int label = labels[i];
    const Color dimmed = grey (picture[i], model.step () >= 0 ? 0.6f : 0.9f);
    picture[i] =
        label > 0 && !background[label] ? blend (dimmed, colors[label], shares[label]) : grey (picture[i], 0.4f);
  }
}

void
paintErrors (const ViewerModel& model, const std::vector<std::uint32_t>& ranks, Image<Color>& picture)
{
  const GroundTruth& truth = *model.results ().scene->truth;
  std::vector<int> region_of_rank (model.segments ().size () + 1, GroundTruth::invalid);
  for (const AttentionSegment& segment : model.segments ())
  {
    const AttentionPoint& point = segment.attention_point;
    region_of_rank[segment.rank] = truth.region_of[static_cast<std::size_t> (point.row) * picture.width + point.column];
  }
  for (std::size_t i = 0; i < picture.size (); ++i)
  {
    const int region = truth.region_of[i];
    const bool right = ranks[i] > 0 && region >= 0 && region == region_of_rank[ranks[i]];
    if (region == GroundTruth::invalid || (ranks[i] == 0 && region < 0))
      picture[i] = grey (picture[i], 0.4f);
    else if (right)
      picture[i] = blend (grey (picture[i], 0.7f), good, 0.35f);
    else
      picture[i] = ranks[i] == 0 ? missed : bad;
  }
}

void
paintSegments (const ViewerModel& model, Image<Color>& picture)
{
  const std::vector<std::uint32_t> ranks = segmentLabels (model.results ().scene->scene, model.segments ());
  if (model.switches.errors && model.results ().scene->truth)
  {
    paintErrors (model, ranks, picture);
    return;
  }
  const AttentionSegment* selected = model.selected ();
  Image<std::uint8_t> inside (picture.width, picture.height, 0);
  if (selected)
    for (const pcl::index_t index : selected->indices)
      inside[index] = 1;
  for (std::size_t i = 0; i < picture.size (); ++i)
  {
    if (selected)
      picture[i] = inside[i] ? blend (picture[i], segmentColor (selected->rank), 0.35f) : grey (picture[i], 0.45f);
    else
      picture[i] = ranks[i] > 0 ? blend (picture[i], segmentColor (static_cast<int> (ranks[i])), 0.4f) : grey (picture[i], 0.5f);
  }
}

void
addOutline (const AttentionSegment& segment, int width, int height, Overlay& overlay)
{
  Image<std::uint8_t> inside (width, height, 0);
  for (const pcl::index_t index : segment.indices)
    inside[index] = 1;
  const auto outside = [&] (int column, int row) { return (!inside.contains (column, row) || !inside (column, row)); };
  for (const pcl::index_t index : segment.indices)
  {
    const int column = index % width, row = index / width;
    if (outside (column - 1, row) || outside (column + 1, row) || outside (column, row - 1) ||
        outside (column, row + 1))
    {
      overlay.pixels.push_back (index);
      overlay.colors.push_back (segmentColor (segment.rank));
    }
  }
}

bool
hasSkeletons (const ViewerModel& model)
{
  return (model.results ().parameters.attention_points.strategy == AttentionStrategy::symmetry_lines);
}

void
addSkeletons (const AttentionPoints& points, Overlay& overlay)
{
  for (std::size_t i = 0; i < points.skeleton.size (); ++i)
    if (points.skeleton[i] != 0)
    {
      overlay.pixels.push_back (static_cast<pcl::index_t> (i));
      overlay.colors.push_back (line_color);
    }
  for (const AttentionPoint& point : points.points)
    for (int row = point.row - 1; row <= point.row + 1; ++row)
      for (int column = point.column - 1; column <= point.column + 1; ++column)
        if (points.skeleton.contains (column, row))
        {
          overlay.pixels.push_back (row * points.skeleton.width + column);
          overlay.colors.push_back (candidate_color);
        }
}

void
addBorders (const PlanarPatches& patches, const PatchGraph& graph, Overlay& overlay)
{
  std::map<std::pair<int, int>, Color> colors;
  for (const auto& [labels, border] : graph.borders)
    colors[labels] = border.connectedShare () < edge_share ? depth_edge : convexityColor (border.convexity ());
  const Image<int>& labels = patches.labels;
  for (int row = 0; row + 1 < labels.height; ++row)
    for (int column = 0; column + 1 < labels.width; ++column)
      for (const int other : {labels (column + 1, row), labels (column, row + 1)})
      {
        const int label = labels (column, row);
        if (label == 0 || other == 0 || label == other)
          continue;
        const auto color = colors.find (std::minmax (label, other));
        if (color == colors.end ())
          continue;
        overlay.pixels.push_back (row * labels.width + column);
        overlay.colors.push_back (color->second);
      }
}

} // namespace

Color
saliencyColor (float saliency)
{
  constexpr std::array<Color, 4> ramp{{{60, 0, 20}, {215, 30, 30}, {255, 165, 30}, {255, 255, 190}}};
  const float place = std::clamp (saliency, 0.0f, 1.0f) * static_cast<float> (ramp.size () - 1);
  const auto lower = std::min (static_cast<std::size_t> (place), ramp.size () - 2);
  return (blend (ramp[lower], ramp[lower + 1], place - static_cast<float> (lower)));
}

Image<Color>
paintView (const ViewerModel& model, View view)
{
  const AttentionResults& results = model.results ();
  if (!results.scene)
    return (Image<Color> ());
  Image<Color> picture = results.scene->background;
  const bool ready = view == View::color || (view == View::saliency && results.saliency) ||
                     (view == View::points && results.attention_points) || (view == View::patches && results.patches) ||
                     (view == View::segments && !model.segments ().empty ());
  if (view == View::color && model.switches.normals && results.normals)
    paintNormals (*results.normals, picture);
  else if (!ready)
    for (Color& pixel : picture.data)
      pixel = grey (pixel, 0.5f);
  else if (view == View::saliency)
    paintSaliency (model, picture);
  else if (view == View::points)
    for (Color& pixel : picture.data)
      pixel = blend (grey (pixel, 0.55f), pixel, 0.25f);
  else if (view == View::patches)
    paintPatches (model, picture);
  else if (view == View::segments)
    paintSegments (model, picture);
  return (picture);
}

Overlay
overlayOf (const ViewerModel& model, View view)
{
  Overlay overlay;
  const AttentionResults& results = model.results ();
  if (!results.scene)
    return (overlay);
  if (view == View::points && model.switches.skeletons && results.attention_points)
    addSkeletons (*results.attention_points, overlay);
  if (view == View::patches && model.switches.convexity && results.patches && results.patch_graph)
    addBorders (*results.patches, *results.patch_graph, overlay);
  const bool errors = model.switches.errors && results.scene->truth; // which lie where the outlines are
  if (view == View::segments && model.switches.outlines && !errors)
    for (const AttentionSegment& segment : model.segments ())
      if (!model.selected () || model.selected ()->rank == segment.rank)
        addOutline (segment, results.scene->cloud.width, results.scene->cloud.height, overlay);
  return (overlay);
}

std::vector<FixationMark>
fixationMarks (const ViewerModel& model, View view, bool large)
{
  std::vector<FixationMark> marks;
  if (!model.switches.fixations || (view != View::points && view != View::segments))
    return (marks);
  for (std::size_t k = 0; k < model.segments ().size (); ++k)
  {
    const AttentionSegment& segment = model.segments ()[k];
    std::array<char, 32> score{};
    const bool selected = model.selection () == static_cast<int> (k);
    if (view == View::segments && (large || selected) && model.score (k) >= 0.0)
      std::snprintf (score.data (), score.size (), "  F %.2f", model.score (k));
    marks.push_back ({segment.attention_point.column, segment.attention_point.row,
                      std::to_string (segment.rank) + score.data (), segmentColor (segment.rank), selected});
  }
  return (marks);
}

std::string
titleOf (const ViewerModel& model, View view)
{
  switch (view)
  {
  case View::color:
    return (model.switches.normals ? "Normals" : "Colour");
  case View::saliency:
    if (model.saliencyLevel () > 0)
      return ("Saliency, level " + std::to_string (model.saliencyLevel ()));
    return (model.results ().image_saliency ? "Saliency of the colours" : "Saliency");
  case View::points:
    return (hasSkeletons (model) ? "Skeletons and fixations" : "Fixations");
  case View::patches:
    return (model.step () >= 0 ? "Growth of object " + std::to_string (model.selected ()->rank) : "Patches");
  case View::segments:
    return (model.switches.errors && model.results ().scene && model.results ().scene->truth ? "Wrong pixels"
                                                                                             : "Objects");
  }
  return ("");
}

std::vector<LegendEntry>
legendOf (const ViewerModel& model, View view)
{
  std::vector<LegendEntry> legend;
  if (view == View::color && model.switches.normals)
    legend = {{{255, 128, 128}, "to the right"}, {{128, 255, 128}, "up"}, {{128, 128, 255}, "to the camera"}};
  if (view == View::points && model.switches.skeletons)
  {
    if (hasSkeletons (model))
      legend.push_back ({line_color, "skeleton"});
    legend.push_back ({candidate_color, "attention point"});
  }
  if (view == View::patches && model.step () >= 0)
    legend = {{grown, "object so far"}, {good, "accepted"}, {bad, "refused"}};
  if (view == View::patches && model.switches.convexity)
    for (const LegendEntry& entry :
         {LegendEntry{good, "convex"}, {convexityColor (0.0f), "flat"}, {bad, "concave"}, {depth_edge, "depth edge"}})
      legend.push_back (entry);
  if (view == View::segments && model.switches.errors && model.results ().scene && model.results ().scene->truth)
    legend = {{good, "right"}, {bad, "wrong"}, {missed, "missed"}};
  if (view == View::segments && model.switches.hull && model.selected ())
    legend.push_back ({{255, 170, 40}, "visible faces of the hull"});
  return (legend);
}

} // namespace pcl_attention
