// SPDX-License-Identifier: BSD-3-Clause
#include "data_set.h"

#include "evaluation/pcd_header.h"
#include "png_image.h"

#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

namespace fs = std::filesystem;

namespace pcl_attention
{

namespace
{

constexpr std::uint32_t support_label = 1, first_object_label = 20, labels_an_object = 10;

/** \brief What is wrong with a data set, a line a file. */
class Problems
{
public:
  void
  add (const fs::path& file, const std::string& problem)
  {
    lines_.push_back (file.string () + ": " + problem);
  }

  /** \brief Do something with a file, and note what goes wrong. */
  template <typename Function>
  void
  check (const std::string& file, Function function)
  {
    try
    {
      if (!fs::is_regular_file (file))
        throw std::runtime_error ("missing");
      function ();
    }
    catch (const std::exception& error)
    {
      add (file, error.what ());
    }
  }

  void
  throwIfAny () const
  {
    if (lines_.empty ())
      return;
    std::string message = lines_.size () == 1 ? "" : std::to_string (lines_.size ()) + " files are wrong or missing";
    for (const std::string& line : lines_)
      message += (message.empty () ? "" : "\n  ") + line;
    throw std::runtime_error (message);
  }

private:
  std::vector<std::string> lines_;
};

/** \brief The stems of a folder's files with an extension; none if there is no such folder. */
std::set<std::string>
stemsIn (const fs::path& folder, const std::string& extension)
{
  std::set<std::string> stems;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator (folder, ignored))
    if (entry.is_regular_file (ignored) && entry.path ().extension () == extension)
      stems.insert (entry.path ().stem ().string ());
  return (stems);
}

/** \brief Folders of images, of the same names, that belong together. */
struct ImageFolders
{
  fs::path root;
  std::string color, labels, depth; /**< their names */
};

std::optional<ImageFolders>
imageFoldersIn (const fs::path& root)
{
  if (fs::is_directory (root / "annotation") && fs::is_directory (root / "image_color"))
    return (
        ImageFolders{root, "image_color", "annotation", fs::is_directory (root / "disparity") ? "disparity" : "depth"});
  if (fs::is_directory (root / "label") && fs::is_directory (root / "rgb"))
    return (ImageFolders{root, "rgb", "label", "depth"});
  return (std::nullopt);
}

/** \brief All such folders at and below a folder, by name. */
std::vector<ImageFolders>
findImageFolders (const fs::path& root)
{
  if (const auto folders = imageFoldersIn (root))
    return {*folders};
  std::vector<fs::path> below;
  for (const fs::directory_entry& entry : fs::directory_iterator (root))
    if (entry.is_directory ())
      below.push_back (entry.path ());
  std::sort (below.begin (), below.end ());
  std::vector<ImageFolders> found;
  for (const fs::path& folder : below)
    for (const ImageFolders& folders : findImageFolders (folder))
      found.push_back (folders);
  return (found);
}

std::vector<std::uint16_t>
supportLabels (const ImageFolders& folders, const DataSetOptions& options)
{
  if (!options.support_labels.empty ())
    return (options.support_labels);
  if (folders.labels != "label")
    return {0};
  const fs::path path = fs::absolute (folders.root).lexically_normal ();
  const bool has_table = std::find (path.begin (), path.end (), fs::path ("table")) != path.end ();
  return (has_table ? std::vector<std::uint16_t>{0, 1, 2} : std::vector<std::uint16_t>{0, 1});
}

/** \brief The scenes of images; a scene is one that any of the folders has a file of. */
void
listImages (const fs::path& data, const ImageFolders& folders, const DataSetOptions& options, Problems& problems,
            std::vector<SceneSource>& sources)
{
  const fs::path clouds = folders.root / "pcd";
  const bool by_depth = options.scene.camera.isKnown () || !fs::is_directory (clouds);
  if (by_depth && !options.scene.camera.isKnown ())
  {
    problems.add (folders.root, "depth images need the camera's -intrinsics fx,fy,cx,cy");
    return;
  }
  std::set<std::string> stems = stemsIn (folders.root / folders.labels, ".png");
  stems.merge (stemsIn (folders.root / folders.color, ".png"));
  stems.merge (by_depth ? stemsIn (folders.root / folders.depth, ".png") : stemsIn (clouds, ".pcd"));
  if (stems.empty ())
    problems.add (folders.root, "no scene in " + folders.color + " and " + folders.labels);

  // The folders on the way to those of OCID's layout say what kind of scene it is.
  const fs::path way = fs::absolute (folders.root).lexically_relative (fs::absolute (data));
  std::string prefix;
  if (way != ".")
    for (const fs::path& part : way)
      prefix += part.string () + "_";
  const std::string kind = way.parent_path ().string ();
  for (const std::string& stem : stems)
  {
    SceneSource source;
    source.name = prefix + stem;
    source.category = kind.empty () ? sceneCategory ((folders.root / (stem + ".png")).string ()) : kind;
    source.labels = (folders.root / folders.labels / (stem + ".png")).string ();
    source.support_labels = supportLabels (folders, options);
    source.points =
        by_depth ? (folders.root / folders.depth / (stem + ".png")).string () : (clouds / (stem + ".pcd")).string ();
    if (by_depth)
      source.color = (folders.root / folders.color / (stem + ".png")).string ();
    sources.push_back (source);
  }
}

std::vector<std::string>
masksOf (const fs::path& cloud)
{
  const std::string prefix = cloud.stem ().string () + "_";
  for (const fs::path& folder : {cloud.parent_path (), cloud.parent_path () / "masks"})
  {
    std::vector<std::string> masks;
    for (const std::string& stem : stemsIn (folder.empty () ? "." : folder, ".png"))
      if (stem.compare (0, prefix.size (), prefix) == 0)
        masks.push_back ((folder / (stem + ".png")).string ());
    if (!masks.empty ())
      return (masks);
  }
  return {};
}

void
listCloud (const std::string& path, Problems& problems, std::vector<SceneSource>& sources)
{
  SceneSource source;
  source.name = fs::path (path).stem ().string ();
  source.category = sceneCategory (path);
  source.points = path;
  problems.check (path, [&] {
    const PcdHeader header = checkPcdHeader (path);
    const bool has_labels = std::any_of (header.fields.begin (), header.fields.end (),
                                         [] (const PcdHeader::Field& field) { return (field.name == "label"); });
    if (!has_labels)
      source.masks = masksOf (path);
    if (!has_labels && source.masks.empty ())
      throw std::runtime_error ("no field \"label\", and no masks " + source.name + "_*.png beside it or in masks/");
  });
  sources.push_back (source);
}

/** \brief Width and height of what the labels are for. */
std::pair<std::uint64_t, std::uint64_t>
sizeOfPoints (const SceneSource& source)
{
  if (fs::path (source.points).extension () == ".pcd")
  {
    const PcdHeader header = checkPcdHeader (source.points);
    return {header.width, header.height};
  }
  const PngHeader header = readPngHeader (source.points);
  if (!header.is_grey || header.bit_depth != 16)
    throw std::runtime_error ("not a depth image: that has to be a 16-bit grey PNG");
  return {header.width, header.height};
}

/** \brief The headers of the images, and whether they fit the points. */
void
checkImages (const SceneSource& source, Problems& problems)
{
  std::pair<std::uint64_t, std::uint64_t> size{0, 0};
  problems.check (source.points, [&] { size = sizeOfPoints (source); });
  const auto checkImage = [&] (const std::string& file, bool is_index) {
    problems.check (file, [&] {
      const PngHeader header = readPngHeader (file);
      if (is_index && !header.is_grey && !header.is_palette)
        throw std::runtime_error ("not a label image: that has to be a grey PNG or one with a palette");
      if (size.first != 0 && (header.width != size.first || header.height != size.second))
        throw std::runtime_error (std::to_string (header.width) + "x" + std::to_string (header.height) +
                                  " pixels, but " + source.points + " has " + std::to_string (size.first) + "x" +
                                  std::to_string (size.second));
    });
  };
  if (!source.color.empty ())
    checkImage (source.color, false);
  if (!source.labels.empty ())
    checkImage (source.labels, true);
  for (const std::string& mask : source.masks)
    checkImage (mask, true);
}

void
listPath (const std::string& path, const DataSetOptions& options, Problems& problems, std::vector<SceneSource>& sources)
{
  if (fs::is_directory (path) && stemsIn (path, ".pcd").empty ())
  {
    const std::vector<ImageFolders> found = findImageFolders (path);
    for (const ImageFolders& folders : found)
      listImages (path, folders, options, problems, sources);
    if (found.empty ())
      problems.add (
          path, "no labelled scenes: neither .pcd files, nor folders image_color and annotation, nor rgb and label");
    return;
  }
  for (const std::string& cloud : listScenes ({path}))
    listCloud (cloud, problems, sources);
}

Image<std::uint16_t>
readLabels (const std::string& file, const pcl::PointCloud<pcl::PointXYZRGBL>& cloud)
{
  try
  {
    Image<std::uint16_t> labels = readIndexPng (file);
    if (labels.width != static_cast<int> (cloud.width) || labels.height != static_cast<int> (cloud.height))
      throw std::runtime_error ("another size than the points");
    return (labels);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error (file + ": " + error.what ());
  }
}

/** \brief A labelled cloud with a sensor pose that sees its points, as the other programs take it: from another nothing
 * would be found. */
LabelledScene
loadLabelledCloud (const std::string& path)
{
  LabelledScene labelled = loadLabelledScene (path);
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr points (new pcl::PointCloud<pcl::PointXYZRGB>);
  pcl::copyPointCloud (*labelled.cloud, *points);
  const Scene seen = makeSceneOf (points, path, true);
  labelled.cloud->sensor_origin_ = seen.cloud->sensor_origin_;
  labelled.cloud->sensor_orientation_ = seen.cloud->sensor_orientation_;
  return (labelled);
}

} // namespace

