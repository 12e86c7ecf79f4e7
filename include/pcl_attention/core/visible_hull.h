// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/alignment_guard.h>
#include <pcl_attention/export.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl_attention
{

/** \brief How the hull of a growing object is worked out. */
enum class HullMethod
{
  growing, /**< kept, and extended by the patches that are added */
  qhull    /**< anew for every candidate, by pcl::ConvexHull */
};

/** \brief What the distance of a point to a face is measured to. */
enum class FaceDistance
{
  triangle, /**< the face itself, as printed */
  plane     /**< the plane it lies on: less only near the outline, where the nearest visible plane's face lies elsewhere */
};

/** \brief The convex hull of an object as the sensor sees it: its vertices and the triangles that face the viewpoint. */
struct PCL_ATTENTION_EXPORTS VisibleHull
{
  struct Face
  {
    std::array<Eigen::Vector3f, 3> corners;
    Eigen::Vector3f normal; /**< unit, out of the hull */
    float offset;           /**< normal . p + offset = 0 on the face */
  };

  std::vector<Eigen::Vector3f> vertices; /**< of the whole hull */
  std::vector<Face> faces;               /**< those that face the viewpoint */
  std::vector<Face> hidden_faces;        /**< the others: a hollow seen from its open side lies on these */
  int dimension{0};                      /**< 3: a solid; 2: the points lie on a plane; 1 or less: on a line or in one point */

  /** \brief Add a triangle to the visible faces or to the hidden ones, as the viewpoint, the origin, sees it.
    * \param[in] normal unit, out of the hull */
  void
  addFace (const std::array<Eigen::Vector3f, 3>& corners, const Eigen::Vector3f& normal);
};

/** \brief Convex hull by pcl::ConvexHull and its faces towards the viewpoint, the origin (paper IV-B.2).
  * \param[in] points at least one, sensor frame, finite; coplanar points give dimension 2 and the plane's polygon as faces,
  *            collinear ones dimension 1 and no face */
PCL_ATTENTION_EXPORTS VisibleHull
computeVisibleHull (const std::vector<Eigen::Vector3f>& points);

/** \brief Shortest distance from a point to a triangle, metres. */
PCL_ATTENTION_EXPORTS float
distanceToTriangle (const Eigen::Vector3f& point, const VisibleHull::Face& face);

/** \brief Shortest distance from a point to any of the faces, metres (paper eq. 14, with the visible faces); 0 without a face. */
PCL_ATTENTION_EXPORTS float
distanceToFaces (const Eigen::Vector3f& point, const std::vector<VisibleHull::Face>& faces);

/** \brief Compactness kappa, the mean distance of the object's points to the visible faces, metres (paper eq. 13).
  * 0 for a hull of dimension under 3, whose points lie on it.
  * \param[in] weights how many points each stands for; empty: one */
PCL_ATTENTION_EXPORTS float
compactness (const std::vector<Eigen::Vector3f>& points, const VisibleHull& hull, const std::vector<float>& weights = {},
             FaceDistance face_distance = FaceDistance::triangle);

/** \brief The same to the hidden faces: small for the inside of a bowl, whose visible faces are its empty mouth. */
PCL_ATTENTION_EXPORTS float
hollowCompactness (const std::vector<Eigen::Vector3f>& points, const VisibleHull& hull, const std::vector<float>& weights = {},
                   FaceDistance face_distance = FaceDistance::triangle);

} // namespace pcl_attention
