// SPDX-License-Identifier: BSD-3-Clause
// A stream of frames: the first object is there long before the last, and a frame may be left for the next one.
#include <pcl/segmentation/attention_segmentation.h>

#include <pcl/io/pcd_io.h>

#include <chrono>
#include <iostream>

using Clock = std::chrono::steady_clock;

namespace
{

long
millisecondsSince (Clock::time_point begin)
{
  return (std::chrono::duration_cast<std::chrono::milliseconds> (Clock::now () - begin).count ());
}

} // namespace

int
main (int argc, char** argv)
{
  if (argc < 2)
  {
    std::cerr << "Usage: stream FRAME.pcd..." << std::endl;
    return (1);
  }
  //! [stream]
  constexpr long budget = 500; // milliseconds a frame
  pcl::AttentionSegmentation<pcl::PointXYZRGB> segmentation;
  segmentation.setNumberOfThreads (0);
  for (int i = 1; i < argc; ++i)
  {
    // In a robot: the callback of the camera's topic.
    const pcl::PointCloud<pcl::PointXYZRGB>::Ptr frame (new pcl::PointCloud<pcl::PointXYZRGB>);
    if (pcl::io::loadPCDFile (argv[i], *frame) < 0)
      return (1);
    const Clock::time_point begin = Clock::now ();
    segmentation.setInputCloud (frame); // forgets the frame before
    pcl::AttentionSegment object;
    while (segmentation.segmentNext (object))
    {
      std::cout << argv[i] << ": object " << object.rank << " after " << millisecondsSince (begin) << " ms" << std::endl;
      if (millisecondsSince (begin) > budget)
        break; // the most salient objects are known; on to the next frame
    }
  }
  //! [stream]
}
