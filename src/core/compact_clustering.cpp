// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/compact_clustering.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace pcl_attention
{

const char*
toString (GrowthConstraint constraint)
{
  switch (constraint)
  {
    case GrowthConstraint::connection:
      return ("connection");
    case GrowthConstraint::convexity:
      return ("convexity");
    case GrowthConstraint::color:
      return ("color");
    case GrowthConstraint::compactness:
      return ("compactness");
    case GrowthConstraint::support:
      return ("support");
    case GrowthConstraint::none:
      break;
  }
  return ("none");
}

/** \brief The growing object. */
struct CompactClustering::Object
{
  std::vector<int> patches;
  std::vector<std::uint8_t> member;   /**< at [label] */
  std::map<int, PatchBorder> borders; /**< to every neighbour that is no member, seen from the object */
  std::vector<Eigen::Vector3f> samples;
  std::vector<Eigen::Vector3f> hull_vertices;
  ColorHistogram histogram;
  std::size_t pixels{0};
  int perimeter{0};
  ColorHistogram surroundings; /**< the not-object, worked out when it is first needed after a change */
  bool surroundings_known{false};
};

CompactClustering::CompactClustering (const OrganizedCloud& cloud, const PlanarPatches& patches, const PatchGraph& graph,
                                      const std::vector<std::uint8_t>& support_patches,
                                      const ClusteringParameters& parameters)
: cloud_ (cloud), patches_ (patches), graph_ (graph), support_patches_ (support_patches), parameters_ (parameters)
{
  const std::size_t count = patches.patches.size () + 1;
  samples_.resize (count);
  hull_vertices_.resize (count);
  histograms_.resize (count);
  color_bins_ = colorBins (cloud);
  for (std::size_t label = 1; label < count; ++label)
  {
    const pcl::Indices& pixels = patches.patches[label - 1].pixels;
    const std::size_t samples = std::min (pixels.size (), static_cast<std::size_t> (parameters.compactness_samples));
    for (std::size_t sample = 0; sample < samples; ++sample)
    {
      const pcl::index_t index = pixels[sample * pixels.size () / samples];
      samples_[label].emplace_back (cloud.x[index], cloud.y[index], cloud.z[index]);
    }
    if (!color_bins_.empty ())
      for (const pcl::index_t index : pixels)
        histograms_[label].add (color_bins_[index]);
  }
}

const std::vector<Eigen::Vector3f>&
CompactClustering::hullVertices (int label)
{
  constexpr std::size_t most_points = 1000;
  std::vector<Eigen::Vector3f>& vertices = hull_vertices_[label];
  if (vertices.empty ())
  {
    const pcl::Indices& pixels = patches_.patches[label - 1].pixels;
    const std::size_t count = std::min (pixels.size (), most_points);
    for (std::size_t i = 0; i < count; ++i)
    {
      const pcl::index_t index = pixels[i * pixels.size () / count];
      vertices.emplace_back (cloud_.x[index], cloud_.y[index], cloud_.z[index]);
    }
    // The hull of a union is the hull of the hulls' vertices.
    vertices = computeVisibleHull (vertices).vertices;
  }
  return (vertices);
}

std::vector<int>
CompactClustering::initialPatches (const AttentionPoint& point) const
{
  const auto isTaken = [this] (int label) {
    return (parameters_.stay_off_support && !support_patches_.empty () && support_patches_[label]);
  };
  // Nearest first, so that the first label is the patch at the point, or the nearest one to it.
  std::vector<std::pair<int, int>> near;
  const int radius = parameters_.initial_radius;
  for (int row = point.row - radius; row <= point.row + radius; ++row)
    for (int column = point.column - radius; column <= point.column + radius; ++column)
    {
      const int distance = (row - point.row) * (row - point.row) + (column - point.column) * (column - point.column);
      if (!patches_.labels.contains (column, row) || distance > radius * radius)
        continue;
      const int label = patches_.labels (column, row);
      if (label && !isTaken (label))
        near.emplace_back (distance, label);
    }
  std::sort (near.begin (), near.end ());
  std::vector<int> initial;
  for (const auto& candidate : near)
  {
    const int label = candidate.second;
    if (std::find (initial.begin (), initial.end (), label) != initial.end ())
      continue;
    if (!initial.empty () && parameters_.initial_patches == InitialPatches::connected)
    {
      const PatchBorder border = graph_.border (initial.front (), label);
      if (border.pairs == 0 || border.connectedShare () < parameters_.minimum_connection ||
          border.convexity () < std::max (0.0f, parameters_.minimum_convexity))
        continue;
    }
    initial.push_back (label);
  }
  return (initial);
}

void
CompactClustering::addPatch (int label, Object& object)
{
  object.patches.push_back (label);
  object.member[label] = 1;
  object.borders.erase (label);
  for (const int neighbor : graph_.neighbors[label])
    if (!object.member[neighbor])
      object.borders[neighbor] += graph_.border (label, neighbor);
  object.samples.insert (object.samples.end (), samples_[label].begin (), samples_[label].end ());
  std::vector<Eigen::Vector3f> vertices = object.hull_vertices;
  const std::vector<Eigen::Vector3f>& added = hullVertices (label);
  vertices.insert (vertices.end (), added.begin (), added.end ());
  object.hull_vertices = computeVisibleHull (vertices).vertices;
  object.histogram += histograms_[label];
  object.pixels += patches_.patches[label - 1].pixels.size ();
  object.perimeter += graph_.perimeter[label];
  object.surroundings_known = false;
}

float
CompactClustering::compactnessWith (int label, const Object& object)
{
  std::vector<Eigen::Vector3f> vertices = object.hull_vertices, samples = object.samples;
  const std::vector<Eigen::Vector3f>& added = hullVertices (label);
  vertices.insert (vertices.end (), added.begin (), added.end ());
  samples.insert (samples.end (), samples_[label].begin (), samples_[label].end ());
  return (compactness (samples, computeVisibleHull (vertices)));
}

ColorHistogram
CompactClustering::notObject (const Object& object) const
{
  Image<std::uint8_t> enlarged (cloud_.width, cloud_.height, 0);
  std::vector<pcl::index_t> front;
  for (const int label : object.patches)
    for (const pcl::index_t index : patches_.patches[label - 1].pixels)
    {
      enlarged[index] = 1;
      front.push_back (index);
    }
  // Ring by ring, every pixel of the image counting, until the area is doubled.
  std::size_t area = front.size ();
  while (area < 2 * object.pixels && !front.empty ())
  {
    std::vector<pcl::index_t> next;
    for (const pcl::index_t index : front)
    {
      const int column = index % cloud_.width, row = index / cloud_.width;
      for (int r = row - 1; r <= row + 1; ++r)
        for (int c = column - 1; c <= column + 1; ++c)
          if (enlarged.contains (c, r) && !enlarged (c, r) && area < 2 * object.pixels)
          {
            enlarged (c, r) = 1;
            next.push_back (r * cloud_.width + c);
            ++area;
          }
    }
    front = std::move (next);
  }
  ColorHistogram histogram;
  for (std::size_t index = 0; index < cloud_.size (); ++index)
    if (cloud_.valid[index] && !enlarged[index])
      histogram.add (color_bins_[index]);
  return (histogram);
}

std::pair<float, float>
CompactClustering::colorDistances (int label, Object& object) const
{
  if (!object.surroundings_known)
  {
    object.surroundings = notObject (object);
    object.surroundings_known = true;
  }
  return {chiSquare (object.histogram, histograms_[label]), chiSquare (object.surroundings, histograms_[label])};
}

GrowthStep
CompactClustering::tryPatch (int label, const PatchBorder& border, Object& object)
{
  GrowthStep step;
  step.patch = label;
  const auto refuse = [&step] (GrowthConstraint constraint, float value, float limit) {
    step.refused_by = constraint;
    step.value = value;
    step.limit = limit;
    return (step);
  };
  if (parameters_.stay_off_support && !support_patches_.empty () && support_patches_[label])
    return (refuse (GrowthConstraint::support, 1.0f, 0.0f));
  if (border.connectedShare () < parameters_.minimum_connection)
    return (refuse (GrowthConstraint::connection, border.connectedShare (), parameters_.minimum_connection));
  if (border.convexity () < parameters_.minimum_convexity)
    return (refuse (GrowthConstraint::convexity, border.convexity (), parameters_.minimum_convexity));
  if (parameters_.color_constraint != ColorConstraint::off && !color_bins_.empty ())
  {
    const auto [inside, outside] = colorDistances (label, object);
    const bool fulfilled =
      parameters_.color_constraint == ColorConstraint::as_printed ? outside < inside : inside < outside;
    if (!fulfilled)
      return (refuse (GrowthConstraint::color, inside, outside));
  }
  const float kappa = compactnessWith (label, object);
  if (kappa >= parameters_.compactness_threshold)
    return (refuse (GrowthConstraint::compactness, kappa, parameters_.compactness_threshold));
  step.value = kappa;
  step.limit = parameters_.compactness_threshold;
  return (step);
}

void
CompactClustering::growOverBorders (Object& object, AttentionSegment& segment)
{
  bool grown = true;
  while (grown)
  {
    grown = false;
    // In one round every patch is tried once, or again if its border to the object has become longer.
    std::map<int, int> tried;
    while (true)
    {
      int best = 0;
      float best_priority = -1.0f;
      for (const auto& [label, border] : object.borders)
      {
        const auto before = tried.find (label);
        if (before != tried.end () && before->second == border.pairs)
          continue;
        const float priority =
          static_cast<float> (border.connected) / std::max (1, std::min (object.perimeter, graph_.perimeter[label]));
        if (priority > best_priority)
        {
          best = label;
          best_priority = priority;
        }
      }
      if (best == 0)
        break;
      const PatchBorder border = object.borders[best];
      tried[best] = border.pairs;
      const GrowthStep step = tryPatch (best, border, object);
      segment.steps.push_back (step);
      if (step.refused_by == GrowthConstraint::none)
      {
        addPatch (best, object);
        grown = true;
      }
    }
  }
}

bool
CompactClustering::joinOccluded (Object&, AttentionSegment&)
{
  return (false);
}

bool
CompactClustering::grow (const AttentionPoint& point, AttentionSegment& segment)
{
  segment = AttentionSegment ();
  segment.attention_point = point;
  const std::vector<int> initial = initialPatches (point);
  if (initial.empty ())
    return (false);
  Object object;
  object.member.assign (patches_.patches.size () + 1, 0);
  for (const int label : initial)
    addPatch (label, object);
  do
    growOverBorders (object, segment);
  while (parameters_.join_occluded && joinOccluded (object, segment));

  int longest = 0;
  for (const GrowthStep& step : segment.steps)
  {
    const auto border = object.borders.find (step.patch);
    if (step.refused_by != GrowthConstraint::none && border != object.borders.end () && border->second.pairs > longest)
    {
      longest = border->second.pairs;
      segment.growth_end = step.refused_by;
    }
  }
  segment.patches = object.patches;
  for (const int label : object.patches)
  {
    const pcl::Indices& pixels = patches_.patches[label - 1].pixels;
    segment.indices.insert (segment.indices.end (), pixels.begin (), pixels.end ());
  }
  std::sort (segment.indices.begin (), segment.indices.end ());
  segment.compactness = compactness (object.samples, computeVisibleHull (object.hull_vertices));
  const PlanarPatch& first = patches_.patches[initial.front () - 1];
  segment.plane << first.normal, -first.normal.dot (first.centroid);
  return (true);
}

} // namespace pcl_attention
