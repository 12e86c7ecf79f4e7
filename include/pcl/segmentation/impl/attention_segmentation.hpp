// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_segmentation.h>
#include <pcl/segmentation/impl/organized_cloud.hpp>
#include <pcl_attention/core/parameters.h>

#include <pcl/console/print.h>

#include <algorithm>
#include <exception>
#include <thread>

namespace pcl
{

template <typename PointT> void
AttentionSegmentation<PointT>::setInputCloud (const typename PCLBase<PointT>::PointCloudConstPtr& cloud)
{
  PCLBase<PointT>::setInputCloud (cloud);
  started_ = false;
}

template <typename PointT> void
AttentionSegmentation<PointT>::setInputNormals (const pcl::PointCloud<pcl::Normal>::ConstPtr& normals)
{
  normals_ = normals;
  started_ = false;
}

template <typename PointT> void
AttentionSegmentation<PointT>::setIndices (const IndicesPtr& indices)
{
  PCLBase<PointT>::setIndices (indices);
  started_ = false;
}

template <typename PointT> void
AttentionSegmentation<PointT>::setIndices (const IndicesConstPtr& indices)
{
  PCLBase<PointT>::setIndices (indices);
  started_ = false;
}

template <typename PointT> void
AttentionSegmentation<PointT>::setIndices (const PointIndicesConstPtr& indices)
{
  PCLBase<PointT>::setIndices (indices);
  started_ = false;
}

template <typename PointT> void
AttentionSegmentation<PointT>::setIndices (std::size_t row_start, std::size_t col_start, std::size_t nb_rows,
                                           std::size_t nb_cols)
{
  PCLBase<PointT>::setIndices (row_start, col_start, nb_rows, nb_cols);
  started_ = false;
}

template <typename PointT> void
AttentionSegmentation<PointT>::setParameters (const pcl_attention::AttentionParameters& parameters)
{
  parameters_ = parameters;
  started_ = false;
}

template <typename PointT> bool
AttentionSegmentation<PointT>::start ()
{
  if (started_)
    return (true);
  const char* name = "AttentionSegmentation";
  const std::string problem = pcl_attention::validate (parameters_);
  if (!problem.empty ())
  {
    PCL_ERROR ("[pcl::%s::segment] Bad parameter: %s.\n", name, problem.c_str ());
    return (false);
  }
  pcl_attention::OrganizedCloud flat;
  if (!pcl_attention::checkAndGather<PointT> (name, input_, indices_, normals_.get (), flat))
    return (false);
  const Eigen::Isometry3f pose = pcl_attention::sensorPose (*input_);
  pcl_attention::NormalImage flat_normals;
  if (normals_)
    flat_normals = pcl_attention::gather (*normals_, pose, flat);
  const unsigned int threads = threads_ > 0 ? threads_ : std::max (1u, std::thread::hardware_concurrency ());
  pipeline_.start (std::move (flat), pose, parameters_, static_cast<int> (threads));
  if (normals_)
    pipeline_.setNormals (std::move (flat_normals));
  started_ = true;
  return (true);
}

template <typename PointT> bool
AttentionSegmentation<PointT>::segment (std::vector<AttentionSegment>& segments)
{
  segments.clear ();
  // All of the frame, also when some of it was already given one by one.
  started_ = false;
  AttentionSegment next;
  while (segmentNext (next))
    segments.push_back (std::move (next));
  return (started_);
}

template <typename PointT> bool
AttentionSegmentation<PointT>::segmentNext (AttentionSegment& segment)
{
  segment = AttentionSegment ();
  return (guarded ("segmentNext", [&] { return (start () && pipeline_.next (segment)); }));
}

template <typename PointT> bool
AttentionSegmentation<PointT>::segmentAt (int column, int row, AttentionSegment& segment)
{
  segment = AttentionSegment ();
  return (guarded ("segmentAt", [&] {
    if (!start ())
      return (false);
    if (column < 0 || row < 0 || column >= static_cast<int> (input_->width) || row >= static_cast<int> (input_->height))
    {
      PCL_ERROR ("[pcl::%s::segmentAt] The pixel (%d, %d) lies outside the cloud of %u x %u points.\n",
                 getClassName ().c_str (), column, row, input_->width, input_->height);
      return (false);
    }
    AttentionPoint point;
    point.column = column;
    point.row = row;
    return (pipeline_.segmentAt (point, segment));
  }));
}

template <typename PointT> std::vector<SupportingPlane>
AttentionSegmentation<PointT>::getSupportingPlanes ()
{
  std::vector<SupportingPlane> planes;
  guarded ("getSupportingPlanes", [&] {
    if (!start ())
      return (false);
    planes = pipeline_.supportingPlanes ();
    return (true);
  });
  return (planes);
}

template <typename PointT> template <typename Work> bool
AttentionSegmentation<PointT>::guarded (const char* method, const Work& work)
{
  try
  {
    return (work ());
  }
  catch (const std::exception& error)
  {
    PCL_ERROR ("[pcl::%s::%s] %s.\n", getClassName ().c_str (), method, error.what ());
    started_ = false;
    return (false);
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_AttentionSegmentation(T) template class PCL_ATTENTION_EXPORTS pcl::AttentionSegmentation<T>;
