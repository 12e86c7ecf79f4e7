// SPDX-License-Identifier: BSD-3-Clause
#define PCL_NO_PRECOMPILE
#include "stages.h"
#include <pcl/segmentation/attention_filter.h>

#include <pcl/register_point_struct.h>

#include <new>

/** \brief A point type that the library knows nothing of. */
struct ThermalPoint
{
  PCL_ADD_POINT4D
  PCL_ADD_RGB
  float temperature;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};
POINT_CLOUD_REGISTER_POINT_STRUCT (ThermalPoint,
                                   (float, x, x) (float, y, y) (float, z, z) (float, rgb, rgb) (float, temperature,
                                                                                                temperature))

namespace
{

template <typename StageT> class CustomPoint : public testing::Test
{
};

using Stages = testing::Types<SaliencyStage<ThermalPoint>, PointStage<ThermalPoint>, PatchStage<ThermalPoint>,
                              ClusteringStage<ThermalPoint>, FacadeStage<ThermalPoint>>;
TYPED_TEST_SUITE (CustomPoint, Stages);

/** \brief Gives the test a way to fail inside. */
class Failing : public pcl::AttentionSegmentation<ThermalPoint>
{
public:
  bool
  fail ()
  {
    return (run ("fail", [] () -> bool { throw std::bad_alloc (); }));
  }
};

pcl::PointCloud<ThermalPoint>::Ptr
thermalCloud ()
{
  const pcl::PointCloud<ThermalPoint>::Ptr cloud (new pcl::PointCloud<ThermalPoint>);
  pcl::copyPointCloud (*sceneCloud (), *cloud);
  return (cloud);
}

} // namespace

TYPED_TEST (CustomPoint, WorksInEveryClass)
{
  const pcl::PointCloud<ThermalPoint>::Ptr cloud = thermalCloud ();
  typename TypeParam::Class object;
  object.setInputCloud (cloud);
  TypeParam::prepare (object, *cloud);
  Outcome outcome;
  EXPECT_TRUE (TypeParam::run (object, outcome));
  EXPECT_FALSE (outcome.groups.empty ());
}

TEST (CustomPointFailure, ReportsAnExceptionInsteadOfLettingItOut)
{
  Failing segmentation;
  segmentation.setInputCloud (thermalCloud ());
  const std::string errors = errorsOf ([&] { EXPECT_FALSE (segmentation.fail ()); });
  EXPECT_TRUE (contains (errors, "[pcl::AttentionSegmentation::fail] Failed: not enough memory."));
  EXPECT_EQ (segmentation.getPipeline (), nullptr) << "what was half done is forgotten";
}

TEST (CustomPointFilter, PassesEveryField)
{
  const pcl::PointCloud<ThermalPoint>::Ptr cloud = thermalCloud ();
  for (std::size_t index = 0; index < cloud->size (); ++index)
    (*cloud)[index].temperature = static_cast<float> (index);
  pcl::AttentionFilter<ThermalPoint> filter;
  filter.setInputCloud (cloud);
  pcl::PointCloud<ThermalPoint> attended;
  filter.filter (attended);
  ASSERT_EQ (filter.getObjects ().size (), 1u);
  const pcl::Indices& indices = filter.getObjects ().front ().indices;
  ASSERT_EQ (attended.size (), indices.size ());
  for (std::size_t index = 0; index < attended.size (); ++index)
    EXPECT_EQ (attended[index].temperature, static_cast<float> (indices[index]));
}
