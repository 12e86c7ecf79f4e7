// SPDX-License-Identifier: BSD-3-Clause
#include "byte_reader.h"
#include "scenes.h"

#include <pcl/common/io.h>
#include <pcl/segmentation/attention_segmentation.h>
#include <pcl_attention/core/parameters.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

// Any values of the parameters: within their ranges they segment, beyond they are an error.

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size)
{
  using namespace pcl_attention;
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  ByteReader bytes (data, size);
  const auto& scenes = smallScenes ();
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
  pcl::copyPointCloud (*scenes[static_cast<std::size_t> (bytes.below (static_cast<int> (scenes.size ())))], *cloud);

  AttentionParameters parameters = bytes.flag () ? AttentionParameters::paper () : AttentionParameters ();
  const std::vector<ParameterDescription>& table = parameterTable ();
  while (!bytes.isAtEnd ())
  {
    const ParameterDescription& row = table[bytes.take<std::uint8_t> () % table.size ()];
    const int way = bytes.below (16);
    double value = row.minimum + (row.maximum - row.minimum) * bytes.take<std::uint16_t> () / 65535.0;
    if (way == 0)
      value = row.minimum;
    else if (way == 1)
      value = row.maximum;
    else if (way < 6) // most ranges are wide, their low end is what is used
      value = row.minimum + (value - row.minimum) * 0.01;
    else if (way == 6) // beyond the range as likely as not; an integer field holds no more than this
      value = row.integer ? bytes.take<std::int16_t> () : bytes.number ();
    if (!row.choices.empty () && way == 6)
      value = static_cast<double> (bytes.below (static_cast<int> (row.choices.size ())));
    row.set (parameters, row.integer ? std::floor (value) : value);
  }

  const bool in_range = validate (parameters).empty ();
  pcl::AttentionSegmentation<pcl::PointXYZRGB> segmentation (parameters);
  segmentation.setInputCloud (cloud);
  std::vector<pcl::AttentionSegment> segments;
  if (segmentation.segment (segments) != in_range || (!in_range && !segments.empty ()))
  {
    std::cerr << "parameter_values: " << (in_range ? "an error" : "none") << " for: " << validate (parameters) << std::endl;
    std::abort ();
  }
  return (0);
}
