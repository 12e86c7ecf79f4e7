// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/patch_graph.h>
#include <pcl_attention/core/skeleton.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>

namespace pcl_attention
{

namespace
{

/** \brief Compares every pixel with the one before it along rows, columns and diagonals, and notes every change of label. */
class BorderScan
{
public:
  BorderScan (const OrganizedCloud& cloud, const SensorModel& sensor, const NormalImage& normals, const Image<int>& labels,
              const PatchGraphParameters& parameters, PatchGraph& graph)
  : cloud_ (cloud),
    normals_ (normals),
    labels_ (labels),
    parameters_ (parameters),
    graph_ (graph),
    sensor_ (sensor)
  {}

  /** \param[in] step_column,step_row from a pixel to the next: (1, 0), (0, 1), (1, 1) or (-1, 1) */
  void
  scan (int step_column, int step_row)
  {
    const int width = labels_.width, height = labels_.height, offset = step_row * width + step_column;
    step_ = {step_column, step_row};
    // Of every line, at the column in which it meets the current row: its last labelled pixel before a gap.
    std::vector<int> before_gap (width, -1);
    for (int row = 0; row < height; ++row)
    {
      if (step_row != 0 && step_column > 0)
        std::rotate (before_gap.begin (), before_gap.end () - 1, before_gap.end ());
      else if (step_column < 0)
        std::rotate (before_gap.begin (), before_gap.begin () + 1, before_gap.end ());
      const auto gapAt = [&] (int column) -> int& { return (before_gap[step_row == 0 ? 0 : column]); };
      const int* const labels = labels_.data.data () + static_cast<std::size_t> (row) * width;
      const auto atBorder = [&] (int column) {
        const bool first = !labels_.contains (column - step_column, row - step_row);
        if (first)
          gapAt (column) = -1;
        const int before = first ? 0 : labels[column - offset];
        if (labels[column] != before)
          noteChange ({column, row}, offset, labels[column], before, gapAt (column));
        if (labels[column] != 0 && !labels_.contains (column + step_column, row + step_row))
          ++graph_.perimeter[labels[column]];
      };
      const bool border_row = row == 0 || row == height - 1;
      const int inner_end = border_row ? 1 : width - 1;
      atBorder (0);
      for (int begin = 1, end; begin < inner_end; begin = end)
      {
        // Most pixels lie within a patch.
        constexpr int together = 32;
        end = std::min (begin + together, inner_end);
        if (std::memcmp (labels + begin, labels + begin - offset, sizeof (int) * static_cast<std::size_t> (end - begin)) == 0)
          continue;
        for (int column = begin; column < end; ++column)
          if (labels[column] != labels[column - offset])
            noteChange ({column, row}, offset, labels[column], labels[column - offset], gapAt (column));
      }
      for (int column = std::max (1, inner_end); column < width; ++column)
        atBorder (column);
    }
  }

private:
  /** \param[in,out] gap_begin the labelled pixel before the gap that ends or begins here; -1: none */
  void
  noteChange (const Pixel& at, int offset, int label, int before, int& gap_begin)
  {
    const int index = at.row * labels_.width + at.column;
    if (before != 0)
    {
      ++graph_.perimeter[before];
      if (label == 0)
        gap_begin = index - offset;
      else
        addPair (at, 1);
    }
    if (label == 0)
      return;
    ++graph_.perimeter[label];
    if (before != 0 || gap_begin < 0)
      return;
    const int distance = (index - gap_begin) / offset;
    if (distance <= parameters_.maximum_gap + 1 && labels_[gap_begin] != label)
      addPair (at, distance);
  }

  /** \brief A border of the graph. */
  struct Border
  {
    std::pair<int, int> names;
    PatchBorder* sums{nullptr};
    BorderPoints* points{nullptr};
  };

  /** \brief The border of two labels. */
  const Border&
  borderOf (int first, int second)
  {
    // A row crosses the same borders as the row before.
    Border& border = recent_[static_cast<std::size_t> (first * 31 + second) % recent_.size ()];
    const std::pair<int, int> names (first, second);
    if (!border.sums || border.names != names)
      border = {names, &graph_.borders[names], &graph_.points[names]};
    return (border);
  }

  Eigen::Vector3f
  point (int index) const { return {cloud_.x[index], cloud_.y[index], cloud_.z[index]}; }

