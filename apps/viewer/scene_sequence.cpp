// SPDX-License-Identifier: BSD-3-Clause
#include "scene_sequence.h"

#include <pcl/common/io.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <stdexcept>
#include <thread>

namespace pcl_attention
{

namespace
{

/** \brief Files as a camera would give them, over and over. It only says that one is due: those that nobody takes need
 * not be read, and those that are taken are read like any scene, which PCL's own grabbers of files do not. */
class FileGrabber : public pcl::Grabber
{
public:
  using Callback = void (const SceneLoader&);

  FileGrabber (const std::vector<SceneLoader>& files, float frame_rate)
      : files_ (files), frame_rate_ (frame_rate), signal_ (*createSignal<Callback> ())
  {
  }

  ~FileGrabber () override { FileGrabber::stop (); }

  void
  start () override
  {
    stop ();
    ends_ = false;
    thread_ = std::thread ([this] { run (); });
  }

  void
  stop () override
  {
    {
      const std::lock_guard<std::mutex> lock (mutex_);
      ends_ = true;
    }
    changed_.notify_all ();
    if (thread_.joinable ())
      thread_.join ();
  }

  bool
  isRunning () const override
  {
    return (thread_.joinable ());
  }

  std::string
  getName () const override
  {
    return ("FileGrabber");
  }

  float
  getFramesPerSecond () const override
  {
    return (frame_rate_);
  }

private:
  void
  run ()
  {
    using Clock = std::chrono::steady_clock;
    const auto period = std::chrono::duration_cast<Clock::duration> (std::chrono::duration<float> (1.0f / frame_rate_));
    auto due = Clock::now ();
    std::unique_lock<std::mutex> lock (mutex_);
    for (std::size_t k = 0; !ends_; k = (k + 1) % files_.size ())
    {
      signal_ (files_[k]);
      due += period;
      changed_.wait_until (lock, due, [this] { return (ends_); });
    }
  }

  const std::vector<SceneLoader> files_;
  const float frame_rate_;
  boost::signals2::signal<Callback>& signal_;
  std::mutex mutex_; /**< of what follows */
  std::condition_variable changed_;
  bool ends_{false};
  std::thread thread_;
};

ViewerScenePtr
sceneOfFrame (const pcl::PointCloud<pcl::PointXYZRGBA>& frame, const std::string& name, float max_range)
{
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
  pcl::copyPointCloud (frame, *cloud);
  const bool has_color = std::any_of (cloud->begin (), cloud->end (), [] (const pcl::PointXYZRGB& point) {
    return (point.r != 0 || point.g != 0 || point.b != 0);
  });
  return (makeViewerScene (makeSceneOf (cloud, name, has_color, max_range)));
}

} // namespace

SceneSequence::SceneSequence (const std::vector<std::string>& files, const SceneOptions& options, float frame_rate)
    : frame_rate_ (frame_rate)
{
  for (const std::string& file : files)
    loaders_.emplace_back ([=] { return (readViewerScene (file, options)); });
  if (files.empty ())
    loaders_.emplace_back (renderViewerScene);
}

SceneSequence::SceneSequence (std::unique_ptr<pcl::Grabber> grabber, const std::string& name, float max_range)
    : grabber_ (std::move (grabber))
{
  using Frame = pcl::PointCloud<pcl::PointXYZRGBA>;
  grabber_->registerCallback<void (const Frame::ConstPtr&)> ([=] (const Frame::ConstPtr& frame) {
    receive ([=] { return (sceneOfFrame (*frame, name, max_range)); });
  });
}

SceneSequence::~SceneSequence ()
{
  if (isPlaying ())
    grabber_->stop ();
}

SceneLoader
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
  if (isPlaying ())
    grabber_->stop ();
  if (!on)
    return;
  if (loaders_.size () == 1)
    throw std::runtime_error ("nothing to play: open a folder, or several scenes");
  if (!loaders_.empty ())
  {
    grabber_ = std::make_unique<FileGrabber> (loaders_, frame_rate_);
    grabber_->registerCallback<FileGrabber::Callback> ([this] (const SceneLoader& frame) { receive (frame); });
  }
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    newest_ = nullptr;
    dropped_ = 0;
  }
  taken_ = 0;
  grabber_->start ();
}

void
SceneSequence::receive (const SceneLoader& frame)
{
  const std::lock_guard<std::mutex> lock (mutex_);
  dropped_ += newest_ != nullptr;
  newest_ = frame;
}

SceneLoader
SceneSequence::takeFrame ()
{
  SceneLoader frame;
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    frame.swap (newest_);
  }
  taken_ += frame != nullptr;
  return (frame);
}

std::size_t
SceneSequence::droppedFrames () const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return (dropped_);
}

} // namespace pcl_attention
