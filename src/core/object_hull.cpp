// SPDX-License-Identifier: BSD-3-Clause
#include "flat_points.h"
#include "instruction_set.h"
#include "object_hull.h"

#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/organized_cloud.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_attention
{

namespace
{

/** \brief Points farthest out in some directions come first: what lies between them is then inside and costs no change.
  * \param[out] extremes how many those are */
std::vector<int>
extremesFirst (const FlatPoints& points, std::size_t& extremes)
{
  std::array<int, 2 * direction_count> farthest;
  laneKernels ().farthestPoints (points.arrays (), points.size (), farthest.data ());
  std::vector<int> order;
  order.reserve (points.size ());
  std::vector<std::uint8_t> taken (points.size (), 0);
  const auto take = [&] (int point) {
    if (!taken[static_cast<std::size_t> (point)])
      order.push_back (point);
    taken[static_cast<std::size_t> (point)] = 1;
  };
  std::for_each (farthest.begin (), farthest.end (), take);
  extremes = order.size ();
  for (std::size_t i = 0; i < points.size (); ++i)
    take (static_cast<int> (i));
  return (order);
}

} // namespace

HullGrid::HullGrid (const OrganizedCloud& cloud, int threads)
{
  if (cloud.size () == 0)
    return;
  // Points that are not valid lie at the sensor, which a frame may hold as well.
  Eigen::Vector3f low, high;
  const std::array<const std::vector<float>*, 3> axes{&cloud.x, &cloud.y, &cloud.z};
  forEachBand (3, 1, threads, [&] (int axis, int) {
    const Eigen::Map<const Eigen::ArrayXf> values (axes[axis]->data (), static_cast<Eigen::Index> (cloud.size ()));
    low[axis] = values.minCoeff ();
    high[axis] = values.maxCoeff ();
  });
  // With coordinates of 16 bits a normal has 35, a plane's value at a point 52: whole numbers up to 2^53 are exact.
  constexpr float steps = 65000.0f;
  const float extent = (high - low).maxCoeff ();
  if (!(extent > 0.0f))
    return;
  origin = 0.5f * (low + high);
  step = extent / steps;
}

void
GrowingHull::add (const std::vector<Eigen::Vector3f>& points)
{
  std::vector<Eigen::Vector3d> on_grid;
  on_grid.reserve (points.size ());
  for (const Eigen::Vector3f& point : points)
    on_grid.emplace_back (((point - grid_.origin) / grid_.step).array ().round ().matrix ().cast<double> ());
  addOnGrid (on_grid);
}

void
GrowingHull::add (const GrowingHull& other)
{
  addOnGrid (other.points_);
}

void
GrowingHull::addOnGrid (const std::vector<Eigen::Vector3d>& points)
{
  if (points.empty ())
    return;
  const std::size_t first = facets_.size () == 0 ? 0 : points_.size (); // while flat, the points before are still to be inserted
  points_.insert (points_.end (), points.begin (), points.end ());
  if (facets_.size () == 0 && !startTetrahedron ())
    return;
  // Coordinates on the grid and sums of three of them are whole numbers that a float holds.
  const FlatPoints flat (&points_[first], points_.size () - first);
  std::size_t extremes;
  const std::vector<int> order = extremesFirst (flat, extremes);
  Insertion insertion;
  std::vector<float> depths (flat.size ());
  const auto insertThose = [&] (std::size_t begin, std::size_t end) {
    // What is inside stays there. A float may be off by a fiftieth of a step.
    constexpr float clearly = 0.1f;
    const std::vector<FlatPlane> planes = facets_.inwards ();
    laneKernels ().lowestHeight (flat.arrays (), flat.size (), planes.data (), planes.size (), depths.data ());
    for (std::size_t i = begin; i < end; ++i)
      if (depths[order[i]] <= clearly)
        insert (static_cast<int> (first) + order[i], insertion);
  };
  insertThose (0, extremes);
  insertThose (extremes, order.size ());
  dropInnerPoints ();
}

bool
GrowingHull::startTetrahedron ()
{
  const auto farthest = [this] (const auto& distance) {
    return (static_cast<int> (std::max_element (points_.begin (), points_.end (),
                                                [&] (const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                                                  return (distance (a) < distance (b));
                                                }) - points_.begin ()));
  };
  const int a = 0;
  const int b = farthest ([&] (const Eigen::Vector3d& p) { return ((p - points_[a]).squaredNorm ()); });
  const Eigen::Vector3d edge = points_[b] - points_[a];
  const int c = farthest ([&] (const Eigen::Vector3d& p) { return (edge.cross (p - points_[a]).squaredNorm ()); });
  const Eigen::Vector3d normal = edge.cross (points_[c] - points_[a]);
  const auto height = [&] (const Eigen::Vector3d& p) { return (normal.dot (p - points_[a])); };
  const int d = farthest ([&] (const Eigen::Vector3d& p) { return (std::abs (height (p))); });
  if (height (points_[d]) == 0.0)
    return (false);
  const bool below = height (points_[d]) < 0.0;
  const int second = below ? b : c, third = below ? c : b;
  addFacet (a, second, third);
  addFacet (a, third, d);
  addFacet (third, second, d);
  addFacet (second, a, d);
  return (true);
}

void
GrowingHull::Facets::push_back (const std::array<int, 3>& triangle, const Eigen::Vector3d& normal, double distance)
{
  corners.push_back (triangle);
  x.push_back (normal.x ());
  y.push_back (normal.y ());
  z.push_back (normal.z ());
  offset.push_back (distance);
  inverse_length.push_back (1.0 / std::max (1.0, normal.norm ()));
}

void
GrowingHull::Facets::resize (std::size_t count)
{
  corners.resize (count);
  for (std::vector<double>* values : {&x, &y, &z, &offset, &inverse_length})
    values->resize (count);
}

std::vector<FlatPlane>
GrowingHull::Facets::inwards () const
{
  std::vector<FlatPlane> planes;
  planes.reserve (size ());
  for (std::size_t i = 0; i < size (); ++i)
  {
    const auto unit = [scale = -inverse_length[i]] (double value) { return (static_cast<float> (scale * value)); };
    planes.push_back ({{unit (x[i]), unit (y[i]), unit (z[i])}, unit (offset[i])});
  }
  return (planes);
}

double
GrowingHull::Facets::largestDistance (const Eigen::Vector3d& point, Eigen::ArrayXd& distances) const
{
  const auto all = [this] (const std::vector<double>& values) {
    return (Eigen::Map<const Eigen::ArrayXd> (values.data (), static_cast<Eigen::Index> (size ())));
  };
  const auto count = static_cast<Eigen::Index> (size ());
  if (distances.size () < count)
    distances.resize (2 * count);
  distances.head (count) = all (x) * point.x () + all (y) * point.y () + all (z) * point.z () + all (offset);
  return ((distances.head (count) * all (inverse_length)).maxCoeff ());
}

void
GrowingHull::addFacet (int a, int b, int c)
{
  const Eigen::Vector3d normal = (points_[b] - points_[a]).cross (points_[c] - points_[a]);
  facets_.push_back ({a, b, c}, normal, -normal.dot (points_[a]));
}

void
GrowingHull::insert (int point, Insertion& insertion)
{
  auto& [distances, edges] = insertion;
  // A point on a facet's plane does not see it: what it adds beside it is seen by the facet's neighbours.
  if (facets_.largestDistance (points_[point], distances) <= tolerance_)
    return;
  // An edge that is met in one direction only is the horizon.
  constexpr std::pair<int, int> met_in_both{-1, -1};
  edges.clear ();
  std::size_t kept = facets_.size ();
  for (std::size_t i = kept; i-- > 0;)
  {
    if (distances[static_cast<Eigen::Index> (i)] <= 0.0)
      continue;
    const std::array<int, 3> triangle = facets_.corners[i];
    if (--kept != i)
      facets_.move (kept, i); // which has been looked at
    for (int corner = 0; corner < 3; ++corner)
    {
      const int from = triangle[corner], to = triangle[corner == 2 ? 0 : corner + 1];
      const auto back = std::find (edges.begin (), edges.end (), std::pair (to, from));
      if (back != edges.end ())
        *back = met_in_both;
      else
        edges.emplace_back (from, to);
    }
  }
  facets_.resize (kept);
  for (const auto& [from, to] : edges)
    if (from >= 0)
      addFacet (from, to, point);
}

void
GrowingHull::dropInnerPoints ()
{
  std::vector<int> place (points_.size (), -1);
  std::vector<Eigen::Vector3d> corners;
  corners.reserve (facets_.size ()); // of which there are no fewer
  for (std::array<int, 3>& triangle : facets_.corners)
    for (int& corner : triangle)
    {
      if (place[corner] < 0)
      {
        place[corner] = static_cast<int> (corners.size ());
        corners.push_back (points_[corner]);
      }
      corner = place[corner];
    }
  points_ = std::move (corners);
}

std::vector<Eigen::Vector3f>
GrowingHull::vertices () const
{
  std::vector<Eigen::Vector3f> vertices;
  vertices.reserve (points_.size ());
  for (const Eigen::Vector3d& point : points_)
    vertices.push_back (inMetres (point));
  return (vertices);
}

VisibleHull
GrowingHull::visible () const
{
  VisibleHull hull;
  hull.vertices = vertices ();
  if (facets_.size () == 0)
  {
    hull.dimension = std::min<int> (2, static_cast<int> (points_.size ()) - 1);
    return (hull);
  }
  hull.dimension = 3;
  hull.faces.reserve (facets_.size ());
  hull.hidden_faces.reserve (facets_.size ());
  for (std::size_t facet = 0; facet < facets_.size (); ++facet)
  {
    std::array<Eigen::Vector3f, 3> corners;
    for (int corner = 0; corner < 3; ++corner)
      corners[corner] = hull.vertices[facets_.corners[facet][corner]];
    const Eigen::Vector3d normal (facets_.x[facet], facets_.y[facet], facets_.z[facet]);
    hull.addFace (corners, normal.normalized ().cast<float> ());
  }
  return (hull);
}

void
ObjectHull::add (const std::vector<Eigen::Vector3f>& points)
{
  if (method_ == HullMethod::growing)
    return (growing_.add (points));
  // The hull of a union is the hull of the hulls' vertices.
  std::vector<Eigen::Vector3f> all = computed_.vertices;
  all.insert (all.end (), points.begin (), points.end ());
  computed_ = computeVisibleHull (all);
}

void
ObjectHull::add (const ObjectHull& other)
{
  if (method_ == HullMethod::growing)
    return (growing_.add (other.growing_));
  add (other.computed_.vertices);
}

} // namespace pcl_attention
