// SPDX-License-Identifier: BSD-3-Clause
// Task-directed search: the red thing within reach, please.
#include <pcl/segmentation/attention_segmentation.h>

#include <pcl/io/pcd_io.h>

#include <iostream>

int
main (int argc, char** argv)
{
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0)
    return (1);

  pcl_attention::AttentionPrior prior;
  prior.color = {180, 35, 40};
  prior.distance = pcl_attention::ValueRange{0.3f, 1.2f}; // metres

  pcl::AttentionSegmentation<pcl::PointXYZRGB> segmentation;
  segmentation.setInputCloud (cloud);
  segmentation.setNumberOfThreads (0);
  segmentation.setAttentionPrior (prior);

  pcl::AttentionSegment object;
  while (segmentation.segmentNext (object)) // what matches best first, then everything else
    std::cout << object.rank << ": matches by " << object.attention_point.weight << ", at " << object.box.center.transpose ()
              << std::endl;
}
