// SPDX-License-Identifier: BSD-3-Clause
// Attention as the first filter of a pipeline: only what is worth a look is processed on.
#include <pcl/segmentation/attention_filter.h>

#include <pcl/filters/voxel_grid.h>
#include <pcl/io/pcd_io.h>

#include <iostream>

int
main (int argc, char** argv)
{
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0)
    return (1);

  //! [filter]
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr attended (new pcl::PointCloud<pcl::PointXYZRGB>);
  pcl::AttentionFilter<pcl::PointXYZRGB> filter;
  filter.setInputCloud (cloud); // organized: before the filters that thin it out
  filter.setKeepObjects (3);
  filter.filter (*attended);

  pcl::PointCloud<pcl::PointXYZRGB> thin;
  pcl::VoxelGrid<pcl::PointXYZRGB> grid;
  grid.setInputCloud (attended);
  grid.setLeafSize (0.003f, 0.003f, 0.003f);
  grid.filter (thin);
  //! [filter]
  std::cout << "of " << cloud->size () << " points " << attended->size () << " are on the " << filter.getObjects ().size ()
            << " most attended objects, " << thin.size () << " voxels" << std::endl;
}
