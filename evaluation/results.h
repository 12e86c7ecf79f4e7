// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/prediction.h"

#include <string>

namespace pcl_attention
{

/** \brief Read anyone's results for a scene, in the layout that pcl_attention_segment writes.
 *
 * | file | what is read of it |
 * |---|---|
 * | attention_points.csv | a header, then one row a point; columns rank (1, 2, ... without gaps), column and row,
 * optionally kind; others are ignored | | mask_0001.png ... | one a rank: 8-bit grey, 255 = segment, 0 = not | |
 * labels.pcd | optional: `label` per point, 0 = no object; without it the first segment that claims a pixel has it | |
 * segments.json | optional: `confidence` (0 to 1) beside `rank`, in an array or in the array "segments" of an object |
 *
 * \param[in] folder the scene's own folder
 * \param[in] width, height size of the scene in pixels, which the results must have
 * \throws std::runtime_error that names the file which is missing or broken */
ScenePrediction readResults (const std::string& folder, int width, int height);

} // namespace pcl_attention
