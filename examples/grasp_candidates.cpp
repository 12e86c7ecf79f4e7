// SPDX-License-Identifier: BSD-3-Clause
// From a camera's cloud to places where a parallel gripper could take something from above.
#include <pcl/segmentation/attention_segmentation.h>

#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

int
main (int argc, char** argv)
{
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0)
    return (1);
  constexpr float opening = 0.10f; // of the gripper, metres

  //! [table]
  pcl::AttentionSegmentation<pcl::PointXYZRGB> segmentation;
  segmentation.setInputCloud (cloud);
  pcl::PointIndices table;
  pcl::ModelCoefficients plane;
  if (!segmentation.getSupportingPlane (table, plane))
  {
    std::cerr << "Nothing that objects stand on was found." << std::endl;
    return (1);
  }
  const Eigen::Vector3f up (plane.values[0], plane.values[1], plane.values[2]);
  //! [table]

  //! [grasps]
  pcl::AttentionSegment object;
  while (segmentation.segmentNext (object))
  {
    // Where most of the contour is in doubt, the box may be that of a part, or of more than the object.
    if (object.confidence < 0.5f)
      continue;
    // What does not stand on the table is not to be taken from above it.
    float foot = std::numeric_limits<float>::infinity ();
    for (const pcl::index_t index : object.indices)
      foot = std::min (foot, up.dot ((*cloud)[index].getVector3fMap ()) + plane.values[3]);
    if (foot > 0.03f)
      continue;
    // The gripper comes from above and closes along the narrower of the box's axes that lie flat.
    const Eigen::Matrix3f axes = object.box.orientation.toRotationMatrix ();
    int closing = -1;
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs (axes.col (axis).dot (up)) < 0.5f && (closing < 0 || object.box.size[axis] < object.box.size[closing]))
        closing = axis;
    if (closing < 0 || object.box.size[closing] > opening)
      continue;
    const Eigen::Vector3f close_along = (axes.col (closing) - axes.col (closing).dot (up) * up).normalized ();
    std::cout << "object " << object.rank << ": open to " << object.box.size[closing] << " m at "
              << object.box.center.transpose () << ", approach along " << -up.transpose () << ", close along "
              << close_along.transpose () << std::endl;
  }
  //! [grasps]
}
