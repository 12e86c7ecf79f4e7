// SPDX-License-Identifier: BSD-3-Clause
#include "stages.h"

#include "core/symmetry_oracle.h"
#include "measure.h"

#include <pcl_attention/core/pyramid.h>

#include <pcl/segmentation/attention_segmentation.h>
#include <pcl/segmentation/impl/organized_cloud.hpp>

#include <memory>

namespace pcl_attention
{

namespace
{

const AttentionParameters parameters;

/** \brief Register whole frames of a stream, which go through one segmentation so that its memory is used again. */
template <typename Segment> void
measureStream (const std::string& name, const std::vector<Frame>& frames, const AttentionParameters& settings, unsigned int threads,
               const Segment& segment)
{
  const auto segmentation = std::make_shared<pcl::AttentionSegmentation<pcl::PointXYZRGB>> (settings);
  segmentation->setNumberOfThreads (threads);
  measure (name, frames, [segmentation, segment] (const Frame& frame) {
    segmentation->setInputCloud (frame.scene);
    segment (*segmentation);
  });
}

void
segmentAll (pcl::AttentionSegmentation<pcl::PointXYZRGB>& segmentation)
{
  std::vector<AttentionSegment> segments;
  segmentation.segment (segments);
  benchmark::DoNotOptimize (segments);
}

void
segmentFirst (pcl::AttentionSegmentation<pcl::PointXYZRGB>& segmentation)
{
  AttentionSegment segment;
  segmentation.segmentNext (segment);
  benchmark::DoNotOptimize (segment);
}

SaliencyParameters
fromFullSize ()
{
  SaliencyParameters settings = parameters.saliency;
  settings.maximum_columns = 0;
  return (settings);
}

void
transcribeLevels (const Frame& frame)
{
  benchmark::DoNotOptimize (oracle::symmetryMap (frame.cloud, frame.normals, parameters.saliency));
  for (const PyramidLevel& level : coarserLevels (frame.cloud, frame.normals, parameters.saliency.levels - 1, 1))
    benchmark::DoNotOptimize (oracle::symmetryMap (level.cloud, level.normals, parameters.saliency));
}

} // namespace

Frame::Frame (const SceneCloud::ConstPtr& input) : scene (input), cloud (gather (*input, nullptr))
{
  estimateNormals (cloud, parameters.normals, 1, normals);
  coarser = coarserLevels (cloud, normals, supportLevels (cloud.width), 1);
  computeSaliency (cloud, normals, parameters.saliency, 1, saliency);
  extractAttentionPoints (saliency.saliency, cloud.valid, parameters.attention_points, points);
  extractPlanarPatches (cloud, normals, parameters.patches, patches);
}

void
measureStages (const std::vector<Frame>& frames)
{
  measure ("gather", frames, [] (const Frame& frame) {
    benchmark::DoNotOptimize (gather (*frame.scene, nullptr));
  });
  measure ("normals/gated_window", frames, [] (const Frame& frame) {
    NormalImage normals;
    estimateNormals (frame.cloud, parameters.normals, 1, normals);
  });
  measure ("saliency", frames, [] (const Frame& frame) {
    SaliencyMaps saliency;
    computeSaliency (frame.cloud, frame.normals, parameters.saliency, 1, saliency);
  });
  measure ("symmetry/finest_level", frames, [] (const Frame& frame) {
    SymmetryMap map;
    computeSymmetry (frame.cloud, frame.normals, parameters.saliency, 1, map);
  });
  measure ("saliency/from_full_size", frames, [] (const Frame& frame) {
    SaliencyMaps saliency;
    computeSaliency (frame.cloud, frame.normals, fromFullSize (), 1, saliency);
  });
  // The same levels, from the full size, by the tests' transcription of the equations in double precision, without blur and sum; it
  // also estimates its uncertainty.
  measure ("saliency/double_transcription", frames, transcribeLevels);
  measure ("attention_points", frames, [] (const Frame& frame) {
    AttentionPoints points;
    extractAttentionPoints (frame.saliency.saliency, frame.cloud.valid, parameters.attention_points, points);
  });
  measure ("patches", frames, [] (const Frame& frame) {
    PlanarPatches patches;
    extractPlanarPatches (frame.cloud, frame.normals, parameters.patches, patches);
  });
  measure ("patches/pcl_region_growing", frames, [] (const Frame& frame) {
    PatchParameters settings = parameters.patches;
    settings.method = PatchMethod::region_growing;
    PlanarPatches patches;
    extractPlanarPatches (frame.cloud, frame.normals, settings, patches);
  });
  measure ("patch_graph", frames, [] (const Frame& frame) {
    benchmark::DoNotOptimize (buildPatchGraph (frame.cloud, estimateSensor (frame.cloud), frame.normals, frame.patches.labels,
                                               static_cast<int> (frame.patches.patches.size ()),
                                               parameters.patch_graph));
  });
  measure ("supporting_planes", frames, [] (const Frame& frame) {
    benchmark::DoNotOptimize (
        findSupportingPlanes (frame.cloud, estimateSensor (frame.cloud), frame.normals, frame.coarser, parameters.support));
  });
  measureStream ("first_object/one_thread", frames, parameters, 1, segmentFirst);
  measureStream ("first_object/two_threads", frames, parameters, 2, segmentFirst);
  measureStream ("frame/one_thread", frames, parameters, 1, segmentAll);
  measureStream ("frame/two_threads", frames, parameters, 2, segmentAll);
  measureStream ("frame/paper", frames, AttentionParameters::paper (), 1, segmentAll);
}

} // namespace pcl_attention
