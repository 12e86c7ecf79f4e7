// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl_attention
{

/** \brief A pinhole camera that delivers depth images, or that an unorganized cloud was taken with. Column u and row v
 * of a point are fx x/z + cx and fy y/z + cy; pixels count from 0 at their centres. */
struct DepthCamera
{
  double fx{0.0}, fy{0.0}, cx{0.0}, cy{0.0}; /**< pixels; no camera is known while fx is 0 */
  int width{0}, height{0};                   /**< pixels; 0: not known, a depth image tells it */
  double depth_scale{0.001};                 /**< metres a unit of a depth image */

  bool
  isKnown () const
  {
    return (fx > 0.0);
  }
};

/** \brief Read "fx,fy,cx,cy" or "fx,fy,cx,cy,width,height", or a JSON file with these keys and optionally depth_scale.
 * \throws std::runtime_error that names the text or the file and what is wrong with it */
DepthCamera readDepthCamera (const std::string& text_or_file);

} // namespace pcl_attention
