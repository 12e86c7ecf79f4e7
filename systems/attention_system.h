// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "systems/color_edges.h"
#include "systems/polar_cut.h"
#include "systems/simple_objects.h"
#include "systems/star_cut.h"
#include <pcl_attention/core/pipeline.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief A system of the paper's Table I: a cloud in, segments out in order of attention. */
class AttentionSystem
{
public:
  virtual ~AttentionSystem () = default;

  /** \brief Segment a scene.
   *
   * Of a segment the fixation, the rank and the indices are always set, the rest only by "proposed".
   * \param[in] cloud organized, metres, with colours
   * \throws std::runtime_error that says what is wrong with the cloud */
  virtual std::vector<AttentionSegment> segment (const pcl::PointCloud<pcl::PointXYZRGB>::ConstPtr& cloud) = 0;
};

/** \brief Settings of all systems. */
struct SystemSettings
{
  AttentionParameters proposed;                                 /**< of "proposed" alone */
  AttentionParameters fixations{AttentionParameters::paper ()}; /**< of "M09+..." and "G10", but for their strategy */
  int maximum_fixations{60}; /**< further ones of a scene are not segmented by "M09+..." and "G10" */
  ColorEdgeParameters color_edges;
  PolarCutParameters polar_cut;
  SimpleObjectParameters simple_objects;
  StarCutParameters star_cut;
  int threads{1}; /**< at least 1; changes no result */
};

/** \brief The rows of Table I in its order: "M09+TJ3D", ..., "proposed". */
const std::vector<std::string>& systemNames ();

/** \brief A system by its name.
 * \throws std::invalid_argument that names all there are */
std::unique_ptr<AttentionSystem> makeSystem (const std::string& name, const SystemSettings& settings = {});

} // namespace pcl_attention
