// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/segmentation/impl/attention_segmentation.hpp>

#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

PCL_INSTANTIATE (AttentionSegmentation, (pcl::PointXYZ) (pcl::PointXYZRGB) (pcl::PointXYZRGBA) (pcl::PointXYZRGBNormal) (pcl::PointXYZRGBL))
