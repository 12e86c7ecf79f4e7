// SPDX-License-Identifier: BSD-3-Clause
#include "even_samples.h"
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

/** \brief How two planes miss each other at the border that their points have in common, metres. */
struct Miss
{
  double step;   /**< how far one of them lies behind the other; 0 at a bend */
  double spread; /**< how much the points lie off the other's plane here and there, standard deviation */
};

Miss
missOf (const Plane& first, const Plane& second, const PointMoments& first_border, const PointMoments& second_border)
{
  const auto [first_side, first_spread] = first_border.fromPlane (second.normal, second.center);
  const auto [second_side, second_spread] = second_border.fromPlane (first.normal, first.center);
  // At a bend both lie behind the other's plane or both before it, at a step one before and one behind.
  const double step = first_side * second_side < 0.0 ? std::min (std::abs (first_side), std::abs (second_side)) : 0.0;
  return {step, std::min (first_spread, second_spread)};
}

double
limitOf (const PatchGraphParameters& parameters, const Plane& first, const Plane& second)
{
  return (parameters.step_tolerance + parameters.step_roughness * std::max (first.rms, second.rms));
}

/** \brief A line in the image. */
struct Line
{
  Eigen::Vector2d direction{1.0, 0.0}; /**< across it, unit */
  double offset{0.0};                  /**< pixels */

  bool
  isBefore (int column, int row) const { return (direction.x () * column + direction.y () * row < offset); }
};

/** \brief Points in two parts, one on either side of a line. */
struct Cut
{
  Line line;
  double residual{std::numeric_limits<double>::infinity ()}; /**< what speaks against it: of both parts, m^2, or how like their
                                                                  colours are, 0..1 */
  double extent{0.0};    /**< of the points across the line, pixels */
  double clearness{0.0}; /**< how far the faces on both sides miss the line, in limits; 0 far below */
};

/** \brief Sums over points of a patch, in coordinates of its plane: u and v in it, w off it. */
struct LocalMoments
{
  Eigen::Array<double, 10, 1> sums; /**< 1, u, v, w, uu, uv, uw, vv, vw, ww */

  LocalMoments () : sums (decltype (sums)::Zero ()) {}
  LocalMoments (double u, double v, double w) { sums << 1.0, u, v, w, u * u, u * v, u * w, v * v, v * w, w * w; }

  double
  count () const { return (sums[0]); }

  LocalMoments&
  operator+= (const LocalMoments& other)
  {
    sums += other.sums;
    return (*this);
  }

  LocalMoments&
  operator-= (const LocalMoments& other)
  {
    sums -= other.sums;
    return (*this);
  }

  /** \brief Sum of the squares that the best w = a + b u + c v leaves. */
  double
  residual () const
  {
    const double u = sums[1], v = sums[2], w = sums[3];
    const double a = sums[4] - u * u / count (), b = sums[5] - u * v / count (), c = sums[7] - v * v / count ();
    const double d = sums[6] - u * w / count (), e = sums[8] - v * w / count (), all = sums[9] - w * w / count ();
    const double determinant = a * c - b * b;
    return (determinant > 0.0 ? std::max (0.0, all - (d * d * c - 2.0 * d * e * b + e * e * a) / determinant) : all);
  }
};

/** \brief Evenly taken points of a patch and the ways to cut them. */
class CutSearch
{
public:
  CutSearch (const OrganizedCloud& cloud, const pcl::Indices& pixels, const PatchGraphParameters& parameters)
  : parameters_ (parameters)
  {
    const pcl::Indices samples = evenSamples (pixels);
    smallest_ = static_cast<int> ((smallest_side * samples.size () + pixels.size () - 1) / pixels.size ());
    PointMoments sums;
    columns_.resize (static_cast<Eigen::Index> (samples.size ()));
    rows_.resize (columns_.size ());
    for (const pcl::index_t index : samples)
    {
      const auto place = static_cast<Eigen::Index> (points_.size ());
      columns_[place] = index % cloud.width;
      rows_[place] = index / cloud.width;
      points_.push_back (pointAt (cloud, index));
      sums.add (points_.back ());
      if (cloud.hasColor ())
        colors_.push_back (HexconeHistogram::sharesOf (cloud.red[index], cloud.green[index], cloud.blue[index]));
    }
    const Plane plane = planeOf (sums);
    const Eigen::Vector3f u = plane.normal.unitOrthogonal (), v = plane.normal.cross (u);
    for (const Eigen::Vector3f& point : points_)
    {
      const Eigen::Vector3f local = point - plane.center;
      local_.emplace_back (u.dot (local), v.dot (local), plane.normal.dot (local));
      all_ += local_.back ();
    }
  }

