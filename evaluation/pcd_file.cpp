// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/pcd_file.h"

#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace pcl_attention
{
namespace
{

/** \brief True if PCL finds a header with fields and points; without them it would go on and read out of bounds. */
bool
hasUsableHeader (const std::string& path)
{
  pcl::PCLPointCloud2 header;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0, data_type = 0;
  unsigned int data_offset = 0;
  const int status = pcl::PCDReader ().readHeader (path, header, origin, orientation, version, data_type, data_offset);
  return (status >= 0 && !header.fields.empty () && header.point_step > 0 && header.width > 0 && header.height > 0 &&
          data_offset > 0);
}

} // namespace

void
readPcdFile (const std::string& path, pcl::PCLPointCloud2& cloud, Eigen::Vector4f& sensor_origin,
             Eigen::Quaternionf& sensor_orientation)
{
  if (!std::filesystem::is_regular_file (path))
    throw std::runtime_error (path + ": no such file");
  bool is_read = false;
  try
  {
    is_read = hasUsableHeader (path) && pcl::io::loadPCDFile (path, cloud, sensor_origin, sensor_orientation) >= 0;
  }
  catch (const std::exception&)
  {
    // PCL throws on some broken files and returns an error on others
  }
  if (!is_read || cloud.data.size () != static_cast<std::size_t> (cloud.width) * cloud.height * cloud.point_step)
    throw std::runtime_error (path + ": not a readable PCD file");
}

const pcl::PCLPointField*
findField (const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  const auto field =
      std::find_if (cloud.fields.begin (), cloud.fields.end (), [&] (const auto& f) { return (f.name == name); });
  return (field == cloud.fields.end () ? nullptr : &*field);
}

} // namespace pcl_attention
