// SPDX-License-Identifier: BSD-3-Clause
#include "clouds.h"
#include <pcl/segmentation/attention_filter.h>
#include <pcl/segmentation/symmetry_saliency_estimation.h>

#include <set>

namespace
{

class Filter : public testing::Test
{
protected:
  void
  SetUp () override
  {
    filter.setInputCloud (sceneCloud ());
  }

  pcl::Indices
  passed ()
  {
    pcl::Indices indices{1, 2, 3};
    filter.filter (indices);
    return (indices);
  }

  /** \brief The points of the first objects, ascending. */
  static pcl::Indices
  pointsOfObjects (std::size_t count)
  {
    pcl::AttentionSegmentation<PointT> segmentation;
    segmentation.setInputCloud (sceneCloud ());
    std::vector<pcl::AttentionSegment> objects;
    EXPECT_TRUE (segmentation.segment (objects));
    std::set<pcl::index_t> points;
    for (std::size_t index = 0; index < std::min (count, objects.size ()); ++index)
      points.insert (objects[index].indices.begin (), objects[index].indices.end ());
    return {points.begin (), points.end ()};
  }

  static pcl::Indices
  finitePointsBut (const pcl::Indices& others)
  {
    pcl::Indices points;
    for (std::size_t index = 0; index < sceneCloud ()->size (); ++index)
      if (pcl::isFinite ((*sceneCloud ())[index]) &&
          !std::binary_search (others.begin (), others.end (), static_cast<pcl::index_t> (index)))
        points.push_back (static_cast<pcl::index_t> (index));
    return (points);
  }

  pcl::AttentionFilter<PointT> filter{true};
};

} // namespace

TEST_F (Filter, KeepsTheMostAttendedObjects)
{
  EXPECT_EQ (passed (), pointsOfObjects (1)) << "one, unless another number is set";
  for (const unsigned int count : {2u, 3u, 1000u})
  {
    filter.setKeepObjects (count);
    EXPECT_EQ (passed (), pointsOfObjects (count));
    EXPECT_LE (filter.getObjects ().size (), count);
  }
  filter.setKeepObjects (0);
  EXPECT_TRUE (passed ().empty ());
}

TEST_F (Filter, RemovesTheRestOrWithNegativeTheObjects)
{
  filter.setKeepObjects (2);
  const pcl::Indices objects = passed ();
  EXPECT_EQ (filter.getRemovedIndices ()->size (), sceneCloud ()->size () - objects.size ());
  filter.setNegative (true);
  EXPECT_EQ (passed (), finitePointsBut (objects));
}

TEST_F (Filter, GivesACloud)
{
  filter.setKeepObjects (2);
  const pcl::Indices objects = passed ();
  Cloud output;
  filter.filter (output);
  EXPECT_EQ (output.size (), objects.size ());

  filter.setKeepOrganized (true);
  filter.filter (output);
  ASSERT_EQ (output.width, sceneCloud ()->width);
  ASSERT_EQ (output.height, sceneCloud ()->height);
  pcl::Indices finite;
  for (std::size_t index = 0; index < output.size (); ++index)
    if (pcl::isFinite (output[index]))
      finite.push_back (static_cast<pcl::index_t> (index));
  EXPECT_EQ (finite, objects);
}

TEST_F (Filter, KeepsSalientPoints)
{
  pcl::SymmetrySaliencyEstimation<PointT> estimation;
  estimation.setInputCloud (sceneCloud ());
  pcl::PointCloud<pcl::Intensity> saliency;
  ASSERT_TRUE (estimation.compute (saliency));
  pcl::Indices expected;
  for (std::size_t index = 0; index < saliency.size (); ++index)
    if (saliency[index].intensity > 0.3f)
      expected.push_back (static_cast<pcl::index_t> (index));
  ASSERT_FALSE (expected.empty ());
  filter.setKeepSalient (0.3f);
  EXPECT_EQ (passed (), expected);
  EXPECT_TRUE (filter.getObjects ().empty ());
  filter.setNegative (true);
  EXPECT_EQ (passed (), finitePointsBut (expected));
  filter.setNegative (false);
  filter.setKeepObjects (1);
  EXPECT_EQ (passed (), pointsOfObjects (1)) << "the later call counts";
}

TEST_F (Filter, KeepsToTheMask)
{
  const pcl::IndicesPtr mask = middleIndices (*sceneCloud ());
  filter.setIndices (mask);
  filter.setKeepObjects (1000);
  const pcl::Indices objects = passed ();
  EXPECT_FALSE (objects.empty ());
  EXPECT_TRUE (std::includes (mask->begin (), mask->end (), objects.begin (), objects.end ()));
  EXPECT_EQ (filter.getRemovedIndices ()->size (), mask->size () - objects.size ());
}

TEST_F (Filter, PassesNothingAfterAnError)
{
  const auto expectError = [&] (const std::string& message) {
    pcl::Indices indices{1, 2, 3};
    Cloud output (2, 2);
    EXPECT_TRUE (contains (errorsOf ([&] { filter.filter (indices); }), message));
    EXPECT_TRUE (indices.empty ());
    errorsOf ([&] { filter.filter (output); });
    EXPECT_TRUE (std::none_of (output.begin (), output.end (), [] (const PointT& p) { return (pcl::isFinite (p)); }));
  };
  filter.setKeepSalient (1.5f);
  expectError ("The threshold of the saliency is 1.5, but must be from 0 to 1.");
  filter.setKeepSalient (nan_value);
  filter.setKeepOrganized (true);
  expectError ("but must be from 0 to 1.");
  filter.setKeepObjects (1);
  filter.setIndices (pcl::IndicesPtr (new pcl::Indices{5, -1, 100000000}));
  filter.setNegative (true);
  expectError ("lies outside the input cloud");
  filter.setIndices (pcl::IndicesPtr (new pcl::Indices{5}));
  filter.setInputCloud (filledCloud (1000, 1, 0.0f, 0.0f, 1.0f));
  expectError ("not organized");
}
