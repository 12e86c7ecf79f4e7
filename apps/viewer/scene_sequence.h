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

/** \brief The scenes that the viewer was opened with: one after the other at the user's pace, or played through
 * pcl::Grabber's interface, from files or from a camera. */
class SceneSequence
{
public:
  /** \brief Organized PCD files. No file at all stands for the rendered scene.
   * \param[in] frame_rate frames per second when playing */
  SceneSequence (const std::vector<std::string>& files, int image_width, float frame_rate);

  /** \brief Depth images with their colours, all of one camera. */
  SceneSequence (const std::vector<DepthImages>& images, float frame_rate);

  /** \brief A camera.
   * \param[in] grabber that gives clouds of pcl::PointXYZRGBA
   * \param[in] name of what it sees */
  SceneSequence (std::unique_ptr<pcl::Grabber> grabber, const std::string& name);

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
   * \return what reads it, on any thread */
  std::function<ViewerScenePtr ()> move (int direction);

  /** \brief Start or stop playing.
   * \throws std::runtime_error where there is nothing to play, or a file that PCL's grabber would fail on */
  void play (bool on);

  bool
  isPlaying () const
  {
    return (grabber_ && grabber_->isRunning ());
  }

  /** \brief Take the newest frame. Those that came before it and were not taken are dropped.
   * \return what makes a scene of it; empty when none has come since */
  std::function<ViewerScenePtr ()> takeFrame ();

  /** \brief Frames that came and were not taken, since playing was started. */
  std::size_t droppedFrames () const;

  std::size_t
  takenFrames () const
  {
    return (taken_);
  }

private:
  using Frame = pcl::PointCloud<pcl::PointXYZRGBA>;

  void receive (const Frame::ConstPtr& frame);

  std::vector<std::function<ViewerScenePtr ()>> loaders_;
  std::function<std::unique_ptr<pcl::Grabber> ()> make_grabber_;
  std::unique_ptr<pcl::Grabber> grabber_;
  std::string name_;
  bool upside_down_{false}; /**< see \ref turnUpright */
  std::size_t current_{0}, taken_{0};
  mutable std::mutex mutex_; /**< of what follows: frames come on the grabber's thread */
  Frame::ConstPtr newest_;
  std::size_t dropped_{0};
};

} // namespace pcl_attention
