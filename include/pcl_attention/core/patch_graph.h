// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/planar_patches.h>
#include <pcl_attention/core/sensor_model.h>

#include <map>
#include <utility>

namespace pcl_attention
{

/** \brief Settings of the patch graph. */
struct PatchGraphParameters
{
  int maximum_gap{10};               /**< borders are found across at most this many pixels without a patch */
  float connection_distance{0.006f}; /**< two border pixels are connected in 3D if nearer than this, metres ... */
  float connection_noise{3.0f};      /**< ... plus this many standard deviations of the depth there ... */
  float gap_slack{1.5f};             /**< ... plus this many pixel widths at their depth for every pixel of the gap */
  int sample_distance{6};            /**< convexity is judged between points this far inside either side, pixels */
  float step_tolerance{0.002f};      /**< two patches whose planes miss their common border by more are a step apart and not
                                       connected, metres ... */
  float step_roughness{1.0f};        /**< ... plus this many times how far their points lie off their planes (rms); 0: no patches
                                       are told apart by that, nor cut */
  float step_color{0.7f};            /**< within a patch, whose two sides look alike, that limit is larger by this share, and
                                       smaller by it where they have no colours in common; between patches, that may be faces of
                                       one object which are printed differently, smaller by half of it; 0..1 */
  float cut_color{0.7f};             /**< a patch is looked for a step along the line that parts its colours best first, if their
                                       chi-square is this or more: sensors smooth small steps away; above 1: off */
};

/** \brief Sums over points, from which follows how far they lie off a plane. They add up. */
struct PCL_ATTENTION_EXPORTS PointMoments
{
  int count{0};
  Eigen::Vector3d sum{Eigen::Vector3d::Zero ()};
  Eigen::Matrix3d square{Eigen::Matrix3d::Zero ()}; /**< sum of p p' */

  void
  add (const Eigen::Vector3f& point);
  PointMoments&
  operator+= (const PointMoments& other);

  /** \brief Mean and standard deviation of their signed distances from the plane through a point, metres; 0 without points. */
  std::pair<double, double>
  fromPlane (const Eigen::Vector3f& normal, const Eigen::Vector3f& on_plane) const;
  /** \brief Root mean square of their distances from the plane that fits them best, metres; 0 without points. */
  double
  flatness () const;
};

/** \brief Where two patches meet: the points on either side of their border. */
struct PCL_ATTENTION_EXPORTS BorderPoints
{
  PointMoments first_connected, second_connected; /**< of the pairs that are connected in 3D */
  PointMoments first_in_front;                    /**< of the first label where it hides the second */
  PointMoments second_in_front;

  BorderPoints&
  operator+= (const BorderPoints& other);

  /** \brief The same border seen from the other patch. */
  BorderPoints
  reversed () const { return {second_connected, first_connected, second_in_front, first_in_front}; }
};

/** \brief What is known of the border two patches (or groups of patches) share. Sums, so that borders of groups add up. */
struct PCL_ATTENTION_EXPORTS PatchBorder
{
  int pairs{0};             /**< pixel pairs across the border */
  int connected{0};         /**< of them connected in 3D */
  int first_in_front{0};    /**< not connected, the first (lower) label nearer to the viewer */
  int second_in_front{0};   /**< not connected, the second label nearer */
  int convexity_pairs{0};   /**< pairs whose convexity could be judged */
  double convexity_sum{0.0}; /**< sum over pairs of (n_b - n_a) . D, D the unit vector from a to b: > 0 convex, < 0 concave */

  float
  connectedShare () const { return (pairs > 0 ? static_cast<float> (connected) / pairs : 0.0f); }

  /** \brief Mean convexity, -2..2; 0 when it could not be judged. */
  float
  convexity () const { return (convexity_pairs > 0 ? static_cast<float> (convexity_sum / convexity_pairs) : 0.0f); }

  PatchBorder&
  operator+= (const PatchBorder& other);

  /** \brief The same border seen from the other patch. */
  PatchBorder
  reversed () const;
};

/** \brief Which patches touch in the image, and how. Labels start at 1. */
struct PCL_ATTENTION_EXPORTS PatchGraph
{
  std::map<std::pair<int, int>, PatchBorder> borders; /**< first label < second label */
  std::map<std::pair<int, int>, BorderPoints> points; /**< of the same borders */
  std::vector<std::vector<int>> neighbors;            /**< of label k at [k], ascending; [0] is empty */
  std::vector<int> perimeter;                         /**< contour pairs of label k at [k], towards anything or out of the image */

  /** \brief The border of two labels, seen from the first one; empty when they do not touch. */
  PatchBorder
  border (int first, int second) const;
  /** \brief The points of that border. */
  BorderPoints
  borderPoints (int first, int second) const;
};

/** \brief Find which patches share a border, how much of it is connected in 3D, and whether it is convex or concave.
  * \param[in] labels 0 = none, else 1..count
  * \param[in] threads number of threads, 0: all processors */
PCL_ATTENTION_EXPORTS PatchGraph
buildPatchGraph (const OrganizedCloud& cloud, const SensorModel& sensor, const NormalImage& normals, const Image<int>& labels,
                 int count, const PatchGraphParameters& parameters, int threads = 1);

} // namespace pcl_attention
