// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/attention_filter.h>
#include <pcl/segmentation/impl/attention_segmentation.hpp>
#include <pcl/segmentation/impl/symmetry_saliency_estimation.hpp>

#include <pcl/common/point_tests.h>
#include <pcl/filters/impl/filter_indices.hpp>

#include <numeric>

namespace pcl
{

template <typename PointT>
void
AttentionFilter<PointT>::applyFilter (Indices& indices)
{
  indices.clear ();
  removed_indices_->clear ();
  objects_.clear ();
  std::vector<std::uint8_t> attended (input_->size (), 0);
  const float* threshold = std::get_if<float> (&criterion_);
  const bool done = threshold ? markSalient (*threshold, attended) : markObjects (attended);
  if (!done && extract_removed_indices_)
  {
    // All of the cloud, so that none of an organized output is left either.
    removed_indices_->resize (input_->size ());
    std::iota (removed_indices_->begin (), removed_indices_->end (), 0);
  }
  if (!done)
    return;
  for (const index_t index : *indices_)
  {
    if (isFinite ((*input_)[index]) && (attended[index] != 0) != negative_)
      indices.push_back (index);
    else if (extract_removed_indices_)
      removed_indices_->push_back (index);
  }
}

template <typename PointT>
bool
AttentionFilter<PointT>::markObjects (std::vector<std::uint8_t>& attended)
{
  AttentionSegmentation<PointT> segmentation (parameters_);
  segmentation.setInputCloud (input_);
  segmentation.setIndices (fake_indices_ ? IndicesPtr () : indices_);
  segmentation.setInputNormals (normals_);
  segmentation.setNumberOfThreads (threads_);
  const unsigned int count = std::get<unsigned int> (criterion_);
  AttentionSegment object;
  while (objects_.size () < count && segmentation.segmentNext (object))
  {
    for (const index_t index : object.indices)
      attended[index] = 1;
    objects_.push_back (std::move (object));
  }
  // Without an error the frame was started, unless no object was asked for.
  return (count == 0 || segmentation.getPipeline ());
}

template <typename PointT>
bool
AttentionFilter<PointT>::markSalient (float threshold, std::vector<std::uint8_t>& attended)
{
  if (!(threshold >= 0.0f && threshold <= 1.0f))
  {
    PCL_ERROR ("[pcl::AttentionFilter::filter] The threshold of the saliency is %g, but must be from 0 to 1.\n",
               static_cast<double> (threshold));
    return (false);
  }
  SymmetrySaliencyEstimation<PointT> estimation;
  estimation.setInputCloud (input_);
  estimation.setIndices (fake_indices_ ? IndicesPtr () : indices_);
  estimation.setInputNormals (normals_);
  estimation.setNormalParameters (parameters_.normals);
  estimation.setParameters (parameters_.saliency);
  estimation.setNumberOfThreads (threads_);
  pcl::PointCloud<pcl::Intensity> saliency;
  if (!estimation.compute (saliency))
    return (false);
  for (std::size_t index = 0; index < saliency.size (); ++index)
    attended[index] = saliency[index].intensity > threshold;
  return (true);
}

} // namespace pcl

#define PCL_INSTANTIATE_AttentionFilter(T) template class PCL_ATTENTION_EXPORTS pcl::AttentionFilter<T>;
