// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/image_symmetry_saliency_estimation.h>
#include <pcl/segmentation/impl/attention_base.hpp>

namespace pcl
{

template <typename PointT>
bool
ImageSymmetrySaliencyEstimation<PointT>::compute (pcl::PointCloud<pcl::Intensity>& saliency)
{
  this->forget ();
  const bool done =
      this->accept ("compute", pcl_attention::HasRgb<PointT>::value ? "" : "The points have no colour.") &&
      this->run ("compute", [&] {
        saliency = pcl_attention::scatter<pcl::Intensity> (pipeline_.imageSaliency (), input_->header,
                                                           &pcl::Intensity::intensity);
        return (true);
      });
  if (!done)
    saliency = pcl::PointCloud<pcl::Intensity> ();
  return (done);
}

} // namespace pcl

#define PCL_INSTANTIATE_ImageSymmetrySaliencyEstimation(T)                                                             \
  template class PCL_ATTENTION_EXPORTS pcl::ImageSymmetrySaliencyEstimation<T>;
