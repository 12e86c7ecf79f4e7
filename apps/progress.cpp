// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <cmath>
#include <iostream>
#include <unistd.h>

namespace pcl_attention
{

std::string
durationText (double seconds)
{
  const auto whole = static_cast<long long> (std::ceil (seconds));
  if (whole < 60)
    return (std::to_string (whole) + " s");
  if (whole < 3600)
    return (std::to_string (whole / 60) + " min " + std::to_string (whole % 60) + " s");
  return (std::to_string (whole / 3600) + " h " + std::to_string (whole % 3600 / 60) + " min");
}

Progress::Progress (std::size_t total) : total_ (total), is_terminal_ (isatty (STDERR_FILENO) != 0) {}

Progress::~Progress ()
{
  if (is_open_)
    std::cerr << std::endl;
}

void
Progress::finished (const std::string& scene)
{
  const std::lock_guard<std::mutex> lock (mutex_);
  ++done_;
  if (total_ < 2)
    return;
  const double elapsed = std::chrono::duration<double> (std::chrono::steady_clock::now () - start_).count ();
  const auto left = static_cast<double> (total_ - done_), done = static_cast<double> (done_);
  std::string text = "scene " + std::to_string (done_) + "/" + std::to_string (total_) + " " + scene;
  if (done_ < total_)
    text += ", " + durationText (elapsed / done * left) + " left";
  if (is_terminal_)
  {
    constexpr std::size_t width = 24;
    const std::size_t full = width * done_ / total_;
    // "\033[K" clears what a longer name has left
    std::cerr << "\r[" << std::string (full, '=') << std::string (width - full, ' ') << "] " << text << "\033[K";
  }
  else
    std::cerr << text << '\n';
  std::cerr << std::flush;
  is_open_ = is_terminal_;
}

} // namespace pcl_attention