  /** \brief The line of a step, if there is one. */
  std::optional<Line>
  step ()
  {
    const std::optional<Line> line = stepBetweenColors ();
    return (line ? line : stepOfLeastResidual ());
  }

private:
  /** \brief Where a sensor has smoothed a step to a slope no line leaves much less residual than others, but colours show it. */
  std::optional<Line>
  stepBetweenColors ()
  {
    if (colors_.empty () || parameters_.cut_color > 1.0f)
      return (std::nullopt);
    Cut best;
    // Colours part by whole faces: half the directions and places are enough to find about where.
    for (int i = 0; i < directions; i += 2)
      tryColors (i * apart, coarse_parts / 2, best);
    if (best.residual > 1.0 - parameters_.cut_color)
      return (std::nullopt);
    return (stepAt (refined (best, [this] (double angle, Cut& finer) { tryColors (angle, fine_parts, finer); })));
  }

  std::optional<Line>
  stepOfLeastResidual ()
  {
    const Cut coarse = clearestCoarse ();
    if (coarse.clearness == 0.0)
      return (std::nullopt);
    return (stepAt (refined (coarse, [this] (double angle, Cut& finer) { tryDirection (angle, fine_parts, finer); })));
  }

  /** \brief The line of a cut, if it shows a step. */
  std::optional<Line>
  stepAt (Cut cut)
  {
    look (cut);
    return (cut.clearness > 1.0 ? std::optional<Line> (cut.line) : std::nullopt);
  }

  /** \brief Of cuts that are spread over the patch and leave about the least residual the one that shows a step most clearly. */
  Cut
  clearestCoarse ()
  {
    constexpr double about = 1.2, clearly_less = 0.7;
    std::array<Cut, directions> cuts;
    double least = std::numeric_limits<double>::infinity ();
    for (int i = 0; i < directions; ++i)
    {
      tryDirection (i * apart, coarse_parts, cuts[i]);
      least = std::min (least, cuts[i].residual);
    }
    const double most = std::max (least, std::min (about * least, clearly_less * all_.residual ()));
    Cut clearest;
    for (Cut& cut : cuts)
    {
      if (cut.extent == 0.0 || cut.residual > most)
        continue;
      look (cut);
      if (cut.clearness > clearest.clearness)
        clearest = cut;
    }
    return (clearest);
  }

  /** \brief The best of a cut and others that lie densely in directions near it.
    * \param[in] tryAt tries those across a direction */
  template <typename Try> static Cut
  refined (const Cut& cut, const Try& tryAt)
  {
    constexpr int finer = 4;
    Cut best = cut;
    const double angle = std::atan2 (cut.line.direction.y (), cut.line.direction.x ());
    for (int i = 1 - finer; i < finer; ++i)
      tryAt (angle + i * apart / finer, best);
    return (best);
  }

