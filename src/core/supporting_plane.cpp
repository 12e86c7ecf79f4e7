// SPDX-License-Identifier: BSD-3-Clause
#include "convex_hull.h"

#include <pcl_attention/core/supporting_plane.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl_attention
{

namespace
{

Eigen::Vector3f
pointAt (const OrganizedCloud& cloud, std::size_t index)
{
  return {cloud.x[index], cloud.y[index], cloud.z[index]};
}

/** \brief Area a pixel covers on a surface with this normal, m^2. */
float
pixelArea (const Eigen::Vector3f& point, const Eigen::Vector3f& normal, float focal_length)
{
  const float side = point.z () / focal_length;
  const float cosine = std::max (0.1f, std::abs (normal.dot (point.normalized ())));
  return (side * side / cosine);
}

/** \brief The outline of a plane's points, to ask what lies over it. */
class Footprint
{
public:
  Footprint (const OrganizedCloud& cloud, const pcl::Indices& indices, const Eigen::Vector3f& normal)
  {
    axis1_ = normal.unitOrthogonal ();
    axis2_ = normal.cross (axis1_);
    std::vector<Eigen::Vector3f> flat;
    const std::size_t step = std::max<std::size_t> (1, indices.size () / 2000);
    for (std::size_t i = 0; i < indices.size (); i += step)
    {
      const Eigen::Vector3f point = pointAt (cloud, indices[i]);
      flat.emplace_back (point.dot (axis1_), point.dot (axis2_), 0.0f);
    }
    outline_ = computeConvexHull (flat, 2).vertices;
    float area = 0.0f;
    for (std::size_t i = 0; i < outline_.size (); ++i)
    {
      const Eigen::Vector3f& a = outline_[i];
      const Eigen::Vector3f& b = outline_[(i + 1) % outline_.size ()];
      area += a.x () * b.y () - a.y () * b.x ();
    }
    if (area < 0.0f)
      std::reverse (outline_.begin (), outline_.end ());
  }

  /** \brief Whether a point's foot lies inside the outline or at most margin metres beyond it. */
  bool
  contains (const Eigen::Vector3f& point, float margin) const
  {
    const Eigen::Vector2f foot (point.dot (axis1_), point.dot (axis2_));
    for (std::size_t i = 0; i < outline_.size (); ++i)
    {
      const Eigen::Vector2f a = outline_[i].head<2> (), edge = outline_[(i + 1) % outline_.size ()].head<2> () - a;
      const Eigen::Vector2f outwards (edge.y (), -edge.x ());
      if (outwards.dot (foot - a) > margin * edge.norm ())
        return (false);
    }
    return (outline_.size () >= 3);
  }

private:
  Eigen::Vector3f axis1_, axis2_;
  std::vector<Eigen::Vector3f> outline_; /**< counter-clockwise, in plane coordinates */
};

struct PlaneFit
{
  Eigen::Vector3f normal;
  float offset;

  float
  height (const Eigen::Vector3f& point) const { return (normal.dot (point) + offset); }
};

PlaneFit
fitPlane (const OrganizedCloud& cloud, const pcl::Indices& indices)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero ();
  for (const pcl::index_t index : indices)
    mean += pointAt (cloud, index).cast<double> () / static_cast<double> (indices.size ());
  // A point's weight falls with the noise of its depth, which grows with z^2.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero ();
  Eigen::Vector3d weighted_mean = Eigen::Vector3d::Zero ();
  double weights = 0.0;
  for (const pcl::index_t index : indices)
  {
    const Eigen::Vector3d point = pointAt (cloud, index).cast<double> ();
    const double weight = 1.0 / std::max (1e-6, std::pow (point.z (), 4));
    weights += weight;
    weighted_mean += weight * (point - mean);
    covariance += weight * (point - mean) * (point - mean).transpose ();
  }
  weighted_mean /= weights;
  covariance = covariance / weights - weighted_mean * weighted_mean.transpose ();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (covariance);
  Eigen::Vector3d normal = solver.eigenvectors ().col (0);
  const Eigen::Vector3d center = mean + weighted_mean;
  if (normal.dot (center) > 0.0)
    normal = -normal;
  return {normal.cast<float> (), static_cast<float> (-normal.dot (center))};
}

/** \brief Grow a plane from a patch to all points near it, over a few rounds of fitting. */
void
refine (const OrganizedCloud& cloud, const NormalImage& normals, float noise, const SupportParameters& parameters,
        PlaneFit& plane, pcl::Indices& indices)
{
  constexpr int rounds = 4;
  const float minimum_cosine = std::cos (0.6f);
  for (int round = 0; round < rounds; ++round)
  {
    indices.clear ();
    for (std::size_t index = 0; index < cloud.size (); ++index)
    {
      if (!cloud.valid[index])
        continue;
      const Eigen::Vector3f point = pointAt (cloud, index);
      const float tolerance = parameters.tolerance + parameters.noise_tolerance * noise * point.z () * point.z ();
      const float height = std::abs (plane.height (point));
      if (height >= tolerance)
        continue;
      const bool aligned = normals.valid[index] &&
        plane.normal.dot (Eigen::Vector3f (normals.x[index], normals.y[index], normals.z[index])) > minimum_cosine;
      if (aligned || height < 0.5f * tolerance)
        indices.push_back (static_cast<pcl::index_t> (index));
    }
    if (indices.size () < 3 || round + 1 == rounds)
      return;
    plane = fitPlane (cloud, indices);
  }
}

} // namespace

