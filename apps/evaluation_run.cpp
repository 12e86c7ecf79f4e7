// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_run.h"

#include "overview_image.h"
#include "progress.h"
#include <pcl_attention/version.h>

#include <boost/crc.hpp>
#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace fs = std::filesystem;

namespace pcl_attention
{

namespace
{

using Json = nlohmann::ordered_json;

/** \brief CRC-32 of the files' names and contents. */
std::string
checksumOf (const std::vector<std::string>& files)
{
  boost::crc_32_type crc;
  std::vector<char> buffer (1 << 20);
  for (const std::string& file : files)
  {
    const std::string name = fs::path (file).filename ().string ();
    crc.process_bytes (name.data (), name.size () + 1);
    std::ifstream stream (file, std::ios::binary);
    while (stream)
    {
      stream.read (buffer.data (), static_cast<std::streamsize> (buffer.size ()));
      crc.process_bytes (buffer.data (), static_cast<std::size_t> (stream.gcount ()));
    }
  }
  char text[16];
  std::snprintf (text, sizeof (text), "%08x", static_cast<unsigned int> (crc.checksum ()));
  return (text);
}

std::string
checksumOf (const SceneSource& source, const EvaluatedSystem& system)
{
  std::vector<std::string> files = source.files ();
  if (system.inputs)
    for (const std::string& file : system.inputs (source.name))
      files.push_back (file);
  return (checksumOf (files));
}

/** \brief Half the size as often as it takes to be at most 400 pixels wide: the drawing's marks stay sharp. */
Image<Color>
reduced (Image<Color> image)
{
  while (image.width > 400 && image.height > 1)
  {
    Image<Color> half (image.width / 2, image.height / 2);
    for (int row = 0; row < half.height; ++row)
      for (int column = 0; column < half.width; ++column)
        for (std::size_t channel = 0; channel < 3; ++channel)
        {
          const auto value = [&] (int x, int y) { return (image (2 * column + x, 2 * row + y)[channel]); };
          half (column, row)[channel] =
              static_cast<std::uint8_t> ((value (0, 0) + value (1, 0) + value (0, 1) + value (1, 1) + 2) / 4);
        }
    image = std::move (half);
  }
  return (image);
}

std::string
pictureOf (const LabelledScene& labelled, const std::vector<AttentionSegment>& segments)
{
  Scene scene;
  scene.cloud.reset (new pcl::PointCloud<pcl::PointXYZRGB>);
  pcl::copyPointCloud (*labelled.cloud, *scene.cloud);
  scene.has_color = std::any_of (scene.cloud->begin (), scene.cloud->end (), [] (const pcl::PointXYZRGB& point) {
    return (point.r > 0 || point.g > 0 || point.b > 0);
  });
  const bool has_points = std::any_of (scene.cloud->begin (), scene.cloud->end (),
                                       [] (const pcl::PointXYZRGB& point) { return (pcl::isFinite (point)); });
  if (!scene.has_color && !has_points)
    return ("");
  return (encodePng (reduced (drawOverview (scene, segments))));
}

std::vector<AttentionSegment>
segmentsOf (const ScenePrediction& prediction)
{
  std::vector<AttentionSegment> segments;
  for (const PredictedSegment& predicted : prediction.segments)
  {
    if (predicted.column < 0)
      continue;
    segments.emplace_back ();
    segments.back ().rank = static_cast<int> (segments.size ());
    segments.back ().indices = predicted.mask;
    segments.back ().attention_point.column = predicted.column;
    segments.back ().attention_point.row = predicted.row;
  }
  return (segments);
}

/** \brief The regions as segments, each with its label for a number. */
std::vector<AttentionSegment>
segmentsOf (const GroundTruth& truth)
{
  std::vector<AttentionSegment> segments (truth.regions.size ());
  for (std::size_t region = 0; region < segments.size (); ++region)
  {
    segments[region].rank = static_cast<int> (truth.regions[region].label);
    segments[region].attention_point.column = truth.regions[region].center_column;
    segments[region].attention_point.row = truth.regions[region].center_row;
  }
  for (std::size_t pixel = 0; pixel < truth.region_of.size (); ++pixel)
    if (truth.region_of[pixel] >= 0)
      segments[truth.region_of[pixel]].indices.push_back (static_cast<pcl::index_t> (pixel));
  return (segments);
}

/** \brief The work on one evaluation: which results are there, and how another is made. */
class Evaluator
{
public:
  Evaluator (const std::vector<SceneSource>& sources, const std::vector<EvaluatedSystem>& systems,
             const std::vector<GroundTruthKind>& kinds, const EvaluationWork& work, const EvaluationStore* store)
      : sources_ (sources), systems_ (systems), kinds_ (kinds), work_ (work), store_ (store),
        results_ (systems.size (), std::vector<std::optional<SceneResult>> (sources.size ()))
  {
    if (store_)
      readStore ();
  }

  /** \brief Scenes of the shard for which a result is missing. */
  std::vector<std::size_t>
  missing () const
  {
    std::vector<std::size_t> scenes;
    for (std::size_t scene = 0; scene < sources_.size (); ++scene)
      if (isOurs (scene) &&
          std::any_of (results_.begin (), results_.end (), [&] (const auto& of_system) { return (!of_system[scene]); }))
        scenes.push_back (scene);
    return (scenes);
  }

  /** \brief Scenes of the shard. */
  std::size_t
  count () const
  {
    std::size_t scenes = 0;
    for (std::size_t scene = 0; scene < sources_.size (); ++scene)
      scenes += isOurs (scene);
    return (scenes);
  }

