// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_base.h>

namespace pcl
{

/** \brief Clusters the normals of an organized cloud into planar patches, starting at the lowest curvature (paper
 * IV-A).
 *
 * \code
 * pcl::PlanarPatchExtraction<pcl::PointXYZRGB> extraction;
 * extraction.setInputCloud (cloud);
 * std::vector<pcl::PointIndices> patches;
 * extraction.extract (patches);
 * \endcode */
template <typename PointT> class PlanarPatchExtraction : public AttentionBase<PointT>
{
public:
  using Ptr = shared_ptr<PlanarPatchExtraction<PointT>>;
  using ConstPtr = shared_ptr<const PlanarPatchExtraction<PointT>>;

  PlanarPatchExtraction () = default;

  using AttentionBase<PointT>::setInputNormals;
  using AttentionBase<PointT>::setNormalParameters;
  using AttentionBase<PointT>::getNormalParameters;
  using AttentionBase<PointT>::setPatchGraphParameters;
  using AttentionBase<PointT>::getPatchGraphParameters;
  using AttentionBase<PointT>::setNumberOfThreads;

  /** \brief Set angle, distance and size of the patches. Checked when extracting. */
  void
  setParameters (const pcl_attention::PatchParameters& parameters)
  {
    this->setPatchParameters (parameters);
  }
  const pcl_attention::PatchParameters&
  getParameters () const
  {
    return (this->getPatchParameters ());
  }

  /** \brief Extract the patches.
   * \param[out] patches label k at [k - 1], in the order they were grown: lowest curvature first
   * \return false on an error; a cloud without patches is none */
  bool extract (std::vector<pcl::PointIndices>& patches);

  /** \brief The patches by label, of the input's size; 0 = none. Empty before \ref extract. */
  pcl::PointCloud<pcl::Label> getLabels () const;

  /** \brief The patches with their planes, in the frame of the input cloud; label k at [k - 1]. Empty before \ref
   * extract. */
  std::vector<pcl_attention::PlanarPatch> getPatches () const;

  /** \brief Which patches touch, and whether their borders are connected in 3D, convex or concave. Empty before
   * \ref extract. */
  pcl_attention::PatchGraph getPatchGraph ();

protected:
  using AttentionBase<PointT>::input_;
  using AttentionBase<PointT>::pipeline_;

  const char*
  getClassName () const override
  {
    return ("PlanarPatchExtraction");
  }

private:
  pcl_attention::PlanarPatches patches_; /**< in the sensor frame; of the frame that is started */
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/planar_patch_extraction.hpp>
#endif
