// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_base.h>

namespace pcl
{

/** \brief Grows objects from attention points over planar patches, as long as they stay compact (paper IV-B, eq.
 * 11-14).
 *
 * Unlike \ref AttentionSegmentation, every attention point gives the segment that grows from it: none is skipped for
 * lying in an earlier one or for its size, and none is added.
 *
 * \code
 * pcl::CompactPatchClustering<pcl::PointXYZRGB> clustering;
 * clustering.setInputCloud (cloud);
 * clustering.setPatches (labels);         // optional, e.g. of pcl::PlanarPatchExtraction
 * clustering.setAttentionPoints (points); // optional, e.g. of pcl::AttentionPointExtraction
 * std::vector<pcl::AttentionSegment> segments;
 * clustering.segment (segments);
 * \endcode */
template <typename PointT> class CompactPatchClustering : public AttentionBase<PointT>
{
public:
  using Ptr = shared_ptr<CompactPatchClustering<PointT>>;
  using ConstPtr = shared_ptr<const CompactPatchClustering<PointT>>;

  CompactPatchClustering () = default;

  using AttentionBase<PointT>::setInputNormals;
  using AttentionBase<PointT>::setPatches;
  using AttentionBase<PointT>::setAttentionPoints;
  using AttentionBase<PointT>::clearAttentionPoints;
  using AttentionBase<PointT>::setNumberOfThreads;

  using AttentionBase<PointT>::setNormalParameters;
  using AttentionBase<PointT>::getNormalParameters;
  using AttentionBase<PointT>::setSaliencyParameters;
  using AttentionBase<PointT>::getSaliencyParameters;
  using AttentionBase<PointT>::setAttentionPointParameters;
  using AttentionBase<PointT>::getAttentionPointParameters;
  using AttentionBase<PointT>::setPatchParameters;
  using AttentionBase<PointT>::getPatchParameters;
  using AttentionBase<PointT>::setPatchGraphParameters;
  using AttentionBase<PointT>::getPatchGraphParameters;
  using AttentionBase<PointT>::setSupportParameters;
  using AttentionBase<PointT>::getSupportParameters;

  /** \brief Set the constraints of the growth (paper IV-B). Checked when segmenting. */
  void
  setParameters (const pcl_attention::ClusteringParameters& parameters)
  {
    this->changeParameters ().clustering = parameters;
  }
  const pcl_attention::ClusteringParameters&
  getParameters () const
  {
    return (this->parameters ().clustering);
  }

  /** \brief Grow a segment from every attention point.
   * \param[out] segments in the order of the points and with ranks 1, 2, ...; points where there is no patch to start
   * with are skipped, with a warning that says how many \return false on an error */
  bool segment (std::vector<AttentionSegment>& segments);

  /** \brief Grow a segment from one attention point. Calls in a row share what they have in common until anything is
   * set. \param[in] point column and row matter, the rest is handed through \param[out] segment its rank is 0 \return
   * false when there is no patch to start with, or on an error */
  bool segment (const AttentionPoint& point, AttentionSegment& segment);

protected:
  using AttentionBase<PointT>::pipeline_;

  const char*
  getClassName () const override
  {
    return ("CompactPatchClustering");
  }
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/compact_patch_clustering.hpp>
#endif
