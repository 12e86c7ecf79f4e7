// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/organized_cloud.h>

namespace pcl_attention
{

/** \brief What a frame tells of the sensor that it was taken with. */
struct SensorModel
{
  float focal_length{0.0f}; /**< pixels; 0 where it is not known */
  float depth_noise{0.0f};  /**< a of the depth's standard deviation a z^2, 1/m; 0 where there is none, or it is not known */
  bool smoothed_depth{false}; /**< whether neighbouring depths have most of their noise in common */
};

/** \brief Focal length, noise and smoothness of a cloud. */
PCL_ATTENTION_EXPORTS SensorModel
estimateSensor (const OrganizedCloud& cloud);

/** \brief Focal length in pixels, estimated from the cloud itself by least squares of column = f x/z + c (and rows alike).
  * \return 0 when the cloud has too few valid points to tell */
PCL_ATTENTION_EXPORTS float
estimateFocalLength (const OrganizedCloud& cloud);

/** \brief Standard deviation of the depth as sigma = a z^2, with a estimated from the second differences of the inverse depth.
  * \return a in 1/m; 0 if the cloud is too small or free of noise */
PCL_ATTENTION_EXPORTS float
estimateDepthNoise (const OrganizedCloud& cloud);

/** \brief Whether the noise of pixels next to each other is alike, as with sensors that match windows of two images or smooth their
  * depth: it differs much less between pixels 4 columns apart than between those 16 apart. Of independent noise it differs as much;
  * recordings of a Kinect have .5 to .85 of it, of a RealSense, an Xtion and a stereo camera .20 to .35.
  * \return false if the cloud is too small or free of noise */
PCL_ATTENTION_EXPORTS bool
hasSmoothedDepth (const OrganizedCloud& cloud);

} // namespace pcl_attention
