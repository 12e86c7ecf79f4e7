// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/impl/attention_base.hpp>
#include <pcl/segmentation/symmetry_saliency_estimation.h>

namespace pcl
{

template <typename PointT>
bool
SymmetrySaliencyEstimation<PointT>::compute (pcl::PointCloud<pcl::Intensity>& saliency)
{
  this->forget ();
  const bool done = this->run ("compute", [&] {
    saliency = pcl_attention::scatter<pcl::Intensity> (pipeline_.saliency ().saliency, input_->header,
                                                       &pcl::Intensity::intensity);
    return (true);
  });
  if (!done)
    saliency = pcl::PointCloud<pcl::Intensity> ();
  return (done);
}

template <typename PointT>
pcl::PointCloud<pcl::Intensity>
SymmetrySaliencyEstimation<PointT>::getLevelMap (int level) const
{
  if (!this->isStarted ())
    return {};
  const std::vector<pcl_attention::SymmetryMap>& levels = pipeline_.saliency ().levels;
  if (level < 1 || level > static_cast<int> (levels.size ()))
  {
    this->accept ("getLevelMap", "There is no level " + std::to_string (level) + ": they are 1 to " +
                                     std::to_string (levels.size ()) + ".");
    return {};
  }
  return (
      pcl_attention::scatter<pcl::Intensity> (levels[level - 1].symmetry, input_->header, &pcl::Intensity::intensity));
}

template <typename PointT>
pcl::PointCloud<pcl::Label>
SymmetrySaliencyEstimation<PointT>::getWinningPlane () const
{
  if (!this->isStarted ())
    return {};
  return (pcl_attention::scatter<pcl::Label> (pipeline_.winningSymmetry ().plane, input_->header, &pcl::Label::label));
}

template <typename PointT>
pcl::PointCloud<pcl::Label>
SymmetrySaliencyEstimation<PointT>::getWinningLevel () const
{
  if (!this->isStarted ())
    return {};
  return (pcl_attention::scatter<pcl::Label> (pipeline_.winningSymmetry ().level, input_->header, &pcl::Label::label));
}

} // namespace pcl

#define PCL_INSTANTIATE_SymmetrySaliencyEstimation(T)                                                                  \
  template class PCL_ATTENTION_EXPORTS pcl::SymmetrySaliencyEstimation<T>;
