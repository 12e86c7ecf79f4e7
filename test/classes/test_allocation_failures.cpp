// SPDX-License-Identifier: BSD-3-Clause
// An allocation that fails is an error like any other. In a program of its own, as it has an operator new of its own.
#include "clouds.h"
#include <pcl/segmentation/attention_segmentation.h>
#include <pcl/segmentation/planar_patch_extraction.h>
#include <pcl/segmentation/symmetry_saliency_estimation.h>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>

namespace
{

constexpr long no_limit = std::numeric_limits<long>::max () / 2;
std::atomic<long> allocations_left{no_limit}; // the one after them fails
std::atomic<bool> all_others_fail_too{false}, limit_reached{false};
std::atomic<long> failed{0}, alive{0}; // without those that may fail, as of std::stable_sort

void*
allocate (std::size_t size)
{
  const long left = allocations_left--;
  if (left == 0)
    limit_reached = true;
  void* const memory = left == 0 || (left < 0 && all_others_fail_too) ? nullptr : std::malloc (std::max<std::size_t> (size, 1));
  alive += memory != nullptr;
  return (memory);
}

void
deallocate (void* memory)
{
  alive -= memory != nullptr;
  std::free (memory);
}

} // namespace

// pcl::ConvexHull leaves what Qhull has allocated where one of its own allocations fails.
extern "C" const char*
__lsan_default_suppressions ()
{
  return ("leak:libqhull_r\nleak:pcl::ConvexHull\n");
}

void*
operator new (std::size_t size)
{
  if (void* const memory = allocate (size))
    return (memory);
  ++failed;
  throw std::bad_alloc ();
}

void*
operator new[] (std::size_t size)
{
  return (operator new (size));
}

void*
operator new (std::size_t size, const std::nothrow_t&) noexcept
{
  return (allocate (size));
}

void*
operator new[] (std::size_t size, const std::nothrow_t&) noexcept
{
  return (allocate (size));
}

void
operator delete (void* memory) noexcept
{
  deallocate (memory);
}

void
operator delete (void* memory, std::size_t) noexcept
{
  deallocate (memory);
}

void
operator delete[] (void* memory) noexcept
{
  deallocate (memory);
}

void
operator delete[] (void* memory, std::size_t) noexcept
{
  deallocate (memory);
}

namespace
{

using Segmentation = pcl::AttentionSegmentation<PointT>;

/** \brief A call of the class that has outputs. */
struct Method
{
  std::string name;
  std::function<bool (Segmentation&)> call;
  std::function<bool ()> is_cleared;
};

/** \brief A scene of few pixels in which an object is found all the same. */
struct SmallScene : Segmentation
{
  explicit SmallScene (unsigned int threads)
  {
    static const Cloud::ConstPtr cloud = renderCloud (pcl_attention::SceneKind::boxes, 3, 64, 48);
    pcl_attention::AttentionParameters parameters;
    parameters.saliency.levels = 2;
    parameters.patches.minimum_size = 10;
    parameters.segmentation.coverage_size = 10;
    parameters.segmentation.minimum_segment_size = 10;
    setParameters (parameters);
    setInputCloud (cloud);
    setNumberOfThreads (threads);
  }
};

class AllocationFailures : public testing::TestWithParam<unsigned int>
{
protected:
  void
  TearDown () override
  {
    allocations_left = no_limit;
  }

  /** \brief Let the allocation after so many fail during a call.
   * \return what was said */
  std::string
  fail (long after, bool others_too, Segmentation& segmentation, const Method& method)
  {
    return (errorsOf ([&] {
      failed = 0;
      limit_reached = false;
      all_others_fail_too = others_too;
      allocations_left = after;
      const bool done = method.call (segmentation);
      allocations_left = no_limit;
      if (failed > 0)
      {
        EXPECT_FALSE (done);
        EXPECT_TRUE (method.is_cleared ());
      }
    }));
  }

