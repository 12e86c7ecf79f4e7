// SPDX-License-Identifier: BSD-3-Clause
#include "attention_worker.h"

#include "evaluation/metrics.h"
#include "evaluation/prediction_of_segments.h"
#include <pcl_attention/core/parameters.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace pcl_attention
{

namespace
{

/** \brief Thrown where a request is given up. */
struct Cancelled
{
};

bool
sameParameters (const AttentionParameters& a, const AttentionParameters& b)
{
  const std::vector<ParameterDescription>& table = parameterTable ();
  return (std::all_of (table.begin (), table.end (),
                       [&] (const ParameterDescription& row) { return (row.get (a) == row.get (b)); }));
}

/** \brief F of every segment against the object that its fixation lies on; 0 on none. */
std::vector<double>
scoreSegments (const ViewerScene& scene, std::vector<AttentionSegment> segments)
{
  std::vector<double> scores;
  if (!scene.truth)
    return (scores);
  const SceneScore score =
      scoreScene (*scene.truth, predictionOfSegments (scene.cloud.width, scene.cloud.height, segments));
  for (const SegmentScore& segment : score.segments)
    scores.push_back (segment.overlap.f);
  return (scores);
}

} // namespace

AttentionWorker::AttentionWorker (unsigned int threads)
    : threads_ (static_cast<int> (threads)), thread_ ([this] { run (); })
{
}

AttentionWorker::~AttentionWorker ()
{
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    ends_ = true;
    cancelled_ = true;
  }
  changed_.notify_all ();
  thread_.join ();
}

int
AttentionWorker::submit (AttentionRequest&& request)
{
  const std::lock_guard<std::mutex> lock (mutex_);
  if (request.load)
    cancelled_ = true;
  else if (waiting_ && waiting_->load)
    request.load = waiting_->load; // the scene that was asked for is still to be read
  waiting_ = std::move (request);
  changed_.notify_all ();
  return (++submitted_);
}

AttentionResultsPtr
AttentionWorker::results () const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return (results_);
}

bool
AttentionWorker::isBusy () const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return (busy_ || waiting_);
}

AttentionResultsPtr
AttentionWorker::wait ()
{
  std::unique_lock<std::mutex> lock (mutex_);
  changed_.wait (lock, [this] { return (!busy_ && !waiting_); });
  return (results_);
}

void
AttentionWorker::run ()
{
  std::unique_lock<std::mutex> lock (mutex_);
  while (true)
  {
    changed_.wait (lock, [this] { return (waiting_ || ends_); });
    if (ends_)
      return;
    const AttentionRequest request = std::move (*waiting_);
    waiting_.reset ();
    busy_ = true;
    cancelled_ = false;
    AttentionResults results;
    results.request = submitted_;
    lock.unlock ();
    bool failed = true;
    try
    {
      answer (request, results);
      failed = false;
    }
    catch (const Cancelled&)
    {
      failed = false;
    }
    catch (const std::bad_alloc&)
    {
      results.error = "not enough memory";
    }
    catch (const std::exception& error)
    {
      results.error = error.what ();
    }
    if (failed)
    {
      started_ = finished_ = false;
      results.complete = true;
      publish (results);
    }
    lock.lock ();
    busy_ = false;
    changed_.notify_all ();
  }
}

void
AttentionWorker::publish (AttentionResults& results)
{
  results.milliseconds =
      std::chrono::duration<double, std::milli> (std::chrono::steady_clock::now () - begin_).count ();
  const auto copy = std::make_shared<const AttentionResults> (results);
  const std::lock_guard<std::mutex> lock (mutex_);
  results_ = copy;
}

