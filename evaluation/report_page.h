// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/evaluation.h"

#include <functional>
#include <string>

namespace pcl_attention
{

/** \brief The PNG file that shows what a system finds in a scene, or with an empty system the scene's ground truth;
 * empty where there is none. */
using PictureOf = std::function<std::string (const std::string& system, const std::string& scene)>;

/** \brief The report as one HTML page that refers to nothing outside of itself: tables, charts and pictures. */
std::string reportPage (const Evaluation& evaluation, const PictureOf& picture_of);

} // namespace pcl_attention
