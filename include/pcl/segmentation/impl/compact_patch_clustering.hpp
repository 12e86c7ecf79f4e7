// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/compact_patch_clustering.h>
#include <pcl/segmentation/impl/attention_base.hpp>

namespace pcl
{

template <typename PointT>
bool
CompactPatchClustering<PointT>::segment (std::vector<AttentionSegment>& segments)
{
  segments.clear ();
  this->forget ();
  std::size_t skipped = 0;
  const bool done = this->run ("segment", [&] {
    for (const AttentionPoint& point : pipeline_.attentionPoints ().points)
    {
      AttentionSegment grown;
      if (!pipeline_.segmentAt (point, grown))
      {
        ++skipped;
        continue;
      }
      grown.rank = static_cast<int> (segments.size ()) + 1;
      this->restoreLabels (grown);
      segments.push_back (std::move (grown));
    }
    return (true);
  });
  if (!done)
    segments.clear ();
  else if (skipped > 0)
    PCL_WARN ("[pcl::%s::segment] %zu of %zu attention points skipped: no patch to start with lies near them.\n",
              getClassName (), skipped, skipped + segments.size ());
  return (done);
}

template <typename PointT>
bool
CompactPatchClustering<PointT>::segment (const AttentionPoint& point, AttentionSegment& segment)
{
  return (this->runAt ("segment", point, segment));
}

} // namespace pcl

#define PCL_INSTANTIATE_CompactPatchClustering(T) template class PCL_ATTENTION_EXPORTS pcl::CompactPatchClustering<T>;
