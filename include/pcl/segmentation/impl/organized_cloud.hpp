// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/attention_points.h>
#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/organized_cloud.h>

#include <Eigen/Geometry>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// The way between PCL's clouds and the flat arrays of the core. The checks return what is wrong and what to do about
// it, or an empty text.

namespace pcl_attention
{

template <typename PointT, typename = void> struct HasRgb : std::false_type
{
};

template <typename PointT>
struct HasRgb<PointT, std::void_t<decltype (PointT::r), decltype (PointT::g), decltype (PointT::b)>> : std::true_type
{
};

/** \brief Rows of a cloud that one thread gathers at a time. */
constexpr int gathered_rows = 60;

/** \brief From the sensor frame to the cloud's. A quaternion of length zero, as of a cloud whose pose was cleared,
 * turns nothing. */
template <typename PointT>
Eigen::Isometry3f
sensorPose (const pcl::PointCloud<PointT>& cloud)
{
  Eigen::Isometry3f pose = Eigen::Isometry3f::Identity ();
  if (cloud.sensor_orientation_.norm () > 0.0f)
    pose.linear () = cloud.sensor_orientation_.normalized ().toRotationMatrix ();
  pose.translation () = cloud.sensor_origin_.template head<3> ();
  return (pose);
}

template <typename CloudT>
std::string
sizeText (const CloudT& cloud)
{
  return (std::to_string (cloud.width) + " x " + std::to_string (cloud.height));
}

/** \param[in] cloud may be null */
template <typename PointT>
std::string
checkCloud (const pcl::PointCloud<PointT>* cloud)
{
  if (!cloud)
    return ("No input cloud: call setInputCloud first.");
  if (cloud->empty ())
    return ("The input cloud is empty.");
  const std::string points = std::to_string (cloud->size ());
  if (static_cast<std::size_t> (cloud->width) * cloud->height != cloud->size ())
    return ("The input cloud has " + points + " points, but is said to be " + sizeText (*cloud) +
            ": set width and height to what the points are.");
  if (!cloud->isOrganized ())
    return ("The input cloud is not organized (" + sizeText (*cloud) +
            "): give it as the camera delivers it, one point a pixel with NaN for holes. Filters keep it so with "
            "setKeepOrganized (true).");
  const std::string problem = imageSizeProblem (cloud->width, cloud->height);
  if (!problem.empty ())
    return ("The input cloud has " + problem + ": give a part of it, or one of fewer points.");
  if (!cloud->sensor_orientation_.coeffs ().allFinite () || !cloud->sensor_origin_.template head<3> ().allFinite ())
    return ("The input cloud's sensor_origin_ or sensor_orientation_ is not finite: set them to the viewpoint.");
  return ("");
}

/** \param[in] indices may be null
 * \param[in] count points of the cloud */
inline std::string
checkIndices (const pcl::Indices* indices, std::size_t count)
{
  if (indices)
    for (const pcl::index_t index : *indices)
      if (index < 0 || static_cast<std::size_t> (index) >= count)
        return ("Index " + std::to_string (index) + " lies outside the input cloud of " + std::to_string (count) +
                " points: call setIndices with indices of this cloud.");
  return ("");
}

/** \param[in] normals may be null
 * \param[in] count points of the cloud */
inline std::string
checkNormals (const pcl::PointCloud<pcl::Normal>* normals, std::size_t count)
{
  if (!normals || normals->size () == count)
    return ("");
  return (std::to_string (normals->size ()) + " normals for " + std::to_string (count) +
          " points: give one per point, NaN where it is not known.");
}

/** \brief Check that there is a value for every pixel.
 * \param[in] what "saliency map", say
 * \param[in] image may be null */
template <typename ValueT, typename PointT>
std::string
checkSize (const char* what, const pcl::PointCloud<ValueT>* image, const pcl::PointCloud<PointT>& cloud)
{
  if (!image || (image->width == cloud.width && image->height == cloud.height && image->size () == cloud.size ()))
    return ("");
  return (std::string ("The ") + what + " is " + sizeText (*image) + " with " + std::to_string (image->size ()) +
          " values, but the input cloud is " + sizeText (cloud) + ": give one value per point, row by row.");
}

/** \param[in] saliency may be null; of the cloud's size */
inline std::string
checkSaliency (const pcl::PointCloud<pcl::Intensity>* saliency)
{
  if (saliency)
    for (std::size_t index = 0; index < saliency->size (); ++index)
    {
      const float value = (*saliency)[index].intensity;
      if (value < 0.0f || std::isinf (value))
        return ("The saliency at column " + std::to_string (index % saliency->width) + ", row " +
                std::to_string (index / saliency->width) + " is " + std::to_string (value) +
                ": give finite values from 0 up, NaN where it is not known.");
    }
  return ("");
}

template <typename PointT>
std::string
checkPoint (const AttentionPoint& point, const pcl::PointCloud<PointT>& cloud)
{
  const std::string pixel = "(" + std::to_string (point.column) + ", " + std::to_string (point.row) + ")";
  if (point.column < 0 || point.row < 0 || point.column >= static_cast<int> (cloud.width) ||
      point.row >= static_cast<int> (cloud.height))
    return ("The pixel " + pixel + " lies outside the input cloud of " + sizeText (cloud) +
            " points: columns and rows count from 0.");
  if (!std::isfinite (point.saliency) || !std::isfinite (point.point_saliency))
    return ("The saliency of the attention point at " + pixel + " is not finite: give 0 where it is not known.");
  return ("");
}

/** \brief What is gathered besides the positions of a cloud without colours. */
struct NothingMore
{
  void
  operator() (std::size_t, std::size_t) const
  {}
};

/** \brief Gather points into flat arrays in the sensor frame. Those that are not finite, or that lie in or behind the
 * viewpoint, are not valid.
 * \param[in] position_at gives the point of an index, as anything with members x, y and z, in metres
 * \param[in] indices the points to take, the others stay as they are; null takes all
 * \param[in,out] flat of the right size
 * \param[in] threads 0: all processors
 * \param[in] gather_more of a row, from its first index to the one behind its last, while its points are in the cache */
template <typename PositionAt, typename GatherMore = NothingMore>
void
gatherPositions (const PositionAt& position_at, const pcl::Indices* indices, const Eigen::Isometry3f& sensor_pose,
                 OrganizedCloud& flat, int threads = 1, const GatherMore& gather_more = GatherMore ())
{
  const Eigen::Isometry3f to_sensor = sensor_pose.inverse ();
  const bool moved = !to_sensor.matrix ().isIdentity (0.0f);
  // Copies of all that points somewhere: a byte that is written might otherwise change it.
  float *const x = flat.x.data (), *const y = flat.y.data (), *const z = flat.z.data ();
  std::uint8_t* const is_valid = flat.valid.data ();
  const auto take = [=] (std::size_t index) {
    const auto& point = position_at (index);
    Eigen::Vector3f position (point.x, point.y, point.z);
    if (moved)
      position = to_sensor * position;
    // Compared so that what is not a number, or too large to be squared, is refused as well.
    const bool valid = position.z () > 0.0f && position.squaredNorm () < 1e12f;
    is_valid[index] = valid;
    x[index] = valid ? position.x () : 0.0f;
    y[index] = valid ? position.y () : 0.0f;
    z[index] = valid ? position.z () : 0.0f;
  };
  if (indices)
    for (const pcl::index_t index : *indices)
      take (static_cast<std::size_t> (index));
  forEachBand (flat.height, gathered_rows, threads, [&] (int begin, int end) {
    const std::size_t width = flat.width;
    const auto take_one = take;
    const auto take_more = gather_more;
    for (std::size_t first = begin * width; first < end * width; first += width)
    {
      if (!indices)
        for (std::size_t index = first; index < first + width; ++index)
          take_one (index);
      take_more (first, first + width);
    }
  });
}

/** \brief Gather a cloud with its colours.
 * \param[in] indices the points to take, the others are not valid; null takes all
 * \param[in,out] flat any cloud, whose memory is used again
 * \param[in] threads 0: all processors */
template <typename PointT>
void
gather (const pcl::PointCloud<PointT>& cloud, const pcl::Indices* indices, OrganizedCloud& flat, int threads)
{
  const auto width = static_cast<int> (cloud.width), height = static_cast<int> (cloud.height);
  indices ? flat.reset (width, height) : flat.resize (width, height);
  const PointT* const points = cloud.data ();
  const auto point_at = [points] (std::size_t index) -> const PointT& { return (points[index]); };
  if constexpr (HasRgb<PointT>::value)
  {
    flat.red.resize (cloud.size ());
    flat.green.resize (cloud.size ());
    flat.blue.resize (cloud.size ());
    std::uint8_t *const red = flat.red.data (), *const green = flat.green.data (), *const blue = flat.blue.data ();
    gatherPositions (point_at, indices, sensorPose (cloud), flat, threads, [=] (std::size_t begin, std::size_t end) {
      for (std::size_t index = begin; index < end; ++index)
      {
        red[index] = points[index].r;
        green[index] = points[index].g;
        blue[index] = points[index].b;
      }
    });
  }
  else
    gatherPositions (point_at, indices, sensorPose (cloud), flat, threads);
}

template <typename PointT>
OrganizedCloud
gather (const pcl::PointCloud<PointT>& cloud, const pcl::Indices* indices)
{
  OrganizedCloud flat;
  gather (cloud, indices, flat, 1);
  return (flat);
}

/** \brief Gather normals into flat arrays in the sensor frame, turned towards the viewpoint.
 * \param[in] cloud the gathered points */
inline NormalImage
gather (const pcl::PointCloud<pcl::Normal>& normals, const Eigen::Isometry3f& sensor_pose, const OrganizedCloud& cloud)
{
  NormalImage flat;
  flat.reset (cloud.size ());
  const Eigen::Matrix3f to_sensor = sensor_pose.linear ().transpose ();
  for (std::size_t index = 0; index < cloud.size (); ++index)
  {
    Eigen::Vector3f normal = to_sensor * normals[index].getNormalVector3fMap ();
    const float length = normal.norm ();
    if (!cloud.valid[index] || !std::isfinite (length) || length < 1e-3f)
      continue;
    normal /= length;
    if (normal.x () * cloud.x[index] + normal.y () * cloud.y[index] + normal.z () * cloud.z[index] > 0.0f)
      normal = -normal;
    flat.valid[index] = 1;
    flat.x[index] = normal.x ();
    flat.y[index] = normal.y ();
    flat.z[index] = normal.z ();
    // A normal without a curvature is worth having, but not as a seed.
    flat.curvature[index] = std::isfinite (normals[index].curvature) ? normals[index].curvature : 1.0f / 3.0f;
  }
  return (flat);
}

/** \brief Gather a saliency map; what is not known (NaN) counts as 0. */
inline Image<float>
gather (const pcl::PointCloud<pcl::Intensity>& saliency)
{
  Image<float> flat (static_cast<int> (saliency.width), static_cast<int> (saliency.height), 0.0f);
  for (std::size_t index = 0; index < saliency.size (); ++index)
    if (std::isfinite (saliency[index].intensity))
      flat[index] = saliency[index].intensity;
  return (flat);
}

/** \brief Gather patch labels: whatever they are, they become 1, 2, ... in ascending order. Points that are not valid
 * get none. \param[in] cloud the gathered points */
inline Image<int>
gather (const pcl::PointCloud<pcl::Label>& labels, const OrganizedCloud& cloud)
{
  std::vector<std::uint32_t> values{0};
  for (std::size_t index = 0; index < labels.size (); ++index)
    if (cloud.valid[index] && labels[index].label != values.back ())
      values.push_back (labels[index].label);
  std::sort (values.begin (), values.end ());
  values.erase (std::unique (values.begin (), values.end ()), values.end ());

  Image<int> flat (cloud.width, cloud.height, 0);
  for (std::size_t index = 0; index < labels.size (); ++index)
    if (cloud.valid[index])
      flat[index] =
          static_cast<int> (std::lower_bound (values.begin (), values.end (), labels[index].label) - values.begin ());
  return (flat);
}

/** \brief The label that most of a patch's labelled points had; 0 when none had one. */
inline std::uint32_t
commonLabel (const pcl::PointCloud<pcl::Label>& labels, const pcl::Indices& pixels)
{
  std::map<std::uint32_t, std::size_t> counts;
  for (const pcl::index_t pixel : pixels)
    if (labels[pixel].label != 0)
      ++counts[labels[pixel].label];
  std::pair<std::uint32_t, std::size_t> best{0, 0};
  for (const auto& count : counts)
    if (count.second > best.second)
      best = count;
  return (best.first);
}

/** \brief Turn an image into a cloud of one field, e.g. scatter<pcl::Label> (image, header, &pcl::Label::label). */
template <typename PointT, typename T, typename Field>
pcl::PointCloud<PointT>
scatter (const Image<T>& image, const pcl::PCLHeader& header, Field field)
{
  pcl::PointCloud<PointT> cloud (static_cast<std::uint32_t> (image.width), static_cast<std::uint32_t> (image.height));
  cloud.header = header;
  for (std::size_t index = 0; index < image.size (); ++index)
    cloud[index].*field = static_cast<std::decay_t<decltype (cloud[index].*field)>> (image[index]);
  return (cloud);
}

} // namespace pcl_attention
