// SPDX-License-Identifier: BSD-3-Clause
// Every instruction set and every number of threads gives the same bits.
#include "../../src/core/instruction_set.h"
#include "../../src/core/object_hull.h"
#include "shapes.h"
#include <pcl_attention/core/pipeline.h>
#include <pcl_attention/core/pyramid.h>
#include <pcl_attention/core/visible_hull.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl_attention;

namespace
{

/** \brief Everything that the inner loops have a part in. */
struct Results
{
  NormalImage normals;
  OrganizedCloud half;
  NormalImage half_normals;
  SymmetryMap symmetry;
  SaliencyMaps saliency;
  std::vector<SupportingPlane> planes;
  std::vector<Eigen::Vector3f> corners; /**< of the hull of all points */
};

Results
resultsOf (const OrganizedCloud& cloud, const AttentionParameters& parameters, int threads)
{
  Results results;
  estimateNormals (cloud, parameters.normals, threads, results.normals);
  halve (cloud, results.normals, threads, results.half, results.half_normals);
  computeSymmetry (cloud, results.normals, parameters.saliency, threads, results.symmetry);
  computeSaliency (cloud, results.normals, parameters.saliency, threads, results.saliency);
  results.planes = findSupportingPlanes (
    cloud, estimateSensor (cloud), results.normals, coarserLevels (cloud, results.normals, supportLevels (cloud.width), threads),
    parameters.support);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t index = 0; index < cloud.size (); ++index)
    if (cloud.valid[index])
      points.emplace_back (cloud.x[index], cloud.y[index], cloud.z[index]);
  GrowingHull hull{HullGrid (cloud)};
  hull.add (points);
  results.corners = hull.vertices ();
  return (results);
}

void
expectSame (const Results& a, const Results& b)
{
  EXPECT_EQ (a.normals.x, b.normals.x);
  EXPECT_EQ (a.normals.y, b.normals.y);
  EXPECT_EQ (a.normals.z, b.normals.z);
  EXPECT_EQ (a.normals.curvature, b.normals.curvature);
  EXPECT_EQ (a.normals.valid, b.normals.valid);
  EXPECT_EQ (a.half.x, b.half.x);
  EXPECT_EQ (a.half.z, b.half.z);
  EXPECT_EQ (a.half.valid, b.half.valid);
  EXPECT_EQ (a.half_normals.y, b.half_normals.y);
  EXPECT_EQ (a.half_normals.valid, b.half_normals.valid);
  EXPECT_EQ (a.symmetry.symmetry.data, b.symmetry.symmetry.data);
  EXPECT_EQ (a.symmetry.winning_axis.data, b.symmetry.winning_axis.data);
  EXPECT_EQ (a.saliency.saliency.data, b.saliency.saliency.data);
  ASSERT_EQ (a.planes.size (), b.planes.size ());
  for (std::size_t k = 0; k < a.planes.size (); ++k)
  {
    EXPECT_EQ (a.planes[k].indices, b.planes[k].indices);
    EXPECT_EQ (a.planes[k].coefficients, b.planes[k].coefficients);
    EXPECT_EQ (a.planes[k].confidence, b.planes[k].confidence);
    EXPECT_EQ (a.planes[k].outline, b.planes[k].outline);
    EXPECT_EQ (a.planes[k].ends, b.planes[k].ends);
  }
  EXPECT_EQ (a.corners, b.corners);
}

/** \brief Sizes that no number of lanes divides, holes, and surfaces so exact that samples lie on the planes of symmetry. */
std::vector<OrganizedCloud>
clouds ()
{
  std::vector<OrganizedCloud> all;
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{{161, 121}, {37, 23}, {5, 9}})
    all.push_back (shapes::rendered (SceneKind::clutter, 3, width, height, 1.0).cloud);
  all.push_back (shapes::rendered (SceneKind::cylinders, 2, 320, 240, 1.0).cloud);
  all.push_back (shapes::rendered (SceneKind::stacked, 1, 200, 150, 0.0).cloud);
  shapes::Frame holes = shapes::hills (4, {93, 61});
  shapes::punchHoles (holes, 2, 0.3);
  all.push_back (holes.cloud);
  all.push_back (shapes::look (shapes::plane ({0, 0, 1}, {0, 0, -1}), {50, 40}).cloud);
  return (all);
}

/** \brief Goes back to the widest instruction set, whatever a test ends with. */
class InstructionSets : public ::testing::Test
{
protected:
  void
  TearDown () override
  {
    useInstructionSet (instructionSets ().back ());
  }
};

} // namespace

