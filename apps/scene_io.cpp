// SPDX-License-Identifier: BSD-3-Clause
#include "scene_io.h"

#include "evaluation/pcd_header.h"
#include "number_text.h"
#include "ply_header.h"
#include "png_image.h"
#include <pcl_attention/core/organized_cloud.h>

#include <pcl/common/point_tests.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace fs = std::filesystem;

namespace pcl_attention
{

namespace
{

constexpr std::size_t enough_points = 100; // to judge a pose or a range by

[[noreturn]] void
fail (const std::string& message)
{
  throw std::runtime_error (message);
}

/** \brief Keeps PCL's reader from adding lines of its own to the one that the user gets. */
class SilentPcl
{
public:
  SilentPcl () : level_ (pcl::console::getVerbosityLevel ())
  {
    pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  }
  ~SilentPcl () { pcl::console::setVerbosityLevel (level_); }
  SilentPcl (const SilentPcl&) = delete;
  SilentPcl& operator= (const SilentPcl&) = delete;

private:
  pcl::console::VERBOSITY_LEVEL level_;
};

void
checkFields (const PcdHeader& header)
{
  for (const char* name : {"x", "y", "z"})
  {
    const auto field = std::find_if (header.fields.begin (), header.fields.end (),
                                     [&] (const PcdHeader::Field& candidate) { return (candidate.name == name); });
    if (field == header.fields.end ())
      fail (std::string ("no field ") + name + ": a cloud with the fields x, y, z and rgb is needed");
    if (field->type != 'F' || field->size != 4 || field->count != 1)
      fail (std::string ("the field ") + name + " is not one 4-byte float (TYPE F, SIZE 4): convert it");
  }
}

/** \brief Colour is stored as rgb or rgba, float or integer, always the same four bytes: bring it to the form that
 * pcl::PointXYZRGB takes. */
bool
normalizeColor (pcl::PCLPointCloud2& blob, std::vector<std::string>& notes)
{
  for (pcl::PCLPointField& field : blob.fields)
  {
    if (field.name != "rgb" && field.name != "rgba")
      continue;
    if (pcl::getFieldSize (field.datatype) == 4 && field.count <= 1)
    {
      field.name = "rgb";
      field.datatype = pcl::PCLPointField::FLOAT32;
      field.count = 1;
      return (true);
    }
    notes.push_back ("the field " + field.name + " has not four bytes and is not used");
  }
  return (false);
}

/** \brief PLY files of other programs have doubles: bring coordinates to the form that pcl::PointXYZRGB takes. */
void
normalizeCoordinates (pcl::PCLPointCloud2& blob)
{
  for (const char* name : {"x", "y", "z"})
  {
    const auto field = std::find_if (blob.fields.begin (), blob.fields.end (),
                                     [&] (const pcl::PCLPointField& candidate) { return (candidate.name == name); });
    if (field == blob.fields.end ())
      fail (std::string ("no property ") + name + ": a cloud with the properties x, y and z is needed");
    if (field->datatype == pcl::PCLPointField::FLOAT64)
    {
      for (std::size_t offset = field->offset; offset < blob.data.size (); offset += blob.point_step)
      {
        double value = 0.0;
        std::memcpy (&value, &blob.data[offset], sizeof (value));
        const auto narrow = static_cast<float> (value);
        std::memcpy (&blob.data[offset], &narrow, sizeof (narrow));
      }
      field->datatype = pcl::PCLPointField::FLOAT32;
    }
    if (field->datatype != pcl::PCLPointField::FLOAT32)
      fail (std::string ("the property ") + name + " is neither float nor double: convert it");
  }
}

/** \brief Whether a cloud is, or can be made, an image of what its camera saw. */
void
checkOrganized (std::uint64_t width, std::uint64_t height, const SceneOptions& options)
{
  if (width == 0 || height == 0)
    fail ("no points");
  const std::string problem = imageSizeProblem (width, height);
  if (height > 1 && !problem.empty ())
    fail ("the cloud is " + problem);
  if (height > 1 || (options.camera.width > 0 && options.image_width == 0))
    return;
  if (options.image_width > 0)
  {
    if (width % options.image_width == 0 && width > static_cast<std::uint64_t> (options.image_width))
      return;
    fail ("not organized, and its " + std::to_string (width) + " points do not fill rows of " +
          std::to_string (options.image_width));
  }
  if (options.camera.isKnown ())
    fail (
        "not organized (" + std::to_string (width) +
        " x 1 points): to organize it, the camera's image size is needed, as in -intrinsics fx,fy,cx,cy,width,height");
  std::string message =
      "not organized (" + std::to_string (width) +
      " x 1 points): the cloud must be width x height as the camera delivers it, with NaN for holes. Record "
      "the driver's organized topic and let filters keep it so (setKeepOrganized (true)), or name the camera by "
      "-intrinsics fx,fy,cx,cy,width,height";
  if (width == 640 * 480)
    message += "; if it is a whole image, row by row, add -image_width 640";
  fail (message);
}

/** \brief Give an unorganized cloud back the pixels that its points were seen at. */
void
organize (const SceneOptions& options, Scene& scene)
{
  pcl::PointCloud<pcl::PointXYZRGB>& cloud = *scene.cloud;
  if (cloud.height > 1)
  {
    if (options.camera.isKnown ())
      scene.notes.push_back ("organized already, the intrinsics are not used");
    return;
  }
  if (options.image_width > 0)
  {
    cloud.height = cloud.width / options.image_width;
    cloud.width = options.image_width;
    return;
  }

  const DepthCamera& camera = options.camera;
  pcl::PointCloud<pcl::PointXYZRGB> image (camera.width, camera.height);
  constexpr float nan_value = std::numeric_limits<float>::quiet_NaN ();
  for (pcl::PointXYZRGB& point : image)
    point.x = point.y = point.z = nan_value;
  std::vector<float> depths (image.size (), std::numeric_limits<float>::infinity ());
  Eigen::Matrix3f to_sensor = Eigen::Matrix3f::Identity ();
  if (cloud.sensor_orientation_.norm () > 1e-3f)
    to_sensor = cloud.sensor_orientation_.normalized ().conjugate ().toRotationMatrix ();
  std::size_t points = 0, outside = 0, hidden = 0;
  for (const pcl::PointXYZRGB& point : cloud)
  {
    if (!pcl::isFinite (point) || point.getVector3fMap ().isZero (0.0f))
      continue;
    ++points;
    const Eigen::Vector3f seen = to_sensor * (point.getVector3fMap () - cloud.sensor_origin_.head<3> ());
    const double column = std::round (camera.fx * seen.x () / seen.z () + camera.cx);
    const double row = std::round (camera.fy * seen.y () / seen.z () + camera.cy);
    if (!(seen.z () > 0.0f && column >= 0.0 && column < camera.width && row >= 0.0 && row < camera.height))
    {
      ++outside;
      continue;
    }
    const std::size_t pixel = static_cast<std::size_t> (row) * camera.width + static_cast<std::size_t> (column);
    hidden += std::isfinite (depths[pixel]);
    if (seen.z () >= depths[pixel])
      continue;
    depths[pixel] = seen.z ();
    image[pixel] = point;
  }
  if (points > 0 && outside == points)
    fail ("no point is seen by the camera of the intrinsics: x must be right, y down and z forward of it, in metres");
  image.sensor_origin_ = cloud.sensor_origin_;
  image.sensor_orientation_ = cloud.sensor_orientation_;
  cloud = std::move (image);
  scene.has_labels = false;
  scene.notes.push_back ("organized by the intrinsics: " + std::to_string (points) + " points in " +
                         std::to_string (camera.width) + " x " + std::to_string (camera.height) + " pixels, " +
                         std::to_string (outside) + " outside the image, " + std::to_string (hidden) +
                         " behind or before others");
}

/** \brief Mark as NaN what is no measurement: points that are not finite, and those at exactly 0, 0, 0, which is how
 * some drivers write a hole. */
void
markHoles (Scene& scene)
{
  std::size_t zeros = 0;
  for (pcl::PointXYZRGB& point : *scene.cloud)
  {
    const bool is_zero = point.x == 0.0f && point.y == 0.0f && point.z == 0.0f;
    zeros += is_zero;
    if (is_zero || !pcl::isFinite (point))
      point.x = point.y = point.z = std::numeric_limits<float>::quiet_NaN ();
    else
      ++scene.valid_points;
  }
  scene.cloud->is_dense = scene.valid_points == scene.cloud->size ();
  if (scene.valid_points == 0)
    fail (zeros == 0 ? "no valid point: all are NaN. Was the sensor too near, or the depth not registered?"
                     : "no valid point: all are NaN or 0 0 0. Was the sensor too near, or the depth not registered?");
  if (zeros > 0)
    scene.notes.push_back (std::to_string (zeros) + " points at 0 0 0 are taken as holes");
}

/** \brief How the points lie before a camera. */
struct View
{
  float median_depth{0.0f};
  double share_in_front{0.0};
  double alignment{1.0}; /**< 1: columns grow with x/z and rows with y/z, as in a camera's image; -1: against */
};

/** \brief Sums for a correlation coefficient. */
struct Correlation
{
  double count{0.0}, a{0.0}, b{0.0}, aa{0.0}, bb{0.0}, ab{0.0};

