// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_scene.h"

#include "evaluation/labelled_scene.h"
#include "overview_image.h"
#include "pcd_header.h"
#include "scene_renderer.h"

#include <pcl/common/io.h>
#include <pcl/console/print.h>
#include <pcl/segmentation/impl/organized_cloud.hpp>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace fs = std::filesystem;

namespace pcl_attention
{

namespace
{

struct PngSize
{
  int width, height, bytes, channels;
};

/** \brief PCL's reader takes whatever VTK gives it: look before. */
PngSize
checkPng (const std::string& path)
{
  if (!fs::exists (path))
    throw std::runtime_error (path + ": no such file");
  vtkNew<vtkPNGReader> reader;
  if (!fs::is_regular_file (path) || reader->CanReadFile (path.c_str ()) == 0)
    throw std::runtime_error (path + ": not a PNG file");
  reader->SetFileName (path.c_str ());
  reader->Update ();
  vtkImageData* image = reader->GetOutput ();
  const int* size = image->GetDimensions ();
  if (size[0] < 2 || size[1] < 2)
    throw std::runtime_error (path + ": damaged, or smaller than 2 x 2 pixels");
  return {size[0], size[1], image->GetScalarSize (), image->GetNumberOfScalarComponents ()};
}

void
checkImages (const DepthImages& images)
{
  const PngSize depth = checkPng (images.depth);
  if (depth.bytes != 2 || depth.channels != 1)
    throw std::runtime_error (images.depth + ": not a depth image: 16 bits and one channel are needed, this has " +
                              std::to_string (8 * depth.bytes) + " bits and " + std::to_string (depth.channels));
  if (images.color.empty ())
    return;
  const PngSize color = checkPng (images.color);
  if (color.bytes != 1 || color.channels != 3)
    throw std::runtime_error (images.color + ": not a colour image of 8 bits and three channels");
  if (color.width != depth.width || color.height != depth.height)
    throw std::runtime_error (images.color + ": " + std::to_string (color.width) + " x " +
                              std::to_string (color.height) + " pixels, but the depth has " +
                              std::to_string (depth.width) + " x " + std::to_string (depth.height) +
                              ": colour has to be registered to the depth");
}

std::shared_ptr<const GroundTruth>
readTruth (const Scene& scene)
{
  const PcdHeader header = checkPcdHeader (scene.path);
  const bool labelled = std::any_of (header.fields.begin (), header.fields.end (),
                                     [] (const PcdHeader::Field& field) { return (field.name == "label"); });
  if (!labelled)
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
readViewerScene (const std::string& path, int image_width)
{
  SceneOptions options;
  options.image_width = image_width;
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

std::unique_ptr<pcl::ImageGrabber<pcl::PointXYZRGBA>>
makeImageGrabber (const std::vector<DepthImages>& images, float frame_rate)
{
  std::vector<std::string> depth, color;
  for (const DepthImages& pair : images)
  {
    checkImages (pair);
    depth.push_back (pair.depth);
    if (!pair.color.empty ())
      color.push_back (pair.color);
  }
  auto grabber = std::make_unique<pcl::ImageGrabber<pcl::PointXYZRGBA>> (depth, frame_rate, true);
  if (!color.empty ())
    grabber->setRGBImageFiles (color);
  const DepthImages& camera = images.front ();
  const PngSize size = checkPng (camera.depth);
  const double focal_length_x = camera.focal_length_x > 0.0 ? camera.focal_length_x : 525.0 / 640.0 * size.width;
  grabber->setCameraIntrinsics (focal_length_x, camera.focal_length_y > 0.0 ? camera.focal_length_y : focal_length_x,
                                camera.center_x >= 0.0 ? camera.center_x : 0.5 * (size.width - 1),
                                size.height - 1 - (camera.center_y >= 0.0 ? camera.center_y : 0.5 * (size.height - 1)));
  grabber->setDepthImageUnits (static_cast<float> (camera.depth_scale));
  return (grabber);
}

void
turnUpright (pcl::PointCloud<pcl::PointXYZRGB>& cloud)
{
  const std::size_t width = cloud.width, height = cloud.height;
  for (std::size_t row = 0; row < height / 2; ++row)
    std::swap_ranges (cloud.begin () + static_cast<std::ptrdiff_t> (row * width),
                      cloud.begin () + static_cast<std::ptrdiff_t> ((row + 1) * width),
                      cloud.begin () + static_cast<std::ptrdiff_t> ((height - 1 - row) * width));
  for (pcl::PointXYZRGB& point : cloud)
    point.y = -point.y;
}

ViewerScenePtr
readDepthImages (const DepthImages& images)
{
  const pcl::PointCloud<pcl::PointXYZRGBA>::ConstPtr read = (*makeImageGrabber ({images}, 0.0f))[0];
  if (read->empty ())
    throw std::runtime_error (images.depth + ": PCL cannot read it");
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
  pcl::copyPointCloud (*read, *cloud);
  turnUpright (*cloud);
  Scene scene = makeSceneOf (cloud, images.depth, !images.color.empty ());
  scene.name = fs::path (images.depth).stem ().string ();
  if (images.focal_length_x <= 0.0)
    scene.notes.push_back ("no -intrinsics given: those of a Kinect are taken");
  return (makeViewerScene (std::move (scene)));
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
