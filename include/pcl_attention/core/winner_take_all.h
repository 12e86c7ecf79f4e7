// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/skeleton.h>

namespace pcl_attention
{

/** \brief A neuron that fired first. */
struct Winner
{
  Pixel pixel;      /**< where to look: the centre of what is salient around the neuron */
  float saliency{}; /**< mean saliency that the neuron saw, in the map's units */
};

/** \brief Where a winner-take-all network of leaky integrate-and-fire neurons looks, in order (Koch and Ullman 1985; Itti, Koch
  * and Niebur 1998; WTA3D and WTA2D of paper V-A).
  *
  * Every neuron is charged by the saliency of its cell. The first to fire is where to look; all are discharged, and the winner
  * and its neighbours are inhibited by a difference of Gaussians that fades slowly, so that the next one is elsewhere. It ends
  * when a neuron wins for the second time, or when none can fire. Neurons that see too little do not take part.
  * \param[in] saliency any map; not finite and negative values count as 0
  * \param[in] cell_size pixels of the map's square that one neuron sees, at least 1
  * \param[in] threshold share of the most salient cell's mean that a cell must exceed, 0..1
  * \param[in] inhibition_width standard deviation of the inhibition around a winner, cells, above 0 */
PCL_ATTENTION_EXPORTS std::vector<Winner>
findWinners (const Image<float>& saliency, int cell_size, float threshold, float inhibition_width);

} // namespace pcl_attention
