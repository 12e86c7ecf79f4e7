// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/organized_cloud.h>

#include <Eigen/Geometry>
#include <pcl/console/print.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>
#include <type_traits>

namespace pcl_attention
{

template <typename PointT, typename = void>
struct HasRgb : std::false_type
{};

template <typename PointT>
struct HasRgb<PointT, std::void_t<decltype (PointT::r), decltype (PointT::g), decltype (PointT::b)>> : std::true_type
{};

/** \brief The largest image that is taken: 64 megapixels, so that row-major indices and sums stay far from overflow. */
constexpr std::size_t most_pixels = std::size_t{1} << 26;

/** \brief From the sensor frame to the cloud's. */
template <typename PointT> Eigen::Isometry3f
sensorPose (const pcl::PointCloud<PointT>& cloud)
{
  Eigen::Isometry3f pose = Eigen::Isometry3f::Identity ();
  pose.linear () = cloud.sensor_orientation_.normalized ().toRotationMatrix ();
  pose.translation () = cloud.sensor_origin_.template head<3> ();
  return (pose);
}

/** \brief Gather a cloud into flat arrays in the sensor frame. Points that are not finite, or that lie in or behind the
  * viewpoint, are not valid.
  * \param[in] indices the points to take, the others are not valid; null takes all */
template <typename PointT> OrganizedCloud
gather (const pcl::PointCloud<PointT>& cloud, const pcl::Indices* indices)
{
  OrganizedCloud flat;
  flat.reset (static_cast<int> (cloud.width), static_cast<int> (cloud.height));
  const Eigen::Isometry3f to_sensor = sensorPose (cloud).inverse ();
  const bool moved = !to_sensor.matrix ().isIdentity (0.0f);
  if constexpr (HasRgb<PointT>::value)
  {
    flat.red.resize (cloud.size ());
    flat.green.resize (cloud.size ());
    flat.blue.resize (cloud.size ());
    for (std::size_t index = 0; index < cloud.size (); ++index)
    {
      flat.red[index] = cloud[index].r;
      flat.green[index] = cloud[index].g;
      flat.blue[index] = cloud[index].b;
    }
  }
  const auto take = [&] (std::size_t index) {
    const PointT& point = cloud[index];
    if (!std::isfinite (point.x) || !std::isfinite (point.y) || !std::isfinite (point.z))
      return;
    Eigen::Vector3f position (point.x, point.y, point.z);
    if (moved)
      position = to_sensor * position;
    // Negated so that a coordinate too large to be squared is refused as well.
    if (!(position.z () > 0.0f && position.squaredNorm () < 1e12f))
      return;
    flat.valid[index] = 1;
    flat.x[index] = position.x ();
    flat.y[index] = position.y ();
    flat.z[index] = position.z ();
  };
  if (indices)
    for (const pcl::index_t index : *indices)
      take (static_cast<std::size_t> (index));
  else
    for (std::size_t index = 0; index < cloud.size (); ++index)
      take (index);
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

/** \brief The checks every class makes of its input, each with a message that says what to do; then \ref gather.
  * \param[in] class_name for the message
  * \param[in] normals may be null
  * \return false when the input cannot be used */
template <typename PointT> bool
checkAndGather (const char* class_name, const typename pcl::PointCloud<PointT>::ConstPtr& cloud,
                const pcl::IndicesConstPtr& indices, const pcl::PointCloud<pcl::Normal>* normals, OrganizedCloud& flat)
{
  if (!cloud)
  {
    PCL_ERROR ("[pcl::%s] No input cloud: call setInputCloud first.\n", class_name);
    return (false);
  }
  if (cloud->empty ())
  {
    PCL_ERROR ("[pcl::%s] The input cloud is empty.\n", class_name);
    return (false);
  }
  if (static_cast<std::size_t> (cloud->width) * cloud->height != cloud->size ())
  {
    PCL_ERROR ("[pcl::%s] The input cloud has %zu points, but is said to be %u x %u.\n", class_name, cloud->size (),
               cloud->width, cloud->height);
    return (false);
  }
  if (!cloud->isOrganized ())
  {
    PCL_ERROR ("[pcl::%s] The input cloud is not organized (%u x 1): give it as the camera delivers it, one point a pixel with "
               "NaN for holes. Filters keep it so with setKeepOrganized (true).\n", class_name, cloud->width);
    return (false);
  }
  if (cloud->size () > most_pixels)
  {
    PCL_ERROR ("[pcl::%s] The input cloud has %zu points, more than the %zu this module takes.\n", class_name,
               cloud->size (), most_pixels);
    return (false);
  }
  if (normals && normals->size () != cloud->size ())
  {
    PCL_ERROR ("[pcl::%s] %zu normals for %zu points: give one per point, NaN where it is not known.\n", class_name,
               normals->size (), cloud->size ());
    return (false);
  }
  if (indices)
    for (const pcl::index_t index : *indices)
      if (index < 0 || static_cast<std::size_t> (index) >= cloud->size ())
      {
        PCL_ERROR ("[pcl::%s] Index %d lies outside the input cloud of %zu points.\n", class_name,
                   static_cast<int> (index), cloud->size ());
        return (false);
      }
  flat = gather (*cloud, indices.get ());
  return (true);
}

} // namespace pcl_attention