  /** \brief Find out how clearly a cut shows a step: the faces on both sides as they are near the line, and the colours. */
  void
  look (Cut& cut)
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
    if (before.count < enough_for_a_plane || behind.count < enough_for_a_plane)
    {
      before = behind = PointMoments ();
      for (std::size_t i = 0; i < points_.size (); ++i)
        (beyondOf (cut.line, i) < 0.0 ? before : behind).add (points_[i]);
    }
    const Plane first = planeOf (before), second = planeOf (behind);
    const double miss =
      std::hypot (missOf (first, second, before_border, behind_border).step, twistOf (first, second, cut.line, border_points));
    // A coarse cut beside the step shows less of it, and colours help.
    constexpr double shown_by_a_coarse_cut = 0.5;
    const double limit = limitOf (parameters_, first, second);
    cut.clearness = 0.0;
    if (miss > shown_by_a_coarse_cut * (1.0 - parameters_.step_color) * limit)
      cut.clearness = miss / std::max (1e-9, limit * (1.0 - parameters_.step_color * contrastAcross (cut.line)));
  }

  /** \brief -1 where both sides of a line have the same colours, 1 where they have none in common, 0 without colour. */
  double
  contrastAcross (const Line& line) const
  {
    std::array<HexconeHistogram, 2> sides;
    for (std::size_t i = 0; i < colors_.size (); ++i)
      sides[beyondOf (line, i) < 0.0].add (colors_[i]);
    return (colorContrast (sides[0], sides[1]));
  }

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
  beyondOf (const Line& line, std::size_t i) const
  {
    const auto place = static_cast<Eigen::Index> (i);
    return (line.direction.x () * columns_[place] + line.direction.y () * rows_[place] - line.offset);
  }

  static constexpr int directions = 8, coarse_parts = 16, fine_parts = 32;
  static constexpr double apart = 3.14159265358979 / directions; /**< radians */

  /** \brief Try the cuts across a direction at so many places. \param[in,out] best the best one so far */
  void
  tryDirection (double angle, int parts, Cut& best) const
  {
    tryCuts<LocalMoments> (
      angle, parts, [this] (std::size_t i, LocalMoments& strip) { strip += local_[i]; },
      [this] (const LocalMoments& before, const LocalMoments& behind) {
        return (before.count () < smallest_ || behind.count () < smallest_ ? none : before.residual () + behind.residual ());
      },
      best);
  }

  /** \brief The same for cuts between colours. */
  void
  tryColors (double angle, int parts, Cut& best) const
  {
    tryCuts<HexconeHistogram> (
      angle, parts, [this] (std::size_t i, HexconeHistogram& strip) { strip.add (colors_[i]); },
      [this] (const HexconeHistogram& before, const HexconeHistogram& behind) {
        const auto least = static_cast<float> (smallest_);
        return (before.total < least || behind.total < least ? none : 1.0 - chiSquare (before, behind));
      },
      best);
  }

  /** \param[in] addTo adds a point to the sums of a strip
    * \param[in] residualOf of the sums of both parts */
  template <typename Sums, typename Add, typename Judge> void
  tryCuts (double angle, int parts, const Add& addTo, const Judge& residualOf, Cut& best) const
  {
    const Eigen::Vector2d direction (std::cos (angle), std::sin (angle));
    const Eigen::ArrayXd along = direction.x () * columns_ + direction.y () * rows_;
    const double low = along.minCoeff (), high = along.maxCoeff ();
    const double width = (high - low) / parts;
    if (!(width > 0.0))
      return;
    const Eigen::ArrayXi strip_of = ((along - low) / width).cast<int> ().min (parts - 1);
    std::vector<Sums> strips (parts);
    for (std::size_t i = 0; i < points_.size (); ++i)
      addTo (i, strips[strip_of[static_cast<Eigen::Index> (i)]]);
    Sums before, behind;
    for (int k = 0; k < parts; ++k)
      behind += strips[k];
    for (int k = 1; k < parts; ++k)
    {
      before += strips[k - 1];
      behind -= strips[k - 1];
      const double residual = residualOf (before, behind);
      if (residual < best.residual)
        best = {{direction, low + k * width}, residual, high - low};
    }
  }

  static constexpr double none = std::numeric_limits<double>::infinity (); /**< of a cut with too few points on one side */

  const PatchGraphParameters& parameters_;
  Eigen::ArrayXd columns_, rows_; /**< of each point */
  std::vector<Eigen::Vector3f> points_;
  std::vector<HexconeHistogram::Shares> colors_; /**< of each point; empty without colour */
  std::vector<LocalMoments> local_; /**< of each point */
  LocalMoments all_;
  int smallest_; /**< points of a part */
};

/** \brief The line that a patch is to be cut along, if there is one. */
std::optional<Line>
stepIn (const OrganizedCloud& cloud, const pcl::Indices& pixels, const PatchGraphParameters& parameters)
{
  if (pixels.size () < 2 * smallest_side)
    return (std::nullopt);
  return (CutSearch (cloud, pixels, parameters).step ());
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
  for (std::size_t k = 0; k < pieces.size (); ++k)
    while (const std::optional<Line> line = stepIn (cloud, pieces[k].pixels, parameters))
    {
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
  int last_cut = 0;
  for (int k = 0; k < count; ++k)
  {
    int cuts_of_patch = 0;
    for (std::size_t piece = 0; piece < pieces[k].size () && pieces[k].size () > 1; ++piece)
    {
      const int label = piece == 0 ? k + 1 : static_cast<int> (patches.patches.size ()) + 1;
      if (piece > 0)
        patches.patches.emplace_back ();
      PlanarPatch& patch = patches.patches[label - 1];
      patch.pixels = std::move (pieces[k][piece].pixels);
      describePatch (cloud, patch);
      for (const pcl::index_t index : patch.pixels)
        patches.labels[index] = label;
      for (const int cut : pieces[k][piece].cuts)
      {
        patch.cuts.push_back (cut > 0 ? cut + last_cut : cut - last_cut);
        cuts_of_patch = std::max (cuts_of_patch, std::abs (cut));
      }
    }
    last_cut += cuts_of_patch;
  }
}

void
disconnectSteps (const OrganizedCloud& cloud, const PlanarPatches& patches, const std::vector<std::uint8_t>& excluded,
                 const PatchGraphParameters& parameters, PatchGraph& graph)
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
    const auto [step, spread] = missOf (first_plane, second_plane, points.first_connected, points.second_connected);
    const double miss = std::hypot (step, spread);
    const double limit = limitOf (parameters, first_plane, second_plane), helped = 0.5 * parameters.step_color;
    const auto contrast = [&] { return (colorContrast (colorsOf (cloud, first.pixels), colorsOf (cloud, second.pixels))); };
    if (wereCutApart (first, second) || miss > limit ||
        (miss > (1.0 - helped) * limit && miss > (1.0 - helped * contrast ()) * limit))
      border.connected = 0;
  }
}

} // namespace pcl_attention
