// SPDX-License-Identifier: BSD-3-Clause
#include "stages.h"

// The five point types that the library is instantiated for; none of the implementation is included here.

namespace
{

template <typename PointType> class EveryPointType : public testing::Test
{
protected:
  template <template <typename> class StageT>
  static Outcome
  resultOf ()
  {
    using Type = PointType;
    const typename pcl::PointCloud<Type>::Ptr cloud (new pcl::PointCloud<Type>);
    pcl::copyPointCloud (*sceneCloud (), *cloud);
    typename StageT<Type>::Class object;
    object.setInputCloud (cloud);
    StageT<Type>::prepare (object, *cloud);
    Outcome outcome;
    EXPECT_TRUE (StageT<Type>::run (object, outcome));
    return (outcome);
  }

  template <template <typename> class StageT>
  static Outcome
  expectedOf ()
  {
    typename StageT<PointT>::Class object;
    object.setInputCloud (sceneCloud ());
    StageT<PointT>::prepare (object, *sceneCloud ());
    Outcome outcome;
    EXPECT_TRUE (StageT<PointT>::run (object, outcome));
    return (outcome);
  }

  template <template <typename> class StageT>
  static void
  expectResult (bool depends_on_color)
  {
    const Outcome outcome = resultOf<StageT> ();
    const bool loses_color = std::is_same_v<PointType, pcl::PointXYZ> && depends_on_color;
    EXPECT_FALSE (outcome.groups.empty ());
    EXPECT_TRUE (loses_color || outcome == expectedOf<StageT> ());
  }
};

using PointTypes =
    testing::Types<pcl::PointXYZ, pcl::PointXYZRGB, pcl::PointXYZRGBA, pcl::PointXYZRGBNormal, pcl::PointXYZRGBL>;
TYPED_TEST_SUITE (EveryPointType, PointTypes);

} // namespace

TYPED_TEST (EveryPointType, HasEveryClass)
{
  this->template expectResult<SaliencyStage> (false);
  this->template expectResult<PointStage> (false);
  this->template expectResult<PatchStage> (false);
  this->template expectResult<ClusteringStage> (true);
  this->template expectResult<FacadeStage> (true);
}
