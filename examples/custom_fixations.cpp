// SPDX-License-Identifier: BSD-3-Clause
// The objects at pixels of your own choice: a click, a pointing hand, another detector.
#include <pcl/segmentation/attention_segmentation.h>

#include <pcl/io/pcd_io.h>

#include <cstdlib>
#include <iostream>

int
main (int argc, char** argv)
{
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
  if (argc < 4 || argc % 2 != 0 || pcl::io::loadPCDFile (argv[1], *cloud) < 0)
  {
    std::cerr << "Usage: custom_fixations SCENE.pcd COLUMN ROW [COLUMN ROW]..." << std::endl;
    return (1);
  }
  std::vector<pcl::AttentionPoint> pixels;
  for (int i = 2; i < argc; i += 2)
  {
    pixels.emplace_back ();
    pixels.back ().column = std::atoi (argv[i]);
    pixels.back ().row = std::atoi (argv[i + 1]);
  }

  pcl::AttentionSegmentation<pcl::PointXYZRGB> segmentation;
  segmentation.setInputCloud (cloud);

  //! [one]
  // One object, as when a user clicks: what was computed for the first click serves all others.
  for (const pcl::AttentionPoint& pixel : pixels)
  {
    pcl::AttentionSegment object;
    if (segmentation.segmentAt (pixel.column, pixel.row, object))
      std::cout << "at " << pixel.column << ", " << pixel.row << ": " << object.indices.size () << " points" << std::endl;
    else
      std::cout << "at " << pixel.column << ", " << pixel.row << ": no object" << std::endl;
  }
  //! [one]

  //! [list]
  // A list of places in your own order: what leads to an object twice is skipped, and nothing is looked for elsewhere.
  pcl_attention::AttentionParameters parameters;
  parameters.segmentation.coverage = false;
  segmentation.setParameters (parameters);
  segmentation.setAttentionPoints (pixels);
  std::vector<pcl::AttentionSegment> objects;
  if (!segmentation.segment (objects))
    return (1);
  std::cout << objects.size () << " different objects" << std::endl;
  //! [list]
}
