// SPDX-License-Identifier: BSD-3-Clause
// A typical program for objects on a table: thin out, remove the plane, cluster what is left.
#include <pcl/filters/extract_indices.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/io/pcd_io.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <iostream>

using PointT = pcl::PointXYZRGB;

int
main (int argc, char** argv)
{
  const pcl::PointCloud<PointT>::Ptr cloud (new pcl::PointCloud<PointT>), thin (new pcl::PointCloud<PointT>);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0)
    return (1);

  pcl::VoxelGrid<PointT> grid;
  grid.setInputCloud (cloud);
  grid.setLeafSize (0.005f, 0.005f, 0.005f);
  grid.filter (*thin);

  pcl::SACSegmentation<PointT> plane;
  plane.setInputCloud (thin);
  plane.setModelType (pcl::SACMODEL_PLANE);
  plane.setMethodType (pcl::SAC_RANSAC);
  plane.setDistanceThreshold (0.01);
  const pcl::PointIndices::Ptr table (new pcl::PointIndices);
  pcl::ModelCoefficients coefficients;
  plane.segment (*table, coefficients);

  const pcl::PointCloud<PointT>::Ptr rest (new pcl::PointCloud<PointT>);
  pcl::ExtractIndices<PointT> extract;
  extract.setInputCloud (thin);
  extract.setIndices (table);
  extract.setNegative (true);
  extract.filter (*rest);

  pcl::EuclideanClusterExtraction<PointT> clustering;
  clustering.setInputCloud (rest);
  clustering.setSearchMethod (pcl::search::KdTree<PointT>::Ptr (new pcl::search::KdTree<PointT>));
  clustering.setClusterTolerance (0.015);
  clustering.setMinClusterSize (50);
  std::vector<pcl::PointIndices> clusters;
  clustering.extract (clusters);
  for (const pcl::PointIndices& cluster : clusters)
    std::cout << "cluster of " << cluster.indices.size () << " points" << std::endl;
}
