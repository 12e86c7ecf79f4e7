// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/alignment_guard.h>
#include <pcl_attention/core/image.h>
#include <pcl_attention/core/organized_cloud.h>

#include <Eigen/Core>
#include <pcl/types.h>

#include <vector>

namespace pcl_attention
{

/** \brief Which plane a new point of a patch is compared with. */
enum class PlaneModel
{
  initial, /**< the plane of the seed ("the initial plane model", paper IV-A) */
  running  /**< the mean normal and point of the patch so far: follows gently curved surfaces */
};

/** \brief What grows the patches. */
enum class PatchMethod
{
  grid_growing,  /**< flat arrays over the pixel grid */
  region_growing /**< pcl::RegionGrowing, which points of equal curvature reach in any order */
};

/** \brief Settings of the normal clustering (paper IV-A). */
struct PatchParameters
{
  PatchMethod method{PatchMethod::grid_growing};
  PlaneModel plane_model{PlaneModel::running};
  float maximum_angle{0.5f};       /**< between a point's normal and the plane's, radians, 0..pi/2 */
  float maximum_distance{0.008f};  /**< of a point from the plane, metres */
  float maximum_step{0.01f};       /**< a step between neighbouring pixels beyond this may be a depth edge, metres */
  int minimum_size{80};            /**< smaller clusters are dissolved: fragments lie in creases and bridge them, pixels */
  float reassign_distance{0.01f};  /**< left-over points join a neighbouring patch nearer than this, metres; 0: they stay noise */
};

/** \brief A cluster of neighbouring points with similar normals. */
struct PlanarPatch
{
  pcl::Indices pixels;                              /**< row-major indices, ascending */
  Eigen::Vector3f centroid{Eigen::Vector3f::Zero ()}; /**< metres, sensor frame */
  Eigen::Vector3f normal{Eigen::Vector3f::Zero ()};   /**< unit, of the plane fitted to its points, towards the viewpoint */
  float rms{0.0f};                                  /**< of the plane fit, metres */
  std::vector<int> cuts; /**< steps along which it was cut from others: k on one side of a step, -k on the other */
};

/** \brief All patches of a cloud. */
struct PlanarPatches
{
  Image<int> labels;                /**< 0 = none, else 1, 2, ...: patch k is at patches[k - 1] */
  std::vector<PlanarPatch> patches; /**< in the order they were grown: lowest curvature first */
};

/** \brief Cluster normals into planar patches, starting at the lowest curvature (paper IV-A).
  * Every point without a patch after that is re-assigned to a neighbouring patch or left as noise.
  * \param[in] threads number of threads, 0: all processors */
PCL_ATTENTION_EXPORTS void
extractPlanarPatches (const OrganizedCloud& cloud, const NormalImage& normals, const PatchParameters& parameters,
                      PlanarPatches& result, int threads = 1);

/** \brief The same where some patches are there already.
  * \param[in] taken of the cloud's size: 0, or the labels 1, 2, ... of those patches; the others have the labels after them */
PCL_ATTENTION_EXPORTS void
extractPlanarPatches (const OrganizedCloud& cloud, const NormalImage& normals, Image<int>&& taken,
                      const PatchParameters& parameters, PlanarPatches& result, int threads = 1);

/** \brief Give valid points without a patch to the neighbouring patch that is nearest in 3D, ring by ring outwards from the
  * patches, as far as they are nearer than maximum_distance metres, and to its plane (paper IV-A). */
PCL_ATTENTION_EXPORTS void
reassignLeftOvers (const OrganizedCloud& cloud, float maximum_distance, PlanarPatches& patches);

/** \brief Fill a patch's plane from its pixels. */
PCL_ATTENTION_EXPORTS void
describePatch (const OrganizedCloud& cloud, PlanarPatch& patch);

/** \brief Fill the patches' pixel lists and planes from a label image, for labels made elsewhere. */
PCL_ATTENTION_EXPORTS void
describePatches (const OrganizedCloud& cloud, PlanarPatches& result);

} // namespace pcl_attention