  std::vector<pcl::AttentionSegment> segments_;
  pcl::AttentionSegment segment_;
  std::vector<pcl::PointIndices> clusters_;
  pcl::PointCloud<pcl::Label> labels_;
  pcl::PointIndices inliers_;
  pcl::ModelCoefficients coefficients_;
  std::vector<pcl::SupportingPlane> planes_;
  const std::vector<Method> methods_{
      {"segment", [this] (Segmentation& s) { return (s.segment (segments_)); }, [this] { return (segments_.empty ()); }},
      {"segmentNext", [this] (Segmentation& s) { return (s.segmentNext (segment_)); },
       [this] { return (segment_.indices.empty ()); }},
      {"extract", [this] (Segmentation& s) { return (s.extract (clusters_)); }, [this] { return (clusters_.empty ()); }},
      {"segment", [this] (Segmentation& s) { return (s.segment (labels_, clusters_)); },
       [this] { return (labels_.empty () && clusters_.empty ()); }},
      {"getSupportingPlane", [this] (Segmentation& s) { return (s.getSupportingPlane (inliers_, coefficients_)); },
       [this] { return (inliers_.indices.empty () && coefficients_.values.empty ()); }},
      {"getSupportingPlanes",
       [this] (Segmentation& s) {
         planes_ = s.getSupportingPlanes ();
         return (!planes_.empty ());
       },
       [this] { return (planes_.empty ()); }}};
};

TEST_P (AllocationFailures, AreErrorsWhereverTheyHappen)
{
  std::vector<pcl::AttentionSegment> expected;
  SmallScene reference (GetParam ());
  ASSERT_TRUE (reference.segment (expected));
  ASSERT_FALSE (expected.empty ());
  for (const Method& method : methods_)
  {
    SCOPED_TRACE (method.name);
    // Every one of the first, then some: with the stages passed, most of the rest is the growth of one patch after the other.
    long failures = 0;
    for (long after = 0;; after += after < 200 ? 1 : 31)
    {
      const bool others_too = after % 2 != 0;
      SmallScene segmentation (GetParam ());
      const std::string errors = fail (after, others_too, segmentation, method);
      if (!limit_reached)
        break;
      if (failed == 0)
        continue;
      ++failures;
      ASSERT_TRUE (contains (errors, "[pcl::AttentionSegmentation::")) << after;
      ASSERT_TRUE (contains (errors, "] Failed: not enough memory.")) << after;
      if (failures % 10 != 0)
        continue;
      std::vector<pcl::AttentionSegment> again;
      ASSERT_TRUE (segmentation.segment (again)) << after;
      expectSame (again, expected);
    }
    EXPECT_GT (failures, 100) << "what needs no memory shows nothing";
  }
}

/** \brief With one thread, where the same allocation is always the same. */
using AllocationFailuresOfOneThread = AllocationFailures;

TEST_P (AllocationFailuresOfOneThread, LeaveNothingBehind)
{
  // Also what is kept for the whole run is there after the first time.
  const auto failAt = [&] (long after) {
    {
      SmallScene segmentation (GetParam ());
      fail (after, false, segmentation, methods_.front ());
    }
    return (alive.load ());
  };
  for (long after = 0; after < 400; after += 3)
  {
    failAt (after);
    const long before = failAt (after);
    EXPECT_EQ (failAt (after), before) << after;
  }
}

INSTANTIATE_TEST_SUITE_P (Threads, AllocationFailuresOfOneThread, testing::Values (1u));
INSTANTIATE_TEST_SUITE_P (Threads, AllocationFailures, testing::Values (1u, 2u));

} // namespace

TEST (AllocationFailures, AreErrorsOfTheOtherClassesToo)
{
  const Cloud::ConstPtr cloud = renderCloud (pcl_attention::SceneKind::boxes, 3, 64, 48);
  const auto expectErrors = [&cloud] (auto& object, auto& output, const auto& method, const std::string& name) {
    object.setInputCloud (cloud);
    all_others_fail_too = false;
    for (long after = 0;; ++after)
    {
      failed = 0;
      limit_reached = false;
      bool done = true;
      const std::string errors = errorsOf ([&] {
        allocations_left = after;
        done = method ();
        allocations_left = no_limit;
      });
      EXPECT_EQ (done, failed == 0) << after;
      EXPECT_EQ (output.empty (), failed > 0) << after;
      if (!limit_reached)
      {
        EXPECT_GT (after, 50) << "what needs no memory shows nothing";
        return;
      }
      EXPECT_TRUE (failed == 0 || contains (errors, "[pcl::" + name + "] Failed: not enough memory."));
    }
  };
  pcl::SymmetrySaliencyEstimation<PointT> estimation;
  pcl::PointCloud<pcl::Intensity> saliency (3, 1);
  expectErrors (estimation, saliency, [&] { return (estimation.compute (saliency)); }, "SymmetrySaliencyEstimation::compute");
  pcl::PlanarPatchExtraction<PointT> extraction;
  std::vector<pcl::PointIndices> patches (3);
  expectErrors (extraction, patches, [&] { return (extraction.extract (patches)); }, "PlanarPatchExtraction::extract");
}
