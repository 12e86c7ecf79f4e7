// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_scene.h"

#include "evaluation/labelled_scene.h"
#include "overview_image.h"
#include "scene_renderer.h"

#include <pcl/common/io.h>
#include <pcl/segmentation/impl/organized_cloud.hpp>

#include <stdexcept>

namespace pcl_attention
{

namespace
{

std::shared_ptr<const GroundTruth>
readTruth (const Scene& scene)
{
  if (!scene.has_labels)
    return (nullptr);
  const LabelledScene labels = loadLabelledScene (scene.path);
  if (labels.cloud->size () != scene.cloud->size ())
    return (nullptr);
  return (std::make_shared<const GroundTruth> (makeGroundTruth (*labels.cloud, GroundTruthKind::objects)));
}

} // namespace

ViewerScenePtr
makeViewerScene (Scene&& scene, const std::shared_ptr<const GroundTruth>& truth)
{
  const std::shared_ptr<ViewerScene> result (new ViewerScene);
  result->scene = std::move (scene);
  result->sensor_pose = sensorPose (*result->scene.cloud);
  result->cloud = gather (*result->scene.cloud, nullptr);
  if (!result->scene.has_color)
  {
    result->cloud.red.clear ();
    result->cloud.green.clear ();
    result->cloud.blue.clear ();
  }
  result->focal_length = estimateFocalLength (result->cloud);
  result->background = backgroundImage (result->scene);
  result->truth = truth;
  return (result);
}

ViewerScenePtr
readViewerScene (const std::string& path, const SceneOptions& options)
{
  Scene scene = readScene (path, options);
  std::shared_ptr<const GroundTruth> truth;
  try
  {
    truth = readTruth (scene);
  }
  catch (const std::exception& error)
  {
    // Labels of another kind are no reason not to show the scene.
    scene.notes.push_back (std::string ("its labels are not used: ") + error.what ());
  }
  return (makeViewerScene (std::move (scene), truth));
}

ViewerScenePtr
renderViewerScene ()
{
  constexpr std::uint64_t seed = 6; // that of the README's picture
  const pcl::PointCloud<pcl::PointXYZRGBL>::Ptr labelled = renderScene (makeScene (SceneKind::clutter, seed), seed);
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
  pcl::copyPointCloud (*labelled, *cloud);
  Scene scene = makeSceneOf (cloud, "rendered", true);
  return (makeViewerScene (
      std::move (scene), std::make_shared<const GroundTruth> (makeGroundTruth (*labelled, GroundTruthKind::objects))));
}

} // namespace pcl_attention
