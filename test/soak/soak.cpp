// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "scene_renderer.h"

#include <pcl/common/io.h>
#include <pcl/segmentation/attention_segmentation.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <limits>
#include <unistd.h>

// Days of a robot in minutes: many frames of changing size through one AttentionSegmentation.

namespace
{

using namespace pcl_attention;
using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;

/** \brief Rendered scenes of all kinds and several sizes; every tenth is black, every 25th has no valid point. */
std::vector<Cloud::ConstPtr>
renderFrames (int count)
{
  constexpr std::pair<int, int> sizes[] = {{160, 120}, {240, 180}, {320, 240}, {199, 151}, {320, 180}, {120, 160}};
  const std::vector<SceneKind>& kinds = allSceneKinds ();
  std::vector<Cloud::ConstPtr> frames;
  for (int k = 0; k < count; ++k)
  {
    SceneDescription scene = makeScene (kinds[k % kinds.size ()], static_cast<std::uint64_t> (k));
    const auto& [columns, rows] = sizes[k % std::size (sizes)];
    scene.camera = scene.camera.resized (columns, rows);
    scene.world_frame = k % 2 == 1;
    const Cloud::Ptr frame (new Cloud);
    pcl::copyPointCloud (*renderScene (scene, static_cast<std::uint64_t> (k)), *frame);
    for (pcl::PointXYZRGB& point : *frame)
    {
      if (k % 10 == 5)
        point.r = point.g = point.b = 0;
      if (k % 25 == 12)
        point.x = point.y = point.z = std::numeric_limits<float>::quiet_NaN ();
    }
    frames.push_back (frame);
  }
  return (frames);
}

/** \brief A number that differs as soon as one bit of the results does (FNV-1a). */
class Digest
{
public:
  void
  add (const void* data, std::size_t size)
  {
    for (const auto* byte = static_cast<const unsigned char*> (data); size > 0; ++byte, --size)
      value_ = (value_ ^ *byte) * 1099511628211u;
  }

  std::uint64_t
  value () const { return (value_); }

private:
  std::uint64_t value_{14695981039346656037u};
};

std::uint64_t
segmentFrame (pcl::AttentionSegmentation<pcl::PointXYZRGB>& segmentation, const Cloud::ConstPtr& frame)
{
  segmentation.setInputCloud (frame);
  std::vector<pcl::AttentionSegment> segments;
  if (!segmentation.segment (segments))
    throw std::runtime_error ("a frame could not be segmented, see above");
  Digest digest;
  for (const pcl::AttentionSegment& segment : segments)
  {
    digest.add (segment.indices.data (), segment.indices.size () * sizeof (pcl::index_t));
    digest.add (&segment.attention_point.column, sizeof (int));
    digest.add (&segment.attention_point.row, sizeof (int));
    digest.add (segment.plane.data (), 4 * sizeof (float));
    digest.add (segment.box.size.data (), 3 * sizeof (float));
    digest.add (&segment.confidence, sizeof (float));
  }
  return (digest.value ());
}

/** \brief Memory of this process that is in use, MB. */
double
residentMemory ()
{
  std::ifstream stream ("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  stream >> all >> resident;
  return (resident * static_cast<double> (sysconf (_SC_PAGESIZE)) / (1024.0 * 1024.0));
}

int
soak (int scenes, int cycles, unsigned int threads, double most_growth)
{
  using Clock = std::chrono::steady_clock;
  const std::vector<Cloud::ConstPtr> frames = renderFrames (scenes);
  pcl::AttentionSegmentation<pcl::PointXYZRGB> segmentation;
  segmentation.setNumberOfThreads (threads);
  std::vector<std::uint64_t> first (frames.size ());
  std::vector<double> seconds (static_cast<std::size_t> (cycles), 0.0);
  double memory = 0.0, growth = 0.0;
  std::size_t different = 0;
  for (int cycle = 0; cycle < cycles; ++cycle)
  {
    const auto start = Clock::now ();
    for (std::size_t k = 0; k < frames.size (); ++k)
    {
      const std::uint64_t digest = segmentFrame (segmentation, frames[k]);
      different += cycle > 0 && digest != first[k];
      if (cycle == 0)
        first[k] = digest;
    }
    seconds[static_cast<std::size_t> (cycle)] = std::chrono::duration<double> (Clock::now () - start).count ();
    if (cycle == 0)
      memory = residentMemory ();
    growth = std::max (growth, residentMemory () - memory);
  }
  // Last, as what these objects take and leave is not the one's.
  std::size_t sample = 0;
  for (std::size_t k = 0; k < frames.size (); k += 7, ++sample)
  {
    pcl::AttentionSegmentation<pcl::PointXYZRGB> fresh;
    fresh.setNumberOfThreads (threads);
    different += segmentFrame (fresh, frames[k]) != first[k];
  }

  std::cout << frames.size () * static_cast<std::size_t> (cycles) << " frames, " << cycles << " cycles of " << frames.size ()
            << " scenes\n"
            << "memory after the first cycle " << memory << " MB, growth from there " << growth << " MB\n"
            << "time of the last cycle over that of the second " << seconds.back () / seconds[1] << ", " << seconds[1]
            << " s that one\n"
            << different << " results that differ from the first cycle's, or from a fresh object's in a sample of " << sample
            << std::endl;
  return (growth <= most_growth && different == 0 ? EXIT_SUCCESS : EXIT_FAILURE);
}

} // namespace

int
main (int argc, char** argv)
{
  namespace po = boost::program_options;
  CommandLine command_line ("pcl_attention_soak [flags]",
                            "Sends rendered scenes through one AttentionSegmentation again and again. Exit code 1 if memory grows "
                            "or results change.\n");
  // clang-format off
  command_line.addOptions ()
    ("scenes", po::value<int> ()->default_value (200), "scenes of a cycle")
    ("cycles", po::value<int> ()->default_value (100), "times that all of them are segmented, 2 or more")
    ("max_growth", po::value<double> ()->default_value (1.0), "resident memory may grow by this after the first cycle, MB");
  // clang-format on
  addThreadsFlag (command_line);
  command_line.parse (argc, argv);
  const int scenes = command_line.get<int> ("scenes"), cycles = command_line.get<int> ("cycles");
  if (scenes < 1 || cycles < 2)
    command_line.fail ("-scenes must be 1 or more, -cycles 2 or more");
  try
  {
    return (soak (scenes, cycles, threadsFromFlag (command_line), command_line.get<double> ("max_growth")));
  }
  catch (const std::exception& error)
  {
    std::cerr << "pcl_attention_soak: " << error.what () << std::endl;
    return (EXIT_FAILURE);
  }
}
