// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewer_scene.h"
#include <pcl_attention/core/pipeline.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace pcl_attention
{

/** \brief What is to be computed next. */
struct AttentionRequest
{
  std::function<ViewerScenePtr ()>
      load; /**< reads another scene first, on the worker's thread; may throw; empty: none */
  AttentionParameters parameters;
  ViewerScenePtr scene;                   /**< that the user's fixations lie in: in another one they are left out */
  std::vector<AttentionPoint> own_points; /**< the user's fixations */
};

/** \brief What is known of a scene, as it stands; never changed once it is published. Stages that have not run are
 * null. */
struct AttentionResults
{
  ViewerScenePtr scene;
  AttentionParameters parameters; /**< that it was computed with */
  std::shared_ptr<const NormalImage> normals;
  std::shared_ptr<const SaliencyMaps> saliency;
  std::shared_ptr<const Image<float>> image_saliency; /**< only where the fixations come from it */
  std::shared_ptr<const AttentionPoints> attention_points;
  std::shared_ptr<const PlanarPatches> patches;
  std::shared_ptr<const PatchGraph> patch_graph;
  std::vector<SupportingPlane> supporting_planes;
  std::vector<AttentionSegment> segments; /**< in order of attention, ranks 1, 2, ... */
  std::vector<AttentionSegment>
      own_segments;           /**< one per own point, of the ranks after those; empty where nothing was found */
  std::vector<double> scores; /**< F of each of segments, then of own_segments; empty without labels */
  StageTimes times;           /**< of every stage when it last ran */
  double milliseconds{0.0};   /**< wall time of this request so far, without reading the scene */
  int request{0};             /**< number of the request that it answers, from 1 */
  bool complete{false};       /**< nothing of the request is left to do */
  std::string error;          /**< why there is nothing, or nothing more; empty: all is well */
};

using AttentionResultsPtr = std::shared_ptr<const AttentionResults>;

/** \brief Runs the method on a thread of its own, so that a window stays alive. Of several requests that wait only the
 * newest is computed; one that runs is finished first, unless another scene is asked for. */
class AttentionWorker
{
public:
  /** \param[in] threads number of threads of the stages, 0 for all processors */
  explicit AttentionWorker (unsigned int threads = 0);

  /** \brief Gives up what runs at the next stage or segment, and waits for that. */
  ~AttentionWorker ();

  AttentionWorker (const AttentionWorker&) = delete;
  AttentionWorker& operator= (const AttentionWorker&) = delete;

  /** \return number of the request, from 1 */
  int submit (AttentionRequest&& request);

  /** \brief The newest results; null before there are any. */
  AttentionResultsPtr results () const;

  /** \brief Whether something is being computed or waits for it. */
  bool isBusy () const;

  /** \brief Wait until there is nothing left to do.
   * \return the newest results */
  AttentionResultsPtr wait ();

private:
  void run ();
  void answer (const AttentionRequest& request, AttentionResults& results);
  void findObjects (const AttentionRequest& request, AttentionResults& results);
  void publish (AttentionResults& results);

  const int threads_;
  AttentionPipeline pipeline_; /**< of the worker's thread alone, as what follows */
  AttentionResults last_;      /**< what the pipeline's results were published as */
  bool started_{false};        /**< whether the pipeline holds last_.scene */
  bool finished_{false};       /**< whether last_.segments are all of them */
  std::chrono::steady_clock::time_point begin_;

  mutable std::mutex mutex_; /**< of what follows */
  std::condition_variable changed_;
  std::optional<AttentionRequest> waiting_;
  AttentionResultsPtr results_;
  int submitted_{0};
  bool busy_{false}, ends_{false};
  std::atomic<bool> cancelled_{false};
  std::thread thread_;
};

} // namespace pcl_attention
