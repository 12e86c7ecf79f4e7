// SPDX-License-Identifier: BSD-3-Clause
#include "byte_reader.h"
#include "scenes.h"

#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>
#include <pcl/segmentation/attention_filter.h>
#include <pcl/segmentation/attention_segmentation.h>
#include <pcl/segmentation/impl/organized_cloud.hpp>

#include <cstdlib>
#include <iostream>
#include <string>

// Whatever a camera sends through AttentionSegmentation: any points, size, indices, pose, and anything of the user's own.

namespace pcl_attention
{
namespace
{

void
expect (bool holds, const char* what)
{
  if (holds)
    return;
  std::cerr << "cloud: " << what << std::endl;
  std::abort ();
}

template <typename PointT>
void
setColor (PointT& point, std::uint8_t red, std::uint8_t green, std::uint8_t blue)
{
  if constexpr (HasRgb<PointT>::value)
  {
    point.r = red;
    point.g = green;
    point.b = blue;
  }
}

/** \brief A value for every point, or a few less or more. */
std::size_t
nearSize (std::size_t size, ByteReader& bytes)
{
  constexpr int offsets[] = {0, 0, 0, 0, 0, 0, 1, -1};
  const int offset = offsets[bytes.below (8)];
  return (offset < 0 && size == 0 ? 0 : size + offset);
}

/** \brief A rendered scene with changes, or all by the bytes. */
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
takeCloud (ByteReader& bytes)
{
  const typename pcl::PointCloud<PointT>::Ptr cloud (new pcl::PointCloud<PointT>);
  const auto& scenes = smallScenes ();
  const auto base = static_cast<std::size_t> (bytes.below (16));
  if (base < scenes.size ())
    pcl::copyPointCloud (*scenes[base], *cloud);
  else
  {
    cloud->width = bytes.below (32);
    cloud->height = bytes.below (24);
    cloud->points.resize (static_cast<std::size_t> (cloud->width) * cloud->height);
    const float depth = bytes.number (), slope = bytes.number ();
    for (std::size_t index = 0; index < cloud->size (); ++index)
    {
      PointT& point = (*cloud)[index];
      const auto column = static_cast<float> (index % cloud->width), row = static_cast<float> (index / cloud->width);
      point.z = depth + slope * 0.01f * row;
      point.x = 0.02f * (column - 16.0f) * point.z;
      point.y = 0.02f * (row - 16.0f) * point.z;
      setColor (point, static_cast<std::uint8_t> (index), static_cast<std::uint8_t> (index >> 4), 90);
    }
  }
  if (bytes.flag ())
  {
    for (float& coordinate : {std::ref (cloud->sensor_origin_[0]), std::ref (cloud->sensor_origin_[1]),
                              std::ref (cloud->sensor_origin_[2]), std::ref (cloud->sensor_origin_[3])})
      coordinate = bytes.number ();
    cloud->sensor_orientation_.coeffs () << bytes.number (), bytes.number (), bytes.number (), bytes.number ();
  }
  // Rectangles of one kind of value, down to single points.
  for (int count = bytes.below (12); count > 0 && !cloud->empty (); --count)
  {
    const auto left = bytes.take<std::uint8_t> () % cloud->width, top = bytes.take<std::uint8_t> () % cloud->height;
    const auto columns = bytes.below (16) * bytes.below (4) + 1u, rows = bytes.below (16) * bytes.below (4) + 1u;
    const int axes = bytes.below (16), way = bytes.below (4);
    const float value = bytes.number ();
    const auto color = bytes.take<std::uint8_t> ();
    for (auto row = top; row < std::min (top + rows, cloud->height); ++row)
      for (auto column = left; column < std::min (left + columns, cloud->width); ++column)
      {
        PointT& point = (*cloud)[static_cast<std::size_t> (row) * cloud->width + column];
        float* const coordinates[] = {&point.x, &point.y, &point.z};
        for (int axis = 0; axis < 3; ++axis)
          if (axes & (1 << axis))
          {
            float& coordinate = *coordinates[axis];
            coordinate = way == 0 ? value : way == 1 ? coordinate + value : way == 2 ? coordinate * value : bytes.number ();
          }
        if (axes & 8)
          setColor (point, color, static_cast<std::uint8_t> (color * 7), static_cast<std::uint8_t> (color * 31));
      }
  }
  switch (bytes.below (16))
  {
    case 0: // unorganized
      cloud->width = static_cast<std::uint32_t> (cloud->size ());
      cloud->height = 1;
      break;
    case 1: // one column
      cloud->height = static_cast<std::uint32_t> (cloud->size ());
      cloud->width = 1;
      break;
    case 2: // a size that is not so
      cloud->width = bytes.take<std::uint32_t> ();
      cloud->height = bytes.take<std::uint32_t> ();
      break;
    case 3:
      cloud->points.resize (nearSize (cloud->size (), bytes));
      break;
    case 4:
      cloud->clear ();
      break;
    default:
      break;
  }
  cloud->is_dense = bytes.flag ();
  return (cloud);
}

template <typename PointT>
void
setIndices (ByteReader& bytes, const pcl::PointCloud<PointT>& cloud, pcl::AttentionSegmentation<PointT>& segmentation)
{
  const int way = bytes.below (8);
  if (way == 0) // any, with repetitions
  {
    const pcl::IndicesPtr indices (new pcl::Indices);
    for (int count = bytes.take<std::uint8_t> (); count > 0; --count)
      indices->push_back (bytes.below (16) == 0 ? bytes.take<std::int32_t> () : bytes.take<std::uint16_t> ());
    segmentation.setIndices (indices);
  }
  else if (way == 1) // part of the cloud, backwards, and some twice
  {
    const pcl::IndicesPtr indices (new pcl::Indices);
    const int step = 1 + bytes.below (5);
    for (auto index = static_cast<pcl::index_t> (cloud.size ()) - 1; index >= 0; index -= step)
      indices->insert (indices->end (), 1 + static_cast<std::size_t> (index % 2), index);
    segmentation.setIndices (indices);
  }
  else if (way == 2)
  {
    const std::size_t row = bytes.below (64), column = bytes.below (64), rows = bytes.below (64), columns = bytes.below (64);
    segmentation.setIndices (row, column, rows, columns);
  }
  else if (way == 3)
    segmentation.setIndices (pcl::IndicesConstPtr ());
}

template <typename PointT>
void
bringOwn (ByteReader& bytes, const pcl::PointCloud<PointT>& cloud, pcl::AttentionSegmentation<PointT>& segmentation)
{
  if (bytes.below (4) == 0)
  {
    const pcl::PointCloud<pcl::Normal>::Ptr normals (new pcl::PointCloud<pcl::Normal>);
    pcl::Normal normal (bytes.number (), bytes.number (), bytes.number (), bytes.number ());
    normals->resize (nearSize (cloud.size (), bytes), normal);
    for (int count = bytes.below (32); count > 0 && !normals->empty (); --count)
    {
      pcl::Normal& other = (*normals)[bytes.take<std::uint16_t> () % normals->size ()];
      other = pcl::Normal (bytes.number (), bytes.number (), bytes.number (), bytes.number ());
    }
    segmentation.setInputNormals (normals);
  }
  if (bytes.below (4) == 0)
  {
    const pcl::PointCloud<pcl::Intensity>::Ptr saliency (new pcl::PointCloud<pcl::Intensity>);
    saliency->resize (nearSize (cloud.size (), bytes));
    saliency->width = cloud.width;
    saliency->height = cloud.height;
    for (int count = bytes.below (64); count > 0 && !saliency->empty (); --count)
    {
      const std::size_t begin = bytes.take<std::uint16_t> () % saliency->size ();
      const float value = bytes.number ();
      for (std::size_t index = begin; index < std::min (begin + 9, saliency->size ()); ++index)
        (*saliency)[index].intensity = value;
    }
    segmentation.setSaliency (saliency);
  }
  if (bytes.below (4) == 0)
  {
    const pcl::PointCloud<pcl::Label>::Ptr patches (new pcl::PointCloud<pcl::Label>);
    patches->resize (nearSize (cloud.size (), bytes));
    patches->width = cloud.width;
    patches->height = cloud.height;
    // Not down to single pixels: the time of growth grows with the cube of the number of patches.
    const std::size_t run = 16 + bytes.below (200);
    const auto factor = bytes.take<std::uint32_t> ();
    for (std::size_t index = 0; index < patches->size (); ++index)
      (*patches)[index].label = static_cast<std::uint32_t> (index / run) * factor;
    segmentation.setPatches (patches);
  }
  if (bytes.below (4) == 0)
  {
    std::vector<pcl::AttentionPoint> points (bytes.below (8));
    for (pcl::AttentionPoint& point : points)
    {
      point.column = bytes.below (16) == 0 ? bytes.take<std::int32_t> () : bytes.below (64);
      point.row = bytes.below (16) == 0 ? bytes.take<std::int32_t> () : bytes.below (48);
      if (bytes.flag ())
      {
        point.saliency = bytes.number ();
        point.point_saliency = bytes.number ();
        point.weight = bytes.number ();
        point.component = bytes.take<std::int32_t> ();
        point.kind = static_cast<AttentionPointKind> (bytes.below (5));
      }
    }
    segmentation.setAttentionPoints (points);
  }
  if (bytes.below (4) == 0)
  {
    AttentionPrior prior;
    const auto range = [&] { return (ValueRange{bytes.number (), bytes.number ()}); };
    const int parts = bytes.take<std::uint8_t> ();
    if (parts & 1)
      prior.map.assign (static_cast<int> (cloud.width % 1024), static_cast<int> (cloud.height % 1024), bytes.number ());
    if (parts & 2)
      prior.region = PixelRegion{bytes.take<std::int32_t> (), bytes.take<std::int32_t> (), bytes.take<std::int32_t> (),
                                 bytes.take<std::int32_t> ()};
    if (parts & 4)
      prior.region = PixelRegion{bytes.below (64), bytes.below (64), bytes.below (64), bytes.below (64)};
    if (parts & 8)
      prior.box = Eigen::AlignedBox3f (Eigen::Vector3f (bytes.number (), bytes.number (), bytes.number ()),
                                       Eigen::Vector3f (bytes.number (), bytes.number (), bytes.number ()));
    if (parts & 16)
      prior.color = {bytes.take<std::uint8_t> (), bytes.take<std::uint8_t> (), bytes.take<std::uint8_t> ()};
    if (parts & 32)
      prior.size = range ();
    if (parts & 64)
      prior.distance = range ();
    if (parts & 128)
    {
      prior.color_exemplar.emplace ();
      prior.color_exemplar->add (colorBin (bytes.take<std::uint8_t> (), bytes.take<std::uint8_t> (), 0));
      prior.floor = bytes.number ();
      prior.color_tolerance = bytes.number ();
    }
    segmentation.setAttentionPrior (prior);
  }
}

template <typename PointT>
void
expectSegment (const pcl::PointCloud<PointT>& cloud, const pcl::AttentionSegment& segment)
{
  expect (!segment.indices.empty (), "a segment without points");
  for (const pcl::index_t index : segment.indices)
    expect (index >= 0 && static_cast<std::size_t> (index) < cloud.size () && pcl::isXYZFinite (cloud[index]),
            "a segment with a point that is not valid");
  const pcl::AttentionPoint& point = segment.attention_point;
  expect (point.column >= 0 && point.row >= 0 && point.column < static_cast<int> (cloud.width) &&
            point.row < static_cast<int> (cloud.height), "an attention point outside of the image");
  expect (segment.confidence >= 0.0f && segment.confidence <= 1.0f, "a confidence that is not from 0 to 1");
}

template <typename PointT>
void
run (ByteReader& bytes)
{
  AttentionParameters parameters = bytes.below (8) == 0 ? AttentionParameters::paper () : AttentionParameters ();
  if (bytes.flag ())
    parameters.visiblePieces ();
  if (bytes.flag ()) // so that small things are objects in small images
  {
    parameters.segmentation.minimum_segment_size = 5;
    parameters.segmentation.coverage_size = 10;
    parameters.patches.minimum_size = 5;
  }
  parameters.attention_points.strategy = static_cast<AttentionStrategy> (bytes.below (3));
  pcl::AttentionSegmentation<PointT> segmentation (parameters);
  const auto cloud = takeCloud<PointT> (bytes);
  segmentation.setInputCloud (cloud);
  setIndices (bytes, *cloud, segmentation);
  bringOwn (bytes, *cloud, segmentation);

  const int way = bytes.below (8);
  const int column = bytes.below (64), row = bytes.below (48);
  if (way == 0)
  {
    pcl::AttentionSegment segment;
    if (segmentation.segmentAt (column, row, segment))
      expectSegment (*cloud, segment);
    else
      expect (segment.indices.empty (), "points of no segment");
  }
  else if (way == 1)
  {
    pcl::PointIndices inliers;
    pcl::ModelCoefficients coefficients;
    const bool found = segmentation.getSupportingPlane (inliers, coefficients);
    expect (found == !inliers.indices.empty () && found == (coefficients.values.size () == 4), "half a plane");
  }
  else if (way == 2)
  {
    pcl::AttentionFilter<PointT> filter (true);
    filter.setInputCloud (cloud);
    pcl::Indices kept;
    filter.filter (kept);
    expect (kept.size () <= cloud->size (), "a filter that adds points");
  }
  else
  {
    std::vector<pcl::AttentionSegment> segments;
    if (!segmentation.segment (segments))
      expect (segments.empty (), "segments after an error");
    for (const pcl::AttentionSegment& segment : segments)
      expectSegment (*cloud, segment);
  }
}

} // namespace
} // namespace pcl_attention

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size)
{
  using namespace pcl_attention;
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  ByteReader bytes (data, size);
  switch (bytes.below (4))
  {
    case 0:
      run<pcl::PointXYZ> (bytes);
      break;
    case 1:
      run<pcl::PointXYZRGBNormal> (bytes);
      break;
    default:
      run<pcl::PointXYZRGB> (bytes);
  }
  return (0);
}
