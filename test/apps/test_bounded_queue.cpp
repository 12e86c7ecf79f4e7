// SPDX-License-Identifier: BSD-3-Clause
#include "bounded_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

using pcl_attention::BoundedQueue;

TEST (BoundedQueue, keepsTheOrderAndItsBound)
{
  BoundedQueue<int> queue (2);
  std::atomic<int> ahead{0}, furthest{0};
  std::thread writer ([&] {
    for (int i = 0; i < 1000; ++i)
    {
      ASSERT_TRUE (queue.push (int{i}));
      const int now = ++ahead;
      furthest = std::max (furthest.load (), now);
    }
    queue.close ();
  });
  for (int i = 0; i < 1000; ++i)
  {
    const std::optional<int> item = queue.pop ();
    --ahead;
    ASSERT_EQ (item, i);
  }
  writer.join ();
  EXPECT_EQ (queue.pop (), std::nullopt);
  EXPECT_LE (furthest, 3); // two in the queue, and one on its way out
}

TEST (BoundedQueue, givesWhatIsLeftAfterClosing)
{
  BoundedQueue<int> queue (2);
  EXPECT_TRUE (queue.push (7));
  queue.close ();
  EXPECT_FALSE (queue.push (8));
  EXPECT_EQ (queue.pop (), 7);
  EXPECT_EQ (queue.pop (), std::nullopt);
}

TEST (BoundedQueue, closingFreesWhoWaits)
{
  BoundedQueue<int> full (1), empty (1);
  EXPECT_TRUE (full.push (1));
  EXPECT_TRUE (empty.waitForRoom ());
  std::thread writer ([&] { EXPECT_FALSE (full.push (2)); }), maker ([&] { EXPECT_FALSE (full.waitForRoom ()); }), reader ([&] { EXPECT_EQ (empty.pop (), std::nullopt); });
  full.close ();
  empty.close ();
  writer.join ();
  maker.join ();
  reader.join ();
}
