// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_point_extraction.h>
#include <pcl/segmentation/impl/attention_base.hpp>

#include <map>

namespace pcl
{

template <typename PointT>
bool
AttentionPointExtraction<PointT>::extract (std::vector<AttentionPoint>& points)
{
  points.clear ();
  this->forget ();
  const bool needs_map = this->getParameters ().strategy != pcl_attention::AttentionStrategy::image_winner_take_all;
  if (!this->accept ("extract", this->hasSaliency () || !needs_map ? ""
                                                     : "No saliency map: call setSaliency first, with that of "
                                                       "pcl::SymmetrySaliencyEstimation or any other."))
    return (false);
  return (this->run ("extract", [&] {
    points = pipeline_.attentionPoints ().points;
    return (true);
  }));
}

template <typename PointT>
pcl::PointCloud<pcl::Label>
AttentionPointExtraction<PointT>::getComponents () const
{
  if (!this->isStarted ())
    return {};
  return (
      pcl_attention::scatter<pcl::Label> (pipeline_.attentionPoints ().components, input_->header, &pcl::Label::label));
}

template <typename PointT>
std::vector<pcl::PointIndices>
AttentionPointExtraction<PointT>::getSkeletons () const
{
  if (!this->isStarted ())
    return {};
  const pcl_attention::AttentionPoints& result = pipeline_.attentionPoints ();
  std::map<int, pcl::PointIndices> of_component;
  for (std::size_t index = 0; index < result.skeleton.size (); ++index)
    if (result.skeleton[index])
      of_component[result.components[index]].indices.push_back (static_cast<pcl::index_t> (index));
  std::vector<pcl::PointIndices> skeletons;
  for (auto& [component, skeleton] : of_component)
  {
    skeleton.header = input_->header;
    skeletons.push_back (std::move (skeleton));
  }
  return (skeletons);
}

template <typename PointT>
std::vector<float>
AttentionPointExtraction<PointT>::getMeanSaliency () const
{
  if (!this->isStarted ())
    return {};
  return (pipeline_.attentionPoints ().mean_saliency);
}

} // namespace pcl

#define PCL_INSTANTIATE_AttentionPointExtraction(T)                                                                    \
  template class PCL_ATTENTION_EXPORTS pcl::AttentionPointExtraction<T>;
