// SPDX-License-Identifier: BSD-3-Clause
// Folders, files and clouds for the tests of the programs.
#pragma once

#include <gtest/gtest.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace pcl_attention
{
namespace test
{

/** \brief An empty folder that is gone after the test. */
class TemporaryFolder
{
public:
  TemporaryFolder ()
  {
    std::string pattern = (std::filesystem::temp_directory_path () / "pcl_attention_apps_XXXXXX").string ();
    path_ = mkdtemp (pattern.data ());
  }
  ~TemporaryFolder ()
  {
    std::error_code ignored;
    std::filesystem::remove_all (path_, ignored);
  }
  TemporaryFolder (const TemporaryFolder&) = delete;
  TemporaryFolder& operator= (const TemporaryFolder&) = delete;

  std::string
  operator/ (const std::string& name) const
  {
    return ((path_ / name).string ());
  }

private:
  std::filesystem::path path_;
};

inline std::string
readText (const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream (path, std::ios::binary).rdbuf ();
  return (text.str ());
}

inline void
writeText (const std::string& path, const std::string& text)
{
  std::filesystem::create_directories (std::filesystem::path (path).parent_path ());
  std::ofstream (path, std::ios::binary) << text;
}

/** \brief The names of everything in a folder, hidden files included; empty if there is no such folder. */
inline std::set<std::string>
namesIn (const std::string& path)
{
  std::set<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator (path, ignored))
    names.insert (entry.path ().filename ().string ());
  return (names);
}

/** \brief What a camera of focal length f sees of a wall at a depth, in its own frame. */
template <typename PointT>
pcl::PointCloud<PointT>
wallBefore (int width, int height, float depth = 1.0f, float f = 100.0f)
{
  pcl::PointCloud<PointT> cloud (width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      PointT& point = cloud (column, row);
      point.x = (static_cast<float> (column) - 0.5f * static_cast<float> (width - 1)) * depth / f;
      point.y = (static_cast<float> (row) - 0.5f * static_cast<float> (height - 1)) * depth / f;
      point.z = depth;
    }
  return (cloud);
}

} // namespace test
} // namespace pcl_attention
