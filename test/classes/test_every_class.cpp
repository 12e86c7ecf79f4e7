// SPDX-License-Identifier: BSD-3-Clause
#include "stages.h"

// What must hold of each of the five classes.

namespace
{

template <typename StageT> class EveryClass : public testing::Test
{
protected:
  using Class = typename StageT::Class;

  void
  setCloud (const Cloud::ConstPtr& cloud)
  {
    object.setInputCloud (cloud);
    if (cloud)
      StageT::prepare (object, *cloud);
  }

  /** \brief The outcome of a call that has to succeed. */
  Outcome
  result ()
  {
    Outcome outcome;
    EXPECT_TRUE (StageT::run (object, outcome));
    return (outcome);
  }

  /** \brief The outcome on a cloud, by an object of its own. */
  static Outcome
  freshResult (const Cloud::ConstPtr& cloud)
  {
    Class other;
    other.setInputCloud (cloud);
    StageT::prepare (other, *cloud);
    Outcome outcome;
    EXPECT_TRUE (StageT::run (other, outcome));
    return (outcome);
  }

  /** \brief Expect that the call fails, clears its output, and says so. */
  void
  expectError (const std::string& message)
  {
    Outcome outcome;
    bool done = true;
    const std::string errors = errorsOf ([&] { done = StageT::run (object, outcome); });
    EXPECT_FALSE (done);
    EXPECT_TRUE (outcome.isEmpty ());
    EXPECT_TRUE (contains (errors, StageT::where + message));
  }

  void
  expectNothingOn (const Cloud::ConstPtr& cloud)
  {
    setCloud (cloud);
    EXPECT_TRUE (result ().groups.empty ());
  }

  Class object;
};

using Stages = testing::Types<SaliencyStage<PointT>, PointStage<PointT>, PatchStage<PointT>, ClusteringStage<PointT>,
                              FacadeStage<PointT>>;
TYPED_TEST_SUITE (EveryClass, Stages);

} // namespace

TYPED_TEST (EveryClass, FindsSomething)
{
  this->setCloud (sceneCloud ());
  EXPECT_FALSE (this->result ().groups.empty ());
}

TYPED_TEST (EveryClass, NeedsACloud)
{
  if constexpr (std::is_same_v<TypeParam, PointStage<PointT>>)
    this->object.setSaliency (crossMap (64, 48, 30, 20));
  this->expectError ("No input cloud: call setInputCloud first.");
  this->setCloud (sceneCloud ());
  this->result ();
  this->object.setInputCloud (nullptr);
  this->expectError ("No input cloud: call setInputCloud first.");
}

TYPED_TEST (EveryClass, RefusesAnEmptyCloud)
{
  this->setCloud (Cloud::Ptr (new Cloud));
  this->expectError ("The input cloud is empty.");
}

TYPED_TEST (EveryClass, RefusesWhatIsNotOrganized)
{
  this->setCloud (filledCloud (1000, 1, 0.0f, 0.0f, 1.0f));
  this->expectError ("The input cloud is not organized (1000 x 1): give it as the camera delivers it");
  this->setCloud (filledCloud (1, 1, 0.0f, 0.0f, 1.0f));
  this->expectError ("The input cloud is not organized (1 x 1)");
}

TYPED_TEST (EveryClass, RefusesAWrongSize)
{
  const Cloud::Ptr cloud = filledCloud (40, 30, 0.0f, 0.0f, 1.0f);
  cloud->height = 31;
  this->setCloud (cloud);
  this->expectError ("The input cloud has 1200 points, but is said to be 40 x 31");
}

TYPED_TEST (EveryClass, RefusesAnImageThatIsTooLarge)
{
  this->setCloud (filledCloud (16385, 2, 0.0f, 0.0f, 1.0f));
  this->expectError ("The input cloud has 16385 x 2, more than the 16384 a side and 67108864 in all that are taken: give");
}

TYPED_TEST (EveryClass, RefusesIndicesOutsideTheCloud)
{
  this->setCloud (sceneCloud ());
  const auto count = static_cast<pcl::index_t> (sceneCloud ()->size ());
  for (const pcl::index_t index : {-1, count, std::numeric_limits<pcl::index_t>::max ()})
  {
    const pcl::IndicesPtr indices (new pcl::Indices{5, index});
    this->object.setIndices (indices);
    this->expectError ("Index " + std::to_string (index) + " lies outside the input cloud of 76800 points");
  }
  this->object.setIndices (pcl::IndicesPtr ());
  EXPECT_EQ (this->result (), this->freshResult (sceneCloud ())) << "null takes all points";
}

