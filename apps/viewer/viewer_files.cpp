// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_files.h"

#include "segment_writer.h"
#include "whole_file.h"

#include <pcl/common/io.h>
#include <pcl/conversions.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace fs = std::filesystem;

namespace pcl_attention
{

namespace
{

std::string
numberedPath (const std::string& folder, const std::string& stem, int number, const std::string& extension)
{
  std::array<char, 16> digits{};
  std::snprintf (digits.data (), digits.size (), "_%04d", number);
  return ((fs::path (folder) / (stem + digits.data () + (extension.empty () ? "" : ".") + extension)).string ());
}

} // namespace

std::string
unusedPath (const std::string& folder, const std::string& stem, const std::string& extension)
{
  OutputFolder::prepareParent (folder);
  int number = 1;
  while (fs::exists (numberedPath (folder, stem, number, extension)))
    ++number;
  return (numberedPath (folder, stem, number, extension));
}

std::string
saveSelectedObject (const ViewerModel& model, const std::string& folder)
{
  const AttentionSegment* segment = model.selected ();
  if (!segment)
    throw std::runtime_error ("no object is selected: Right selects the next one");
  const Scene& scene = model.results ().scene->scene;
  pcl::PCLPointCloud2 blob;
  if (scene.has_color)
    pcl::toPCLPointCloud2 (model.selectedCloud (), blob);
  else
  {
    pcl::PointCloud<pcl::PointXYZ> points;
    pcl::copyPointCloud (model.selectedCloud (), points);
    pcl::toPCLPointCloud2 (points, blob);
  }
  OutputFolder::prepareParent (folder);
  const std::string path = numberedPath (folder, scene.name + "_object", segment->rank, "pcd");
  writeWholeFile (path, encodePcd (scene, blob));
  return (path);
}

std::string
saveResults (const ViewerModel& model, const std::string& folder)
{
  if (!model.results ().complete || !model.results ().scene)
    throw std::runtime_error ("there are no results yet");
  const Scene& scene = model.results ().scene->scene;
  NamedParameters parameters = model.parameters ();
  parameters.values = model.results ().parameters;
  OutputFolder::prepareParent (folder);
  OutputFolder output (folder, scene.name);
  writeSceneSegments (scene, model.sceneSegments (), parameters, output);
  output.commit ();
  return (output.path ().string ());
}

std::string
saveParameters (const ViewerModel& model, const std::string& folder)
{
  OutputFolder::prepareParent (folder);
  const std::string path = (fs::path (folder) / "parameters.json").string ();
  writeParameters (path, model.parameters ());
  return (path);
}

void
savePicture (const Image<Color>& picture, const std::string& path)
{
  writeWholeFile (path, encodePng (picture));
}

} // namespace pcl_attention