void
AttentionWorker::answer (const AttentionRequest& request, AttentionResults& results)
{
  begin_ = std::chrono::steady_clock::now ();
  results.scene = last_.scene;
  bool same_frame = started_;
  if (request.load)
    try
    {
      results.scene = request.load ();
      same_frame = false;
      begin_ = std::chrono::steady_clock::now ();
    }
    catch (const std::exception& error)
    {
      // The scene before it stays.
      results.error = error.what ();
    }
  if (!results.scene)
    throw std::runtime_error (results.error.empty () ? "no scene" : results.error);
  results.parameters = request.parameters;

  if (same_frame && finished_ && sameParameters (request.parameters, last_.parameters))
  {
    // Only the user's own fixations have changed.
    const AttentionResults asked = results;
    results = last_;
    results.request = asked.request;
    results.error = asked.error;
    results.complete = false;
  }
  else
  {
    finished_ = false;
    if (same_frame)
      pipeline_.changeParameters (request.parameters);
    else
    {
      last_ = AttentionResults ();
      last_.scene = results.scene;
      started_ = true;
      pipeline_.start (OrganizedCloud (results.scene->cloud), results.scene->sensor_pose, request.parameters, threads_);
      publish (results);
    }
    findObjects (request, results);
    finished_ = true;
  }

  results.own_segments.clear ();
  int rank = static_cast<int> (results.segments.size ());
  std::vector<AttentionSegment> all = results.segments;
  const bool fixations_apply = request.scene == results.scene;
  for (const AttentionPoint& point : fixations_apply ? request.own_points : std::vector<AttentionPoint> ())
  {
    AttentionSegment segment;
    if (pipeline_.segmentAt (point, segment))
      segment.rank = ++rank;
    segment.attention_point = point;
    all.push_back (segment);
    results.own_segments.push_back (std::move (segment));
  }
  results.scores = scoreSegments (*results.scene, std::move (all));
  results.times = pipeline_.times ();
  results.complete = true;
  last_ = results;
  publish (results);
}

void
AttentionWorker::findObjects (const AttentionRequest& request, AttentionResults& results)
{
  // A stage that was kept has its time; what was published of it is still right.
  const StageTimes kept = pipeline_.times ();
  const auto checkpoint = [&] {
    results.times = pipeline_.times ();
    if (cancelled_)
      throw Cancelled ();
    publish (results);
  };
  const auto stage = [&] (auto& published, auto& before, bool is_kept, const auto& compute) {
    using Value = typename std::decay_t<decltype (published)>::element_type;
    if (is_kept && before)
      published = before;
    else
    {
      published = std::make_shared<Value> (compute ());
      before = published; // the pipeline keeps it even if the request is given up here
      checkpoint ();
    }
  };
  stage (results.normals, last_.normals, kept.normals > 0.0,
         [&] () -> const NormalImage& { return (pipeline_.normals ()); });
  stage (results.saliency, last_.saliency, kept.saliency > 0.0,
         [&] () -> const SaliencyMaps& { return (pipeline_.saliency ()); });
  if (request.parameters.attention_points.strategy == AttentionStrategy::image_winner_take_all)
    results.image_saliency = std::make_shared<Image<float>> (pipeline_.imageSaliency ());
  stage (results.attention_points, last_.attention_points, kept.attention_points > 0.0,
         [&] () -> const AttentionPoints& { return (pipeline_.attentionPoints ()); });
  stage (results.patches, last_.patches, kept.patches > 0.0, [&] () -> const PlanarPatches& {
    const PlanarPatches& patches = pipeline_.patches ();
    results.supporting_planes = pipeline_.supportingPlanes ();
    last_.patch_graph.reset (); // of the patches before
    return (patches);
  });
  stage (results.patch_graph, last_.patch_graph, kept.patches > 0.0,
         [&] () -> const PatchGraph& { return (pipeline_.patchGraph ()); });
  results.supporting_planes = pipeline_.supportingPlanes ();
  last_.parameters = request.parameters;

  AttentionSegment segment;
  while (pipeline_.next (segment))
  {
    results.segments.push_back (std::move (segment));
    if (cancelled_)
      throw Cancelled ();
  }
}

} // namespace pcl_attention
