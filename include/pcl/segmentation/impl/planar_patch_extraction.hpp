// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/segmentation/impl/attention_base.hpp>
#include <pcl/segmentation/planar_patch_extraction.h>

#include <pcl_attention/core/patch_steps.h>

namespace pcl
{

template <typename PointT>
bool
PlanarPatchExtraction<PointT>::extract (std::vector<pcl::PointIndices>& patches)
{
  patches.clear ();
  this->forget ();
  const bool done = this->run ("extract", [&] {
    // Those of the pipeline would already be cut along the planes of the background.
    pcl_attention::extractPlanarPatches (pipeline_.cloud (), pipeline_.normals (), this->getPatchParameters (),
                                         patches_, pipeline_.threads ());
    pcl_attention::cutAtSteps (pipeline_.cloud (), {}, getPatchGraphParameters (), patches_, pipeline_.threads ());
    for (const pcl_attention::PlanarPatch& patch : patches_.patches)
    {
      patches.emplace_back ();
      patches.back ().header = input_->header;
      patches.back ().indices = patch.pixels;
    }
    return (true);
  });
  if (!done)
    patches.clear ();
  return (done);
}

template <typename PointT>
pcl::PointCloud<pcl::Label>
PlanarPatchExtraction<PointT>::getLabels () const
{
  if (!this->isStarted ())
    return {};
  return (pcl_attention::scatter<pcl::Label> (patches_.labels, input_->header, &pcl::Label::label));
}

template <typename PointT>
std::vector<pcl_attention::PlanarPatch>
PlanarPatchExtraction<PointT>::getPatches () const
{
  if (!this->isStarted ())
    return {};
  std::vector<pcl_attention::PlanarPatch> patches = patches_.patches;
  const Eigen::Isometry3f pose = pcl_attention::sensorPose (*input_);
  for (pcl_attention::PlanarPatch& patch : patches)
  {
    patch.centroid = pose * patch.centroid;
    patch.normal = pose.linear () * patch.normal;
  }
  return (patches);
}

template <typename PointT>
pcl_attention::PatchGraph
PlanarPatchExtraction<PointT>::getPatchGraph ()
{
  pcl_attention::PatchGraph graph;
  if (this->isStarted ())
    this->run ("getPatchGraph", [&] {
      graph = pcl_attention::buildPatchGraph (pipeline_.cloud (), pcl_attention::estimateSensor (pipeline_.cloud ()), pipeline_.normals (),
                                              patches_.labels, static_cast<int> (patches_.patches.size ()),
                                              getPatchGraphParameters (), pipeline_.threads ());
      pcl_attention::disconnectSteps (pipeline_.cloud (), patches_, {}, getPatchGraphParameters (), graph);
      return (true);
    });
  return (graph);
}

} // namespace pcl

#define PCL_INSTANTIATE_PlanarPatchExtraction(T) template class PCL_ATTENTION_EXPORTS pcl::PlanarPatchExtraction<T>;
