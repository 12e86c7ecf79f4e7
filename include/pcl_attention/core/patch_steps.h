// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/patch_graph.h>

namespace pcl_attention
{

/** \brief Cut patches that grew over two faces a step apart: growth passes where a step runs out, such as at the corner of a box
  * that stands askew on a larger one, and takes what lies on its other side for more of the same.
  * A patch is cut along a straight line in the image that leaves about the least rms on both sides, the one that the planes of both
  * sides miss most clearly, if they miss it by more than step_tolerance plus step_roughness times their rms. The more their colours
  * differ the less will do, see step_color. A step that is smoothed to a slope leaves little rms: the line that parts the colours best
  * is tried first, if they differ by cut_color. Its pieces are tried again.
  * \param[in] excluded 1 at [label] for patches that stay whole, such as a table; may be empty
  * \param[in,out] patches the larger piece keeps the label, the others come after all; their \ref PlanarPatch::cuts tell them
  *                apart
  * \param[in] threads number of threads, 0: all processors */
PCL_ATTENTION_EXPORTS void
cutAtSteps (const OrganizedCloud& cloud, const std::vector<std::uint8_t>& excluded, const PatchGraphParameters& parameters,
            PlanarPatches& patches, int threads = 1);

/** \brief Take apart what only seems connected. Two patches of one surface meet where their planes do, whether in an edge or as a
  * plane that goes on; the sides of two boxes, one set back behind the other or turned a little, do not. Nor do pieces that were
  * cut apart. Where colours differ less will do, see step_color.
  * \param[in] patches whose graph it is
  * \param[in] excluded 1 at [label] for patches whose planes say nothing, such as a bent table; may be empty
  * \param[in,out] graph connected becomes 0 on the borders of a step */
PCL_ATTENTION_EXPORTS void
disconnectSteps (const OrganizedCloud& cloud, const PlanarPatches& patches, const std::vector<std::uint8_t>& excluded,
                 const PatchGraphParameters& parameters, PatchGraph& graph);

} // namespace pcl_attention
