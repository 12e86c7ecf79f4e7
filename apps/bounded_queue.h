// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <queue>
#include <utility>

namespace pcl_attention
{

/** \brief Hands items from one thread to the next, in order, and makes the first wait when it is too far ahead. */
template <typename T> class BoundedQueue
{
public:
  explicit BoundedQueue (std::size_t capacity) : capacity_ (capacity) {}

  /** \brief Wait for room, then append.
   * \return false when the queue is closed: nobody wants the item */
  bool
  push (T&& item)
  {
    std::unique_lock<std::mutex> lock (mutex_);
    changed_.wait (lock, [this] { return (closed_ || items_.size () < capacity_); });
    if (closed_)
      return (false);
    items_.push (std::move (item));
    changed_.notify_all ();
    return (true);
  }

  /** \brief Wait until \ref push would not wait: to make an item only when there is room for it.
   * \return false when the queue is closed */
  bool
  waitForRoom ()
  {
    std::unique_lock<std::mutex> lock (mutex_);
    changed_.wait (lock, [this] { return (closed_ || items_.size () < capacity_); });
    return (!closed_);
  }

  /** \brief Wait for an item.
   * \return nothing when the queue is closed and empty */
  std::optional<T>
  pop ()
  {
    std::unique_lock<std::mutex> lock (mutex_);
    changed_.wait (lock, [this] { return (closed_ || !items_.empty ()); });
    if (items_.empty ())
      return (std::nullopt);
    std::optional<T> item (std::move (items_.front ()));
    items_.pop ();
    changed_.notify_all ();
    return (item);
  }

  /** \brief No more items are taken; what is in the queue can still be popped. */
  void
  close ()
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    closed_ = true;
    changed_.notify_all ();
  }

private:
  const std::size_t capacity_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::queue<T> items_;
  bool closed_{false};
};

} // namespace pcl_attention
