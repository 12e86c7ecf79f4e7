// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "png_image.h"
#include "viewer_model.h"

#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief Pixels that are drawn over a picture, larger than its own. */
struct Overlay
{
  pcl::Indices pixels;
  std::vector<Color> colors; /**< of each of them */
};

/** \brief A mark at a fixation. */
struct FixationMark
{
  int column, row;
  std::string text; /**< the rank, with F where there are labels */
  Color color;
  bool selected;
};

/** \brief A line of the legend: what a colour stands for. */
struct LegendEntry
{
  Color color;
  std::string text;
};

/** \brief Colour of every pixel in one of the views, as the model's state asks for it. */
Image<Color> paintView (const ViewerModel& model, View view);

/** \brief What lies over it: skeletons, contours, borders. */
Overlay overlayOf (const ViewerModel& model, View view);

/** \brief Numbered fixations of a view; empty in those that have none.
 * \param[in] large whether there is room for the F of every object; else only the selected one has it */
std::vector<FixationMark> fixationMarks (const ViewerModel& model, View view, bool large);

/** \brief Headline of a view. */
std::string titleOf (const ViewerModel& model, View view);

std::vector<LegendEntry> legendOf (const ViewerModel& model, View view);

/** \brief The colours of saliency over black, from 0 to 1: dark red, orange, pale yellow. */
Color saliencyColor (float saliency);

} // namespace pcl_attention
