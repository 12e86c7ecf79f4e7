// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/labelled_scene.h"

#include "evaluation/pcd_file.h"

#include <pcl/conversions.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

namespace fs = std::filesystem;

namespace pcl_attention
{
namespace
{

/** \brief Refuse what pcl::fromPCLPointCloud2 would only warn about, leaving zeros behind. */
void
checkFields (pcl::PCLPointCloud2& cloud, const std::string& path)
{
  for (const char* name : {"x", "y", "z"})
  {
    const pcl::PCLPointField* field = findField (cloud, name);
    if (!field || field->datatype != pcl::PCLPointField::FLOAT32)
      throw std::runtime_error (path + ": no 4-byte floating-point field \"" + name + "\"");
  }
  const auto label = std::find_if (cloud.fields.begin (), cloud.fields.end (),
                                   [] (const auto& field) { return (field.name == "label"); });
  if (label == cloud.fields.end ())
    throw std::runtime_error (path + ": no field \"label\": not a labelled scene");
  if (label->datatype == pcl::PCLPointField::INT32)
    label->datatype = pcl::PCLPointField::UINT32; // the same bits for every valid label
  if (label->datatype != pcl::PCLPointField::UINT32)
    throw std::runtime_error (path + ": the field \"label\" is not a 4-byte integer");
}

void
organize (pcl::PointCloud<pcl::PointXYZRGBL>& cloud, const std::string& path)
{
  constexpr std::uint32_t width = 640, height = 480;
  if (cloud.empty ())
    throw std::runtime_error (path + ": no points");
  if (cloud.width > 1 && cloud.height > 1)
    return;
  if (cloud.size () != width * height)
    throw std::runtime_error (path + ": unorganized, " + std::to_string (cloud.size ()) +
                              " points; only 640 * 480 can be taken as an image");
  cloud.width = width;
  cloud.height = height;
}

} // namespace

std::string
sceneCategory (const std::string& path)
{
  struct Range
  {
    int last;
    const char* category;
  };
  constexpr Range learn_ranges[] = {{16, "boxes"}, {24, "stacked"}, {32, "occluded"}, {44, "cylindric"}};

  const std::string stem = fs::path (path).stem ().string ();
  const std::string prefix = "learn";
  const std::string digits = stem.compare (0, prefix.size (), prefix) == 0 ? stem.substr (prefix.size ()) : "";
  const bool numbered = !digits.empty () && digits.size () <= 2 &&
                        std::all_of (digits.begin (), digits.end (), [] (char c) { return (c >= '0' && c <= '9'); });
  if (numbered)
  {
    for (const Range& range : learn_ranges)
    {
      if (std::stoi (digits) <= range.last)
        return (range.category);
    }
  }
  return (fs::absolute (path).lexically_normal ().parent_path ().filename ().string ());
}

std::vector<std::string>
listScenes (const std::vector<std::string>& paths, const std::vector<std::string>& extensions)
{
  std::vector<std::string> scenes;
  for (const std::string& path : paths)
  {
    if (!fs::exists (path))
      throw std::runtime_error (path + ": no such file or folder");
    if (!fs::is_directory (path))
    {
      scenes.push_back (path);
      continue;
    }
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::directory_iterator (path))
    {
      const std::string extension = entry.path ().extension ().string ();
      if (entry.is_regular_file () && std::find (extensions.begin (), extensions.end (), extension) != extensions.end ())
        files.push_back (entry.path ().string ());
    }
    if (files.empty ())
    {
      std::string names;
      for (const std::string& extension : extensions)
        names += (names.empty () ? "" : " or ") + extension;
      throw std::runtime_error (path + ": a folder without a " + names + " file");
    }
    std::sort (files.begin (), files.end ());
    scenes.insert (scenes.end (), files.begin (), files.end ());
  }

  std::map<std::string, std::string> path_of;
  for (const std::string& scene : scenes)
  {
    const auto inserted = path_of.emplace (fs::path (scene).stem ().string (), scene);
    if (!inserted.second)
      throw std::runtime_error (scene + ": same name as " + inserted.first->second);
  }
  return (scenes);
}

LabelledScene
loadLabelledScene (const std::string& path)
{
  LabelledScene scene;
  scene.name = fs::path (path).stem ().string ();
  scene.category = sceneCategory (path);
  scene.cloud.reset (new pcl::PointCloud<pcl::PointXYZRGBL>);

  pcl::PCLPointCloud2 raw;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  readPcdFile (path, raw, origin, orientation);
  checkFields (raw, path);
  pcl::fromPCLPointCloud2 (raw, *scene.cloud);
  scene.cloud->sensor_origin_ = origin;
  scene.cloud->sensor_orientation_ = orientation;
  organize (*scene.cloud, path);
  return (scene);
}

} // namespace pcl_attention
