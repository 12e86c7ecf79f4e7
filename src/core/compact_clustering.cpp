// SPDX-License-Identifier: BSD-3-Clause
#include "image_outline.h"
#include "nonzero.h"
#include "object_hull.h"
#include "patch_groups.h"
#include "point_at.h"

#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/compact_clustering.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl_attention
{

namespace
{

/** \brief Share of a piece that lies within an outline if the piece does. */
constexpr float almost_all = 0.8f;

/** \brief A patch is large if it is at least so much of its piece, as 1 / n. */
constexpr int large_share = 5;

/** \brief So many points fix a mean over an object to a fifth of a millimetre, however many patches it has. */
constexpr std::size_t enough_samples = 400;

bool
areParallel (const PlanarPatch& first, const PlanarPatch& second)
{
  constexpr float parallel = 0.95f;
  return (first.normal.dot (second.normal) >= parallel);
}

} // namespace

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

/** \brief A set of patches: the growing object, or what it may join. */
struct CompactClustering::Piece
{
  std::vector<int> patches;           /**< first those that have grown together, then those of what was joined */
  std::vector<int> inside;            /**< those of them that are the inside of a hollow */
  std::vector<std::uint8_t> member;   /**< at [label] */
  std::map<int, PatchBorder> borders; /**< to every neighbour that is no member, seen from the piece */
  ObjectHull hull;
  HexconeHistogram colors;
  ColorHistogram histogram; /**< for the colour constraint; empty without it */
  int pixels{0};
  int perimeter{0};            /**< contour pairs */
  float hollowness{0.0f};           /**< of what has grown together, and of the other halves of an inside */
  std::vector<GrowthStep> steps;    /**< how it has grown */
  bool is_cut{false};               /**< of the partition: it would have grown on into another of its pieces */
  ColorHistogram surroundings; /**< the not-object, worked out when it is first needed after a change */
  bool surroundings_known{false};
};

CompactClustering::CompactClustering (const OrganizedCloud& cloud, const SensorModel& sensor, const NormalImage& normals,
                                      const PlanarPatches& patches, const PatchGraph& graph,
                                      const std::vector<std::uint8_t>& support_patches, const ClusteringParameters& parameters,
                                      int threads)
: cloud_ (cloud),
  patches_ (patches),
  graph_ (graph),
  support_patches_ (support_patches),
  parameters_ (parameters),
  sensor_ (sensor),
  threads_ (threads),
  hull_grid_ (std::make_unique<HullGrid> (cloud, threads))
{
  const std::size_t count = patches.patches.size () + 1;
  samples_.resize (count);
  rows_.resize (count);
  hulls_.resize (count);
  patch_hollowness_.resize (count);
  piece_of_.resize (count);
  with_halves_.resize (count);
  for (std::size_t label = 1; label < count; ++label)
    if (!patches.patches[label - 1].pixels.empty () && !isStayedOff (static_cast<int> (label)))
      seeds_.push_back (static_cast<int> (label));
  std::stable_sort (seeds_.begin (), seeds_.end (), [&] (int a, int b) {
    return (patches.patches[a - 1].pixels.size () > patches.patches[b - 1].pixels.size ());
  });
  findIslands ();
  colors_.resize (count);
  histograms_.resize (count);
  if (parameters.color_constraint != ColorConstraint::off)
    color_bins_ = colorBins (cloud);
  for (std::size_t index = 0; index < color_bins_.size (); ++index)
    if (cloud.valid[index])
      scene_histogram_.add (color_bins_[index]);
  forEachSeed ([&] (int label) {
    const pcl::Indices& pixels = patches.patches[label - 1].pixels;
    const std::size_t samples = std::min (pixels.size (), static_cast<std::size_t> (parameters.compactness_samples));
    samples_[label].reserve (samples);
    for (std::size_t sample = 0; sample < samples; ++sample)
    {
      const pcl::index_t index = pixels[sample * pixels.size () / samples];
      samples_[label].push_back ({pointAt (cloud, index),
                                  {normals.x[index], normals.y[index], normals.z[index]},
                                  static_cast<float> (pixels.size ()) / static_cast<float> (samples)});
    }
    rows_[label] = rowsOf (pixels, cloud.width);
    colors_[label] = colorsOf (cloud, pixels);
    for (std::size_t i = 0; i < pixels.size () && !color_bins_.empty (); ++i)
      histograms_[label].add (color_bins_[pixels[i]]);
  });
}

CompactClustering::~CompactClustering () = default;

void
CompactClustering::findIslands ()
{
  // A border of several patches has no larger share that is connected than the best of them.
  const std::vector<std::uint8_t> excluded = parameters_.stay_off_support ? support_patches_ : std::vector<std::uint8_t> ();
  island_of_ = groupsOf (graph_, patches_.patches.size (), excluded, [this] (const PatchBorder& border) {
    return (border.connectedShare () >= parameters_.minimum_connection);
  });
  islands_.resize (*std::max_element (island_of_.begin (), island_of_.end ()) + 1);
  for (const int seed : seeds_)
    islands_[island_of_[seed]].seeds.push_back (seed);
}

void
CompactClustering::forEachSeed (const std::function<void (int label)>& work) const
{
  constexpr int together = 4; // the first ones are the largest
  forEachBand (static_cast<int> (seeds_.size ()), together, threads_, [&] (int begin, int end) {
    std::for_each (seeds_.begin () + begin, seeds_.begin () + end, work);
  });
}

const ObjectHull&
CompactClustering::patchHull (int label)
{
  if (!hulls_[label])
  {
    // The outline goes through ends of rows; some points between them tell how far the patch bulges.
    constexpr std::size_t enough_between = 200;
    const pcl::Indices& pixels = patches_.patches[label - 1].pixels;
    const std::size_t step = std::max<std::size_t> (1, pixels.size () / enough_between);
    std::vector<Eigen::Vector3f> points;
    for (std::size_t i = 0; i < pixels.size (); ++i)
      if (i % step == 0 || isRowEnd (pixels, i, cloud_.width))
        points.push_back (pointAt (cloud_, pixels[i]));
    constexpr float decides_nothing = 0.1f; // of the limit that distances to the hull are compared with
    hulls_[label] = std::make_unique<ObjectHull> (parameters_.hull_method, *hull_grid_,
                                                  decides_nothing * compactnessLimit (label));
    hulls_[label]->add (points);
  }
  return (*hulls_[label]);
}

std::vector<int>
CompactClustering::initialPatches (const AttentionPoint& point) const
{
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
      if (label && !isStayedOff (label))
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
CompactClustering::addPatch (int label, Piece& piece)
{
  if (piece.patches.empty ())
    return (addPatch (label, piece, ObjectHull (patchHull (label))));
  ObjectHull united = std::move (piece.hull);
  united.add (patchHull (label));
  addPatch (label, piece, std::move (united));
}

void
CompactClustering::addPatch (int label, Piece& piece, ObjectHull&& united)
{
  if (piece.member.empty ())
    piece.member.assign (patches_.patches.size () + 1, 0);
  const auto common = piece.borders.find (label);
  piece.perimeter += graph_.perimeter[label];
  if (common != piece.borders.end ())
  {
    piece.perimeter -= 2 * common->second.pairs;
    piece.borders.erase (common);
  }
  piece.patches.push_back (label);
  piece.member[label] = 1;
  for (const int neighbor : graph_.neighbors[label])
    if (!piece.member[neighbor])
      piece.borders[neighbor] += graph_.border (label, neighbor);
  piece.hull = std::move (united);
  piece.colors += colors_[label];
  piece.histogram += histograms_[label];
  piece.pixels += static_cast<int> (patches_.patches[label - 1].pixels.size ());
  piece.surroundings_known = false;
}

Eigen::Vector3f
CompactClustering::centroidOf (const std::vector<int>& labels) const
{
  std::size_t pixels = 0;
  for (const int label : labels)
    pixels += patches_.patches[label - 1].pixels.size ();
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero ();
  for (const int label : labels)
  {
    const PlanarPatch& patch = patches_.patches[label - 1];
    centroid += patch.centroid * (static_cast<float> (patch.pixels.size ()) / static_cast<float> (pixels));
  }
  return (centroid);
}

template <typename Visit> void
CompactClustering::forEachSample (const std::vector<int>& labels, const Visit& visit) const
{
  std::size_t count = 0;
  for (const int label : labels)
    count += samples_[label].size ();
  const std::size_t step = std::max<std::size_t> (1, count / enough_samples);
  std::size_t next = 0; // counted from the first sample of the patch
  for (const int label : labels)
  {
    const std::vector<Sample>& samples = samples_[label];
    for (; next < samples.size (); next += step)
      visit (samples[next]);
    next -= samples.size ();
  }
}

float
CompactClustering::hollownessOf (const std::vector<int>& labels) const
{
  const Eigen::Vector3f centroid = centroidOf (labels);
  float sum = 0.0f, weights = 0.0f;
  forEachSample (labels, [&] (const Sample& sample) {
    const Eigen::Vector3f inwards = centroid - sample.point;
    const float length = inwards.norm ();
    if (length < 1e-6f)
      return;
    sum += sample.weight * sample.normal.dot (inwards) / length;
    weights += sample.weight;
  });
  return (weights > 0.0f ? sum / weights : 0.0f);
}

float
CompactClustering::patchHollowness (int label)
{
  if (!patch_hollowness_[label])
    patch_hollowness_[label] = hollownessOf ({label});
  return (*patch_hollowness_[label]);
}

bool
CompactClustering::isPlane (int label) const
{
  const PlanarPatch& patch = patches_.patches[label - 1];
  return (static_cast<int> (patch.pixels.size ()) >= parameters_.certain_size && patch.rms < withNoise (0.0f, patch.centroid.z ()));
}

float
CompactClustering::compactnessOf (const std::vector<int>& labels, const VisibleHull& hull, bool hollow) const
{
  std::vector<Eigen::Vector3f> points;
  std::vector<float> weights;
  points.reserve (2 * enough_samples);
  weights.reserve (2 * enough_samples);
  forEachSample (labels, [&] (const Sample& sample) {
    points.push_back (sample.point);
    weights.push_back (sample.weight);
  });
  return (hollow ? hollowCompactness (points, hull, weights, parameters_.face_distance)
                 : compactness (points, hull, weights, parameters_.face_distance));
}

ColorHistogram
CompactClustering::notObject (const Piece& piece) const
{
  Image<std::uint8_t> enlarged (cloud_.width, cloud_.height, 0);
  for (const int label : piece.patches)
    for (const pcl::index_t index : patches_.patches[label - 1].pixels)
      enlarged[index] = 1;
  const auto forFreeNeighbors = [&] (pcl::index_t index, const auto& visit) {
    const int column = index % cloud_.width, row = index / cloud_.width;
    const int left = std::max (0, column - 1), right = std::min (cloud_.width - 1, column + 1);
    for (int r = std::max (0, row - 1); r <= std::min (cloud_.height - 1, row + 1); ++r)
      for (pcl::index_t neighbor = r * cloud_.width + left; neighbor <= r * cloud_.width + right; ++neighbor)
        if (!enlarged[neighbor])
          visit (neighbor);
  };
  std::vector<pcl::index_t> front;
  for (const int label : piece.patches)
    for (const pcl::index_t index : patches_.patches[label - 1].pixels)
    {
      bool on_contour = false;
      forFreeNeighbors (index, [&] (pcl::index_t) { on_contour = true; });
      if (on_contour)
        front.push_back (index);
    }
  // Ring by ring, every pixel of the image counting, until the area is doubled.
  ColorHistogram within = piece.histogram;
  int to_add = piece.pixels;
  while (to_add > 0 && !front.empty ())
  {
    std::vector<pcl::index_t> next;
    for (const pcl::index_t index : front)
      forFreeNeighbors (index, [&] (pcl::index_t neighbor) {
        if (to_add == 0)
          return;
        enlarged[neighbor] = 1;
        next.push_back (neighbor);
        --to_add;
        if (cloud_.valid[neighbor])
          within.add (color_bins_[neighbor]);
      });
    front = std::move (next);
  }
  ColorHistogram histogram = scene_histogram_;
  histogram -= within;
  return (histogram);
}

std::pair<float, float>
CompactClustering::colorDistances (int label, Piece& piece) const
{
  if (!piece.surroundings_known)
  {
    piece.surroundings = notObject (piece);
    piece.surroundings_known = true;
  }
  return {chiSquare (piece.histogram, histograms_[label]), chiSquare (piece.surroundings, histograms_[label])};
}

bool
CompactClustering::isOneInside (const Piece& piece, int label, const PatchBorder& border)
{
  // Half of a mug's inside may be flat, but both together surround their middle. So do a box's front and what it stands on, at a right
  // angle, where the convexity is the negative root of 2.
  constexpr float surrounded = 0.25f, between_two_boxes = -1.0f;
  const float of_patch = patchHollowness (label);
  if (!parameters_.recognize_hollows || !parameters_.join_hollows || border.convexity () < between_two_boxes ||
      std::min (piece.hollowness, of_patch) < -parameters_.certain_hollowness ||
      std::min (piece.pixels, static_cast<int> (patches_.patches[label - 1].pixels.size ())) < parameters_.certain_size)
    return (false);
  std::vector<int> together = piece.patches;
  together.push_back (label);
  const float of_both = hollownessOf (together);
  return (of_both > surrounded && of_both > std::max (piece.hollowness, of_patch));
}

float
CompactClustering::contactOf (int label, const PatchBorder& border, const Piece& piece) const
{
  int of_patch = 0, of_piece = 0; // contour pairs; towards a hole in the depth there may be anything
  for (const int neighbor : graph_.neighbors[label])
    of_patch += graph_.border (label, neighbor).pairs;
  for (const auto& neighbor : piece.borders)
    of_piece += neighbor.second.pairs;
  return (static_cast<float> (border.connected) / static_cast<float> (std::max (1, std::min (of_patch, of_piece))));
}

GrowthStep
CompactClustering::tryPatch (int label, const PatchBorder& border, Piece& piece,
                             ObjectHull& united)
{
  GrowthStep step;
  step.patch = label;
  const auto refuse = [&step] (GrowthConstraint constraint, float value, float limit) {
    step.refused_by = constraint;
    step.value = value;
    step.limit = limit;
    return (step);
  };
  if (isStayedOff (label))
    return (refuse (GrowthConstraint::support, 1.0f, 0.0f));
  if (border.connectedShare () < parameters_.minimum_connection)
    return (refuse (GrowthConstraint::connection, border.connectedShare (), parameters_.minimum_connection));

  const float contrast = colorContrast (piece.colors, colors_[label]);
  const int patch_pixels = static_cast<int> (patches_.patches[label - 1].pixels.size ());
  // A small patch is of no other object.
  if (const float needed = parameters_.color_contact * contrast;
      needed > 0.0f && large_share * std::min (piece.pixels, patch_pixels) >= std::max (piece.pixels, patch_pixels))
  {
    const float contact = contactOf (label, border, piece);
    if (contact < needed)
      return (refuse (GrowthConstraint::connection, contact, needed));
  }
  bool hollow = false;
  if (parameters_.minimum_convexity > -2.0f)
  {
    float limit = parameters_.minimum_convexity;
    if (parameters_.recognize_hollows)
    {
      const float of_patch = patchHollowness (label);
      const auto [less, more] = std::minmax (piece.hollowness, of_patch);
      hollow = less > parameters_.minimum_hollowness;
      const bool is_floor = parameters_.separate_floors &&
                            (isPlane (label) || (piece.patches.size () == 1 && isPlane (piece.patches.front ())));
      if (hollow && !is_floor)
        limit = std::min (limit, -0.7f);
      const bool inside_and_outside = more > parameters_.certain_hollowness && less < -parameters_.certain_hollowness &&
                                      std::min (piece.pixels, patch_pixels) >= parameters_.certain_size;
      if (inside_and_outside)
        return (refuse (GrowthConstraint::convexity, -2.0f, limit));
      const auto isInside = [this] (float hollowness, int pixels) {
        return (hollowness > parameters_.certain_hollowness && pixels >= parameters_.certain_size);
      };
      if (border.convexity () > parameters_.rim_convexity && (isInside (piece.hollowness, piece.pixels) || isInside (of_patch, patch_pixels)))
        return (refuse (GrowthConstraint::convexity, border.convexity (), parameters_.rim_convexity));
    }
    limit += parameters_.color_convexity * contrast;
    if (border.convexity () < limit)
    {
      hollow = contrast <= 0.0f && isOneInside (piece, label, border);
      if (!hollow)
        return (refuse (GrowthConstraint::convexity, border.convexity (), limit));
    }
  }
  if (parameters_.color_constraint != ColorConstraint::off && !color_bins_.empty ())
  {
    const auto [inside, outside] = colorDistances (label, piece);
    const bool fulfilled =
      parameters_.color_constraint == ColorConstraint::as_printed ? outside < inside : inside < outside;
    if (!fulfilled)
      return (refuse (GrowthConstraint::color, inside, outside));
  }
  united = piece.hull;
  united.add (patchHull (label));
  std::vector<int> together = piece.patches;
  together.push_back (label);
  const float kappa = compactnessOf (together, united.visible (), hollow);
  // Noise moves the hull outwards, the points not: their mean distance grows by as much.
  const float likeness = 1.0f - parameters_.color_compactness * std::max (0.0f, contrast);
  const float limit = likeness * compactnessLimit (label);
  if (kappa >= limit)
    return (refuse (GrowthConstraint::compactness, kappa, limit));
  step.value = kappa;
  step.limit = limit;
  return (step);
}

void
CompactClustering::growOverBorders (Piece& piece, bool of_partition)
{
  // What is joined later lies apart, so that only what has grown together tells whether it is hollow.
  piece.hollowness = hollownessOf (piece.patches);
  bool grown = true;
  while (grown)
  {
    grown = false;
    // In one round every patch is tried once, or again if its border to the piece has become longer.
    std::map<int, int> tried;
    while (true)
    {
      int best = 0;
      float best_priority = -1.0f;
      for (const auto& [label, border] : piece.borders)
      {
        // What is of another island is not asked for its piece, which may be growing beside this one.
        if (piece.is_cut && island_of_[label] == island_of_[piece.patches.front ()] && piece_of_[label])
          continue;
        const auto before = tried.find (label);
        if (before != tried.end () && before->second == border.pairs)
          continue;
        const float priority =
          static_cast<float> (border.connected) / std::max (1, std::min (piece.perimeter, graph_.perimeter[label]));
        if (priority > best_priority)
        {
          best = label;
          best_priority = priority;
        }
      }
      if (best == 0)
        break;
      const PatchBorder border = piece.borders[best];
      tried[best] = border.pairs;
      ObjectHull united;
      const GrowthStep step = tryPatch (best, border, piece, united);
      const bool is_allowed = step.refused_by == GrowthConstraint::none;
      if (is_allowed && of_partition && piece_of_[best])
      {
        piece.is_cut = true;
        continue;
      }
      piece.steps.push_back (step);
      if (is_allowed)
      {
        addPatch (best, piece, std::move (united));
        piece.hollowness = hollownessOf (piece.patches);
        grown = true;
      }
    }
  }
  if (piece.hollowness > parameters_.certain_hollowness)
    piece.inside = piece.patches;
}

CompactClustering::Piece
CompactClustering::grownFrom (int label)
{
  const Piece* const known = piece_of_[label];
  if (known && known->patches.front () == label && !known->is_cut)
    return (*known);
  Piece piece;
  addPatch (label, piece);
  growOverBorders (piece, false);
  return (piece);
}

const CompactClustering::Piece&
CompactClustering::pieceAt (int label)
{
  Island& island = islands_[island_of_[label]];
  while (!piece_of_[label])
  {
    const int seed = island.seeds[island.next++];
    if (piece_of_[seed])
      continue;
    auto piece = std::make_unique<Piece> ();
    addPatch (seed, *piece);
    growOverBorders (*piece, true);
    for (const int member : piece->patches)
      piece_of_[member] = piece.get ();
    island.pieces.push_back (std::move (piece));
  }
  return (*piece_of_[label]);
}

void
CompactClustering::growAhead (const std::function<bool ()>& is_over)
{
  if (!is_over ())
    forEachSeed ([this] (int label) {
      patchHull (label);
      patchHollowness (label);
    });
  if (!parameters_.joinsPieces ())
    return;
  forEachBand (static_cast<int> (islands_.size ()), 1, threads_, [&] (int island, int) {
    for (const int seed : islands_[island].seeds)
    {
      if (is_over ())
        return;
      pieceAt (seed);
    }
  });
  forEachBand (static_cast<int> (islands_.size ()), 1, threads_, [&] (int island, int) {
    for (const auto& piece : islands_[island].pieces)
    {
      if (is_over ())
        return;
      withHalves (*piece);
    }
  });
}

PatchBorder
CompactClustering::borderBetween (const Piece& piece, const Piece& other) const
{
  PatchBorder border;
  for (const int label : other.patches)
  {
    const auto found = piece.borders.find (label);
    if (found != piece.borders.end ())
      border += found->second;
  }
  return (border);
}

int
CompactClustering::commonPixels (const Piece& piece, const Piece& other) const
{
  int common = 0;
  for (const int label : other.patches)
    if (piece.member[label])
      common += static_cast<int> (patches_.patches[label - 1].pixels.size ());
  return (common);
}

bool
CompactClustering::isSame (const Piece& piece, const Piece& other) const
{
  return (2 * commonPixels (piece, other) > std::min (piece.pixels, other.pixels));
}

bool
CompactClustering::isHandleOf (const Piece& object, const Piece& piece)
{
  if (parameters_.handle_size * piece.pixels > object.pixels || piece.hollowness > parameters_.certain_hollowness ||
      chiSquare (object.colors, piece.colors) > parameters_.joined_color)
    return (false);
  // The contour is counted in four directions, so that a strip of w pixels has four pairs for every w pixels of its area.
  const float depth = patches_.patches[piece.patches.front () - 1].centroid.z ();
  const float width = 4.0f * static_cast<float> (piece.pixels) / std::max (1, piece.perimeter) * depth / sensor_.focal_length;
  if (!(width < parameters_.handle_width))
    return (false);
  const PatchBorder border = borderBetween (object, piece);
  if (border.connected < 0.05f * piece.perimeter)
    return (false);
  for (const auto& [label, other] : piece.borders)
  {
    if (object.member[label])
      continue;
    // What stands on the table itself, or hangs on something else, is an object of its own.
    const int connected = isSupport (label)                    ? other.connected
                          : isSame (pieceAt (label), object) ? 0
                                                              : borderBetween (pieceAt (label), piece).connected;
    if (connected > border.connected)
      return (false);
  }
  return (true);
}

std::vector<const CompactClustering::Piece*>
CompactClustering::standingBetween (const Piece& wall, const Piece& inside, const RowSpans& mouth)
{
  constexpr float enough = 0.3f; // the rest may look out of the hollow
  std::set<const Piece*> neighbors;
  for (const auto& border : inside.borders)
    if (!wall.member[border.first] && !isStayedOff (border.first))
      neighbors.insert (&pieceAt (border.first));
  std::vector<const Piece*> standing;
  for (const Piece* piece : neighbors)
  {
    const PatchBorder to_inside = borderBetween (*piece, inside), to_wall = borderBetween (*piece, wall);
    if (2 * to_wall.second_in_front > to_wall.pairs && 2 * to_inside.second_in_front < to_inside.pairs &&
        liesWithin (mouth, *piece, enough))
      standing.push_back (piece);
  }
  return (standing);
}

bool
CompactClustering::isRim (const Piece& wall, const Piece& inside) const
{
  PointMoments rim;
  for (const int inside_label : inside.patches)
    for (const int label : graph_.neighbors[inside_label])
    {
      if (inside.member[label])
        continue;
      const BorderPoints points = graph_.borderPoints (inside_label, label);
      if (!wall.member[label])
        rim += points.first_in_front;
      else
      {
        rim += points.second_connected;
        rim += points.second_in_front;
      }
    }
  const float limit = withNoise (parameters_.surface_tolerance, centroidOf (inside.patches).z ());
  return (rim.count > 0 && rim.flatness () <= limit);
}

bool
CompactClustering::isHollowOf (const Piece& object, const Piece& piece)
{
  constexpr float least_score = 0.1f;
  const bool object_is_hollow = object.hollowness > parameters_.certain_hollowness,
             piece_is_hollow = piece.hollowness > parameters_.certain_hollowness;
  if (object_is_hollow == piece_is_hollow)
    return (false);
  const Piece& inside = object_is_hollow ? object : piece;
  const Piece& wall = object_is_hollow ? piece : object;
  // A crease between two objects curves inwards as well.
  if (inside.pixels < parameters_.certain_size)
    return (false);
  std::optional<RowSpans> mouth; // once a candidate is like enough
  // The wall is the neighbour with most of the border and the likest colours.
  const auto score = [&] (const Piece& candidate) {
    if (candidate.hollowness > parameters_.minimum_hollowness)
      return (0.0f); // another part of the inside
    const float likeness = 1.05f - chiSquare (candidate.colors, inside.colors);
    if (likeness < least_score)
      return (0.0f); // whatever its share
    if (!mouth)
      mouth = outlineOf (inside.inside);
    int pairs = borderBetween (candidate, inside).pairs;
    for (const Piece* standing : standingBetween (candidate, inside, *mouth))
      pairs += borderBetween (candidate, *standing).pairs;
    const float share = static_cast<float> (pairs) / std::max (1, inside.perimeter);
    const float value = share * likeness;
    // Nor is what stands in a hollow a wall of it.
    const bool is_wall = value >= least_score && isRim (candidate, inside) &&
                         !liesWithin (*mouth, candidate, almost_all);
    return (is_wall ? value : 0.0f);
  };
  const float own = score (wall);
  if (own <= 0.0f)
    return (false);
  for (const auto& neighbor : inside.borders)
    if (!wall.member[neighbor.first] && !isSupport (neighbor.first) && !isSame (pieceAt (neighbor.first), wall) &&
        score (pieceAt (neighbor.first)) > own)
      return (false);
  return (true);
}

const std::vector<int>&
CompactClustering::insideOf (const Piece& piece)
{
  return (piece.inside.empty () ? piece.patches : piece.inside);
}

bool
CompactClustering::areHalvesOfInside (const Piece& piece, const Piece& other) const
{
  // Each may be nearly flat, but both together surround their middle. Two bowls beside each other have no common middle.
  constexpr float surrounded = 0.4f, more_than_either = 0.15f, like_colors = 0.3f;
  if (std::min (piece.pixels, other.pixels) < parameters_.certain_size ||
      std::min (piece.hollowness, other.hollowness) < -parameters_.certain_hollowness ||
      2 * commonPixels (piece, other) > other.pixels || chiSquare (piece.colors, other.colors) > like_colors)
    return (false);
  std::vector<int> together = insideOf (piece);
  together.insert (together.end (), insideOf (other).begin (), insideOf (other).end ());
  return (hollownessOf (together) > std::max (surrounded, more_than_either + std::max (piece.hollowness, other.hollowness)));
}

const CompactClustering::Piece*
CompactClustering::otherHalfOf (const Piece& piece)
{
  if (!parameters_.join_hollows || piece.pixels < parameters_.certain_size ||
      piece.hollowness < -parameters_.certain_hollowness)
    return (nullptr);
  std::set<const Piece*> asked;
  for (const auto& border : piece.borders)
  {
    if (isStayedOff (border.first))
      continue;
    for (const auto& beyond : pieceAt (border.first).borders)
    {
      if (piece.member[beyond.first] || isStayedOff (beyond.first))
        continue;
      const Piece& other = pieceAt (beyond.first);
      if (asked.insert (&other).second && areHalvesOfInside (piece, other))
        return (&other);
    }
  }
  return (nullptr);
}

void
CompactClustering::addPiece (const Piece& other, const std::vector<int>& inside, Piece& piece)
{
  // Also what the piece has already, but did not know to be of an inside.
  for (const int label : inside)
    if (std::find (piece.inside.begin (), piece.inside.end (), label) == piece.inside.end ())
      piece.inside.push_back (label);
  for (const int label : other.patches)
    if (!piece.member[label])
      addPatch (label, piece);
}

void
CompactClustering::joinHalf (const Piece& half, Piece& piece)
{
  piece.inside = insideOf (piece);
  addPiece (half, insideOf (half), piece);
  piece.hollowness = hollownessOf (piece.inside);
}

const CompactClustering::Piece&
CompactClustering::withHalves (const Piece& piece)
{
  std::optional<std::unique_ptr<Piece>>& known = with_halves_[piece.patches.front ()];
  if (!known)
  {
    std::unique_ptr<Piece> whole;
    for (const Piece* half = otherHalfOf (piece); half; half = otherHalfOf (*whole))
    {
      if (!whole)
        whole = std::make_unique<Piece> (piece);
      joinHalf (*half, *whole);
    }
    known = std::move (whole);
  }
  return (*known ? **known : piece);
}

bool
CompactClustering::hidesNothing (const Piece& piece) const
{
  constexpr float almost = 0.1f; // of its contour
  int before = 0;
  for (const auto& border : piece.borders)
    before += border.second.first_in_front;
  return (before <= almost * piece.perimeter);
}

bool
CompactClustering::isFloorOf (const Piece& object, const Piece& piece) const
{
  const float hollow = parameters_.certain_hollowness;
  const bool object_is_hollow = object.hollowness > hollow;
  const Piece& inside = object_is_hollow ? object : piece;
  const Piece& floor = object_is_hollow ? piece : object;
  if (inside.hollowness <= hollow || floor.hollowness < -hollow || inside.pixels < parameters_.certain_size)
    return (false);
  return (hidesNothing (floor) && borderBetween (inside, floor).connected >= 0.25f * floor.perimeter);
}

bool
CompactClustering::isBehindSameOccluder (const Piece& object, const Piece& piece)
{
  const int smallest = parameters_.certain_size;
  if (object.pixels < smallest || piece.pixels < smallest || borderBetween (object, piece).pairs > 0)
    return (false);
  const auto centerPixel = [this] (const Piece& of) {
    Eigen::Vector2f sum = Eigen::Vector2f::Zero ();
    for (const int label : of.patches)
      for (const pcl::index_t index : patches_.patches[label - 1].pixels)
        sum += Eigen::Vector2f (static_cast<float> (index % cloud_.width), static_cast<float> (index / cloud_.width)) /
               static_cast<float> (of.pixels);
    return (sum);
  };
  const Eigen::Vector3f a = centroidOf (object.patches), b = centroidOf (piece.patches);
  if ((a - b).norm () > parameters_.occluded_distance ||
      !goesOnIn (object, piece, chiSquare (object.colors, piece.colors) <= parameters_.joined_color))
    return (false);
  const Eigen::Vector2f from = centerPixel (object), to = centerPixel (piece);
  const int steps = static_cast<int> ((to - from).norm ());
  int between = 0, nearer = 0;
  for (int step = 0; step <= steps; ++step)
  {
    const float share = static_cast<float> (step) / static_cast<float> (std::max (1, steps));
    const Eigen::Vector2f at = from + share * (to - from);
    const int index = static_cast<int> (at.y () + 0.5f) * cloud_.width + static_cast<int> (at.x () + 0.5f);
    const int label = patches_.labels[index];
    if (!cloud_.valid[index] || (label && (object.member[label] || piece.member[label])))
      continue;
    ++between;
    // Linear in the inverse depth, as a plane through both would be.
    const float depth = 1.0f / ((1.0f - share) / a.z () + share / b.z ());
    nearer += cloud_.z[index] < depth - 0.005f;
  }
  if (between == 0 || nearer < 0.8f * between)
    return (false);
  ObjectHull united = object.hull;
  united.add (piece.hull);
  std::vector<int> together = object.patches;
  together.insert (together.end (), piece.patches.begin (), piece.patches.end ());
  return (compactnessOf (together, united.visible (), false) <=
          withNoise (parameters_.compactness_threshold, std::max (a.z (), b.z ())));
}

std::vector<int>
CompactClustering::largePatches (const Piece& piece) const
{
  std::vector<int> large;
  std::copy_if (piece.patches.begin (), piece.patches.end (), std::back_inserter (large), [&] (int label) {
    return (large_share * static_cast<int> (patches_.patches[label - 1].pixels.size ()) >= piece.pixels);
  });
  return (large);
}

bool
CompactClustering::inOnePlane (const PlanarPatch& first, const PlanarPatch& second) const
{
  const Eigen::Vector3f normal = (first.normal + second.normal).normalized ();
  return (std::abs (normal.dot (second.centroid - first.centroid)) <=
          withNoise (parameters_.surface_tolerance, std::max (first.centroid.z (), second.centroid.z ())));
}

bool
CompactClustering::goesOnIn (const Piece& piece, const Piece& other, bool look_alike) const
{
  constexpr float across_each_other = 0.5f;
  std::vector<Eigen::Vector3f> faces; // that go on
  const std::vector<int> large = largePatches (piece), others = largePatches (other);
  for (const int label : large)
    for (const int other_label : others)
    {
      const PlanarPatch &a = patches_.patches[label - 1], &b = patches_.patches[other_label - 1];
      if (!areParallel (a, b))
        continue;
      if (!inOnePlane (a, b))
        return (false);
      if (static_cast<int> (std::min (a.pixels.size (), b.pixels.size ())) >= parameters_.certain_size)
        faces.push_back (a.normal);
    }
  return (look_alike ? !faces.empty () : std::any_of (faces.begin (), faces.end (), [&] (const Eigen::Vector3f& face) {
    return (std::abs (face.dot (faces.front ())) < across_each_other);
  }));
}

bool
CompactClustering::joinPiece (Piece& object)
{
  // Neighbours first, then what lies beyond them.
  std::set<int> seen;
  const auto collect = [&] (int label, std::vector<const Piece*>& pieces) {
    if (object.member[label] || seen.count (label) || isStayedOff (label))
      return;
    const Piece& piece = pieceAt (label);
    seen.insert (piece.patches.begin (), piece.patches.end ());
    if (2 * commonPixels (object, piece) < piece.pixels)
      pieces.push_back (&piece);
  };
  std::vector<const Piece*> neighbors, around;
  for (const auto& border : object.borders)
    collect (border.first, neighbors);
  const auto join = [&] (const Piece& piece) {
    addPiece (piece, piece.inside, object);
    return (true);
  };
  const auto isHandle = [&] (const Piece& piece) {
    return (parameters_.join_handles && (isHandleOf (object, piece) || isHandleOf (piece, object)));
  };
  for (const Piece* piece : neighbors)
  {
    if (isHandle (*piece) || (parameters_.join_hollows && isFloorOf (object, *piece)))
      return (join (*piece));
    const Piece& whole = withHalves (*piece);
    if (parameters_.join_hollows && isHollowOf (object, whole))
      return (join (whole));
  }
  if (parameters_.join_hollows && !object.inside.empty ())
  {
    std::vector<const Piece*> seen_within;
    std::copy_if (neighbors.begin (), neighbors.end (), std::back_inserter (seen_within), [&] (const Piece* piece) {
      return (piece->pixels <= object.pixels && piece->hollowness >= -parameters_.certain_hollowness && hidesNothing (*piece));
    });
    const RowSpans outline = seen_within.empty () ? RowSpans () : outlineOf (object.patches);
    for (const Piece* piece : seen_within)
      if (liesWithin (outline, *piece, almost_all))
        return (join (*piece));
  }
  if (!parameters_.join_occluded)
    return (false);
  // The shadow of an occluder may be so wide that it has no border with what it hides.
  const Eigen::Vector3f center = centroidOf (object.patches);
  const std::vector<int> large = largePatches (object);
  for (const int label : seeds_)
  {
    const PlanarPatch& patch = patches_.patches[label - 1];
    if (static_cast<int> (patch.pixels.size ()) < parameters_.certain_size)
      break; // nor do the smaller ones that follow tell that a face goes on
    if ((patch.centroid - center).norm () <= parameters_.occluded_distance &&
        std::any_of (large.begin (), large.end (), [&] (int own) {
          return (areParallel (patches_.patches[own - 1], patch) && inOnePlane (patches_.patches[own - 1], patch));
        }))
      collect (label, around);
  }
  for (const Piece* piece : around)
    if (isBehindSameOccluder (object, *piece))
      return (join (*piece));
  return (false);
}

RowSpans
CompactClustering::outlineOf (const std::vector<int>& labels) const
{
  std::vector<const RowSpans*> all;
  for (const int label : labels)
    all.push_back (&rows_[label]);
  return (convexOutline (all));
}

pcl::Indices
CompactClustering::pixelsOf (const Piece& object) const
{
  int first_row = cloud_.height, last_row = -1; // of the mouth as well
  for (const int label : object.patches)
  {
    const pcl::Indices& patch = patches_.patches[label - 1].pixels;
    first_row = std::min (first_row, patch.front () / cloud_.width);
    last_row = std::max (last_row, patch.back () / cloud_.width);
  }
  const pcl::index_t before = first_row * cloud_.width;
  std::vector<std::uint8_t> taken (static_cast<std::size_t> (last_row + 1 - first_row) * cloud_.width, 0);
  for (const int label : object.patches)
    for (const pcl::index_t index : patches_.patches[label - 1].pixels)
      taken[index - before] = 1;
  // What was taken for the support, but is seen through the mouth of a hollow, is its floor.
  const RowSpans mouth = parameters_.join_hollows ? outlineOf (object.inside) : RowSpans ();
  for (std::size_t k = 0; k < mouth.columns.size (); ++k)
    for (int column = mouth.columns[k].first; column < mouth.columns[k].second; ++column)
      if (const pcl::index_t index = (mouth.first_row + static_cast<int> (k)) * cloud_.width + column; isSupport (patches_.labels[index]))
        taken[index - before] = 1;
  pcl::Indices pixels;
  pixels.reserve (object.pixels);
  forEachNonZero (taken.data (), taken.data () + taken.size (),
                  [&] (std::ptrdiff_t at) { pixels.push_back (before + static_cast<pcl::index_t> (at)); });
  return (pixels);
}

bool
CompactClustering::liesWithin (const RowSpans& outline, const Piece& piece, float share) const
{
  int within = 0;
  for (const int label : piece.patches)
    for (const pcl::index_t index : patches_.patches[label - 1].pixels)
      within += outline.contains (index % cloud_.width, index / cloud_.width);
  return (within >= share * piece.pixels);
}

float
CompactClustering::confidenceOf (const Piece& object) const
{
  // Where the depth jumps down an object ends to the pixel; behind an occluder it may go on.
  float doubtful = static_cast<float> (object.perimeter);
  for (const auto& [label, border] : object.borders)
    doubtful -= static_cast<float> (border.first_in_front) + 0.75f * static_cast<float> (border.second_in_front);
  return (std::exp (-2.0f * std::max (0.0f, doubtful) / static_cast<float> (std::max (1, object.pixels))));
}

CompactClustering::Piece
CompactClustering::wholeObject (const std::vector<int>& initial)
{
  Piece object;
  if (initial.size () == 1)
    object = grownFrom (initial.front ());
  else
  {
    for (const int label : initial)
      addPatch (label, object);
    growOverBorders (object, false);
  }
  while (const Piece* const half = otherHalfOf (object))
    joinHalf (*half, object);
  while (parameters_.joinsPieces () && joinPiece (object))
  {
  }
  return (object);
}

void
CompactClustering::takeLargerObject (Piece& object)
{
  std::vector<std::pair<int, int>> neighbors;
  for (const auto& [label, border] : object.borders)
    if (border.connected > 0 && !isStayedOff (label))
      neighbors.emplace_back (-border.connected, label);
  std::sort (neighbors.begin (), neighbors.end ());
  std::set<int> seen;
  for (const auto& neighbor : neighbors)
  {
    const Piece& piece = pieceAt (neighbor.second);
    if (piece.pixels < parameters_.handle_size * object.pixels || !seen.insert (*std::min_element (piece.patches.begin (), piece.patches.end ())).second)
      continue;
    Piece larger = wholeObject ({piece.patches.front ()});
    if (2 * commonPixels (larger, object) > object.pixels)
    {
      object = std::move (larger);
      return;
    }
  }
}

bool
CompactClustering::grow (const AttentionPoint& point, const std::vector<int>& initial, AttentionSegment& segment)
{
  segment = AttentionSegment ();
  segment.attention_point = point;
  if (initial.empty ())
    return (false);
  Piece object = wholeObject (initial);
  if (parameters_.join_handles)
    takeLargerObject (object);
  segment.steps = std::move (object.steps);

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
  segment.confidence = confidenceOf (object);
  segment.indices = pixelsOf (object);
  segment.compactness = compactnessOf (object.patches, object.hull.visible (), false);
  const PlanarPatch& first = patches_.patches[initial.front () - 1];
  segment.plane << first.normal, -first.normal.dot (first.centroid);
  return (true);
}

} // namespace pcl_attention