  /** \brief The pixel sample_distance steps inside the patch, nearer if the patch ends before.
    * \param[out] reached how many steps */
  int
  inside (const Pixel& at, const Pixel& step, int& reached) const
  {
    const auto room = [] (int place, int direction, int size) {
      return (direction == 0 ? std::numeric_limits<int>::max () : direction > 0 ? size - 1 - place : place);
    };
    const int most = std::min ({parameters_.sample_distance, room (at.column, step.column, labels_.width),
                                room (at.row, step.row, labels_.height)});
    const int offset = step.row * labels_.width + step.column;
    int index = at.row * labels_.width + at.column;
    const int label = labels_[index];
    for (reached = 0; reached < most && labels_[index + offset] == label; ++reached)
      index += offset;
    return (index);
  }

  /** \brief Whether a surface seen at a grazing angle, whose neighbouring pixels lie far apart, leads on to the other point. */
  bool
  continuesGrazing (int from, int to) const
  {
    constexpr float grazing_cosine = 0.2f, farthest = 4.0f, offset = 0.5f;
    if (!normals_.valid[from])
      return (false);
    const Eigen::Vector3f position = point (from), difference = point (to) - position;
    const Eigen::Vector3f normal (normals_.x[from], normals_.y[from], normals_.z[from]);
    return (std::abs (normal.dot (position)) < grazing_cosine * position.norm () &&
            difference.norm () < farthest * parameters_.connection_distance &&
            std::abs (normal.dot (difference)) < offset * parameters_.connection_distance);
  }

  /** \brief Add the pair of a pixel and the one so many steps before it. */
  void
  addPair (const Pixel& at, int distance_in_pixels)
  {
    Pixel step = step_, second_at = at;
    Pixel first_at{at.column - distance_in_pixels * step.column, at.row - distance_in_pixels * step.row};
    const auto indexOf = [this] (const Pixel& pixel) { return (pixel.row * labels_.width + pixel.column); };
    int first = indexOf (first_at), second = indexOf (second_at);
    if (labels_[first] > labels_[second])
    {
      std::swap (first, second);
      std::swap (first_at, second_at);
      step = {-step.column, -step.row};
    }
    const Border& found = borderOf (labels_[first], labels_[second]);
    PatchBorder& border = *found.sums;
    BorderPoints& points = *found.points;
    ++border.pairs;
    const Eigen::Vector3f a = point (first), b = point (second);
    const float depth = std::max (a.z (), b.z ());
    const float slack = sensor_.focal_length > 0.0f
                          ? parameters_.gap_slack * static_cast<float> (distance_in_pixels - 1) * depth / sensor_.focal_length : 0.0f;
    const float noise = parameters_.connection_noise * sensor_.depth_noise * depth * depth;
    if ((b - a).norm () >= parameters_.connection_distance + noise + slack && !continuesGrazing (first, second) &&
        !continuesGrazing (second, first))
    {
      const bool first_in_front = a.norm () < b.norm ();
      ++(first_in_front ? border.first_in_front : border.second_in_front);
      if (first_in_front)
        points.first_in_front.add (a);
      else
        points.second_in_front.add (b);
      return;
    }
    ++border.connected;
    points.first_connected.add (a);
    points.second_connected.add (b);
    // Normals at the very border are mixed from both sides; one of them may be, on a strip along an edge.
    constexpr int deep = 2;
    int reached_first, reached_second;
    const int inside_first = inside (first_at, {-step.column, -step.row}, reached_first);
    const int inside_second = inside (second_at, step, reached_second);
    if (std::max (reached_first, reached_second) < deep || !normals_.valid[inside_first] || !normals_.valid[inside_second])
      return;
    const Eigen::Vector3f direction = (point (inside_second) - point (inside_first)).normalized ();
    const Eigen::Vector3f difference (normals_.x[inside_second] - normals_.x[inside_first],
                                      normals_.y[inside_second] - normals_.y[inside_first],
                                      normals_.z[inside_second] - normals_.z[inside_first]);
    ++border.convexity_pairs;
    border.convexity_sum += difference.dot (direction);
  }

