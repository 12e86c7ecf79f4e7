// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_base.h>

#include <pcl/ModelCoefficients.h>
#include <pcl/common/io.h>
#include <pcl/console/print.h>

#include <new>

namespace pcl
{

/** \brief Finds the objects of an organized RGB-D cloud in order of attention and segments each, after Potapova,
 * Varadarajan, Richtsfeld, Zillich and Vincze, "Attention-driven Object Detection and Segmentation of Cluttered Table
 * Scenes using 2.5D Symmetry", ICRA 2014.
 *
 * \code
 * pcl::AttentionSegmentation<pcl::PointXYZRGB> segmentation;
 * segmentation.setInputCloud (cloud);
 * std::vector<pcl::AttentionSegment> objects;
 * segmentation.segment (objects);
 * \endcode
 *
 * The cloud must be organized; points that are not finite are holes. Points without colour (pcl::PointXYZ) work: the
 * colour constraint is then off. The viewpoint is the cloud's sensor_origin_ and sensor_orientation_ (x right, y down,
 * z forward). setIndices masks points; the results keep indices of the full cloud. Normals, saliency, attention points
 * and patches are computed, each unless the user brings it.
 *
 * Nothing throws: an error is reported by PCL_ERROR, the output is empty and the return value false. */
template <typename PointT> class AttentionSegmentation : public AttentionBase<PointT>
{
public:
  using Ptr = shared_ptr<AttentionSegmentation<PointT>>;
  using ConstPtr = shared_ptr<const AttentionSegmentation<PointT>>;

  /** \param[in] parameters of all stages; the default is the best setting known for every sensor */
  explicit AttentionSegmentation (const pcl_attention::AttentionParameters& parameters = {})
  {
    setParameters (parameters);
  }

  using AttentionBase<PointT>::setInputNormals;
  using AttentionBase<PointT>::setSaliency;
  using AttentionBase<PointT>::setPatches;
  using AttentionBase<PointT>::setAttentionPrior;
  using AttentionBase<PointT>::getAttentionPrior;
  using AttentionBase<PointT>::setNumberOfThreads;

  /** \brief The user's points come first, in the given order; those that lead to an earlier segment are skipped, and
   * patches that none of them claims come after, unless \ref pcl_attention::SegmentationParameters switches that off.
   */
  using AttentionBase<PointT>::setAttentionPoints;
  using AttentionBase<PointT>::clearAttentionPoints;

  /** \brief Set the parameters of all stages. Checked when segmenting. */
  void
  setParameters (const pcl_attention::AttentionParameters& parameters)
  {
    changeParameters () = parameters;
  }

  const pcl_attention::AttentionParameters&
  getParameters () const
  {
    return (this->parameters ());
  }

  /** \brief Segment every object, in order of attention.
   * \param[out] segments one per object
   * \return false on an error; a scene without objects is none */
  bool segment (std::vector<AttentionSegment>& segments);

  /** \brief The same as the points alone, as PCL's own segmenters give them.
   * \param[out] clusters one per object, in order of attention, with the cloud's header
   * \return false on an error */
  bool extract (std::vector<pcl::PointIndices>& clusters);

  /** \brief The same as labels, too.
   * \param[out] labels organized like the cloud, of any point type with a field label: pcl::Label for the labels alone,
   * e.g. pcl::PointXYZRGBL for a copy of the cloud with labels. Label k is that of the first cluster, k - 1, that claims
   * the point; 0 is no object.
   * \param[out] clusters see \ref extract
   * \return false on an error */
  template <typename PointLT>
  bool segment (pcl::PointCloud<PointLT>& labels, std::vector<pcl::PointIndices>& clusters);

  /** \brief Segment the next object in order of attention; the first call after anything was set starts the frame.
   * \return false when there is none left, or on an error */
  bool segmentNext (AttentionSegment& segment);

  /** \brief Segment the object at a pixel of your own choice; does not change what \ref segmentNext gives.
   * \return false when there is no object at the pixel, or on an error */
  bool segmentAt (int column, int row, AttentionSegment& segment);

  /** \brief The supporting plane first, if there is one, then the other planes of the background. Empty on an error. */
  std::vector<SupportingPlane> getSupportingPlanes ();

  /** \brief The plane that the objects stand on, in the form that pcl::SACSegmentation gives a plane.
   * \param[out] inliers its points
   * \param[out] coefficients a, b, c, d of ax + by + cz + d = 0, unit normal towards the viewpoint, metres
   * \return false when there is none, or on an error; the outputs are then empty */
  bool getSupportingPlane (pcl::PointIndices& inliers, pcl::ModelCoefficients& coefficients);

  /** \brief The stages behind the segments: saliency, points, patches, graph and times. Null before a frame is started.
   * Patches are numbered 1, 2, ... there, also the user's own. */
  pcl_attention::AttentionPipeline*
  getPipeline ()
  {
    return (this->isStarted () ? &pipeline_ : nullptr);
  }

protected:
  using AttentionBase<PointT>::input_;
  using AttentionBase<PointT>::pipeline_;
  using AttentionBase<PointT>::changeParameters;
  using AttentionBase<PointT>::run;

  const char*
  getClassName () const override
  {
    return ("AttentionSegmentation");
  }
};

// Here for every type of labels, also where the rest is compiled in the library.
template <typename PointT>
template <typename PointLT>
bool
AttentionSegmentation<PointT>::segment (pcl::PointCloud<PointLT>& labels, std::vector<pcl::PointIndices>& clusters)
{
  labels = pcl::PointCloud<PointLT> ();
  if (!extract (clusters))
    return (false);
  try
  {
    pcl::copyPointCloud (*input_, labels);
  }
  catch (const std::bad_alloc&)
  {
    PCL_ERROR ("[pcl::%s::segment] Failed: not enough memory.\n", getClassName ());
    labels = pcl::PointCloud<PointLT> ();
    clusters.clear ();
    return (false);
  }
  for (PointLT& point : labels)
    point.label = 0;
  for (std::size_t cluster = clusters.size (); cluster > 0; --cluster)
    for (const index_t index : clusters[cluster - 1].indices)
      labels[index].label = static_cast<std::uint32_t> (cluster);
  return (true);
}

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/attention_segmentation.hpp>
#endif