float
estimateDepthNoise (const OrganizedCloud& cloud)
{
  // The inverse depth of a plane is linear along a row, so its second difference is noise, wherever there is no edge.
  constexpr int distance = 8;
  std::vector<float> differences;
  for (int row = 0; row < cloud.height; row += 2)
    for (int column = distance; column + distance < cloud.width; column += 2)
    {
      const std::size_t index = static_cast<std::size_t> (row) * cloud.width + column;
      if (!cloud.valid[index] || !cloud.valid[index - distance] || !cloud.valid[index + distance] ||
          std::min ({cloud.z[index], cloud.z[index - distance], cloud.z[index + distance]}) <= 0.0f)
        continue;
      differences.push_back (std::abs (1.0f / cloud.z[index - distance] + 1.0f / cloud.z[index + distance] -
                                       2.0f / cloud.z[index]));
    }
  if (differences.size () < 100)
    return (0.0f);
  const auto middle = differences.begin () + static_cast<std::ptrdiff_t> (differences.size () / 2);
  std::nth_element (differences.begin (), middle, differences.end ());
  // The median of |normal| is 0.6745 standard deviations; the second difference has six times the variance.
  return (*middle / 0.6745f / std::sqrt (6.0f));
}

std::vector<SupportingPlane>
findSupportingPlanes (const OrganizedCloud& cloud, const NormalImage& normals, const PlanarPatches& patches,
                      const PatchGraph& graph, const SupportParameters& parameters)
{
  std::vector<SupportingPlane> planes;
  const float focal_length = estimateFocalLength (cloud);
  if (focal_length <= 0.0f)
    return (planes);
  const float noise = estimateDepthNoise (cloud);

  struct Scored
  {
    SupportingPlane plane;
    double score;
  };
  std::vector<Scored> scored;
  for (std::size_t k = 0; k < patches.patches.size (); ++k)
  {
    const PlanarPatch& patch = patches.patches[k];
    if (patch.pixels.size () < 500)
      continue;
    float area = 0.0f;
    for (const pcl::index_t index : patch.pixels)
      area += pixelArea (pointAt (cloud, index), patch.normal, focal_length);
    if (area < parameters.minimum_area)
      continue;

    PlaneFit plane = fitPlane (cloud, patch.pixels);
    Scored candidate;
    refine (cloud, normals, noise, parameters, plane, candidate.plane.indices);
    if (candidate.plane.indices.size () < patch.pixels.size () / 2)
      continue;
    const Footprint footprint (cloud, patch.pixels, plane.normal);
    double over = 0.0, below = 0.0;
    constexpr std::size_t step = 4;
    for (std::size_t index = 0; index < cloud.size (); index += step)
    {
      if (!cloud.valid[index])
        continue;
      const Eigen::Vector3f point = pointAt (cloud, index);
      const float height = plane.height (point);
      const float clear = 0.02f + parameters.noise_tolerance * noise * point.z () * point.z ();
      if (height > clear && height < 0.4f && footprint.contains (point, 0.05f))
        over += step;
      else if (height < -clear && height > -0.3f && footprint.contains (point, 0.15f))
        below += step;
    }
    const int label = static_cast<int> (k) + 1;
    double concave = 0.0;
    for (const int neighbor : graph.neighbors[label])
    {
      const PatchBorder border = graph.border (label, neighbor);
      if (border.convexity () < -0.2f)
        concave += border.connected;
    }
    candidate.plane.coefficients << plane.normal, plane.offset;
    candidate.plane.area = 0.0f;
    for (const pcl::index_t index : candidate.plane.indices)
      candidate.plane.area += pixelArea (pointAt (cloud, index), plane.normal, focal_length);
    candidate.plane.confidence = static_cast<float> ((over + 100.0) / (over + below + 100.0));
    candidate.score = static_cast<double> (patch.pixels.size ()) * (concave + 20.0) * (over + 300.0) *
                      candidate.plane.confidence * candidate.plane.confidence;
    scored.push_back (std::move (candidate));
  }
  std::stable_sort (scored.begin (), scored.end (), [] (const Scored& a, const Scored& b) { return (a.score > b.score); });
  for (Scored& candidate : scored)
  {
    candidate.plane.supports_objects = planes.empty () && candidate.plane.confidence >= parameters.minimum_confidence;
    if (candidate.plane.supports_objects)
      planes.push_back (std::move (candidate.plane));
  }
  return (planes);
}

} // namespace pcl_attention
