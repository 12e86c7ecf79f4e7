// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_base.h>
#include <pcl_attention/core/parameters.h>

#include <pcl/console/print.h>
#include <pcl/segmentation/impl/organized_cloud.hpp>

#include <algorithm>
#include <exception>
#include <new>

namespace pcl
{

template <typename PointT>
void
AttentionBase<PointT>::setInputCloud (const PointCloudConstPtr& cloud)
{
  PCLBase<PointT>::setInputCloud (cloud);
  forget ();
}

template <typename PointT>
void
AttentionBase<PointT>::setIndices (const IndicesPtr& indices)
{
  PCLBase<PointT>::setIndices (indices);
  forget ();
}

// PCL's own setters of constant indices do not expect null.
template <typename PointT>
void
AttentionBase<PointT>::setIndices (const IndicesConstPtr& indices)
{
  setIndices (indices ? IndicesPtr (new Indices (*indices)) : IndicesPtr ());
}

template <typename PointT>
void
AttentionBase<PointT>::setIndices (const PointIndicesConstPtr& indices)
{
  setIndices (indices ? IndicesPtr (new Indices (indices->indices)) : IndicesPtr ());
}

template <typename PointT>
void
AttentionBase<PointT>::setIndices (std::size_t row_start, std::size_t col_start, std::size_t nb_rows,
                                   std::size_t nb_cols)
{
  if (!accept ("setIndices", input_ ? "" : "No input cloud: call setInputCloud before a rectangle is set."))
    return;
  PCLBase<PointT>::setIndices (row_start, col_start, nb_rows, nb_cols);
  forget ();
}

template <typename PointT>
void
AttentionBase<PointT>::setInputNormals (const pcl::PointCloud<pcl::Normal>::ConstPtr& normals)
{
  normals_ = normals;
  forget ();
}

template <typename PointT>
void
AttentionBase<PointT>::setSaliency (const pcl::PointCloud<pcl::Intensity>::ConstPtr& saliency)
{
  saliency_ = saliency;
  forget ();
}

template <typename PointT>
void
AttentionBase<PointT>::setAttentionPoints (const std::vector<AttentionPoint>& points)
{
  attention_points_ = points;
  forget ();
}

template <typename PointT>
void
AttentionBase<PointT>::clearAttentionPoints ()
{
  attention_points_.reset ();
  forget ();
}

template <typename PointT>
void
AttentionBase<PointT>::setAttentionPrior (const pcl_attention::AttentionPrior& prior)
{
  prior_ = prior;
  prior_is_new_ = true;
}

template <typename PointT>
void
AttentionBase<PointT>::setPatches (const pcl::PointCloud<pcl::Label>::ConstPtr& patches)
{
  patches_ = patches;
  forget ();
}

template <typename PointT>
std::string
AttentionBase<PointT>::checkInput () const
{
  std::string problem = pcl_attention::validate (parameters_);
  if (problem.empty () && !pcl_attention::HasRgb<PointT>::value &&
      parameters_.attention_points.strategy == pcl_attention::AttentionStrategy::image_winner_take_all)
    problem = "strategy is image_winner_take_all, which looks at colours, but the points have none";
  if (!problem.empty ())
    return ("Bad parameter: " + problem + ".");
  problem = pcl_attention::checkCloud (input_.get ());
  if (problem.empty ())
    problem = pcl_attention::checkIndices (indices_.get (), input_->size ());
  if (problem.empty ())
    problem = pcl_attention::checkNormals (normals_.get (), input_->size ());
  if (problem.empty ())
    problem = pcl_attention::checkSize ("saliency map", saliency_.get (), *input_);
  if (problem.empty ())
    problem = pcl_attention::checkSaliency (saliency_.get ());
  if (problem.empty ())
    problem = pcl_attention::checkSize ("image of patch labels", patches_.get (), *input_);
  if (attention_points_)
    for (auto point = attention_points_->begin (); problem.empty () && point != attention_points_->end (); ++point)
      problem = pcl_attention::checkPoint (*point, *input_);
  return (problem);
}

template <typename PointT>
std::string
AttentionBase<PointT>::checkPrior () const
{
  if (attention_points_)
    return (""); // whose order stands
  const std::string problem =
      pcl_attention::validate (prior_, static_cast<int> (input_->width), static_cast<int> (input_->height),
                               pcl_attention::HasRgb<PointT>::value);
  return (problem.empty () ? "" : "Bad prior: " + problem + ".");
}

template <typename PointT>
void
AttentionBase<PointT>::start ()
{
  pcl_attention::OrganizedCloud flat = pipeline_.releaseCloud ();
  pcl_attention::gather (*input_, indices_.get (), flat, static_cast<int> (threads_));
  const Eigen::Isometry3f pose = pcl_attention::sensorPose (*input_);
  std::optional<pcl_attention::NormalImage> flat_normals;
  if (normals_)
    flat_normals = pcl_attention::gather (*normals_, pose, flat);
  std::optional<pcl_attention::PlanarPatches> flat_patches;
  patch_labels_ = patches_ ? *patches_ : pcl::PointCloud<pcl::Label> ();
  patch_names_.clear ();
  if (patches_)
  {
    flat_patches.emplace ();
    flat_patches->labels = pcl_attention::gather (*patches_, flat);
  }

  pipeline_.start (std::move (flat), pose, parameters_, static_cast<int> (threads_));
  if (flat_normals)
    pipeline_.setNormals (std::move (*flat_normals));
  if (flat_patches)
    pipeline_.setPatches (std::move (*flat_patches));
  if (saliency_)
    pipeline_.setSaliency (pcl_attention::gather (*saliency_));
  if (attention_points_)
  {
    pcl_attention::AttentionPoints points;
    points.points = *attention_points_;
    pipeline_.setAttentionPoints (std::move (points));
  }
}

template <typename PointT>
template <typename Work>
bool
AttentionBase<PointT>::run (const char* method, const Work& work)
{
  try
  {
    std::string problem = started_ ? "" : checkInput ();
    prior_is_new_ = prior_is_new_ || !started_;
    if (problem.empty () && prior_is_new_)
      problem = checkPrior ();
    if (!accept (method, problem))
      return (false);
    if (!started_)
      start ();
    started_ = true;
    if (prior_is_new_ && !attention_points_)
      pipeline_.setPrior (pcl_attention::AttentionPrior (prior_));
    prior_is_new_ = false;
    return (work ());
  }
  catch (const std::bad_alloc&)
  {
    // There may be no memory for a text either.
    forget ();
    PCL_ERROR ("[pcl::%s::%s] Failed: not enough memory.\n", getClassName (), method);
    return (false);
  }
  catch (const std::exception& error)
  {
    forget ();
    return (accept (method, std::string ("Failed: ") + error.what () + "."));
  }
}

template <typename PointT>
template <typename Work>
bool
AttentionBase<PointT>::runForSegment (const char* method, AttentionSegment& segment, const Work& work)
{
  const bool found = run (method, [&] {
    if (!work ())
      return (false);
    restoreLabels (segment);
    return (true);
  });
  if (!found)
    segment = AttentionSegment ();
  return (found);
}

template <typename PointT>
bool
AttentionBase<PointT>::runAt (const char* method, const AttentionPoint& point, AttentionSegment& segment)
{
  return (runForSegment (method, segment, [&] {
    return (accept (method, pcl_attention::checkPoint (point, *input_)) && pipeline_.segmentAt (point, segment));
  }));
}

template <typename PointT>
bool
AttentionBase<PointT>::accept (const char* method, const std::string& problem) const
{
  if (!problem.empty ())
    PCL_ERROR ("[pcl::%s::%s] %s\n", getClassName (), method, problem.c_str ());
  return (problem.empty ());
}

template <typename PointT>
void
AttentionBase<PointT>::restoreLabels (AttentionSegment& segment)
{
  if (patch_labels_.empty ())
    return;
  if (patch_names_.empty ())
  {
    patch_names_.push_back (0);
    for (const pcl_attention::PlanarPatch& patch : pipeline_.patches ().patches)
      patch_names_.push_back (static_cast<int> (pcl_attention::commonLabel (patch_labels_, patch.pixels)));
  }
  for (pcl_attention::GrowthStep& step : segment.steps)
    step.patch = patch_names_[step.patch];
  // The background may have cut a patch of the user's into several.
  std::vector<int> names;
  for (const int patch : segment.patches)
    if (std::find (names.begin (), names.end (), patch_names_[patch]) == names.end ())
      names.push_back (patch_names_[patch]);
  segment.patches = std::move (names);
}

} // namespace pcl

#define PCL_INSTANTIATE_AttentionBase(T) template class pcl::AttentionBase<T>;
