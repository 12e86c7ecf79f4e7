// SPDX-License-Identifier: BSD-3-Clause
#include "point_at.h"

#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/color_histogram.h>
#include <pcl_attention/core/patch_steps.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl_attention
{

namespace
{

/** \brief Fewer pixels on one side say nothing about a step. */
constexpr std::size_t smallest_side = 200;

struct Plane
{
  Eigen::Vector3f normal, center;
  double rms;
};

Eigen::Matrix3d
covarianceOf (const PointMoments& points)
{
  const Eigen::Vector3d mean = points.sum / points.count;
  return (points.square / points.count - mean * mean.transpose ());
}

/** \brief Sum of the squared distances of the points from the plane that fits them best. */
double
residualOf (const PointMoments& points)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect (covarianceOf (points), Eigen::EigenvaluesOnly);
  return (points.count * std::max (0.0, solver.eigenvalues () (0)));
}

Plane
planeOf (const PointMoments& points)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (covarianceOf (points));
  const Eigen::Vector3f center = (points.sum / points.count).cast<float> ();
  Eigen::Vector3f normal = solver.eigenvectors ().col (0).cast<float> ();
  if (normal.dot (center) > 0.0f)
    normal = -normal;
  return {normal, center, std::sqrt (std::max (0.0, solver.eigenvalues () (0)))};
}

Plane
planeOf (const PlanarPatch& patch)
{
  return {patch.normal, patch.centroid, patch.rms};
}

/** \brief How far one of two planes lies behind the other at the border that their points have in common, metres; 0 at a bend. */
double
stepOf (const Plane& first, const Plane& second, const PointMoments& first_border, const PointMoments& second_border)
{
  // At a bend both lie behind the other's plane or both before it, at a step one before and one behind.
  const double first_side = first_border.fromPlane (second.normal, second.center).first;
  const double second_side = second_border.fromPlane (first.normal, first.center).first;
  return (first_side * second_side < 0.0 ? std::min (std::abs (first_side), std::abs (second_side)) : 0.0);
}

/** \brief How much the points of a common border lie off the other's plane here and there, standard deviation, metres. */
double
spreadOf (const Plane& first, const Plane& second, const PointMoments& first_border, const PointMoments& second_border)
{
  return (std::min (first_border.fromPlane (second.normal, second.center).second,
                    second_border.fromPlane (first.normal, first.center).second));
}

double
limitOf (const PatchGraphParameters& parameters, const Plane& first, const Plane& second)
{
  return (parameters.step_tolerance + parameters.step_roughness * std::max (first.rms, second.rms));
}

/** \brief The place of a sample among so many pixels in rows: evenly spread, and out of step with the rows. */
std::size_t
sampleAt (std::size_t sample, std::size_t samples, std::size_t pixels)
{
  constexpr double golden = 0.6180339887498949;
  double whole;
  const double within = std::modf (static_cast<double> (sample) * golden, &whole);
  return (static_cast<std::size_t> ((static_cast<double> (sample) + within) * static_cast<double> (pixels) /
                                    static_cast<double> (samples)));
}

/** \brief A line in the image. */
struct Line
{
  Eigen::Vector2d direction; /**< across it, unit */
  double offset;             /**< pixels */

  bool
  isBefore (int column, int row) const { return (direction.x () * column + direction.y () * row < offset); }
};

/** \brief Points in two parts, one on either side of a line. */
struct Cut
{
  Line line;
  double residual{std::numeric_limits<double>::infinity ()}; /**< of both parts, m^2 */
  PointMoments before, behind;
  double extent{0.0}; /**< of the points across the line, pixels */
};

/** \brief \ref PointMoments laid out flat, for the many that a search adds up. */
struct FlatMoments
{
  double count{0.0};
  std::array<double, 9> sums{}; /**< x, y, z, xx, xy, xz, yy, yz, zz */

  FlatMoments () = default;
  explicit FlatMoments (const Eigen::Vector3f& point) : count (1.0)
  {
    const double x = point.x (), y = point.y (), z = point.z ();
    sums = {x, y, z, x * x, x * y, x * z, y * y, y * z, z * z};
  }

