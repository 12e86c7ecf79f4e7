// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/visible_hull.h>

#include <array>
#include <vector>

namespace pcl_attention
{

struct FlatPlane;
struct OrganizedCloud;

/** \brief A grid of 65,000 steps over a frame, a fraction of any depth sensor's noise. Planes through its points, and the sides on
  * which others lie, are exact in double arithmetic, so that a hull of them needs no tolerance. */
struct PCL_ATTENTION_EXPORTS HullGrid
{
  HullGrid () = default;
  /** \brief Over the points of a cloud. */
  explicit HullGrid (const OrganizedCloud& cloud, int threads = 1);

  Eigen::Vector3f origin{Eigen::Vector3f::Zero ()}; /**< metres */
  float step{1.0f};                                 /**< metres */
};

/** \brief A convex hull that is kept and extended: adding a patch to an object costs the patch's vertices, not a new hull. */
class PCL_ATTENTION_EXPORTS GrowingHull
{
public:
  GrowingHull () = default;
  /** \param[in] tolerance a point that lies less outside is left off, metres */
  explicit GrowingHull (const HullGrid& grid, float tolerance = 0.0f) : grid_ (grid), tolerance_ (tolerance / grid.step) {}

  /** \brief Extend the hull.
    * \param[in] points on the grid after rounding, metres, sensor frame, within the grid's frame */
  void
  add (const std::vector<Eigen::Vector3f>& points);
  /** \brief Extend by another hull on the same grid. */
  void
  add (const GrowingHull& other);

  /** \brief Corners of the hull, or all points while they lie on a plane, metres. */
  std::vector<Eigen::Vector3f>
  vertices () const;

  /** \brief The hull seen from the origin. A hull without volume has no faces, and dimension 2 or less. */
  VisibleHull
  visible () const;

private:
  /** \brief Triangles, counter-clockwise seen from outside, and their planes: n . p + d > 0 outside. Arrays, as most points that are
    * tried lie inside and are told by the planes alone. */
  struct Facets
  {
    std::vector<std::array<int, 3>> corners;
    std::vector<double> x, y, z; /**< of n */
    std::vector<double> offset;  /**< d */
    std::vector<double> inverse_length; /**< 1 / |n| */

    std::size_t
    size () const { return (corners.size ()); }
    void
    push_back (const std::array<int, 3>& triangle, const Eigen::Vector3d& normal, double distance);
    /** \brief Overwrite one by another. */
    void
    move (std::size_t from, std::size_t to)
    {
      corners[to] = corners[from];
      x[to] = x[from];
      y[to] = y[from];
      z[to] = z[from];
      offset[to] = offset[from];
      inverse_length[to] = inverse_length[from];
    }
    void
    resize (std::size_t count);
    /** \brief Their planes with unit normals that point inwards, steps. */
    std::vector<FlatPlane>
    inwards () const;
    /** \brief The largest distance of a point from any plane, steps.
      * \param[in,out] distances first those from all of them, times |n| and exact; enlarged where it has no room for them */
    double
    largestDistance (const Eigen::Vector3d& point, Eigen::ArrayXd& distances) const;
  };

  /** \brief What is worked out for a point that is inserted; kept from one to the next for its memory. */
  struct Insertion
  {
    Eigen::ArrayXd distances;               /**< see \ref Facets::largestDistance */
    std::vector<std::pair<int, int>> edges; /**< of the facets that see the point, from one corner to another */
  };

  void
  addOnGrid (const std::vector<Eigen::Vector3d>& points);
  /** \brief Find four points that span a volume.
    * \return false when there are none */
  bool
  startTetrahedron ();
  void
  insert (int point, Insertion& insertion);
  void
  addFacet (int a, int b, int c);
  /** \brief Forget points that are no corner. */
  void
  dropInnerPoints ();
  Eigen::Vector3f
  inMetres (const Eigen::Vector3d& point) const { return (grid_.origin + grid_.step * point.cast<float> ()); }

  HullGrid grid_;
  double tolerance_{0.0};               /**< steps */
  std::vector<Eigen::Vector3d> points_; /**< in steps from the grid's origin, whole numbers; the corners, or all while flat */
  Facets facets_;                       /**< empty while flat */
};

/** \brief The hull of a growing object by either method. */
class PCL_ATTENTION_EXPORTS ObjectHull
{
public:
  ObjectHull () = default;
  /** \param[in] tolerance a point that lies less outside is left off by the growing hull, metres */
  ObjectHull (HullMethod method, const HullGrid& grid, float tolerance = 0.0f) : method_ (method), growing_ (grid, tolerance) {}

  void
  add (const std::vector<Eigen::Vector3f>& points);
  void
  add (const ObjectHull& other);

  VisibleHull
  visible () const { return (method_ == HullMethod::growing ? growing_.visible () : computed_); }

private:
  HullMethod method_{HullMethod::growing};
  GrowingHull growing_;
  VisibleHull computed_;
};

} // namespace pcl_attention