  const OrganizedCloud& cloud_;
  const NormalImage& normals_;
  const Image<int>& labels_;
  const PatchGraphParameters& parameters_;
  PatchGraph& graph_;
  const SensorModel sensor_;
  Pixel step_{0, 0}; /**< from a pixel to the next along the lines */
  std::array<Border, 256> recent_; /**< where borders that were met last are in the graph */
};

template <typename Sums> void
addUp (const std::map<std::pair<int, int>, Sums>& part, std::map<std::pair<int, int>, Sums>& whole)
{
  auto behind = whole.begin ();
  for (const auto& [names, sums] : part)
  {
    const auto at = whole.try_emplace (behind, names);
    at->second += sums;
    behind = std::next (at);
  }
}

} // namespace

void
PointMoments::add (const Eigen::Vector3f& point)
{
  const Eigen::Vector3d p = point.cast<double> ();
  ++count;
  sum += p;
  square += p * p.transpose ();
}

PointMoments&
PointMoments::operator+= (const PointMoments& other)
{
  count += other.count;
  sum += other.sum;
  square += other.square;
  return (*this);
}

std::pair<double, double>
PointMoments::fromPlane (const Eigen::Vector3f& normal, const Eigen::Vector3f& on_plane) const
{
  if (count == 0)
    return {0.0, 0.0};
  const Eigen::Vector3d n = normal.cast<double> (), mean = sum / count;
  const double variance = n.dot (square * n) / count - std::pow (n.dot (mean), 2);
  return {n.dot (mean - on_plane.cast<double> ()), std::sqrt (std::max (0.0, variance))};
}

double
PointMoments::flatness () const
{
  if (count == 0)
    return (0.0);
  const Eigen::Vector3d mean = sum / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (square / count - mean * mean.transpose (),
                                                               Eigen::EigenvaluesOnly);
  return (std::sqrt (std::max (0.0, solver.eigenvalues () (0))));
}

BorderPoints&
BorderPoints::operator+= (const BorderPoints& other)
{
  first_connected += other.first_connected;
  second_connected += other.second_connected;
  first_in_front += other.first_in_front;
  second_in_front += other.second_in_front;
  return (*this);
}

PatchBorder&
PatchBorder::operator+= (const PatchBorder& other)
{
  pairs += other.pairs;
  connected += other.connected;
  first_in_front += other.first_in_front;
  second_in_front += other.second_in_front;
  convexity_pairs += other.convexity_pairs;
  convexity_sum += other.convexity_sum;
  return (*this);
}

PatchBorder
PatchBorder::reversed () const
{
  PatchBorder border = *this;
  std::swap (border.first_in_front, border.second_in_front);
  return (border);
}

PatchBorder
PatchGraph::border (int first, int second) const
{
  const auto found = borders.find (std::minmax (first, second));
  if (found == borders.end ())
    return (PatchBorder ());
  return (first < second ? found->second : found->second.reversed ());
}

BorderPoints
PatchGraph::borderPoints (int first, int second) const
{
  const auto found = points.find (std::minmax (first, second));
  if (found == points.end ())
    return (BorderPoints ());
  return (first < second ? found->second : found->second.reversed ());
}

PatchGraph
buildPatchGraph (const OrganizedCloud& cloud, const SensorModel& sensor, const NormalImage& normals, const Image<int>& labels,
                 int count, const PatchGraphParameters& parameters, int threads)
{
  constexpr std::array<Pixel, 4> directions{{{1, 0}, {0, 1}, {1, 1}, {-1, 1}}};
  std::array<PatchGraph, directions.size ()> parts;
  forEachBand (static_cast<int> (directions.size ()), 1, threads, [&] (int begin, int) {
    PatchGraph& part = parts[begin];
    part.perimeter.assign (count + 1, 0);
    BorderScan (cloud, sensor, normals, labels, parameters, part).scan (directions[begin].column, directions[begin].row);
  });
  PatchGraph graph = std::move (parts[0]);
  for (auto part = parts.begin () + 1; part != parts.end (); ++part)
  {
    addUp (part->borders, graph.borders);
    addUp (part->points, graph.points);
    std::transform (part->perimeter.begin (), part->perimeter.end (), graph.perimeter.begin (), graph.perimeter.begin (), std::plus<int> ());
  }
  graph.neighbors.assign (count + 1, {});
  for (const auto& border : graph.borders)
  {
    graph.neighbors[border.first.first].push_back (border.first.second);
    graph.neighbors[border.first.second].push_back (border.first.first);
  }
  for (auto& neighbors : graph.neighbors)
    std::sort (neighbors.begin (), neighbors.end ());
  return (graph);
}

} // namespace pcl_attention
