// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/segmentation/attention_segmentation.h>

#include <pcl/io/pcd_io.h>

#include <iostream>

int
main (int argc, char** argv)
{
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0)
    return (1);

  pcl::AttentionSegmentation<pcl::PointXYZRGB> segmentation;
  segmentation.setInputCloud (cloud);
  segmentation.setNumberOfThreads (0);

  pcl::AttentionSegment object;
  while (segmentation.segmentNext (object)) // one fixation at a time, the most salient first
    std::cout << object.rank << ": " << object.indices.size () << " points, box of " << object.box.size.transpose ()
              << " m at " << object.box.center.transpose () << std::endl;
}
