// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief Which regions of a labelled scene count as objects; mOSD's two ground truths. */
enum class GroundTruthKind
{
  objects, ///< label / 10: pieces behind an occluder and the faces of a bowl are one object
  parts    ///< the raw label: every visible piece on its own
};

/** \brief "objects" or "parts". */
std::string toString (GroundTruthKind kind);

/** \brief The other way round.
 * \throws std::invalid_argument if it is neither */
GroundTruthKind groundTruthKindFromName (const std::string& name);

/** \brief One object (or part) of the ground truth. */
struct Region
{
  std::uint32_t label = 0; ///< label / 10 for objects, the raw label for parts
  std::size_t pixels = 0;  ///< valid pixels, at least 1
  int center_column = 0;   ///< the region's own pixel that is closest to the mean of its pixels;
  int center_row = 0;      ///< ties go to the first in row-major order
};

/** \brief The ground truth of a scene, one entry a pixel.
 *
 * Labels: 0 invalid, 1-19 support and background, from 20 on parts of objects. A point with a coordinate that is not
 * finite is invalid whatever its label: it can be in no object and counts in no mask. A finite point of label 0 is in
 * no object either, but it counts in a mask that covers it. Regions are kept however small they are. */
struct GroundTruth
{
  /** \brief What a pixel shows when it is no region's; the values of \ref region_of below 0. */
  enum Surface : int
  {
    support = -1,    ///< label 1-19
    unlabelled = -2, ///< label 0, finite coordinates
    invalid = -3     ///< a coordinate is not finite
  };

  GroundTruthKind kind = GroundTruthKind::objects;
  int width = 0;               ///< pixels
  int height = 0;              ///< pixels
  std::vector<Region> regions; ///< in ascending order of their labels
  std::vector<int> region_of;  ///< per pixel, row-major: index into \ref regions, or a Surface
};

/** \brief The ground truth of an organized labelled cloud.
 * \throws std::invalid_argument if the cloud is empty or its size does not match width * height */
GroundTruth makeGroundTruth (const pcl::PointCloud<pcl::PointXYZRGBL>& cloud, GroundTruthKind kind);

} // namespace pcl_attention