TEST_F (InstructionSets, AllGiveTheSame)
{
  AttentionParameters other;
  other.normals.radius = 7;
  other.saliency.window_radius = 5;
  other.saliency.convexity_gate = false;
  for (const OrganizedCloud& cloud : clouds ())
    for (const AttentionParameters& parameters : {AttentionParameters (), other})
    {
      ASSERT_TRUE (useInstructionSet ("baseline"));
      const Results baseline = resultsOf (cloud, parameters, 1);
      for (const std::string& name : instructionSets ())
      {
        SCOPED_TRACE (::testing::Message () << name << ", " << cloud.width << "x" << cloud.height);
        ASSERT_TRUE (useInstructionSet (name));
        for (const int threads : {1, 2, 3, 8})
          expectSame (baseline, resultsOf (cloud, parameters, threads));
      }
    }
}

TEST_F (InstructionSets, BeginWithTheBaselineAndRefuseOthers)
{
  EXPECT_EQ (instructionSets ().front (), "baseline");
  EXPECT_FALSE (useInstructionSet ("mmx"));
  EXPECT_FALSE (useInstructionSet (""));
}

TEST_F (InstructionSets, StagesBesideEachOtherGiveTheSameObjects)
{
  AttentionParameters pieces, all_points;
  pieces.visiblePieces ();
  all_points.segmentation.inhibition_of_return = false;
  for (const auto& [kind, parameters] : {std::pair<SceneKind, AttentionParameters> (SceneKind::clutter, AttentionParameters ()),
                                         {SceneKind::occluded, AttentionParameters ()}, {SceneKind::filled, AttentionParameters ()},
                                         {SceneKind::clutter, pieces},
                                         {SceneKind::cylinders, all_points}, {SceneKind::occluded, AttentionParameters::paper ()}})
  {
    const OrganizedCloud cloud = shapes::rendered (kind, 5, 320, 240, 1.0).cloud;
    const auto segmentsOf = [&cloud, &parameters = parameters] (int threads, bool all) {
      AttentionPipeline pipeline;
      pipeline.start (OrganizedCloud (cloud), Eigen::Isometry3f::Identity (), parameters, threads);
      std::vector<AttentionSegment> segments;
      if (all)
        pipeline.all (segments);
      for (AttentionSegment segment; !all && pipeline.next (segment);)
        segments.push_back (segment);
      EXPECT_GE (pipeline.times ().overlap, 0.0);
      EXPECT_GT (pipeline.times ().total (), 0.0);
      return (segments);
    };
    const std::vector<AttentionSegment> one = segmentsOf (1, false);
    EXPECT_GE (one.size (), 2u);
    for (const auto& [threads, all] : {std::pair<int, bool> (1, true), {2, false}, {2, true}, {3, true}, {8, false}, {8, true}})
    {
      const std::vector<AttentionSegment> more = segmentsOf (threads, all);
      ASSERT_EQ (more.size (), one.size ()) << threads << " threads, all " << all;
      for (std::size_t k = 0; k < one.size (); ++k)
      {
        EXPECT_EQ (more[k].indices, one[k].indices);
        EXPECT_EQ (more[k].patches, one[k].patches);
        EXPECT_EQ (more[k].attention_point.column, one[k].attention_point.column);
        EXPECT_EQ (more[k].compactness, one[k].compactness);
        EXPECT_EQ (more[k].confidence, one[k].confidence);
        EXPECT_EQ (more[k].rank, one[k].rank);
        EXPECT_EQ (more[k].box.center, one[k].box.center);
      }
    }
  }
}

TEST_F (InstructionSets, DistancesToTheNearestPlaneAreThoseOfEveryNumberOfPoints)
{
  // A cube from 1 to 2 m away, half a metre wide, seen from its front and one side; points fill the lanes to any part.
  std::vector<Eigen::Vector3f> corners;
  for (const float x : {0.2f, 0.7f})
    for (const float y : {-0.3f, 0.2f})
      for (const float z : {1.0f, 1.5f})
        corners.emplace_back (x, y, z);
  const VisibleHull cube = computeVisibleHull (corners);
  std::vector<Eigen::Vector3f> points;
  double sum = 0.0;
  for (int count = 1; count <= 150; ++count)
  {
    const auto share = static_cast<float> (count) / 151.0f;
    points.emplace_back (0.2f + 0.5f * share, -0.3f + 0.5f * std::fmod (7.0f * share, 1.0f), 1.0f + 0.5f * std::fmod (3.0f * share, 1.0f));
    // The visible planes are x = .2 and z = 1; y = .2 and -.3 face away or are seen from within their slab.
    sum += std::min (points.back ().x () - 0.2f, points.back ().z () - 1.0f);
    for (const std::string& name : instructionSets ())
    {
      ASSERT_TRUE (useInstructionSet (name));
      EXPECT_NEAR (compactness (points, cube, {}, FaceDistance::plane), sum / count, 1e-6) << name << ", " << count << " points";
    }
  }
}
