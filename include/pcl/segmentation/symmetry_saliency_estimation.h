// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_base.h>

namespace pcl
{

/** \brief Saliency of an organized cloud by 2.5D reflective symmetry over a pyramid (paper III-A and III-B, eq. 1-9).
 *
 * \code
 * pcl::SymmetrySaliencyEstimation<pcl::PointXYZRGB> estimation;
 * estimation.setInputCloud (cloud);
 * pcl::PointCloud<pcl::Intensity> saliency;
 * estimation.compute (saliency);
 * \endcode */
template <typename PointT> class SymmetrySaliencyEstimation : public AttentionBase<PointT>
{
public:
  using Ptr = shared_ptr<SymmetrySaliencyEstimation<PointT>>;
  using ConstPtr = shared_ptr<const SymmetrySaliencyEstimation<PointT>>;

  SymmetrySaliencyEstimation () = default;

  using AttentionBase<PointT>::setInputNormals;
  using AttentionBase<PointT>::setNormalParameters;
  using AttentionBase<PointT>::getNormalParameters;
  using AttentionBase<PointT>::setNumberOfThreads;

  void
  setParameters (const pcl_attention::SaliencyParameters& parameters)
  {
    settings () = parameters;
  }
  const pcl_attention::SaliencyParameters&
  getParameters () const
  {
    return (this->getSaliencyParameters ());
  }

  /** \brief Radius of the neighbourhood N(p), its centre row and column left out: 1..8 pixels (paper III-A). */
  void
  setWindowRadius (int pixels)
  {
    settings ().window_radius = pixels;
  }
  int
  getWindowRadius () const
  {
    return (getParameters ().window_radius);
  }

  /** \brief Levels of the pyramid: 1..8 (paper III-B, eq. 9). */
  void
  setNumberOfLevels (int levels)
  {
    settings ().levels = levels;
  }
  int
  getNumberOfLevels () const
  {
    return (getParameters ().levels);
  }

  /** \brief Columns of the finest level that counts: 0 (no limit)..16384 pixels. */
  void
  setMaximumColumns (int columns)
  {
    settings ().maximum_columns = columns;
  }
  int
  getMaximumColumns () const
  {
    return (getParameters ().maximum_columns);
  }

  /** \brief Units of the exponentials: 0..1e6 per metre, 1000 being millimetres (paper eq. 3). */
  void
  setDistanceScale (float scale)
  {
    settings ().distance_scale = scale;
  }
  float
  getDistanceScale () const
  {
    return (getParameters ().distance_scale);
  }

  /** \brief Whether only what bulges towards the viewer is symmetric: both halves' normals point away from the plane.
   */
  void
  setConvexityGate (bool gate)
  {
    settings ().convexity_gate = gate;
  }
  bool
  getConvexityGate () const
  {
    return (getParameters ().convexity_gate);
  }

  /** \brief Radius of the box blur of every level map: 0 (off)..15 pixels. */
  void
  setBlurRadius (int pixels)
  {
    settings ().blur_radius = pixels;
  }
  int
  getBlurRadius () const
  {
    return (getParameters ().blur_radius);
  }

  /** \brief Share of a level's maximum under which its values become 0: 0 (off)..1. */
  void
  setLevelThreshold (float share)
  {
    settings ().level_threshold = share;
  }
  float
  getLevelThreshold () const
  {
    return (getParameters ().level_threshold);
  }

  /** \brief Whether every level is divided by its maximum before the sum (paper eq. 9). */
  void
  setNormalizeLevels (bool normalize)
  {
    settings ().normalize_levels = normalize;
  }
  bool
  getNormalizeLevels () const
  {
    return (getParameters ().normalize_levels);
  }

  /** \brief Symmetry under which a value is noise, whatever the maximum: 0 (off)..4. */
  void
  setSaliencyFloor (float symmetry)
  {
    settings ().saliency_floor = symmetry;
  }
  float
  getSaliencyFloor () const
  {
    return (getParameters ().saliency_floor);
  }

  /** \brief Compute the saliency map S (paper eq. 9).
   * \param[out] saliency of the input's size, in [0, 1]; 0 at holes, and everywhere when nothing is symmetric
   * \return false on an error */
  bool compute (pcl::PointCloud<pcl::Intensity>& saliency);

  /** \brief The symmetry s(p) of one level after blur and thresholds, in its own size: 0..4 (paper eq. 2).
   * \param[in] level 1 (finest) to \ref getNumberOfLevels
   * \return empty before \ref compute, and for a level that does not exist, which is an error */
  pcl::PointCloud<pcl::Intensity> getLevelMap (int level) const;

  /** \brief At every point the axis whose plane won at the winning level, 1..3; 0 where S is 0 (paper eq. 2). Empty
   * before \ref compute. */
  pcl::PointCloud<pcl::Label> getWinningPlane () const;

  /** \brief At every point the level that contributes most, 1 being the finest; 0 where S is 0. Empty before \ref
   * compute. */
  pcl::PointCloud<pcl::Label> getWinningLevel () const;

  /** \brief The largest value of the sum before it was normalised to 1; 0 when nothing is symmetric, and before
   * \ref compute. */
  float
  getMaximum () const
  {
    return (this->isStarted () ? pipeline_.saliency ().maximum : 0.0f);
  }

protected:
  using AttentionBase<PointT>::input_;
  using AttentionBase<PointT>::pipeline_;

  const char*
  getClassName () const override
  {
    return ("SymmetrySaliencyEstimation");
  }

private:
  pcl_attention::SaliencyParameters&
  settings ()
  {
    return (this->changeParameters ().saliency);
  }
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/symmetry_saliency_estimation.hpp>
#endif