std::vector<std::string>
SceneSource::files () const
{
  std::vector<std::string> all{points};
  for (const std::string& file : {color, labels})
    if (!file.empty ())
      all.push_back (file);
  all.insert (all.end (), masks.begin (), masks.end ());
  return (all);
}

std::vector<SceneSource>
listSceneSources (const std::vector<std::string>& paths, const DataSetOptions& options)
{
  Problems problems;
  std::vector<SceneSource> sources;
  for (const std::string& path : paths)
    if (fs::exists (path))
      listPath (path, options, problems, sources);
    else
      problems.add (path, "no such file or folder");
  std::map<std::string, std::string> points_of;
  for (const SceneSource& source : sources)
  {
    const auto inserted = points_of.emplace (source.name, source.points);
    if (!inserted.second)
      problems.add (source.points, "same name as " + inserted.first->second);
    if (!source.labels.empty () || !source.masks.empty ())
      checkImages (source, problems);
  }
  problems.throwIfAny ();
  return (sources);
}

LabelledScene
loadScene (const SceneSource& source, const DataSetOptions& options)
{
  if (source.labels.empty () && source.masks.empty ())
    return (loadLabelledCloud (source.points));
  SceneOptions scene_options = options.scene;
  scene_options.color = source.color;
  const Scene scene = readScene (source.points, scene_options);
  LabelledScene labelled;
  labelled.name = source.name;
  labelled.category = source.category;
  labelled.cloud.reset (new pcl::PointCloud<pcl::PointXYZRGBL>);
  pcl::copyPointCloud (*scene.cloud, *labelled.cloud);
  pcl::PointCloud<pcl::PointXYZRGBL>& cloud = *labelled.cloud;
  for (pcl::PointXYZRGBL& point : cloud)
    point.label = support_label;
  const auto objectLabel = [] (std::size_t object) {
    return (first_object_label + labels_an_object * static_cast<std::uint32_t> (object));
  };
  if (!source.labels.empty ())
  {
    const Image<std::uint16_t> labels = readLabels (source.labels, cloud);
    const std::set<std::uint16_t> support (source.support_labels.begin (), source.support_labels.end ());
    for (std::size_t i = 0; i < cloud.size (); ++i)
      if (support.count (labels[i]) == 0)
        cloud[i].label = objectLabel (labels[i]);
  }
  for (std::size_t object = 0; object < source.masks.size (); ++object)
  {
    const Image<std::uint16_t> mask = readLabels (source.masks[object], cloud);
    for (std::size_t i = 0; i < cloud.size (); ++i)
      if (mask[i] != 0 && cloud[i].label == support_label)
        cloud[i].label = objectLabel (object);
  }
  for (pcl::PointXYZRGBL& point : cloud)
    if (!pcl::isXYZFinite (point))
      point.label = 0;
  return (labelled);
}

} // namespace pcl_attention