  void
  add (double value_a, double value_b)
  {
    count += 1.0;
    a += value_a;
    b += value_b;
    aa += value_a * value_a;
    bb += value_b * value_b;
    ab += value_a * value_b;
  }

  /** \brief 1 where one of them does not vary: nothing is known against it. */
  double
  value () const
  {
    const double variance_a = aa - a * a / count, variance_b = bb - b * b / count;
    if (count < enough_points || variance_a <= 1e-9 * aa || variance_b <= 1e-9 * bb)
      return (1.0);
    return ((ab - a * b / count) / std::sqrt (variance_a * variance_b));
  }
};

View
viewFrom (const pcl::PointCloud<pcl::PointXYZRGB>& cloud, const Eigen::Vector4f& origin,
          const Eigen::Quaternionf& orientation)
{
  const Eigen::Matrix3f to_sensor = orientation.conjugate ().toRotationMatrix ();
  const Eigen::Vector3f position = origin.head<3> ();
  std::vector<float> depths;
  Correlation columns, rows;
  std::size_t in_front = 0;
  for (std::size_t i = 0; i < cloud.size (); ++i)
  {
    if (!pcl::isFinite (cloud[i]))
      continue;
    const Eigen::Vector3f point = to_sensor * (cloud[i].getVector3fMap () - position);
    depths.push_back (point.z ());
    if (!(point.z () > 0.0f))
      continue;
    ++in_front;
    columns.add (static_cast<double> (i % cloud.width), point.x () / point.z ());
    rows.add (static_cast<double> (i / cloud.width), point.y () / point.z ());
  }
  View view;
  std::nth_element (depths.begin (), depths.begin () + depths.size () / 2, depths.end ());
  view.median_depth = depths[depths.size () / 2];
  view.share_in_front = static_cast<double> (in_front) / static_cast<double> (depths.size ());
  view.alignment = std::min (columns.value (), rows.value ());
  return (view);
}

/** \brief Replace a sensor pose that cannot have seen the points by one that has, where the pixels tell which one.
 * \return what the sensor sees from its pose */
View
mendSensorPose (Scene& scene)
{
  pcl::PointCloud<pcl::PointXYZRGB>& cloud = *scene.cloud;
  cloud.sensor_origin_[3] = 0.0f; // some writers leave 1 there
  if (!cloud.sensor_origin_.allFinite () || !cloud.sensor_orientation_.coeffs ().allFinite () ||
      cloud.sensor_orientation_.norm () < 1e-3f)
  {
    scene.notes.push_back ("the sensor pose (VIEWPOINT) is not a pose, taken as 0 0 0 1 0 0 0");
    cloud.sensor_origin_.setZero ();
    cloud.sensor_orientation_.setIdentity ();
  }
  cloud.sensor_orientation_.normalize ();

  const View stored = viewFrom (cloud, cloud.sensor_origin_, cloud.sensor_orientation_);
  const bool is_behind = stored.share_in_front < 0.5;
  if (!is_behind && stored.alignment > 0.5)
    return (stored);

  struct Candidate
  {
    const char* description;
    Eigen::Vector4f origin;
    Eigen::Quaternionf orientation;
  };
  const Eigen::Quaternionf half_turn (0.0f, 1.0f, 0.0f, 0.0f); // about x: from y up, z backward to y down, z forward
  const Candidate candidates[] = {
      {"its axes are y up and z backward, as in graphics; it is turned by 180 degrees about x", cloud.sensor_origin_,
       cloud.sensor_orientation_ * half_turn},
      {"the points are taken as given in the camera's own frame", Eigen::Vector4f::Zero (),
       Eigen::Quaternionf::Identity ()},
      {"the points are taken as given in the camera's own frame with y up and z backward", Eigen::Vector4f::Zero (),
       half_turn}};
  const std::string wrong = is_behind ? "the points lie behind the sensor pose of the file (VIEWPOINT)"
                                      : "the sensor pose of the file (VIEWPOINT) does not fit the image";
  for (const Candidate& candidate : candidates)
  {
    const View view = viewFrom (cloud, candidate.origin, candidate.orientation);
    if (view.share_in_front < 0.9 || view.alignment < 0.9)
      continue;
    scene.notes.push_back (wrong + ": " + candidate.description);
    cloud.sensor_origin_ = candidate.origin;
    cloud.sensor_orientation_ = candidate.orientation;
    return (view);
  }
  if (is_behind)
    fail (wrong + ": correct it, e.g. 0 0 0 1 0 0 0 where x is right, y down and z forward of the camera");
  scene.notes.push_back (wrong + ": normals and visible sides may be wrong");
  return (stored);
}

void
noteImplausible (const View& view, Scene& scene)
{
  const double share = static_cast<double> (scene.valid_points) / static_cast<double> (scene.cloud->size ());
  if (share < 0.05)
    scene.notes.push_back ("only " + std::to_string (scene.valid_points) + " of " +
                           std::to_string (scene.cloud->size ()) +
                           " points are valid: is the scene within the sensor's range?");
  if (view.median_depth < 0.1f || view.median_depth > 20.0f)
    scene.notes.push_back ("the median depth is " + numberText (view.median_depth) +
                           " m: coordinates must be in metres (are these millimetres, or is the depth scale wrong?)");
}

/** \brief Make points out of what PCL has read. */
void
convert (pcl::PCLPointCloud2& blob, Scene& scene)
{
  blob.row_step = blob.point_step * blob.width;
  if (blob.data.size () != static_cast<std::size_t> (blob.row_step) * blob.height)
    fail ("damaged: it does not hold the points that its header announces");
  scene.has_color = normalizeColor (blob, scene.notes);
  pcl::fromPCLPointCloud2 (blob, *scene.cloud);
  scene.cloud->sensor_origin_ = scene.stored_origin;
  scene.cloud->sensor_orientation_ = scene.stored_orientation;
}

void
readPcd (const std::string& path, const SceneOptions& options, Scene& scene)
{
  const PcdHeader header = checkPcdHeader (path);
  checkFields (header);
  checkOrganized (header.width, header.height, options);
  scene.has_labels = std::any_of (header.fields.begin (), header.fields.end (),
                                  [] (const PcdHeader::Field& field) { return (field.name == "label"); });

  pcl::PCLPointCloud2 blob;
  const SilentPcl silent;
  int version = 0;
  if (pcl::PCDReader ().read (path, blob, scene.stored_origin, scene.stored_orientation, version) != 0)
    fail ("damaged: PCL cannot read its points");
  convert (blob, scene);
  organize (options, scene);
}

void
readPly (const std::string& path, const SceneOptions& options, Scene& scene)
{
  checkPlyHeader (path);
  pcl::PCLPointCloud2 blob;
  const SilentPcl silent;
  int version = 0;
  if (pcl::PLYReader ().read (path, blob, scene.stored_origin, scene.stored_orientation, version) < 0)
    fail ("damaged: PCL cannot read its points");
  checkOrganized (blob.width, blob.height, options);
  normalizeCoordinates (blob);
  convert (blob, scene);
  for (pcl::PointXYZRGB& point : *scene.cloud)
    point.a = 255; // as a point has it that was not read from PLY
  organize (options, scene);
}

/** \brief The colour image that belongs to a depth image. */
void
readColor (const std::string& depth_path, const std::string& color, Scene& scene)
{
  const fs::path path =
      fs::is_directory (color) ? fs::path (color) / fs::path (depth_path).filename () : fs::path (color);
  Image<Color> image;
  try
  {
    if (!fs::is_regular_file (path))
      fail ("no such file");
    image = readColorPng (path.string ());
    const pcl::PointCloud<pcl::PointXYZRGB>& cloud = *scene.cloud;
    if (image.width != static_cast<int> (cloud.width) || image.height != static_cast<int> (cloud.height))
      fail (std::to_string (image.width) + " x " + std::to_string (image.height) + " pixels, the depth image has " +
            std::to_string (cloud.width) + " x " + std::to_string (cloud.height) +
            ": depth registered to the colour image is needed");
  }
  catch (const std::exception& error)
  {
    fail ("its colour image " + path.string () + ": " + error.what ());
  }
  for (std::size_t index = 0; index < image.size (); ++index)
  {
    pcl::PointXYZRGB& point = (*scene.cloud)[index];
    point.r = image[index][0];
    point.g = image[index][1];
    point.b = image[index][2];
  }
  scene.has_color = true;
}

/** \brief What shows at once that a depth scale is wrong. */
std::string
describeDepths (const Image<std::uint16_t>& depths, double scale)
{
  std::vector<std::uint16_t> values;
  std::copy_if (depths.data.begin (), depths.data.end (), std::back_inserter (values),
                [] (std::uint16_t value) { return (value > 0); });
  if (values.empty ())
    fail ("no depth: all values are 0");
  std::sort (values.begin (), values.end ());
  const auto metres = [&] (std::uint16_t value) { return (numberText (std::round (value * scale * 1e3) / 1e3)); };
  const auto share = static_cast<int> (100 * values.size () / depths.size ());
  return ("depth " + metres (values.front ()) + " to " + metres (values.back ()) + " m, median " +
          metres (values[values.size () / 2]) + " m, at " + std::to_string (share) + " % of the pixels");
}

void
readDepthImage (const std::string& path, const SceneOptions& options, Scene& scene)
{
  const DepthCamera& camera = options.camera;
  if (!camera.isKnown ())
    fail ("a depth image needs the camera's -intrinsics fx,fy,cx,cy");
  const Image<std::uint16_t> depths = readDepthPng (path);
  if (camera.width > 0 && (camera.width != depths.width || camera.height != depths.height))
    fail (std::to_string (depths.width) + " x " + std::to_string (depths.height) +
          " pixels, but the intrinsics are of " + std::to_string (camera.width) + " x " +
          std::to_string (camera.height));
  scene.notes.push_back (describeDepths (depths, camera.depth_scale));
  *scene.cloud = pcl::PointCloud<pcl::PointXYZRGB> (depths.width, depths.height);
  for (int row = 0; row < depths.height; ++row)
    for (int column = 0; column < depths.width; ++column)
    {
      pcl::PointXYZRGB& point = scene.cloud->at (column, row);
      const double depth = depths (column, row) * camera.depth_scale;
      point.x = static_cast<float> ((column - camera.cx) / camera.fx * depth);
      point.y = static_cast<float> ((row - camera.cy) / camera.fy * depth);
      point.z = static_cast<float> (depth);
      if (depths (column, row) == 0)
        point.x = point.y = point.z = std::numeric_limits<float>::quiet_NaN ();
    }
  if (!options.color.empty ())
    readColor (path, options.color, scene);
}

/** \brief Make holes of what is too far before the sensor. */
void
cutRange (float max_range, Scene& scene)
{
  pcl::PointCloud<pcl::PointXYZRGB>& cloud = *scene.cloud;
  const Eigen::Vector3f forward = cloud.sensor_orientation_ * Eigen::Vector3f::UnitZ ();
  const float origin = forward.dot (cloud.sensor_origin_.head<3> ());
  std::size_t cut = 0;
  for (pcl::PointXYZRGB& point : cloud)
    if (forward.dot (point.getVector3fMap ()) - origin > max_range)
    {
      point.x = point.y = point.z = std::numeric_limits<float>::quiet_NaN ();
      ++cut;
    }
  if (cut == 0)
    return;
  if (cut == scene.valid_points)
    fail ("all points are beyond -max_range " + numberText (max_range) + " m");
  scene.valid_points -= cut;
  cloud.is_dense = false;
  scene.notes.push_back (std::to_string (cut) + " points beyond " + numberText (max_range) + " m are left out");
}

std::string
lowerCaseExtension (const std::string& path)
{
  std::string extension = fs::path (path).extension ().string ();
  std::transform (extension.begin (), extension.end (), extension.begin (),
                  [] (unsigned char letter) { return (static_cast<char> (std::tolower (letter))); });
  return (extension);
}

} // namespace

Scene
readScene (const std::string& path, const SceneOptions& options)
{
  Scene scene;
  scene.path = path;
  scene.name = fs::path (path).stem ().string ();
  scene.cloud.reset (new pcl::PointCloud<pcl::PointXYZRGB>);
  try
  {
    if (!fs::exists (path))
      fail ("no such file");
    if (!fs::is_regular_file (path))
      fail ("not a regular file");
    const std::string extension = lowerCaseExtension (path);
    if (extension == ".png")
      readDepthImage (path, options, scene);
    else if (extension == ".ply")
      readPly (path, options, scene);
    else
      readPcd (path, options, scene);
    markHoles (scene);
    noteImplausible (mendSensorPose (scene), scene);
    cutRange (options.max_range, scene);
  }
  catch (const std::bad_alloc&)
  {
    fail (path + ": not enough memory to read it");
  }
  catch (const std::exception& error)
  {
    // PCL throws its own exceptions and those of the standard library on damaged data.
    fail (path + ": " + error.what ());
  }
  return (scene);
}

Scene
makeSceneOf (const pcl::PointCloud<pcl::PointXYZRGB>::Ptr& cloud, const std::string& name, bool has_color,
             float max_range)
{
  Scene scene;
  scene.path = scene.name = name;
  scene.cloud = cloud;
  scene.has_color = has_color;
  scene.stored_origin = cloud->sensor_origin_;
  scene.stored_orientation = cloud->sensor_orientation_;
  if (!cloud->isOrganized ())
    fail (name + ": not organized: the cloud must be width x height as the camera delivers it");
  try
  {
    markHoles (scene);
    noteImplausible (mendSensorPose (scene), scene);
    cutRange (max_range, scene);
  }
  catch (const std::runtime_error& error)
  {
    fail (name + ": " + error.what ());
  }
  return (scene);
}

} // namespace pcl_attention
