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
    AttentionSegment next;
    while (pipeline_.next (next))
    {
      this->restoreLabels (next);
      segments.push_back (std::move (next));
    }
    return (true);
  });
  if (!done)
    segments.clear ();
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
  run ("getSupportingPlanes", [&] {
    planes = pipeline_.supportingPlanes ();
    return (true);
  });
  return (planes);
}

} // namespace pcl

#define PCL_INSTANTIATE_AttentionSegmentation(T) template class PCL_ATTENTION_EXPORTS pcl::AttentionSegmentation<T>;
