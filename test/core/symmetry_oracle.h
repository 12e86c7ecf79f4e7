// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/symmetry.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/** \brief Equations 1 to 8 of the paper once more, as they are printed, in double precision and one pixel after the
 * other: what the fast implementation is checked against and measured by. Shares no code with it. */
namespace pcl_attention::oracle
{

/** \brief One of the two neighbourhoods N_i1 and N_i2 (eq. 1), with its mean point and mean normal. */
struct Half
{
  int count{0};
  Eigen::Vector3d point{Eigen::Vector3d::Zero ()}, normal{Eigen::Vector3d::Zero ()};

  void
  add (const Eigen::Vector3d& p, const Eigen::Vector3d& n)
  {
    ++count;
    point += p;
    normal += n;
  }

  Eigen::Vector3d
  meanPoint () const
  {
    return (point / count);
  }

  /** \brief Only its direction enters eq. 6 and 8. */
  Eigen::Vector3d
  meanNormal () const
  {
    return (normal.normalized ());
  }
};

/** \brief A reflective plane pi_i: through the point, perpendicular to the principal axis. */
struct ReflectivePlane
{
  Eigen::Vector3d through, axis;

  /** \brief d (p', pi_i) of eq. 1, signed. */
  double
  distance (const Eigen::Vector3d& point) const
  {
    return (axis.dot (point - through));
  }
};

/** \brief Eq. 4. */
inline double
distanceDifference (const Half& half1, const Half& half2, const ReflectivePlane& plane)
{
  return (std::abs (std::abs (plane.distance (half1.meanPoint ())) - std::abs (plane.distance (half2.meanPoint ()))));
}

/** \brief Eq. 5. */
inline double
depthDifference (const Half& half1, const Half& half2)
{
  return (std::abs (half1.meanPoint ().z () - half2.meanPoint ().z ()));
}

/** \brief Eq. 7, with p_i2 where the denominator of the text repeats p_i1. */
inline Eigen::Vector3d
connectingLine (const Half& half1, const Half& half2)
{
  const Eigen::Vector3d difference = half1.meanPoint () - half2.meanPoint ();
  return (difference / difference.norm ());
}

/** \brief omega_1, eq. 6; 0 for parallel mean normals, where the text divides by 0. */
inline double
coplanarity (const Half& half1, const Half& half2)
{
  const Eigen::Vector3d product = half1.meanNormal ().cross (half2.meanNormal ());
  const double length = product.norm ();
  return (length > 0.0 ? (product / length).cross (connectingLine (half1, half2)).norm () : 0.0);
}

/** \brief alpha_j of eq. 8. */
inline double
angle (const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return (std::acos (std::clamp (a.dot (b) / (a.norm () * b.norm ()), -1.0, 1.0)));
}

/** \brief omega_2, eq. 8. */
inline double
normalOpposition (const Half& half1, const Half& half2)
{
  const Eigen::Vector3d line = connectingLine (half1, half2);
  const double alpha1 = angle (half1.meanNormal (), line), alpha2 = angle (half2.meanNormal (), line);
  return ((1.0 - std::cos (alpha1 + alpha2)) * (1.0 - std::cos (alpha1 - alpha2)));
}

/** \brief Omega_i, eq. 3. */
inline double
reflectiveSymmetry (const Half& half1, const Half& half2, const ReflectivePlane& plane, double distance_scale)
{
  return (std::exp (-distance_scale * depthDifference (half1, half2)) *
          std::exp (-distance_scale * distanceDifference (half1, half2, plane)) * coplanarity (half1, half2) *
          normalOpposition (half1, half2));
}

/** \brief s (p) of eq. 2, and how well it is defined. */
struct Symmetry
{
  double value{0.0};
  Eigen::Vector3d axis{Eigen::Vector3d::Zero ()}; /**< the principal axis that won; 0 where value is 0 */
  double axis_uncertainty{
      0.0}; /**< how far float rounding may turn the principal axes, radians; infinite where two are alike */
  double margin{std::numeric_limits<double>::infinity ()}; /**< how far the axes could be turned before a sample changes
                                                              sides or the gate opens or closes, radians */

