// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewer_scene.h"

#include <pcl/io/grabber.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief What reads or makes a scene, on any thread. It throws std::runtime_error of one line where it cannot. */
using SceneLoader = std::function<ViewerScenePtr ()>;

/** \brief The scenes that the viewer was opened with: one after the other at the user's pace, or played through
 * pcl::Grabber's interface, from files or from a camera. */
class SceneSequence
{
public:
  /** \brief Files that \ref readScene takes. No file at all stands for the rendered scene.
   * \param[in] frame_rate frames per second when playing */
  SceneSequence (const std::vector<std::string>& files, const SceneOptions& options, float frame_rate);

  /** \brief A camera.
   * \param[in] grabber that gives clouds of pcl::PointXYZRGBA
   * \param[in] name of what it sees
   * \param[in] max_range see \ref SceneOptions */
  SceneSequence (std::unique_ptr<pcl::Grabber> grabber, const std::string& name, float max_range);

  ~SceneSequence ();

  /** \brief How many scenes there are; 0 for a camera. */
  std::size_t
  size () const
  {
    return (loaders_.size ());
  }

  /** \brief Which one is shown, from 0. */
  std::size_t
  current () const
  {
    return (current_);
  }

  /** \brief Go to the next or previous one, at the ends on to the other end.
   * \return what reads it */
  SceneLoader move (int direction);

  /** \brief Start or stop playing, from the first scene on.
   * \throws std::runtime_error where there is nothing to play */
  void play (bool on);

  bool
  isPlaying () const
  {
    return (grabber_ && grabber_->isRunning ());
  }

  /** \brief Take the newest frame. Those that came before it and were not taken are dropped.
   * \return what makes a scene of it; empty when none has come since */
  SceneLoader takeFrame ();

  /** \brief Frames that came and were not taken, since playing was started. */
  std::size_t droppedFrames () const;

  std::size_t
  takenFrames () const
  {
    return (taken_);
  }

private:
  void receive (const SceneLoader& frame);

  std::vector<SceneLoader> loaders_;
  float frame_rate_{0.0f};
  std::unique_ptr<pcl::Grabber> grabber_;
  std::size_t current_{0}, taken_{0};
  mutable std::mutex mutex_; /**< of what follows: frames come on the grabber's thread */
  SceneLoader newest_;
  std::size_t dropped_{0};
};

} // namespace pcl_attention