  FlatMoments&
  operator+= (const FlatMoments& other)
  {
    count += other.count;
    for (std::size_t i = 0; i < sums.size (); ++i)
      sums[i] += other.sums[i];
    return (*this);
  }

  FlatMoments&
  operator-= (const FlatMoments& other)
  {
    count -= other.count;
    for (std::size_t i = 0; i < sums.size (); ++i)
      sums[i] -= other.sums[i];
    return (*this);
  }

  PointMoments
  moments () const
  {
    PointMoments result;
    result.count = static_cast<int> (count);
    result.sum << sums[0], sums[1], sums[2];
    result.square << sums[3], sums[4], sums[5], sums[4], sums[6], sums[7], sums[5], sums[7], sums[8];
    return (result);
  }
};

/** \brief Evenly taken points of a patch and the ways to cut them. */
class CutSearch
{
public:
  CutSearch (const OrganizedCloud& cloud, const pcl::Indices& pixels)
  {
    constexpr std::size_t enough = 400;
    const std::size_t count = std::min (enough, pixels.size ());
    smallest_ = static_cast<int> ((smallest_side * count + pixels.size () - 1) / pixels.size ());
    for (std::size_t i = 0; i < count; ++i)
    {
      const pcl::index_t index = pixels[sampleAt (i, count, pixels.size ())];
      places_.emplace_back (index % cloud.width, index / cloud.width);
      points_.push_back (pointAt (cloud, index));
      flat_.emplace_back (points_.back ());
      all_ += flat_.back ();
    }
  }

  /** \brief The cut that leaves the least residual, of some that are spread over the patch.
    * \return nothing before it where no cut leaves enough pixels on both sides */
  Cut
  coarse () const
  {
    Cut best;
    for (int i = 0; i < directions; ++i)
      tryDirection (i * apart, 16, best);
    return (best);
  }

  /** \brief The same among cuts that lie more densely, in directions near a cut's. */
  Cut
  refined (const Cut& cut) const
  {
    constexpr int finer = 4;
    Cut best = cut;
    const double angle = std::atan2 (cut.line.direction.y (), cut.line.direction.x ());
    for (int i = 1 - finer; i < finer; ++i)
      tryDirection (angle + i * apart / finer, 32, best);
    return (best);
  }

  /** \brief The faces on both sides of a cut, as they are near the line.
    * \param[out] miss how far they miss the line, metres */
  std::pair<Plane, Plane>
  facesAt (const Cut& cut, double& miss) const
  {
    // Shares of the patch's extent. The cut is as exact as its search: what is nearer may be of either face.
    constexpr double uncertain = 0.015, border = 0.09, near = 0.3;
    PointMoments before, behind, before_border, behind_border;
    std::vector<std::size_t> border_points;
    for (std::size_t i = 0; i < points_.size (); ++i)
    {
      const double beyond = beyondOf (cut.line, i), distance = std::abs (beyond) / cut.extent;
      if (distance < uncertain)
        continue;
      if (distance < near)
        (beyond < 0.0 ? before : behind).add (points_[i]);
      if (distance >= border)
        continue;
      (beyond < 0.0 ? before_border : behind_border).add (points_[i]);
      border_points.push_back (i);
    }
    constexpr int enough_for_a_plane = 12;
    const bool is_narrow = before.count < enough_for_a_plane || behind.count < enough_for_a_plane;
    const Plane first = planeOf (is_narrow ? cut.before : before), second = planeOf (is_narrow ? cut.behind : behind);
    miss = std::hypot (stepOf (first, second, before_border, behind_border), twistOf (first, second, cut.line, border_points));
    return {first, second};
  }

private:
  /** \brief How much the distance between two planes changes along a line, standard deviation. Across the line it changes at
    * every bend, and is not counted. */
  double
  twistOf (const Plane& first, const Plane& second, const Line& line, const std::vector<std::size_t>& border_points) const
  {
    double sum_across = 0.0, sum = 0.0, square_across = 0.0, product = 0.0, square = 0.0;
    for (const std::size_t i : border_points)
    {
      const double across = beyondOf (line, i);
      const double distance = second.normal.dot (points_[i] - second.center) - first.normal.dot (points_[i] - first.center);
      sum_across += across;
      sum += distance;
      square_across += across * across;
      product += across * distance;
      square += distance * distance;
    }
    const auto count = static_cast<double> (std::max<std::size_t> (1, border_points.size ()));
    const double variance_across = square_across / count - std::pow (sum_across / count, 2);
    const double covariance = product / count - sum_across / count * sum / count;
    double variance = square / count - std::pow (sum / count, 2);
    if (variance_across > 0.0)
      variance -= covariance * covariance / variance_across;
    return (std::sqrt (std::max (0.0, variance)));
  }

