// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_base.h>

namespace pcl
{

/** \brief Where to look: attention points of a saliency map (paper III-C, eq. 10).
 *
 * Salient pixels are joined to 8-connected components, those salient enough on the whole (theta_sal) are thinned to
 * skeletons, and the skeletons' junctions are the points, or their mid-points where there are no junctions: the strategy
 * TJ3D of paper V-A. The other strategies there are choices too: winners of a winner-take-all network on the map (WTA3D)
 * or on the symmetry saliency of the colours (WTA2D, see \ref ImageSymmetrySaliencyEstimation). The map may come from
 * \ref SymmetrySaliencyEstimation or from anywhere else.
 *
 * \code
 * pcl::AttentionPointExtraction<pcl::PointXYZRGB> extraction;
 * extraction.setInputCloud (cloud);
 * extraction.setSaliency (saliency);
 * std::vector<pcl::AttentionPoint> points;
 * extraction.extract (points);
 * \endcode */
template <typename PointT> class AttentionPointExtraction : public AttentionBase<PointT>
{
public:
  using Ptr = shared_ptr<AttentionPointExtraction<PointT>>;
  using ConstPtr = shared_ptr<const AttentionPointExtraction<PointT>>;

  AttentionPointExtraction () = default;

  /** \brief The map, which this class cannot do without, unless the strategy looks at the colours alone. */
  using AttentionBase<PointT>::setSaliency;

  using AttentionBase<PointT>::setAttentionPrior;
  using AttentionBase<PointT>::getAttentionPrior;

  void
  setParameters (const pcl_attention::AttentionPointParameters& parameters)
  {
    settings () = parameters;
  }
  const pcl_attention::AttentionPointParameters&
  getParameters () const
  {
    return (this->getAttentionPointParameters ());
  }

  /** \brief How the points are chosen (paper III-C and V-A). */
  void
  setStrategy (pcl_attention::AttentionStrategy strategy)
  {
    settings ().strategy = strategy;
  }
  pcl_attention::AttentionStrategy
  getStrategy () const
  {
    return (getParameters ().strategy);
  }

  /** \brief The map's square that a neuron of the winner-take-all network sees: 1..64 pixels (paper V-A). */
  void
  setWinnerCellSize (int pixels)
  {
    settings ().winner_cell_size = pixels;
  }
  int
  getWinnerCellSize () const
  {
    return (getParameters ().winner_cell_size);
  }

  /** \brief Standard deviation of the inhibition of return around a winner: 0.1..10 cells (paper V-A). */
  void
  setInhibitionWidth (float cells)
  {
    settings ().inhibition_width = cells;
  }
  float
  getInhibitionWidth () const
  {
    return (getParameters ().inhibition_width);
  }

  /** \brief Share of the map's maximum that a pixel must exceed to be part of a component: 0 ("bigger than zero", paper
   * III-C)..1. */
  void
  setPixelThreshold (float share)
  {
    settings ().pixel_threshold = share;
  }
  float
  getPixelThreshold () const
  {
    return (getParameters ().pixel_threshold);
  }

  /** \brief theta_sal: share of the map's maximum that a component's mean (paper eq. 10) must exceed: 0..1. */
  void
  setComponentThreshold (float share)
  {
    settings ().component_threshold = share;
  }
  float
  getComponentThreshold () const
  {
    return (getParameters ().component_threshold);
  }

  /** \brief Whether every junction of a component is a point, or only the most salient one. */
  void
  setAllJunctions (bool all)
  {
    settings ().all_junctions = all;
  }
  bool
  getAllJunctions () const
  {
    return (getParameters ().all_junctions);
  }

  /** \brief Junctions nearer than this are one: 0..100 pixels. */
  void
  setJunctionMergeRadius (float pixels)
  {
    settings ().junction_merge_radius = pixels;
  }
  float
  getJunctionMergeRadius () const
  {
    return (getParameters ().junction_merge_radius);
  }

  /** \brief Shorter skeletons give no point: 1..10000 pixels. */
  void
  setMinimumSkeletonLength (int pixels)
  {
    settings ().minimum_skeleton_length = pixels;
  }
  int
  getMinimumSkeletonLength () const
  {
    return (getParameters ().minimum_skeleton_length);
  }

  /** \brief Extract the attention points.
   * \param[out] points in order of attention, each on a point of the cloud that is finite and not masked
   * \return false on an error; a map without salient points is none */
  bool extract (std::vector<AttentionPoint>& points);

  /** \brief The components by number, that of \ref pcl_attention::AttentionPoint::component; 0 = none. Those under
   * theta_sal are included. Empty before \ref extract. */
  pcl::PointCloud<pcl::Label> getComponents () const;

  /** \brief The skeletons in ascending order of their components, one for each component that has one: its number is
   * that of any of the skeleton's pixels in \ref getComponents. Empty before \ref extract. */
  std::vector<pcl::PointIndices> getSkeletons () const;

  /** \brief Mean saliency of component k at [k - 1], in the map's units (paper eq. 10). Empty before \ref extract. */
  std::vector<float> getMeanSaliency () const;

protected:
  using AttentionBase<PointT>::input_;
  using AttentionBase<PointT>::pipeline_;

  const char*
  getClassName () const override
  {
    return ("AttentionPointExtraction");
  }

private:
  pcl_attention::AttentionPointParameters&
  settings ()
  {
    return (this->changeParameters ().attention_points);
  }
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/attention_point_extraction.hpp>
#endif
