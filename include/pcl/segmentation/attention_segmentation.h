// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_segment.h>

#include <pcl/PointIndices.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>

namespace pcl
{

/** \brief Finds the objects of an organized RGB-D cloud in order of attention and segments each, after Potapova, Varadarajan,
  * Richtsfeld, Zillich and Vincze, "Attention-driven Object Detection and Segmentation of Cluttered Table Scenes using 2.5D
  * Symmetry", ICRA 2014.
  *
  * \code
  * pcl::AttentionSegmentation<pcl::PointXYZRGB> segmentation;
  * segmentation.setInputCloud (cloud);
  * std::vector<pcl::AttentionSegment> objects;
  * segmentation.segment (objects);
  * \endcode
  *
  * The cloud must be organized; points that are not finite are holes. Points without colour (pcl::PointXYZ) work: the colour
  * constraint is then off. The viewpoint is the cloud's sensor_origin_ and sensor_orientation_ (x right, y down, z forward).
  * setIndices masks points; the results keep indices of the full cloud.
  *
  * Nothing throws: an error is reported by PCL_ERROR, the output is empty and the return value false. */
template <typename PointT>
class AttentionSegmentation : public PCLBase<PointT>
{
public:
  using PointCloud = pcl::PointCloud<PointT>;
  using Ptr = shared_ptr<AttentionSegmentation<PointT>>;
  using ConstPtr = shared_ptr<const AttentionSegmentation<PointT>>;

  /** \param[in] parameters of all stages; the default is the best setting known for every sensor */
  explicit AttentionSegmentation (const pcl_attention::AttentionParameters& parameters = {}) : parameters_ (parameters) {}

  /** \brief Set the cloud. Results of an earlier one are forgotten. */
  void
  setInputCloud (const typename PCLBase<PointT>::PointCloudConstPtr& cloud) override;

  /** \brief Bring normals instead of having them estimated: one per point, unit length, NaN where not known; they are
    * turned towards the viewpoint. Null goes back to estimating. */
  void
  setInputNormals (const pcl::PointCloud<pcl::Normal>::ConstPtr& normals);

  using PCLBase<PointT>::setIndices;

  void
  setIndices (const IndicesPtr& indices) override;
  void
  setIndices (const IndicesConstPtr& indices) override;
  void
  setIndices (const PointIndicesConstPtr& indices) override;
  void
  setIndices (std::size_t row_start, std::size_t col_start, std::size_t nb_rows, std::size_t nb_cols) override;

  /** \brief Set the parameters of all stages. Checked when segmenting. */
  void
  setParameters (const pcl_attention::AttentionParameters& parameters);

  const pcl_attention::AttentionParameters&
  getParameters () const { return (parameters_); }

  /** \brief Number of threads; 0 takes all processors. The result does not depend on it. */
  void
  setNumberOfThreads (unsigned int threads = 0) { threads_ = threads; }

  /** \brief Segment every object, in order of attention.
    * \param[out] segments one per object
    * \return false on an error; a scene without objects is none */
  bool
  segment (std::vector<AttentionSegment>& segments);

  /** \brief Segment the next object in order of attention; the first call after setInputCloud starts the frame.
    * \return false when there is none left, or on an error */
  bool
  segmentNext (AttentionSegment& segment);

  /** \brief Segment the object at a pixel of your own choice; does not change what \ref segmentNext gives.
    * \return false when there is no object at the pixel, or on an error */
  bool
  segmentAt (int column, int row, AttentionSegment& segment);

  /** \brief The supporting plane first, if there is one, then the other planes of the background. Empty on an error. */
  std::vector<SupportingPlane>
  getSupportingPlanes ();

  /** \brief The stages behind the segments: saliency, points, patches, graph and times. Null before a frame is started. */
  pcl_attention::AttentionPipeline*
  getPipeline () { return (started_ ? &pipeline_ : nullptr); }

protected:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
  using PCLBase<PointT>::initCompute;
  using PCLBase<PointT>::deinitCompute;

  std::string
  getClassName () const { return ("AttentionSegmentation"); }

private:
  /** \brief Check the input and start the pipeline, unless this frame is already under way. */
  bool
  start ();

  /** \brief Run work and turn an exception, as of a failed allocation, into an error and false. */
  template <typename Work> bool
  guarded (const char* method, const Work& work);

  pcl_attention::AttentionParameters parameters_;
  pcl::PointCloud<pcl::Normal>::ConstPtr normals_;
  unsigned int threads_{1};
  bool started_{false};
  pcl_attention::AttentionPipeline pipeline_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/attention_segmentation.hpp>
#endif
