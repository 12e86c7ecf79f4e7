// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_segmentation.h>
#include <pcl/segmentation/impl/attention_base.hpp>

namespace pcl
{

template <typename PointT>
bool
AttentionSegmentation<PointT>::segment (std::vector<AttentionSegment>& segments)
{
  segments.clear ();
  // All of the frame, also when some of it was already given one by one.
  this->forget ();
  const bool done = run ("segment", [&] {
    pipeline_.all (segments);
    for (AttentionSegment& found : segments)
      this->restoreLabels (found);
    return (true);
  });
  if (!done)
    segments.clear ();
  return (done);
}

template <typename PointT>
bool
AttentionSegmentation<PointT>::extract (std::vector<pcl::PointIndices>& clusters)
{
  clusters.clear ();
  std::vector<AttentionSegment> segments;
  const bool done = segment (segments) && run ("extract", [&] {
    for (AttentionSegment& object : segments)
    {
      clusters.emplace_back ();
      clusters.back ().header = input_->header;
      clusters.back ().indices = std::move (object.indices);
    }
    return (true);
  });
  if (!done)
    clusters.clear ();
  return (done);
}

template <typename PointT>
bool
AttentionSegmentation<PointT>::segmentNext (AttentionSegment& segment)
{
  return (this->runForSegment ("segmentNext", segment, [&] { return (pipeline_.next (segment)); }));
}

template <typename PointT>
bool
AttentionSegmentation<PointT>::segmentAt (int column, int row, AttentionSegment& segment)
{
  AttentionPoint point;
  point.column = column;
  point.row = row;
  return (this->runAt ("segmentAt", point, segment));
}

template <typename PointT>
std::vector<SupportingPlane>
AttentionSegmentation<PointT>::getSupportingPlanes ()
{
  std::vector<SupportingPlane> planes;
  const bool done = run ("getSupportingPlanes", [&] {
    planes = pipeline_.supportingPlanes ();
    return (true);
  });
  if (!done)
    planes.clear ();
  return (planes);
}

template <typename PointT>
bool
AttentionSegmentation<PointT>::getSupportingPlane (pcl::PointIndices& inliers, pcl::ModelCoefficients& coefficients)
{
  const bool found = run ("getSupportingPlane", [&] {
    const std::vector<SupportingPlane>& planes = pipeline_.supportingPlanes ();
    if (planes.empty () || !planes.front ().supports_objects)
      return (false);
    inliers.header = coefficients.header = input_->header;
    inliers.indices = planes.front ().indices;
    const Eigen::Vector4f& plane = planes.front ().coefficients;
    coefficients.values.assign (plane.data (), plane.data () + 4);
    return (true);
  });
  if (!found)
  {
    inliers = pcl::PointIndices ();
    coefficients = pcl::ModelCoefficients ();
  }
  return (found);
}

} // namespace pcl

#define PCL_INSTANTIATE_AttentionSegmentation(T) template class PCL_ATTENTION_EXPORTS pcl::AttentionSegmentation<T>;
