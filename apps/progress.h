// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace pcl_attention
{

/** \brief "1 h 5 min", "3 min 20 s" or "4 s". */
std::string durationText (double seconds);

/** \brief How far a work of several scenes is, on stderr: on a terminal a bar that is overwritten, else a line each. */
class Progress
{
public:
  /** \param[in] total scenes to do; with one there is nothing to see */
  explicit Progress (std::size_t total);
  ~Progress ();
  Progress (const Progress&) = delete;
  Progress& operator= (const Progress&) = delete;

  /** \brief One more scene is done; may be called from several threads. */
  void finished (const std::string& scene);

private:
  std::mutex mutex_;
  std::size_t total_, done_{0};
  bool is_terminal_, is_open_{false};
  std::chrono::steady_clock::time_point start_{std::chrono::steady_clock::now ()};
};

} // namespace pcl_attention
