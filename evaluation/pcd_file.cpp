// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/pcd_file.h"

#include "evaluation/file_error.h"
#include "evaluation/pcd_header.h"

#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace pcl_attention
{

void
readPcdFile (const std::string& path, pcl::PCLPointCloud2& cloud, Eigen::Vector4f& sensor_origin,
             Eigen::Quaternionf& sensor_orientation)
{
  if (!std::filesystem::is_regular_file (path))
    fail (path, "no such file");
  try
  {
    if (checkPcdHeader (path).points == 0)
      throw std::runtime_error ("no points");
    // PCL throws on some broken files and returns an error on others.
    const bool is_read = pcl::io::loadPCDFile (path, cloud, sensor_origin, sensor_orientation) >= 0;
    if (!is_read || cloud.data.size () != static_cast<std::size_t> (cloud.width) * cloud.height * cloud.point_step)
      throw std::runtime_error ("damaged: PCL cannot read its points");
  }
  catch (const std::exception& error)
  {
    fail (path, error.what ());
  }
}

const pcl::PCLPointField*
findField (const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  const auto field =
      std::find_if (cloud.fields.begin (), cloud.fields.end (), [&] (const auto& f) { return (f.name == name); });
  return (field == cloud.fields.end () ? nullptr : &*field);
}

} // namespace pcl_attention
