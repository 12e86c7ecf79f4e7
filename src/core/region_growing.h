// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/planar_patches.h>

namespace pcl_attention
{

/** \brief The plane of a growing patch, and the tests of paper IV-A against it, without roots and divisions: with the sums Q of
  * normals and S of points, count c, the plane's normal is Q / |Q| and its point S / c. */
class GrowingPlane
{
public:
  explicit GrowingPlane (const PatchParameters& parameters)
  : running_ (parameters.plane_model == PlaneModel::running),
    squared_cosine_ (std::cos (parameters.maximum_angle) * std::cos (parameters.maximum_angle)),
    squared_distance_ (parameters.maximum_distance * parameters.maximum_distance),
    squared_step_ (parameters.maximum_step * parameters.maximum_step)
  {}

  /** \brief Start afresh at a seed. */
  void
  start (const Eigen::Vector3f& point, const Eigen::Vector3f& normal)
  {
    count_ = 1.0f;
    point_sum_ = point;
    normal_sum_ = normal;
  }

  /** \brief Whether a point belongs to the plane and does not step away from its neighbour in the patch. */
  bool
  takes (const Eigen::Vector3f& point, const Eigen::Vector3f& normal, const Eigen::Vector3f& neighbor,
         const Eigen::Vector3f& neighbor_normal) const
  {
    const float square = normal_sum_.squaredNorm (), along = normal.dot (normal_sum_);
    const float distance = normal_sum_.dot (point * count_ - point_sum_);
    return (along > 0.0f && along * along >= squared_cosine_ * square &&
            distance * distance <= squared_distance_ * square * (count_ * count_) &&
            !isStep (neighbor, neighbor_normal, point));
  }

  /** \brief The plane follows its points, if it is to. */
  void
  add (const Eigen::Vector3f& point, const Eigen::Vector3f& normal)
  {
    if (!running_)
      return;
    count_ += 1.0f;
    point_sum_ += point;
    normal_sum_ += normal;
  }

  /** \brief Whether the surface steps between two neighbouring pixels: apart along the view, and off the first one's tangent
    * plane, so that a slanted surface is no step. */
  bool
  isStep (const Eigen::Vector3f& from, const Eigen::Vector3f& normal, const Eigen::Vector3f& to) const
  {
    const Eigen::Vector3f difference = to - from;
    const float off_plane = normal.dot (difference);
    return (difference.squaredNorm () > squared_step_ && off_plane * off_plane > 0.25f * squared_step_);
  }

private:
  bool running_;
  float squared_cosine_, squared_distance_, squared_step_;
  float count_{0.0f};
  Eigen::Vector3f normal_sum_{Eigen::Vector3f::Zero ()}, point_sum_{Eigen::Vector3f::Zero ()};
};

/** \brief Label the regions that grow from the points of lowest curvature, of equal ones from the first.
  * \param[in] threads 0: all processors; the regions do not depend on it
  * \param[in,out] labels of the cloud's size; pixels with one are taken already
  * \param[in] label of the patch before; the regions have those after it, in the order they are grown, without those under the
  * minimum size */
void
growOnGrid (const OrganizedCloud& cloud, const NormalImage& normals, const PatchParameters& parameters, int threads,
            Image<int>& labels, int label);

/** \brief The same with pcl::RegionGrowing, in which points of equal curvature come in any order. */
void
growWithPcl (const OrganizedCloud& cloud, const NormalImage& normals, const PatchParameters& parameters, Image<int>& labels,
             int label);

} // namespace pcl_attention
