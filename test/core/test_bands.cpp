// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/bands.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace pcl_attention;

TEST (Bands, CoverEveryRowOnceForAnyNumberOfThreads)
{
  for (const int threads : {0, 1, 2, 5})
    for (const bool in_a_team : {false, true})
    {
      std::vector<std::atomic<int>> visits (23);
      const auto visitAll = [&] {
        forEachBand (23, 4, threads, [&] (int begin, int end) {
          EXPECT_EQ (begin % 4, 0);
          EXPECT_EQ (end, std::min (begin + 4, 23));
          for (int row = begin; row < end; ++row)
            ++visits[row];
        });
      };
      if (in_a_team)
        forEachBand (1, 1, 3, [&] (int, int) { visitAll (); });
      else
        visitAll ();
      for (const std::atomic<int>& visit : visits)
        EXPECT_EQ (visit, 1);
    }
  forEachBand (0, 4, 2, [] (int, int) { ADD_FAILURE () << "there is no row"; });
}

TEST (Bands, ComeInOrderInATeam)
{
  // Whoever gives the largest piece of work the first band relies on it. The team's other thread is kept away.
  std::vector<int> order;
  std::atomic<bool> is_done{false};
  forEachBand (2, 1, 2, [&] (int place, int) {
    if (place == 0)
    {
      forEachBand (10, 3, 1, [&order] (int begin, int) { order.push_back (begin); });
      is_done = true;
    }
    while (!is_done)
      std::this_thread::yield ();
  });
  EXPECT_EQ (order, (std::vector<int>{0, 3, 6, 9}));
}

TEST (Bands, ThrowWhatABandThrowsWhenAllAreDone)
{
  for (const int threads : {1, 3})
  {
    std::atomic<int> done{0};
    const auto work = [&] (int begin, int) {
      ++done;
      if (begin == 2)
        throw std::runtime_error ("the third");
    };
    EXPECT_THROW (forEachBand (8, 1, threads, work), std::runtime_error);
    EXPECT_EQ (done, 8);
  }
}
