// SPDX-License-Identifier: BSD-3-Clause
// Every parameter at either end of its range: something is computed, the same with any number of threads, or an error is said.
#include "clouds.h"
#include <pcl/segmentation/attention_segmentation.h>
#include <pcl_attention/core/parameters.h>

namespace
{

using Parameters = pcl_attention::AttentionParameters;

/** \brief What a value may depend on to be looked at: the presets, and each way to choose attention points. */
std::vector<Parameters>
bases ()
{
  std::vector<Parameters> all{Parameters (), Parameters::paper ()};
  for (const auto strategy :
       {pcl_attention::AttentionStrategy::winner_take_all, pcl_attention::AttentionStrategy::image_winner_take_all})
  {
    Parameters parameters;
    parameters.attention_points.strategy = strategy;
    all.push_back (parameters);
  }
  return (all);
}

/** \brief Objects of a scene of few pixels; only a message if the parameters do not go together. */
std::vector<pcl::AttentionSegment>
segmentsWith (const Parameters& parameters, unsigned int threads)
{
  static const Cloud::ConstPtr cloud = renderCloud (pcl_attention::SceneKind::clutter, 7, 64, 48);
  pcl::AttentionSegmentation<PointT> segmentation (parameters);
  segmentation.setInputCloud (cloud);
  segmentation.setNumberOfThreads (threads);
  std::vector<pcl::AttentionSegment> segments;
  bool done = true;
  const std::string errors = errorsOf ([&] { done = segmentation.segment (segments); });
  const std::string problem = pcl_attention::validate (parameters);
  EXPECT_EQ (done, problem.empty ()) << problem;
  if (!done)
  {
    EXPECT_TRUE (contains (errors, "Bad parameter: " + problem));
    EXPECT_TRUE (segments.empty ());
  }
  int rank = 0;
  for (const pcl::AttentionSegment& segment : segments)
  {
    EXPECT_EQ (segment.rank, ++rank);
    EXPECT_FALSE (segment.indices.empty ());
    EXPECT_TRUE (std::is_sorted (segment.indices.begin (), segment.indices.end ()));
    for (const pcl::index_t index : {segment.indices.front (), segment.indices.back ()})
      EXPECT_TRUE (index >= 0 && index < 64 * 48);
    EXPECT_TRUE (segment.box.center.allFinite () && segment.box.size.allFinite ());
    EXPECT_TRUE (std::isfinite (segment.compactness) && std::isfinite (segment.attention_point.saliency));
  }
  return (segments);
}

} // namespace

TEST (ParameterExtremes, EachAlone)
{
  int computed = 0;
  for (const Parameters& base : bases ())
    for (const pcl_attention::ParameterDescription& row : pcl_attention::parameterTable ())
      for (const double value : {row.minimum, row.maximum})
      {
        Parameters parameters = base;
        row.set (parameters, value);
        SCOPED_TRACE (row.name + " is " + row.toString (parameters));
        computed += pcl_attention::validate (parameters).empty ();
        expectSame (segmentsWith (parameters, 3), segmentsWith (parameters, 1));
      }
  // Only the radii of the image's symmetry do not go with every value of the other one.
  EXPECT_EQ (computed, 4 * (2 * static_cast<int> (pcl_attention::parameterTable ().size ()) - 2));
}

TEST (ParameterExtremes, AllAtOnce)
{
  for (const bool highest : {false, true})
  {
    Parameters parameters;
    for (const pcl_attention::ParameterDescription& row : pcl_attention::parameterTable ())
      row.set (parameters, highest ? row.maximum : row.minimum);
    ASSERT_EQ (pcl_attention::validate (parameters), "");
    expectSame (segmentsWith (parameters, 3), segmentsWith (parameters, 1));
  }
}
