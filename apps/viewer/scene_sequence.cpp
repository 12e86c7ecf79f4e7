// SPDX-License-Identifier: BSD-3-Clause
#include "scene_sequence.h"

#include "pcd_header.h"

#include <pcl/common/io.h>
#include <pcl/io/image_grabber.h>
#include <pcl/io/pcd_grabber.h>

#include <algorithm>
#include <stdexcept>

namespace pcl_attention
{

SceneSequence::SceneSequence (const std::vector<std::string>& files, int image_width, float frame_rate)
    : name_ ("frame")
{
  for (const std::string& file : files)
    loaders_.emplace_back ([=] { return (readViewerScene (file, image_width)); });
  if (files.empty ())
    loaders_.emplace_back (renderViewerScene);
  make_grabber_ = [=] () -> std::unique_ptr<pcl::Grabber> {
    if (files.size () < 2)
      throw std::runtime_error ("nothing to play: open a folder, or several scenes");
    // PCL's reader trusts a damaged file.
    for (const std::string& file : files)
      try
      {
        checkPcdHeader (file);
      }
      catch (const std::exception& error)
      {
        throw std::runtime_error (file + ": " + error.what ());
      }
    return (std::make_unique<pcl::PCDGrabber<pcl::PointXYZRGBA>> (files, frame_rate, true));
  };
}

SceneSequence::SceneSequence (const std::vector<DepthImages>& images, float frame_rate)
    : name_ ("frame"), upside_down_ (true)
{
  for (const DepthImages& pair : images)
    loaders_.emplace_back ([=] { return (readDepthImages (pair)); });
  make_grabber_ = [=] () -> std::unique_ptr<pcl::Grabber> {
    if (images.size () < 2)
      throw std::runtime_error ("nothing to play: open folders of images");
    return (makeImageGrabber (images, frame_rate));
  };
}

SceneSequence::SceneSequence (std::unique_ptr<pcl::Grabber> grabber, const std::string& name)
    : grabber_ (std::move (grabber)), name_ (name)
{
  grabber_->registerCallback<void (const Frame::ConstPtr&)> (
      [this] (const Frame::ConstPtr& frame) { receive (frame); });
}

SceneSequence::~SceneSequence ()
{
  if (isPlaying ())
    grabber_->stop ();
}

std::function<ViewerScenePtr ()>
SceneSequence::move (int direction)
{
  if (loaders_.empty ())
    return (nullptr);
  const auto count = static_cast<std::ptrdiff_t> (loaders_.size ());
  current_ = static_cast<std::size_t> ((static_cast<std::ptrdiff_t> (current_) + direction % count + count) % count);
  return (loaders_[current_]);
}

void
SceneSequence::play (bool on)
{
  if (!on)
  {
    if (isPlaying ())
      grabber_->stop ();
    return;
  }
  if (make_grabber_)
  {
    grabber_ = make_grabber_ ();
    grabber_->registerCallback<void (const Frame::ConstPtr&)> (
        [this] (const Frame::ConstPtr& frame) { receive (frame); });
  }
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    newest_.reset ();
    dropped_ = 0;
  }
  taken_ = 0;
  grabber_->start ();
}

void
SceneSequence::receive (const Frame::ConstPtr& frame)
{
  const std::lock_guard<std::mutex> lock (mutex_);
  dropped_ += newest_ != nullptr;
  newest_ = frame;
}

std::function<ViewerScenePtr ()>
SceneSequence::takeFrame ()
{
  Frame::ConstPtr frame;
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    frame.swap (newest_);
  }
  if (!frame)
    return (nullptr);
  const std::string name = name_ + ' ' + std::to_string (++taken_);
  return ([frame, name, upside_down = upside_down_] {
    const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
    pcl::copyPointCloud (*frame, *cloud);
    if (upside_down)
      turnUpright (*cloud);
    const bool has_color = std::any_of (cloud->begin (), cloud->end (), [] (const pcl::PointXYZRGB& point) {
      return (point.r != 0 || point.g != 0 || point.b != 0);
    });
    return (makeViewerScene (makeSceneOf (cloud, name, has_color)));
  });
}

std::size_t
SceneSequence::droppedFrames () const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return (dropped_);
}

} // namespace pcl_attention
