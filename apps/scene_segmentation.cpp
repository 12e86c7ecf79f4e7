// SPDX-License-Identifier: BSD-3-Clause
#include "scene_segmentation.h"

#include <pcl/segmentation/attention_segmentation.h>
#include <pcl/segmentation/impl/organized_cloud.hpp>

#include <pcl/common/io.h>

#include <stdexcept>

namespace pcl_attention
{

namespace
{

template <typename PointT>
SceneSegments
segmentCloud (const typename pcl::PointCloud<PointT>::ConstPtr& cloud, const std::string& name,
              const AttentionParameters& parameters, unsigned int threads, const NamedPrior& prior)
{
  pcl::AttentionSegmentation<PointT> segmentation (parameters);
  segmentation.setNumberOfThreads (threads);
  segmentation.setInputCloud (cloud);
  SceneSegments result;
  try
  {
    result.prior = priorForScene (prior, static_cast<int> (cloud->width), static_cast<int> (cloud->height),
                                  HasRgb<PointT>::value);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error (name + ": " + error.what ());
  }
  segmentation.setAttentionPrior (result.prior.values);
  if (!segmentation.segment (result.segments))
    throw std::runtime_error (name + ": the segmentation failed");
  AttentionPipeline& pipeline = *segmentation.getPipeline ();
  // What is asked for below may have to be computed just for the report, and is then no part of the segmentation's
  // time.
  result.times = pipeline.times ();
  result.supporting_planes = segmentation.getSupportingPlanes ();
  result.extracted_points = pipeline.attentionPoints ().points.size ();
  result.patches = pipeline.patches ().patches.size ();
  return (result);
}

} // namespace

SceneSegments
segmentScene (const Scene& scene, const AttentionParameters& parameters, unsigned int threads, const NamedPrior& prior)
{
  if (scene.has_color)
    return (segmentCloud<pcl::PointXYZRGB> (scene.cloud, scene.path, parameters, threads, prior));
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);
  pcl::copyPointCloud (*scene.cloud, *cloud);
  return (segmentCloud<pcl::PointXYZ> (cloud, scene.path, parameters, threads, prior));
}

} // namespace pcl_attention
