// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clouds.h"
#include <pcl/segmentation/attention_point_extraction.h>
#include <pcl/segmentation/attention_segmentation.h>
#include <pcl/segmentation/compact_patch_clustering.h>
#include <pcl/segmentation/planar_patch_extraction.h>
#include <pcl/segmentation/symmetry_saliency_estimation.h>

// The five classes behind one interface, for what must hold of each of them.

/** \brief What any of the classes found: groups of points, and numbers that go with them. */
struct Outcome
{
  std::vector<pcl::Indices> groups;
  std::vector<float> numbers;

  bool
  operator== (const Outcome& other) const
  {
    return (groups == other.groups && numbers == other.numbers);
  }

  bool
  isEmpty () const
  {
    return (groups.empty () && numbers.empty ());
  }

  void
  add (const std::vector<pcl::AttentionSegment>& segments)
  {
    for (const pcl::AttentionSegment& segment : segments)
    {
      groups.push_back (segment.indices);
      numbers.insert (numbers.end (), segment.plane.data (), segment.plane.data () + 4);
      numbers.insert (numbers.end (), segment.box.center.data (), segment.box.center.data () + 3);
      numbers.insert (numbers.end (), segment.box.size.data (), segment.box.size.data () + 3);
      numbers.push_back (segment.compactness);
    }
  }
};

// Each run starts with an output that is not empty, to see that it is cleared.

template <typename PointType> struct SaliencyStage
{
  using Class = pcl::SymmetrySaliencyEstimation<PointType>;
  static constexpr const char* where = "[pcl::SymmetrySaliencyEstimation::compute] ";
  static constexpr const char* bad_parameter = "window_radius is 99";

  static void
  prepare (Class&, const pcl::PointCloud<PointType>&)
  {
  }

  static void
  spoil (Class& estimation)
  {
    estimation.setWindowRadius (99);
  }

  static bool
  run (Class& estimation, Outcome& outcome)
  {
    pcl::PointCloud<pcl::Intensity> saliency (3, 1);
    const bool done = estimation.compute (saliency);
    outcome = Outcome ();
    pcl::Indices salient;
    for (std::size_t index = 0; index < saliency.size (); ++index)
      if (saliency[index].intensity != 0.0f)
      {
        salient.push_back (static_cast<pcl::index_t> (index));
        outcome.numbers.push_back (saliency[index].intensity);
      }
    if (!salient.empty ())
      outcome.groups.push_back (salient);
    EXPECT_TRUE (done || saliency.empty ());
    return (done);
  }
};

template <typename PointType> struct PointStage
{
  using Class = pcl::AttentionPointExtraction<PointType>;
  static constexpr const char* where = "[pcl::AttentionPointExtraction::extract] ";
  static constexpr const char* bad_parameter = "pixel_threshold is -1";

  static void
  prepare (Class& extraction, const pcl::PointCloud<PointType>& cloud)
  {
    extraction.setSaliency (crossMap (cloud.width, cloud.height, static_cast<int> (cloud.width) / 2 - 5,
                                      static_cast<int> (cloud.height) / 2 + 3));
  }

  static void
  spoil (Class& extraction)
  {
    extraction.setPixelThreshold (-1.0f);
  }

  static bool
  run (Class& extraction, Outcome& outcome)
  {
    std::vector<pcl::AttentionPoint> points (3);
    const bool done = extraction.extract (points);
    outcome = Outcome ();
    for (const pcl::AttentionPoint& point : points)
    {
      outcome.groups.push_back (
          {static_cast<pcl::index_t> (point.row * extraction.getInputCloud ()->width + point.column)});
      outcome.numbers.push_back (point.saliency);
    }
    return (done);
  }
};

template <typename PointType> struct PatchStage
{
  using Class = pcl::PlanarPatchExtraction<PointType>;
  static constexpr const char* where = "[pcl::PlanarPatchExtraction::extract] ";
  static constexpr const char* bad_parameter = "patch_minimum_size is 0";

  static void
  prepare (Class&, const pcl::PointCloud<PointType>&)
  {
  }

  static void
  spoil (Class& extraction)
  {
    pcl_attention::PatchParameters parameters;
    parameters.minimum_size = 0;
    extraction.setParameters (parameters);
  }

  static bool
  run (Class& extraction, Outcome& outcome)
  {
    std::vector<pcl::PointIndices> patches (3);
    const bool done = extraction.extract (patches);
    outcome = Outcome ();
    for (const pcl::PointIndices& patch : patches)
      outcome.groups.push_back (patch.indices);
    for (const pcl_attention::PlanarPatch& patch : extraction.getPatches ())
      outcome.numbers.push_back (patch.rms);
    return (done);
  }
};

template <typename PointType> struct ClusteringStage
{
  using Class = pcl::CompactPatchClustering<PointType>;
  static constexpr const char* where = "[pcl::CompactPatchClustering::segment] ";
  static constexpr const char* bad_parameter = "compactness_threshold is -1";

  static void
  prepare (Class&, const pcl::PointCloud<PointType>&)
  {
  }

  static void
  spoil (Class& clustering)
  {
    pcl_attention::ClusteringParameters parameters;
    parameters.compactness_threshold = -1.0f;
    clustering.setParameters (parameters);
  }

  static bool
  run (Class& clustering, Outcome& outcome)
  {
    std::vector<pcl::AttentionSegment> segments (3);
    const bool done = clustering.segment (segments);
    outcome = Outcome ();
    outcome.add (segments);
    return (done);
  }
};

template <typename PointType> struct FacadeStage
{
  using Class = pcl::AttentionSegmentation<PointType>;
  static constexpr const char* where = "[pcl::AttentionSegmentation::segment] ";
  static constexpr const char* bad_parameter = "levels is 0";

  static void
  prepare (Class&, const pcl::PointCloud<PointType>&)
  {
  }

  static void
  spoil (Class& segmentation)
  {
    pcl_attention::AttentionParameters parameters;
    parameters.saliency.levels = 0;
    segmentation.setParameters (parameters);
  }

  static bool
  run (Class& segmentation, Outcome& outcome)
  {
    std::vector<pcl::AttentionSegment> segments (3);
    const bool done = segmentation.segment (segments);
    outcome = Outcome ();
    outcome.add (segments);
    return (done);
  }
};
