// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_base.h>

namespace pcl
{

/** \brief Saliency of a cloud's colours alone, by the symmetry of the image's gradients (Kootstra, Nederveen and de Boer
 * 2008): what paper V-A compares the 2.5D symmetry with, as WTA2D.
 *
 * \code
 * pcl::ImageSymmetrySaliencyEstimation<pcl::PointXYZRGB> estimation;
 * estimation.setInputCloud (cloud);
 * pcl::PointCloud<pcl::Intensity> saliency;
 * estimation.compute (saliency);
 * \endcode */
template <typename PointT> class ImageSymmetrySaliencyEstimation : public AttentionBase<PointT>
{
public:
  using Ptr = shared_ptr<ImageSymmetrySaliencyEstimation<PointT>>;
  using ConstPtr = shared_ptr<const ImageSymmetrySaliencyEstimation<PointT>>;

  ImageSymmetrySaliencyEstimation () = default;

  using AttentionBase<PointT>::setNumberOfThreads;

  void
  setParameters (const pcl_attention::ImageSymmetryParameters& parameters)
  {
    this->changeParameters ().image_symmetry = parameters;
  }
  const pcl_attention::ImageSymmetryParameters&
  getParameters () const
  {
    return (this->parameters ().image_symmetry);
  }

  /** \brief Compute the saliency map.
   * \param[out] saliency of the input's size, in [0, 1]; everywhere 0 when nothing is symmetric
   * \return false on an error, such as a cloud without colours */
  bool compute (pcl::PointCloud<pcl::Intensity>& saliency);

protected:
  using AttentionBase<PointT>::input_;
  using AttentionBase<PointT>::pipeline_;

  const char*
  getClassName () const override
  {
    return ("ImageSymmetrySaliencyEstimation");
  }
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/image_symmetry_saliency_estimation.hpp>
#endif