  void
  evaluate (std::size_t index)
  {
    const SceneSource& source = sources_[index];
    const LabelledScene scene = loadScene (source, work_.data);
    std::vector<GroundTruth> truths;
    for (const GroundTruthKind kind : kinds_)
      truths.push_back (makeGroundTruth (*scene.cloud, kind));
    if (store_ && work_.pictures)
      store_->writePicture ("", source.name, pictureOf (scene, segmentsOf (truths.front ())));
    for (std::size_t system = 0; system < systems_.size (); ++system)
      if (!results_[system][index])
        results_[system][index] = evaluate (source, scene, truths, systems_[system]);
  }

  /** \brief With what other shards have done in the meantime. */
  std::vector<std::vector<std::optional<SceneResult>>>
  takeResults ()
  {
    for (std::size_t system = 0; store_ && system < systems_.size (); ++system)
      for (std::size_t scene = 0; scene < sources_.size (); ++scene)
        if (!results_[system][scene])
          results_[system][scene] = store_->read (systems_[system].name, sources_[scene].name);
    return (std::move (results_));
  }

private:
  bool
  isOurs (std::size_t scene) const
  {
    return (scene % work_.shards == work_.shard - 1);
  }

  /** \brief Of the shard; what others have done they have checked. */
  void
  readStore ()
  {
    for (std::size_t system = 0; system < systems_.size (); ++system)
      for (std::size_t scene = 0; scene < sources_.size (); ++scene)
      {
        if (!isOurs (scene))
          continue;
        std::optional<SceneResult>& result = results_[system][scene];
        result = store_->read (systems_[system].name, sources_[scene].name);
        if (result && result->checksum != checksumOf (sources_[scene], systems_[system]))
          throw std::runtime_error (sources_[scene].points + ": has changed since " + systems_[system].name +
                                    " was evaluated on it. Take another -output_dir, or remove that one");
      }
  }

  SceneResult
  evaluate (const SceneSource& source, const LabelledScene& scene, const std::vector<GroundTruth>& truths,
            const EvaluatedSystem& system) const
  {
    const unsigned int processors = std::max (1u, std::thread::hardware_concurrency ());
    const unsigned int threads = work_.threads == 0 ? std::max (1u, processors / work_.jobs) : work_.threads;
    const SystemOutput output = system.run (scene, threads);
    SceneResult result;
    for (const GroundTruth& truth : truths)
    {
      result.scores.push_back (scoreScene (truth, output.prediction));
      result.scores.back ().name = scene.name;
      result.scores.back ().category = scene.category;
    }
    result.milliseconds = output.milliseconds;
    if (!store_)
      return (result);
    result.checksum = checksumOf (source, system);
    if (work_.pictures && system.swept.empty ())
      store_->writePicture (system.name, source.name, pictureOf (scene, segmentsOf (output.prediction)));
    store_->write (system.name, source.name, result);
    return (result);
  }

  const std::vector<SceneSource>& sources_;
  const std::vector<EvaluatedSystem>& systems_;
  const std::vector<GroundTruthKind>& kinds_;
  const EvaluationWork& work_;
  const EvaluationStore* store_;
  std::vector<std::vector<std::optional<SceneResult>>> results_;
};

} // namespace

Json
describeEvaluation (const std::vector<SceneSource>& sources, const DataSetOptions& data,
                    const std::vector<EvaluatedSystem>& systems, const std::vector<GroundTruthKind>& kinds)
{
  Json description{{"version", PCL_ATTENTION_VERSION}};
  for (const GroundTruthKind kind : kinds)
    description["ground_truth"].push_back (toString (kind));
  for (const EvaluatedSystem& system : systems)
    description["systems"].push_back ({{"name", system.name},
                                       {"note", system.note},
                                       {"swept", system.swept},
                                       {"theta_com", system.theta_com},
                                       {"parameters", system.parameters}});
  const DepthCamera& camera = data.scene.camera;
  if (camera.isKnown ())
    description["camera"] = {camera.fx, camera.fy, camera.cx, camera.cy, camera.depth_scale};
  if (std::isfinite (data.scene.max_range))
    description["max_range"] = data.scene.max_range;
  for (const SceneSource& source : sources)
  {
    std::uintmax_t bytes = 0;
    for (const std::string& file : source.files ())
      bytes += fs::file_size (file);
    description["scenes"].push_back ({{"name", source.name}, {"category", source.category}, {"bytes", bytes}});
    if (!source.labels.empty ())
      description["scenes"].back ()["support_labels"] = source.support_labels;
  }
  return (description);
}

std::vector<std::vector<std::optional<SceneResult>>>
evaluateScenes (const std::vector<SceneSource>& sources, const std::vector<EvaluatedSystem>& systems,
                const std::vector<GroundTruthKind>& kinds, const EvaluationWork& work, const EvaluationStore* store)
{
  Evaluator evaluator (sources, systems, kinds, work, store);
  const std::vector<std::size_t> scenes = evaluator.missing ();
  if (scenes.size () < evaluator.count ())
    std::cerr << evaluator.count () - scenes.size () << " of " << evaluator.count () << " scenes are there already\n";

  Progress progress (scenes.size ());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;
  const auto workOff = [&] {
    for (std::size_t at = next++; at < scenes.size (); at = next++)
      try
      {
        evaluator.evaluate (scenes[at]);
        progress.finished (sources[scenes[at]].name);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock (mutex);
        if (!error)
          error = std::current_exception ();
        next = scenes.size ();
      }
  };
  std::vector<std::thread> others;
  for (unsigned int job = 1; job < work.jobs; ++job)
    others.emplace_back (workOff);
  workOff ();
  for (std::thread& other : others)
    other.join ();
  if (error)
    std::rethrow_exception (error);
  return (evaluator.takeResults ());
}

} // namespace pcl_attention
