// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/ground_truth.h"
#include "evaluation/labelled_scene.h"

#include <pcl_attention/core/pipeline.h>

#include <ostream>
#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief What a task knows of the object it asks for, each taken from the object's ground truth. */
enum class AskedFor
{
  map,            ///< its mask
  region,         ///< its bounding rectangle in the image
  coarse_region,  ///< the cell of a 4 x 3 grid over the image that its centre lies in
  exemplar,       ///< the histogram of its colours
  color,          ///< its mean colour
  color_name,     ///< the nearest of the named colours
  size,           ///< its longest side, +-10 %
  coarse_size,    ///< the same rounded to 5 cm, +-2.5 cm
  distance,       ///< its distances from the viewpoint but for 5 % at either end
  coarse_distance ///< its mean distance rounded to 10 cm, +-5 cm
};

/** \brief "map", "region", "coarse_region", ...: in the order of AskedFor. */
const std::vector<std::string>& askedForNames ();

/** \brief The prior that asks for one object of a scene.
 * \param[in] region its index in the ground truth */
AttentionPrior priorFor (const pcl::PointCloud<pcl::PointXYZRGBL>& cloud, const GroundTruth& truth, int region,
                         AskedFor asked_for);

/** \brief When an object has its turn, without and with a prior that asks for it. A rank is that of the first segment
 * whose attention point lies on the object; one more than there are segments if none does. */
struct AskedForRanks
{
  int without = 0, with = 0;
};

/** \brief Ask for every object of a scene in turn, by every kind of prior.
 * \return ranks of every region for every kind
 * \throws std::runtime_error that names the scene */
std::vector<std::vector<AskedForRanks>> rankAskedFor (const LabelledScene& scene, const std::vector<AskedFor>& kinds,
                                                      const AttentionParameters& parameters, unsigned int threads);

/** \brief Mean ranks without and with the prior, and the share of the objects that come first, a line a kind.
 * \param[in] ranks of every kind in \a kinds, over the objects of all scenes */
void printAskedFor (std::ostream& stream, const std::vector<AskedFor>& kinds,
                    const std::vector<std::vector<AskedForRanks>>& ranks);

} // namespace pcl_attention