  double
  beyondOf (const Line& line, std::size_t i) const { return (line.direction.dot (places_[i]) - line.offset); }

  static constexpr int directions = 8;
  static constexpr double apart = 3.14159265358979 / directions; /**< radians */

  /** \brief Try the cuts across a direction at so many places. \param[in,out] best the best one so far */
  void
  tryDirection (double angle, int parts, Cut& best) const
  {
    const Eigen::Vector2d direction (std::cos (angle), std::sin (angle));
    double low = std::numeric_limits<double>::infinity (), high = -low;
    for (const Eigen::Vector2d& place : places_)
    {
      const double along = direction.dot (place);
      low = std::min (low, along);
      high = std::max (high, along);
    }
    const double width = (high - low) / parts;
    if (!(width > 0.0))
      return;
    std::vector<FlatMoments> strips (parts);
    for (std::size_t i = 0; i < points_.size (); ++i)
      strips[std::min (parts - 1, static_cast<int> ((direction.dot (places_[i]) - low) / width))] += flat_[i];
    FlatMoments before, behind = all_;
    for (int k = 1; k < parts; ++k)
    {
      before += strips[k - 1];
      behind -= strips[k - 1];
      if (before.count < smallest_ || behind.count < smallest_)
        continue;
      const double residual = residualOf (before.moments ()) + residualOf (behind.moments ());
      if (residual >= best.residual)
        continue;
      best = {{direction, low + k * width}, residual, before.moments (), behind.moments (), high - low};
    }
  }

  std::vector<Eigen::Vector2d> places_; /**< column, row */
  std::vector<Eigen::Vector3f> points_;
  std::vector<FlatMoments> flat_; /**< of each point */
  FlatMoments all_;
  int smallest_; /**< points of a part */
};

/** \brief -1 where both sides have the same colours, 1 where they have none in common, 0 without colour. */
double
contrastAcross (const OrganizedCloud& cloud, const pcl::Indices& pixels, const Line& line)
{
  if (!cloud.hasColor ())
    return (0.0);
  constexpr std::size_t enough = 400;
  std::array<ColorHistogram, 2> sides;
  const std::size_t count = std::min (enough, pixels.size ());
  for (std::size_t i = 0; i < count; ++i)
  {
    const pcl::index_t index = pixels[sampleAt (i, count, pixels.size ())];
    sides[line.isBefore (index % cloud.width, index / cloud.width)].add (
      colorBin (cloud.red[index], cloud.green[index], cloud.blue[index]));
  }
  return (2.0 * chiSquare (sides[0], sides[1]) - 1.0);
}

/** \brief The line that a patch is to be cut along, if there is one. */
std::optional<Line>
stepIn (const OrganizedCloud& cloud, const pcl::Indices& pixels, const PatchGraphParameters& parameters)
{
  if (pixels.size () < 2 * smallest_side)
    return (std::nullopt);
  const CutSearch search (cloud, pixels);
  const auto misses = [&] (const Cut& cut, double share_of_limit) {
    double miss;
    const auto [first, second] = search.facesAt (cut, miss);
    return (miss > share_of_limit * limitOf (parameters, first, second));
  };
  // A coarse cut beside the step shows less of it.
  constexpr double shown_by_a_coarse_cut = 0.5;
  const double least = 1.0 - parameters.step_color; // with all the help of colours
  const Cut coarse = search.coarse ();
  if (coarse.before.count == 0 || !misses (coarse, shown_by_a_coarse_cut * least))
    return (std::nullopt);
  const Cut cut = search.refined (coarse);
  if (!misses (cut, least) || !misses (cut, 1.0 - parameters.step_color * contrastAcross (cloud, pixels, cut.line)))
    return (std::nullopt);
  return (cut.line);
}

struct Piece
{
  pcl::Indices pixels;
  std::vector<int> cuts;
};