TYPED_TEST (EveryClass, TakesNullIndicesForAllPoints)
{
  this->setCloud (sceneCloud ());
  this->object.setIndices (middleIndices (*sceneCloud ()));
  this->object.setIndices (pcl::IndicesConstPtr ());
  EXPECT_EQ (this->result (), this->freshResult (sceneCloud ()));
  this->object.setIndices (middleIndices (*sceneCloud ()));
  this->object.setIndices (pcl::PointIndicesConstPtr ());
  EXPECT_EQ (this->result (), this->freshResult (sceneCloud ()));
}

TYPED_TEST (EveryClass, RefusesARectangleBeforeTheCloud)
{
  const std::string errors = errorsOf ([&] { this->object.setIndices (0, 0, 10, 10); });
  EXPECT_TRUE (contains (errors, "setIndices] No input cloud"));
}

TYPED_TEST (EveryClass, RefusesASensorPoseThatIsNotFinite)
{
  const Cloud::Ptr cloud (new Cloud (*sceneCloud ()));
  cloud->sensor_origin_[1] = nan_value;
  this->setCloud (cloud);
  this->expectError ("The input cloud's sensor_origin_ or sensor_orientation_ is not finite");
}

TYPED_TEST (EveryClass, TakesAZeroQuaternionForNoRotation)
{
  const Cloud::Ptr cloud (new Cloud (*sceneCloud ()));
  cloud->sensor_orientation_.coeffs ().setZero ();
  EXPECT_EQ (this->freshResult (cloud), this->freshResult (sceneCloud ()));
}

TYPED_TEST (EveryClass, RefusesParametersOutOfRange)
{
  this->setCloud (sceneCloud ());
  TypeParam::spoil (this->object);
  this->expectError (std::string ("Bad parameter: ") + TypeParam::bad_parameter + ", but must be ");
}

TYPED_TEST (EveryClass, FindsNothingWhereThereIsNothing)
{
  this->expectNothingOn (filledCloud (64, 48, nan_value, nan_value, nan_value));
  this->expectNothingOn (filledCloud (64, 48, 0.0f, 0.0f, 0.0f));
  this->expectNothingOn (filledCloud (64, 48, 0.1f, 0.2f, -1.0f));
  constexpr float infinity = std::numeric_limits<float>::infinity ();
  this->expectNothingOn (filledCloud (64, 48, 0.0f, 0.0f, infinity));
  this->expectNothingOn (filledCloud (64, 48, 1e30f, 1e30f, 1e30f));
}

TYPED_TEST (EveryClass, FindsNothingUnderAnEmptyMask)
{
  this->object.setIndices (pcl::IndicesPtr (new pcl::Indices));
  this->expectNothingOn (sceneCloud ());
}

TYPED_TEST (EveryClass, SurvivesTinyAndNarrowClouds)
{
  for (const auto& [width, height] : {std::pair<int, int>{1, 2}, {2, 2}, {1, 200}, {200, 2}, {3, 3}, {7, 5}})
  {
    const Cloud::Ptr cloud = filledCloud (width, height, 0.0f, 0.0f, 1.0f);
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        cloud->at (column, row).getVector3fMap () =
            Eigen::Vector3f (0.002f * static_cast<float> (column), 0.002f * static_cast<float> (row), 1.0f);
    this->setCloud (cloud);
    this->result ();
  }
}

TYPED_TEST (EveryClass, TakesBadPointsForHoles)
{
  // Points at the origin, behind the camera, infinite or too far are the same as NaN.
  const Cloud::Ptr bad (new Cloud (*sceneCloud ())), holes (new Cloud (*sceneCloud ()));
  const std::vector<Eigen::Vector3f> positions{{0.0f, 0.0f, 0.0f},
                                               {0.1f, 0.1f, -0.5f},
                                               {0.0f, std::numeric_limits<float>::infinity (), 1.0f},
                                               {1e20f, -1e20f, 1e20f},
                                               {3e38f, 3e38f, 3e38f}};
  for (std::size_t index = 0; index < bad->size (); index += 97)
  {
    (*bad)[index].getVector3fMap () = positions[(index / 97) % positions.size ()];
    (*holes)[index].getVector3fMap ().setConstant (nan_value);
  }
  EXPECT_EQ (this->freshResult (bad), this->freshResult (holes));
}