  /** \brief Whether any two correct implementations must agree: elsewhere rounding decides on which side of a plane a
   * sample lies, and s (p), which jumps there, may be one value or another. */
  bool
  isWellDefined (double largest_uncertainty = 1e-4) const
  {
    return (axis_uncertainty < largest_uncertainty && axis_uncertainty < margin);
  }
};

/** \brief s (p), eq. 1 to 3, of one pixel. */
inline Symmetry
symmetryAt (const OrganizedCloud& cloud, const NormalImage& normals, const SaliencyParameters& parameters, int column,
            int row)
{
  const auto indexOf = [&] (int c, int r) { return (static_cast<std::size_t> (r) * cloud.width + c); };
  const auto isValid = [&] (int c, int r) {
    return (c >= 0 && c < cloud.width && r >= 0 && r < cloud.height && cloud.valid[indexOf (c, r)] &&
            normals.valid[indexOf (c, r)]);
  };
  const auto pointAt = [&] (int c, int r) {
    const std::size_t index = indexOf (c, r);
    return (Eigen::Vector3d (cloud.x[index], cloud.y[index], cloud.z[index]));
  };
  const auto normalAt = [&] (int c, int r) {
    const std::size_t index = indexOf (c, r);
    return (Eigen::Vector3d (normals.x[index], normals.y[index], normals.z[index]));
  };

  Symmetry result;
  if (!isValid (column, row))
    return (result);
  // N (p): the window without the centre row and column.
  std::vector<Eigen::Vector3d> neighbor_points, neighbor_normals;
  const int radius = parameters.window_radius;
  for (int r = row - radius; r <= row + radius; ++r)
    for (int c = column - radius; c <= column + radius; ++c)
      if (r != row && c != column && isValid (c, r))
      {
        neighbor_points.push_back (pointAt (c, r));
        neighbor_normals.push_back (normalAt (c, r));
      }
  const std::size_t count = neighbor_points.size ();
  if (count < 2)
    return (result);

  // PCA on the Extended Gaussian Image.
  const Eigen::Vector3d center = pointAt (column, row), center_normal = normalAt (column, row);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero ();
  for (const Eigen::Vector3d& normal : neighbor_normals)
    mean += normal / static_cast<double> (count);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero ();
  double second_moment = 0.0;
  for (const Eigen::Vector3d& normal : neighbor_normals)
  {
    covariance += (normal - mean) * (normal - mean).transpose () / static_cast<double> (count);
    second_moment += (normal - center_normal).squaredNorm () / static_cast<double> (count);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (covariance);
  // A covariance from float sums is off by some float roundings of the second moment; eigenvectors turn by error / gap.
  const double gap = std::min (solver.eigenvalues () (1) - solver.eigenvalues () (0),
                               solver.eigenvalues () (2) - solver.eigenvalues () (1));
  const double error = 4.0 * std::numeric_limits<float>::epsilon () * second_moment;
  result.axis_uncertainty = gap > 0.0 ? error / gap : std::numeric_limits<double>::infinity ();

  for (int i = 0; i < 3; ++i)
  {
    const ReflectivePlane plane{center, solver.eigenvectors ().col (i)};
    Half half1, half2;
    for (std::size_t k = 0; k < count; ++k)
    {
      const double distance = plane.distance (neighbor_points[k]);
      const double length = (neighbor_points[k] - center).norm ();
      if (length > 0.0)
        result.margin = std::min (result.margin, std::abs (distance) / length);
      if (distance > 0.0)
        half1.add (neighbor_points[k], neighbor_normals[k]);
      else if (distance < 0.0)
        half2.add (neighbor_points[k], neighbor_normals[k]);
    }
    if (half1.count == 0 || half2.count == 0)
      continue;
    const double value = reflectiveSymmetry (half1, half2, plane, parameters.distance_scale);
    if (parameters.convexity_gate)
    {
      const double facing1 = half1.meanNormal ().dot (plane.axis), facing2 = -half2.meanNormal ().dot (plane.axis);
      result.margin = std::min ({result.margin, std::abs (facing1), std::abs (facing2)});
      if (facing1 <= 0.0 || facing2 <= 0.0)
        continue;
    }
    if (std::isfinite (value) && value > result.value)
    {
      result.value = value;
      result.axis = plane.axis;
    }
  }
  return (result);
}

/** \brief s (p) of every pixel. */
inline Image<Symmetry>
symmetryMap (const OrganizedCloud& cloud, const NormalImage& normals, const SaliencyParameters& parameters)
{
  Image<Symmetry> map (cloud.width, cloud.height);
  for (int row = 0; row < cloud.height; ++row)
    for (int column = 0; column < cloud.width; ++column)
      map (column, row) = symmetryAt (cloud, normals, parameters, column, row);
  return (map);
}

} // namespace pcl_attention::oracle
