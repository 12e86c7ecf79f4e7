// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_segmentation.h>

#include <pcl/filters/filter_indices.h>

#include <variant>

namespace pcl
{

/** \brief Keeps what draws attention: the points of the most attended objects, or the salient points.
 *
 * \code
 * pcl::AttentionFilter<pcl::PointXYZRGB> filter;
 * filter.setInputCloud (cloud); // organized
 * filter.setKeepObjects (3);
 * filter.setKeepOrganized (true);
 * filter.filter (*objects);
 * \endcode
 *
 * All of pcl::FilterIndices applies: setNegative, setKeepOrganized, setUserFilterValue, getRemovedIndices. Points that
 * are not finite are removed either way. setIndices masks points: the objects are sought among those, and only those
 * are passed or removed. On an error, which PCL_ERROR reports, no point is passed. */
template <typename PointT> class AttentionFilter : public FilterIndices<PointT>
{
public:
  using Ptr = shared_ptr<AttentionFilter<PointT>>;
  using ConstPtr = shared_ptr<const AttentionFilter<PointT>>;

  /** \param[in] extract_removed_indices whether getRemovedIndices shall have the points that are removed */
  explicit AttentionFilter (bool extract_removed_indices = false) : FilterIndices<PointT> (extract_removed_indices)
  {
    this->filter_name_ = "AttentionFilter";
  }

  /** \brief Keep the most attended objects; the default is one object. The later call of this and
   * \ref setKeepSalient counts.
   * \param[in] count how many at most: 0 or more; fewer where fewer are found. Only these are segmented. */
  void
  setKeepObjects (unsigned int count)
  {
    criterion_ = count;
  }

  /** \brief Keep the points whose saliency exceeds a threshold.
   * \param[in] threshold share of the map's maximum: 0..1 */
  void
  setKeepSalient (float threshold)
  {
    criterion_ = threshold;
  }

  /** \brief The parameters of all stages. Checked when filtering. */
  void
  setParameters (const pcl_attention::AttentionParameters& parameters)
  {
    parameters_ = parameters;
  }
  const pcl_attention::AttentionParameters&
  getParameters () const
  {
    return (parameters_);
  }

  /** \brief Bring normals instead of having them estimated; see \ref AttentionSegmentation. */
  void
  setInputNormals (const pcl::PointCloud<pcl::Normal>::ConstPtr& normals)
  {
    normals_ = normals;
  }

  /** \brief Number of threads; 0 takes all processors. The result does not depend on it. */
  void
  setNumberOfThreads (unsigned int threads = 0)
  {
    threads_ = threads;
  }

  /** \brief The objects that the last call of filter passed, in order of attention; empty with \ref setKeepSalient. */
  const std::vector<AttentionSegment>&
  getObjects () const
  {
    return (objects_);
  }

protected:
  using FilterIndices<PointT>::input_;
  using FilterIndices<PointT>::indices_;
  using FilterIndices<PointT>::fake_indices_;
  using FilterIndices<PointT>::negative_;
  using FilterIndices<PointT>::extract_removed_indices_;
  using FilterIndices<PointT>::removed_indices_;
  using FilterIndices<PointT>::applyFilter;

  void applyFilter (Indices& indices) override;

private:
  /** \brief Mark the points that draw attention with 1.
   * \return false on an error */
  bool markObjects (std::vector<std::uint8_t>& attended);
  bool markSalient (float threshold, std::vector<std::uint8_t>& attended);

  std::variant<unsigned int, float> criterion_{1u}; /**< how many objects, or the threshold of the saliency */
  pcl_attention::AttentionParameters parameters_;
  pcl::PointCloud<pcl::Normal>::ConstPtr normals_;
  unsigned int threads_{1};
  std::vector<AttentionSegment> objects_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/attention_filter.hpp>
#endif
