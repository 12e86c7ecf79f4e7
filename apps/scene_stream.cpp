// SPDX-License-Identifier: BSD-3-Clause
#include "scene_stream.h"

namespace pcl_attention
{

SceneStream::SceneStream (const std::vector<std::string>& paths, const SceneOptions& scene_options, const AttentionParameters& parameters,
                          const NamedPrior& prior, unsigned int threads)
{
  reader_ = std::thread ([this, paths, scene_options] {
    for (const std::string& path : paths)
    {
      // No more than three scenes are in memory: one a stage.
      if (!read_.waitForRoom ())
        return;
      Item item;
      try
      {
        item.scene = std::make_unique<Scene> (readScene (path, scene_options));
      }
      catch (...)
      {
        item.error = std::current_exception ();
      }
      if (!read_.push (std::move (item)))
        return;
    }
    read_.close ();
  });
  try
  {
    segmenter_ = std::thread ([this, parameters, prior, threads] {
      while (segmented_.waitForRoom ())
      {
        std::optional<Item> item = read_.pop ();
        if (!item)
          break;
        if (!item->error)
          try
          {
            item->result = segmentScene (*item->scene, parameters, threads, prior);
          }
          catch (...)
          {
            item->error = std::current_exception ();
          }
        if (!segmented_.push (std::move (*item)))
          return;
      }
      segmented_.close ();
    });
  }
  catch (...) // the system gives no second thread
  {
    read_.close ();
    reader_.join ();
    throw;
  }
}

SceneStream::~SceneStream ()
{
  read_.close ();
  segmented_.close ();
  reader_.join ();
  segmenter_.join ();
}

SceneStream::Item
SceneStream::next ()
{
  std::optional<Item> item = segmented_.pop ();
  return (item ? std::move (*item) : Item ());
}

} // namespace pcl_attention
