// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bounded_queue.h"
#include "scene_segmentation.h"

#include <exception>
#include <memory>
#include <thread>

namespace pcl_attention
{

/** \brief Scenes read and segmented ahead in threads of their own: while the caller writes one, the next is segmented and
 * the one after it is read, and no more, so that memory does not grow with their number. */
class SceneStream
{
public:
  struct Item
  {
    std::unique_ptr<Scene> scene; /**< null if it could not be read */
    SceneSegments result;
    std::exception_ptr error; /**< why it could not be read or segmented */
  };

  /** \param[in] scene_options see \ref readScene
   * \param[in] prior,threads see \ref segmentScene */
  SceneStream (const std::vector<std::string>& paths, const SceneOptions& scene_options, const AttentionParameters& parameters,
               const NamedPrior& prior, unsigned int threads);

  /** \brief Gives up what is not yet read and waits for the scene in work. */
  ~SceneStream ();

  SceneStream (const SceneStream&) = delete;
  SceneStream& operator= (const SceneStream&) = delete;

  /** \brief The next scene in the order of the paths; there are as many as paths. */
  Item next ();

private:
  BoundedQueue<Item> read_{1}, segmented_{1};
  std::thread reader_, segmenter_;
};

} // namespace pcl_attention
