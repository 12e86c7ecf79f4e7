// SPDX-License-Identifier: BSD-3-Clause
#include "scene_io.h"

#include "number_text.h"
#include "pcd_header.h"

#include <pcl/common/point_tests.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
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

void
checkOrganized (const PcdHeader& header, int image_width)
{
  if (header.points == 0)
    fail ("no points");
  if (header.height > 1)
    return;
  const std::uint64_t width = header.width;
  if (image_width > 0)
  {
    if (width % image_width == 0 && width > static_cast<std::uint64_t> (image_width))
      return;
    fail ("not organized, and its " + std::to_string (width) + " points do not fill rows of " +
          std::to_string (image_width));
  }
  std::string message =
      "not organized (" + std::to_string (width) +
      " x 1 points): the cloud must be width x height as the camera delivers it, with NaN for holes. Record "
      "the driver's organized topic and let filters keep it so (setKeepOrganized (true))";
  if (width == 640 * 480)
    message += "; if it is a whole image, row by row, add -image_width 640";
  fail (message);
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
  const Eigen::Matrix3f to_sensor = orientation.toRotationMatrix ().transpose ();
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

void
readCloud (const std::string& path, int image_width, Scene& scene)
{
  const PcdHeader header = checkPcdHeader (path);
  checkFields (header);
  checkOrganized (header, image_width);

  pcl::PCLPointCloud2 blob;
  const SilentPcl silent;
  int version = 0;
  if (pcl::PCDReader ().read (path, blob, scene.stored_origin, scene.stored_orientation, version) != 0)
    fail ("damaged: PCL cannot read its points");
  blob.row_step = blob.point_step * blob.width;
  if (blob.data.size () != static_cast<std::size_t> (blob.row_step) * blob.height)
    fail ("damaged: it does not hold the points that its header announces");
  scene.has_color = normalizeColor (blob, scene.notes);
  pcl::fromPCLPointCloud2 (blob, *scene.cloud);
  if (scene.cloud->height == 1)
  {
    scene.cloud->height = scene.cloud->width / image_width;
    scene.cloud->width = image_width;
  }
  scene.cloud->sensor_origin_ = scene.stored_origin;
  scene.cloud->sensor_orientation_ = scene.stored_orientation;
}

} // namespace

Scene
readScene (const std::string& path, int image_width)
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
    readCloud (path, image_width, scene);
    markHoles (scene);
    noteImplausible (mendSensorPose (scene), scene);
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
makeSceneOf (const pcl::PointCloud<pcl::PointXYZRGB>::Ptr& cloud, const std::string& name, bool has_color)
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
  }
  catch (const std::runtime_error& error)
  {
    fail (name + ": " + error.what ());
  }
  return (scene);
}

} // namespace pcl_attention
