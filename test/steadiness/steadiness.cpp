// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "scene_renderer.h"

#include <pcl/common/io.h>
#include <pcl/segmentation/attention_segmentation.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>

// The frames of a still camera: does an object's segment stay the same when only the noise differs?

namespace
{

using namespace pcl_attention;
using LabelledCloud = pcl::PointCloud<pcl::PointXYZRGBL>;
using Mask = std::vector<bool>;

/** \brief What was seen of a scene with one seed of the noise. */
struct Frame
{
  LabelledCloud::Ptr cloud;
  std::vector<Mask> segments;
};

Frame
see (const SceneDescription& scene, std::uint64_t noise_seed, pcl::AttentionSegmentation<pcl::PointXYZRGB>& segmentation)
{
  Frame frame;
  frame.cloud = renderScene (scene, noise_seed);
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
  pcl::copyPointCloud (*frame.cloud, *cloud);
  segmentation.setInputCloud (cloud);
  std::vector<pcl::AttentionSegment> segments;
  if (!segmentation.segment (segments))
    throw std::runtime_error ("a scene could not be segmented, see above");
  for (const pcl::AttentionSegment& segment : segments)
  {
    frame.segments.emplace_back (cloud->size (), false);
    for (const pcl::index_t index : segment.indices)
      frame.segments.back ()[static_cast<std::size_t> (index)] = true;
  }
  return (frame);
}

/** \brief Visible pixels of every object. */
std::map<std::uint32_t, Mask>
objectsOf (const LabelledCloud& cloud)
{
  std::map<std::uint32_t, Mask> objects;
  for (std::size_t index = 0; index < cloud.size (); ++index)
    if (cloud[index].label >= scene_label::first_object)
      objects.try_emplace (cloud[index].label / 10, cloud.size (), false).first->second[index] = true;
  return (objects);
}

/** \brief Intersection over union, among the points that are valid in both frames. */
double
overlap (const Mask& a, const Mask& b, const Mask& valid)
{
  std::size_t common = 0, united = 0;
  for (std::size_t index = 0; index < valid.size (); ++index)
  {
    common += valid[index] && a[index] && b[index];
    united += valid[index] && (a[index] || b[index]);
  }
  return (united > 0 ? static_cast<double> (common) / static_cast<double> (united) : 0.0);
}

/** \brief The segment that overlaps an object most. */
const Mask*
segmentOf (const Mask& object, const Frame& frame)
{
  const Mask everywhere (object.size (), true), *best = nullptr;
  double most = 0.0;
  for (const Mask& segment : frame.segments)
  {
    const double share = overlap (object, segment, everywhere);
    if (share > most)
    {
      most = share;
      best = &segment;
    }
  }
  return (best);
}

int
measure (int scenes, int seeds, const SensorNoise& noise, unsigned int threads, bool verbose, double least_share)
{
  constexpr SceneKind kinds[] = {SceneKind::clutter,  SceneKind::boxes,     SceneKind::stacked,
                                 SceneKind::occluded, SceneKind::cylinders, SceneKind::separate};
  constexpr double same = 0.8;
  constexpr std::ptrdiff_t smallest = 300; // pixels: of fewer the overlap is a matter of the contour
  pcl::AttentionSegmentation<pcl::PointXYZRGB> segmentation;
  segmentation.setNumberOfThreads (threads);
  int objects = 0, steady = 0, pairs = 0, kept = 0;
  for (int k = 0; k < scenes; ++k)
  {
    const SceneKind kind = kinds[static_cast<std::size_t> (k) % std::size (kinds)];
    SceneDescription scene = makeScene (kind, 1000 + static_cast<std::uint64_t> (k));
    scene.noise = noise;
    std::vector<Frame> frames;
    for (int seed = 0; seed < seeds; ++seed)
      frames.push_back (see (scene, static_cast<std::uint64_t> (seed), segmentation));
    for (const auto& [label, object] : objectsOf (*frames.front ().cloud))
    {
      if (std::count (object.begin (), object.end (), true) < smallest)
        continue;
      std::vector<const Mask*> segments;
      for (const Frame& frame : frames)
        segments.push_back (segmentOf (object, frame));
      int kept_here = 0, pairs_here = 0;
      for (std::size_t a = 0; a < frames.size (); ++a)
        for (std::size_t b = a + 1; b < frames.size (); ++b)
        {
          Mask valid (object.size ());
          for (std::size_t index = 0; index < valid.size (); ++index)
            valid[index] = frames[a].cloud->points[index].label > 0 && frames[b].cloud->points[index].label > 0;
          ++pairs_here;
          kept_here += segments[a] && segments[b] && overlap (*segments[a], *segments[b], valid) >= same;
        }
      ++objects;
      steady += kept_here == pairs_here;
      pairs += pairs_here;
      kept += kept_here;
      if (verbose && kept_here < pairs_here)
        std::cout << sceneKindName (kind) << " " << 1000 + k << " object " << label << ": " << kept_here << " of " << pairs_here << "\n";
    }
  }
  const double share = pairs > 0 ? static_cast<double> (kept) / pairs : 0.0;
  std::cout << scenes << " scenes, " << seeds << " seeds of the noise of level " << noise.level << ", " << objects << " objects\n"
            << "segments with IoU >= " << same << " between two seeds: " << kept << " of " << pairs << ", " << share << "\n"
            << "objects with such segments between all seeds: " << steady << ", " << static_cast<double> (steady) / std::max (1, objects)
            << std::endl;
  return (share >= least_share ? EXIT_SUCCESS : EXIT_FAILURE);
}

} // namespace

int
main (int argc, char** argv)
{
  namespace po = boost::program_options;
  CommandLine command_line ("pcl_attention_steadiness [flags]",
                            "Segments rendered scenes several times, with other noise each time. Exit code 1 if too few objects keep "
                            "their segment.\n");
  // clang-format off
  command_line.addOptions ()
    ("scenes", po::value<int> ()->default_value (200), "scenes")
    ("seeds", po::value<int> ()->default_value (5), "seeds of the noise for each scene, 2 or more")
    ("sensor", po::value<std::string> ()->default_value ("kinect"), "whose noise: kinect or stereo")
    ("noise", po::value<double> ()->default_value (1.0), "level of the noise: 0 = exact, 1 = the sensor's own, up to 3")
    ("verbose", "name the objects that change")
    ("least", po::value<double> ()->default_value (0.9), "share that has to keep its segment, 0 to 1");
  // clang-format on
  addThreadsFlag (command_line);
  command_line.parse (argc, argv);
  const int scenes = command_line.get<int> ("scenes"), seeds = command_line.get<int> ("seeds");
  if (scenes < 1 || seeds < 2)
    command_line.fail ("-scenes must be 1 or more, -seeds 2 or more");
  const auto sensor = sceneSensorFromName (command_line.get<std::string> ("sensor"));
  if (!sensor)
    command_line.fail ("no sensor '" + command_line.get<std::string> ("sensor") + "', -sensor takes kinect or stereo");
  SensorNoise noise;
  noise.sensor = *sensor;
  noise.level = command_line.get<double> ("noise");
  try
  {
    return (measure (scenes, seeds, noise, threadsFromFlag (command_line), command_line.has ("verbose"),
                     command_line.get<double> ("least")));
  }
  catch (const std::exception& error)
  {
    std::cerr << "pcl_attention_steadiness: " << error.what () << std::endl;
    return (EXIT_FAILURE);
  }
}
