// SPDX-License-Identifier: BSD-3-Clause
#include "clouds.h"
#include <pcl/features/integral_image_normal.h>
#include <pcl/segmentation/planar_patch_extraction.h>

namespace
{

class PatchExtraction : public testing::Test
{
protected:
  void
  SetUp () override
  {
    extraction.setInputCloud (sceneCloud ());
  }

  std::vector<pcl::PointIndices>
  extract ()
  {
    std::vector<pcl::PointIndices> patches (2);
    EXPECT_TRUE (extraction.extract (patches));
    return (patches);
  }

  pcl::PlanarPatchExtraction<PointT> extraction;
};

} // namespace

TEST_F (PatchExtraction, LabelsWhatItLists)
{
  const std::vector<pcl::PointIndices> patches = extract ();
  const pcl::PointCloud<pcl::Label> labels = extraction.getLabels ();
  ASSERT_GT (patches.size (), 5u);
  ASSERT_EQ (labels.width, 320u);
  ASSERT_EQ (labels.height, 240u);
  std::size_t listed = 0, labelled = 0;
  for (std::size_t k = 0; k < patches.size (); ++k)
  {
    listed += patches[k].indices.size ();
    for (const pcl::index_t index : patches[k].indices)
    {
      ASSERT_EQ (labels[index].label, k + 1);
      ASSERT_TRUE (pcl::isFinite ((*sceneCloud ())[index]));
    }
  }
  for (const pcl::Label& label : labels)
    labelled += label.label != 0;
  EXPECT_EQ (listed, labelled);
}

TEST_F (PatchExtraction, ANormalWithoutCurvatureIsNoSeed)
{
  pcl::IntegralImageNormalEstimation<PointT, pcl::Normal> estimation;
  estimation.setInputCloud (sceneCloud ());
  pcl::PointCloud<pcl::Normal> estimated;
  estimation.compute (estimated);
  const auto labelsWith = [&] (float missing) {
    const pcl::PointCloud<pcl::Normal>::Ptr normals (new pcl::PointCloud<pcl::Normal> (estimated));
    for (std::size_t index = 0; index < normals->size (); index += 3)
      (*normals)[index].curvature = missing;
    extraction.setInputNormals (normals);
    extract ();
    std::vector<std::uint32_t> labels;
    for (const pcl::Label& label : extraction.getLabels ())
      labels.push_back (label.label);
    return (labels);
  };
  EXPECT_EQ (labelsWith (nan_value), labelsWith (1.0f / 3.0f)); // the largest curvature there is
  EXPECT_NE (labelsWith (nan_value), labelsWith (0.0f));
}

TEST_F (PatchExtraction, DescribesPatchesInTheFrameOfTheCloud)
{
  const Eigen::Isometry3f motion = someMotion ();
  extraction.setInputCloud (moved (*sceneCloud (), motion));
  const std::vector<pcl::PointIndices> indices = extract ();
  const std::vector<pcl_attention::PlanarPatch> patches = extraction.getPatches ();
  ASSERT_EQ (patches.size (), indices.size ());
  const Cloud::ConstPtr cloud = extraction.getInputCloud ();
  for (std::size_t k = 0; k < patches.size (); ++k)
  {
    EXPECT_EQ (patches[k].pixels, indices[k].indices);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero ();
    for (const pcl::index_t index : patches[k].pixels)
      sum += (*cloud)[index].getVector3fMap ().cast<double> ();
    const Eigen::Vector3f centroid = (sum / static_cast<double> (patches[k].pixels.size ())).cast<float> ();
    EXPECT_LT ((patches[k].centroid - centroid).norm (), 1e-4f);
    EXPECT_NEAR (patches[k].normal.norm (), 1.0f, 1e-4f);
    EXPECT_LE (patches[k].normal.dot (patches[k].centroid - motion.translation ()), 0.0f) << "towards the viewpoint";
  }
}

TEST_F (PatchExtraction, KnowsWhichPatchesTouch)
{
  const std::size_t count = extract ().size ();
  const pcl_attention::PatchGraph graph = extraction.getPatchGraph ();
  ASSERT_EQ (graph.neighbors.size (), count + 1);
  EXPECT_FALSE (graph.borders.empty ());
  for (const auto& border : graph.borders)
  {
    EXPECT_GE (border.first.first, 1);
    EXPECT_LE (border.first.second, static_cast<int> (count));
    EXPECT_GT (border.second.pairs, 0);
  }
  pcl_attention::PatchGraphParameters parameters;
  parameters.maximum_gap = 0;
  extraction.setPatchGraphParameters (parameters);
  EXPECT_TRUE (extraction.getPatchGraph ().borders.empty ()) << "results of other parameters are forgotten";
  extract ();
  EXPECT_LT (extraction.getPatchGraph ().borders.size (), graph.borders.size ());
}

TEST_F (PatchExtraction, UsesItsParameters)
{
  const std::size_t count = extract ().size ();
  pcl_attention::PatchParameters parameters;
  parameters.minimum_size = 500;
  parameters.reassign_distance = 0.0f;
  extraction.setParameters (parameters);
  EXPECT_EQ (extraction.getParameters ().minimum_size, 500);
  const std::vector<pcl::PointIndices> large = extract ();
  EXPECT_FALSE (large.empty ());
  EXPECT_LT (large.size (), count);
  for (const pcl::PointIndices& patch : large)
    EXPECT_GE (patch.indices.size (), 500u);
}

TEST_F (PatchExtraction, UsesTheNormalsItIsGiven)
{
  // A wall that two kinds of normals divide in the middle.
  const Cloud::Ptr wall = filledCloud (64, 48, 0.0f, 0.0f, 1.0f);
  const pcl::PointCloud<pcl::Normal>::Ptr normals (new pcl::PointCloud<pcl::Normal> (64, 48));
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column)
    {
      wall->at (column, row).getVector3fMap () =
          Eigen::Vector3f (0.002f * static_cast<float> (column - 32), 0.002f * static_cast<float> (row - 24), 1.0f);
      normals->at (column, row) = column < 32 ? pcl::Normal (0.0f, 0.0f, -1.0f) : pcl::Normal (0.8f, 0.0f, -0.6f);
    }
  extraction.setInputCloud (wall);
  EXPECT_EQ (extract ().size (), 1u);
  extraction.setInputNormals (normals);
  const std::vector<pcl::PointIndices> patches = extract ();
  EXPECT_GE (patches.size (), 2u);
  for (const pcl::PointIndices& patch : patches)
    for (const pcl::index_t index : patch.indices)
      EXPECT_EQ (index % 64 < 32, patch.indices.front () % 64 < 32) << "no patch crosses the middle";
}

TEST_F (PatchExtraction, HasNoStaleResults)
{
  const auto expectNone = [this] {
    EXPECT_TRUE (extraction.getLabels ().empty ());
    EXPECT_TRUE (extraction.getPatches ().empty ());
    EXPECT_TRUE (extraction.getPatchGraph ().borders.empty ());
  };
  expectNone ();
  extract ();
  EXPECT_FALSE (extraction.getLabels ().empty ());
  extraction.setInputCloud (filledCloud (64, 48, nan_value, nan_value, nan_value));
  expectNone ();
  EXPECT_TRUE (extract ().empty ());
  EXPECT_EQ (extraction.getLabels ().width, 64u);
}
