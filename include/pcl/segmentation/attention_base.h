// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_segment.h>

#include <pcl/PointIndices.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl
{

/** \brief What goes into the classes of this module, with the checks of all of it: the cloud, its mask and viewpoint,
 * the user's own results of earlier stages, parameters and threads. What comes out is up to the derived classes; each
 * makes those of the protected setters public that it has a use for.
 *
 * The cloud must be organized; points that are not finite, or that lie in or behind the viewpoint, are holes. The
 * viewpoint is the cloud's sensor_origin_ and sensor_orientation_ (x right, y down, z forward). setIndices masks
 * points; results keep the size and the indices of the full cloud.
 *
 * Every setter forgets the results of the frame before; what the user has set stays until it is set again. Nothing
 * throws: an error is reported by PCL_ERROR with what to do, the output is empty and the return value false. */
template <typename PointT> class AttentionBase : public PCLBase<PointT>
{
public:
  using PointCloud = pcl::PointCloud<PointT>;
  using PointCloudConstPtr = typename PCLBase<PointT>::PointCloudConstPtr;

  /** \brief Set the cloud: organized, metres. */
  void setInputCloud (const PointCloudConstPtr& cloud) override;

  /** \brief Mask the cloud: points that are not listed count as holes. Null takes all points. */
  void setIndices (const IndicesPtr& indices) override;
  void setIndices (const IndicesConstPtr& indices) override;
  void setIndices (const PointIndicesConstPtr& indices) override;

  /** \brief Mask the cloud with a rectangle, after \ref setInputCloud. */
  void setIndices (std::size_t row_start, std::size_t col_start, std::size_t nb_rows, std::size_t nb_cols) override;

protected:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

  AttentionBase () = default;

  // The stages of a frame refer to each other.
  AttentionBase (const AttentionBase&) = delete;
  AttentionBase& operator= (const AttentionBase&) = delete;

  virtual const char* getClassName () const = 0;

  /** \brief Bring normals instead of having them estimated: one per point, of any length, NaN where not known; they are
   * turned towards the viewpoint. Null goes back to estimating. */
  void setInputNormals (const pcl::PointCloud<pcl::Normal>::ConstPtr& normals);

  /** \brief Bring a saliency map: of the cloud's size, from 0 up in any unit, NaN where not known, which counts as 0.
   * Null goes back to the one of 2.5D symmetry (paper III-B). */
  void setSaliency (const pcl::PointCloud<pcl::Intensity>::ConstPtr& saliency);

  /** \brief Bring attention points, in order of attention: inside the image, their saliency finite. None at all is an
   * answer too; \ref clearAttentionPoints goes back to extracting them from the saliency map (paper III-C). */
  void setAttentionPoints (const std::vector<AttentionPoint>& points);
  void clearAttentionPoints ();

  /** \brief Ask for something: what matches comes first. It only re-orders, nothing is hidden. An empty prior asks for
   * nothing in particular. On the same frame only the attention points are made again; those of the user's own keep
   * their order whatever is asked for. */
  void setAttentionPrior (const pcl_attention::AttentionPrior& prior);

  const pcl_attention::AttentionPrior&
  getAttentionPrior () const
  {
    return (prior_);
  }

  /** \brief Bring patches: a label per point, of the cloud's size; 0 is no patch, every other value is a patch of its
   * own. Null goes back to extracting them (paper IV-A). As those, they are cut along the planes of the background
   * unless \ref pcl_attention::ClusteringParameters::stay_off_support is off. Segments name patches by these labels;
   * they are int there, to be converted back to std::uint32_t where labels exceed it. */
  void setPatches (const pcl::PointCloud<pcl::Label>::ConstPtr& patches);

  /** \brief Number of threads, from the next frame on; 0 takes all processors. The result does not depend on it. */
  void
  setNumberOfThreads (unsigned int threads = 0)
  {
    threads_ = threads;
  }

  /** \brief Settings of the normals where the user brings none (paper III-A). */
  void
  setNormalParameters (const pcl_attention::NormalParameters& parameters)
  {
    changeParameters ().normals = parameters;
  }
  const pcl_attention::NormalParameters&
  getNormalParameters () const
  {
    return (parameters_.normals);
  }

  /** \brief Settings of the saliency map where the user brings none (paper III-A and III-B). */
  void
  setSaliencyParameters (const pcl_attention::SaliencyParameters& parameters)
  {
    changeParameters ().saliency = parameters;
  }
  const pcl_attention::SaliencyParameters&
  getSaliencyParameters () const
  {
    return (parameters_.saliency);
  }

  /** \brief Settings of the attention points where the user brings none (paper III-C). */
  void
  setAttentionPointParameters (const pcl_attention::AttentionPointParameters& parameters)
  {
    changeParameters ().attention_points = parameters;
  }
  const pcl_attention::AttentionPointParameters&
  getAttentionPointParameters () const
  {
    return (parameters_.attention_points);
  }

  /** \brief Settings of the patches where the user brings none (paper IV-A). */
  void
  setPatchParameters (const pcl_attention::PatchParameters& parameters)
  {
    changeParameters ().patches = parameters;
  }
  const pcl_attention::PatchParameters&
  getPatchParameters () const
  {
    return (parameters_.patches);
  }

  /** \brief Settings of the borders between patches. */
  void
  setPatchGraphParameters (const pcl_attention::PatchGraphParameters& parameters)
  {
    changeParameters ().patch_graph = parameters;
  }
  const pcl_attention::PatchGraphParameters&
  getPatchGraphParameters () const
  {
    return (parameters_.patch_graph);
  }

  /** \brief Settings of the supporting planes. */
  void
  setSupportParameters (const pcl_attention::SupportParameters& parameters)
  {
    changeParameters ().support = parameters;
  }
  const pcl_attention::SupportParameters&
  getSupportParameters () const
  {
    return (parameters_.support);
  }

  /** \brief The parameters of all stages, to be changed: the results made with the old ones are forgotten. They are
   * checked when computing. */
  pcl_attention::AttentionParameters&
  changeParameters ()
  {
    forget ();
    return (parameters_);
  }

  const pcl_attention::AttentionParameters&
  parameters () const
  {
    return (parameters_);
  }

  bool
  hasSaliency () const
  {
    return (saliency_ != nullptr);
  }

  /** \brief Do the work on the frame, started before if need be.
   * \param[in] method for messages
   * \param[in] work returns bool; an exception of it, as of a failed allocation, becomes an error
   * \return false on an error, else what work returned */
  template <typename Work> bool run (const char* method, const Work& work);

  /** \brief The same for work that gives one segment; its patches are then named by the user's labels.
   * \param[out] segment empty when the result is false */
  template <typename Work> bool runForSegment (const char* method, AttentionSegment& segment, const Work& work);

  /** \brief Segment the object at one point. */
  bool runAt (const char* method, const AttentionPoint& point, AttentionSegment& segment);

  /** \brief Report a problem, unless the text is empty.
   * \return true when there is none */
  bool accept (const char* method, const std::string& problem) const;

  /** \brief Forget all results, so that the next \ref run starts afresh. */
  void
  forget ()
  {
    started_ = false;
  }

  /** \brief Whether there are results: the frame was started, and nothing has been set since. */
  bool
  isStarted () const
  {
    return (started_);
  }

  /** \brief Name the patches of a segment by the labels that the user gave them. */
  void restoreLabels (AttentionSegment& segment);

  /** \brief The stages. A getter may be the first to ask for a result. */
  mutable pcl_attention::AttentionPipeline pipeline_;

private:
  std::string checkInput () const;
  std::string checkPrior () const;

  void start ();

  pcl_attention::AttentionParameters parameters_;
  unsigned int threads_{1};
  pcl::PointCloud<pcl::Normal>::ConstPtr normals_;
  pcl::PointCloud<pcl::Intensity>::ConstPtr saliency_;
  pcl::PointCloud<pcl::Label>::ConstPtr patches_;
  std::optional<std::vector<AttentionPoint>> attention_points_;
  pcl_attention::AttentionPrior prior_;
  bool prior_is_new_{false}; /**< the pipeline does not know it yet */
  pcl::PointCloud<pcl::Label> patch_labels_; /**< the user's, as they were when the frame was started */
  std::vector<int> patch_names_;             /**< the user's label of patch k at [k]; empty until asked for */
  bool started_{false};
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/attention_base.hpp>
#endif
