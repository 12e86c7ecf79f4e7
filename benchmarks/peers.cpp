// SPDX-License-Identifier: BSD-3-Clause
#include "peers.h"

#include "measure.h"

#include <pcl/features/integral_image_normal.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

namespace pcl_attention
{

namespace
{

using IntegralImageNormals = pcl::IntegralImageNormalEstimation<pcl::PointXYZRGB, pcl::Normal>;

void
estimateNormals (const SceneCloud::ConstPtr& cloud, IntegralImageNormals::NormalEstimationMethod method)
{
  IntegralImageNormals estimation;
  estimation.setNormalEstimationMethod (method);
  estimation.setInputCloud (cloud);
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute (normals);
}

void
segmentByConvexity (const SceneCloud::ConstPtr& cloud)
{
  constexpr float voxel_resolution = 0.005f, seed_resolution = 0.015f;
  pcl::SupervoxelClustering<pcl::PointXYZRGB> supervoxels (voxel_resolution, seed_resolution);
  supervoxels.setUseSingleCameraTransform (false);
  supervoxels.setInputCloud (cloud);
  supervoxels.setColorImportance (0.0f);
  supervoxels.setSpatialImportance (0.4f);
  supervoxels.setNormalImportance (10.0f);
  std::map<std::uint32_t, pcl::Supervoxel<pcl::PointXYZRGB>::Ptr> clusters;
  supervoxels.extract (clusters);
  std::multimap<std::uint32_t, std::uint32_t> adjacency;
  supervoxels.getSupervoxelAdjacency (adjacency);

  pcl::LCCPSegmentation<pcl::PointXYZRGB> lccp;
  lccp.setConcavityToleranceThreshold (8.0f);
  lccp.setSmoothnessCheck (false, voxel_resolution, seed_resolution);
  lccp.setKFactor (1); // extended convexity
  lccp.setMinSegmentSize (6);
  lccp.setInputSupervoxels (clusters, adjacency);
  lccp.segment ();
  const pcl::PointCloud<pcl::PointXYZL>::Ptr labels = supervoxels.getLabeledCloud ();
  lccp.relabelCloud (*labels);
}

} // namespace

void
measurePeers (const std::vector<SceneCloud::ConstPtr>& clouds)
{
  measure ("normals/pcl_covariance_matrix", clouds, [] (const SceneCloud::ConstPtr& cloud) {
    estimateNormals (cloud, IntegralImageNormals::COVARIANCE_MATRIX);
  });
  measure ("normals/pcl_average_3d_gradient", clouds, [] (const SceneCloud::ConstPtr& cloud) {
    estimateNormals (cloud, IntegralImageNormals::AVERAGE_3D_GRADIENT);
  });
  measure ("frame/pcl_lccp_tuned", clouds, segmentByConvexity);
}

} // namespace pcl_attention