TYPED_TEST (EveryClass, KeepsToTheMask)
{
  this->setCloud (sceneCloud ());
  const pcl::IndicesPtr indices = middleIndices (*sceneCloud ());
  this->object.setIndices (indices);
  const Outcome outcome = this->result ();
  EXPECT_FALSE (outcome.groups.empty ());
  for (const pcl::Indices& group : outcome.groups)
    EXPECT_TRUE (std::includes (indices->begin (), indices->end (), group.begin (), group.end ()));
  EXPECT_EQ (outcome, this->freshResult (onlyAt (*indices, *sceneCloud ())));

  this->object.setIndices (60, 80, 120, 160);
  EXPECT_EQ (outcome, this->result ()) << "the same as a rectangle";
}

TYPED_TEST (EveryClass, GivesTheSameAgain)
{
  this->setCloud (sceneCloud ());
  const Outcome first = this->result ();
  EXPECT_EQ (first, this->result ());
  EXPECT_EQ (first, this->freshResult (sceneCloud ()));
}

TYPED_TEST (EveryClass, GivesTheSameWithAnyNumberOfThreads)
{
  if constexpr (!std::is_same_v<TypeParam, PointStage<PointT>>)
  {
    this->setCloud (sceneCloud ());
    const Outcome first = this->result ();
    for (const unsigned int threads : {2u, 3u, 8u, 0u})
    {
      this->object.setNumberOfThreads (threads);
      for (int repeat = 0; repeat < 3; ++repeat)
        EXPECT_EQ (first, this->result ()) << threads << " threads";
    }
  }
}

TYPED_TEST (EveryClass, TakesOneFrameAfterTheOther)
{
  this->setCloud (sceneCloud ());
  const Outcome first = this->result ();
  const Cloud::ConstPtr smaller = renderCloud (pcl_attention::SceneKind::boxes, 3, 200, 150);
  this->setCloud (smaller);
  EXPECT_EQ (this->result (), this->freshResult (smaller));
  // As when the camera's lens is covered for a moment.
  this->expectNothingOn (filledCloud (320, 240, nan_value, nan_value, nan_value));
  this->expectNothingOn (filledCloud (7, 5, nan_value, nan_value, nan_value));
  this->setCloud (sceneCloud ());
  EXPECT_EQ (this->result (), first);
}

TYPED_TEST (EveryClass, RecoversFromAnError)
{
  this->setCloud (Cloud::Ptr (new Cloud));
  this->expectError ("The input cloud is empty.");
  this->setCloud (sceneCloud ());
  EXPECT_EQ (this->result (), this->freshResult (sceneCloud ()));
}

TYPED_TEST (EveryClass, SeesAChangeOfTheCloudItself)
{
  const Cloud::Ptr cloud (new Cloud (*sceneCloud ()));
  this->setCloud (cloud);
  this->result ();
  *cloud = *filledCloud (320, 240, nan_value, nan_value, nan_value);
  EXPECT_TRUE (this->result ().groups.empty ());
}

TYPED_TEST (EveryClass, ChecksNormals)
{
  if constexpr (!std::is_same_v<TypeParam, PointStage<PointT>>)
  {
    this->setCloud (sceneCloud ());
    const pcl::PointCloud<pcl::Normal>::Ptr normals (new pcl::PointCloud<pcl::Normal> (100, 100));
    this->object.setInputNormals (normals);
    this->expectError ("10000 normals for 76800 points: give one per point");
    this->object.setInputNormals (nullptr);
    EXPECT_EQ (this->result (), this->freshResult (sceneCloud ())) << "null estimates them";
  }
}

TYPED_TEST (EveryClass, TakesNormalsThatAreNotKnown)
{
  if constexpr (!std::is_same_v<TypeParam, PointStage<PointT>>)
  {
    this->setCloud (sceneCloud ());
    const pcl::PointCloud<pcl::Normal>::Ptr normals (
        new pcl::PointCloud<pcl::Normal> (320, 240, pcl::Normal (nan_value, nan_value, nan_value, nan_value)));
    this->object.setInputNormals (normals);
    EXPECT_TRUE (this->result ().groups.empty ()) << "nothing is known of any surface";
    for (std::size_t index = 0; index < normals->size (); ++index)
      if (index % 7 != 0)
        (*normals)[index] = pcl::Normal (0.0f, 0.0f, -2.0f, nan_value);
    this->result ();
  }
}