/** \brief What is left of a patch after all cuts, the piece that keeps its label first. */
std::vector<Piece>
piecesOf (const OrganizedCloud& cloud, const pcl::Indices& pixels, const PatchGraphParameters& parameters)
{
  std::vector<Piece> pieces{{pixels, {}}};
  int cuts = 0;
  for (std::size_t k = 0; k < pieces.size ();)
  {
    const std::optional<Line> line = stepIn (cloud, pieces[k].pixels, parameters);
    if (!line)
    {
      ++k;
      continue;
    }
    Piece before{{}, pieces[k].cuts}, behind{{}, pieces[k].cuts};
    for (const pcl::index_t index : pieces[k].pixels)
      (line->isBefore (index % cloud.width, index / cloud.width) ? before : behind).pixels.push_back (index);
    ++cuts;
    before.cuts.push_back (cuts);
    behind.cuts.push_back (-cuts);
    if (before.pixels.size () < behind.pixels.size ())
      std::swap (before, behind);
    pieces[k] = std::move (before);
    pieces.push_back (std::move (behind));
  }
  return (pieces);
}

bool
wereCutApart (const PlanarPatch& first, const PlanarPatch& second)
{
  return (std::any_of (first.cuts.begin (), first.cuts.end (), [&] (int cut) {
    return (std::find (second.cuts.begin (), second.cuts.end (), -cut) != second.cuts.end ());
  }));
}

} // namespace

void
cutAtSteps (const OrganizedCloud& cloud, const std::vector<std::uint8_t>& excluded, const PatchGraphParameters& parameters,
            PlanarPatches& patches, int threads)
{
  if (parameters.step_roughness <= 0.0f)
    return;
  const auto count = static_cast<int> (patches.patches.size ());
  std::vector<std::vector<Piece>> pieces (count);
  constexpr int together = 4;
  forEachBand (count, together, threads, [&] (int begin, int end) {
    for (int k = begin; k < end; ++k)
      if (excluded.empty () || !excluded[k + 1])
        pieces[k] = piecesOf (cloud, patches.patches[k].pixels, parameters);
  });
  std::vector<std::vector<int>> cuts (count);
  int last_cut = 0;
  for (int k = 0; k < count; ++k)
  {
    int cuts_of_patch = 0;
    for (std::size_t piece = 0; piece < pieces[k].size () && pieces[k].size () > 1; ++piece)
    {
      const int label = piece == 0 ? k + 1 : static_cast<int> (cuts.size ()) + 1;
      if (piece > 0)
        cuts.emplace_back ();
      for (const pcl::index_t index : pieces[k][piece].pixels)
        patches.labels[index] = label;
      for (const int cut : pieces[k][piece].cuts)
      {
        cuts[label - 1].push_back (cut > 0 ? cut + last_cut : cut - last_cut);
        cuts_of_patch = std::max (cuts_of_patch, std::abs (cut));
      }
    }
    last_cut += cuts_of_patch;
  }
  if (last_cut == 0)
    return;
  describePatches (cloud, patches);
  for (std::size_t k = 0; k < cuts.size (); ++k)
    patches.patches[k].cuts = std::move (cuts[k]);
}

void
disconnectSteps (const PlanarPatches& patches, const std::vector<std::uint8_t>& excluded, const PatchGraphParameters& parameters,
                 PatchGraph& graph)
{
  if (parameters.step_roughness <= 0.0f)
    return;
  for (auto& [labels, border] : graph.borders)
  {
    if (border.connected == 0 || (!excluded.empty () && (excluded[labels.first] || excluded[labels.second])))
      continue;
    const PlanarPatch &first = patches.patches[labels.first - 1], &second = patches.patches[labels.second - 1];
    const BorderPoints& points = graph.points.at (labels);
    const Plane first_plane = planeOf (first), second_plane = planeOf (second);
    const double miss = std::hypot (stepOf (first_plane, second_plane, points.first_connected, points.second_connected),
                                    spreadOf (first_plane, second_plane, points.first_connected, points.second_connected));
    if (wereCutApart (first, second) || miss > limitOf (parameters, first_plane, second_plane))
      border.connected = 0;
  }
}

} // namespace pcl_attention
