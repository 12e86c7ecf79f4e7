// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/attention_points.h>
#include <pcl_attention/core/color_histogram.h>
#include <pcl_attention/core/patch_graph.h>

#include <Eigen/Geometry>

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_attention
{

/** \brief A rectangle of pixels. */
struct PixelRegion
{
  int column{0}, row{0};   /**< of its first pixel */
  int width{0}, height{0}; /**< pixels */
};

/** \brief From minimum to maximum, both inclusive. */
struct ValueRange
{
  float minimum{0.0f};
  float maximum{std::numeric_limits<float>::max ()};

  bool
  contains (float value) const { return (value >= minimum && value <= maximum); }
};

/** \brief What a task asks for: any of a map, regions, colours, a size and a distance. Each part that is given says how well a place
  * matches, from 0 to 1; the parts multiply.
  *
  * The match is that of a whole object, as far as one can be told before it is segmented: the patches that are connected without a
  * crease between them are one piece, and every pixel of a piece has the piece's mean. A prior never hides an object: what does
  * not match at all keeps the weight \ref floor, and comes last. */
struct AttentionPrior
{
  Image<float> map;                   /**< match of every pixel of the cloud, 0..1; empty: not asked for */
  std::optional<PixelRegion> region;  /**< in the image */
  std::optional<Eigen::AlignedBox3f> box; /**< in space, in the frame of the user's cloud, metres */
  std::optional<std::array<std::uint8_t, 3>> color; /**< red, green, blue: see \ref colorSimilarity */
  std::optional<ColorHistogram> color_exemplar; /**< of an example's pixels, for what has several colours: compared by chi-square (eq. 11) */
  std::optional<ValueRange> size;     /**< of the piece's longest side, as in a segment's box, metres */
  std::optional<ValueRange> distance; /**< from the viewpoint, metres */
  float color_tolerance{20.0f};       /**< difference at which a colour matches by half, in CIELAB units, above 0 */
  float floor{0.01f};                 /**< weight of what does not match at all, above 0, up to 1 */

  bool
  empty () const
  {
    return (map.data.empty () && !region && !box && !color && !color_exemplar && !size && !distance);
  }
};

/** \brief Check a prior for a cloud.
  * \return empty, or what is wrong and what would be right */
PCL_ATTENTION_EXPORTS std::string
validate (const AttentionPrior& prior, int width, int height, bool has_color);

/** \brief The 11 basic colour terms (Berlin and Kay 1969) with a colour typical of things in a room, red, green, blue. */
PCL_ATTENTION_EXPORTS const std::vector<std::pair<std::string, std::array<std::uint8_t, 3>>>&
namedColors ();

/** \brief How alike two colours are: 1 / (1 + (d / tolerance)^2), d their distance in CIELAB with the lightness halved, since
  * shading changes that most. */
PCL_ATTENTION_EXPORTS float
colorSimilarity (const std::array<std::uint8_t, 3>& a, const std::array<std::uint8_t, 3>& b, float tolerance);

/** \brief Extent of some points along their first principal axis, metres; 0 without points. */
PCL_ATTENTION_EXPORTS float
longestSide (const OrganizedCloud& cloud, const pcl::Indices& pixels);

/** \brief Which patches make up one piece: those connected over most of their border, in no crease; a fragment goes with the patch
  * that it is connected to most.
  * \param[in] excluded 1 at [label] for patches that are no objects; may be empty
  * \return piece of label k at [k], 1, 2, ...; 0 for none */
PCL_ATTENTION_EXPORTS std::vector<int>
groupPatches (const PlanarPatches& patches, const PatchGraph& graph, const std::vector<std::uint8_t>& excluded);

/** \brief Weight of every pixel, floor..1. Those of a piece have the mean of its pixels' matches times the match of the piece as a
  * whole: the square of how its length compares with the asked-for one (half as long or twice as long: 1/4), and of 1 - chi-square of
  * its colours and the exemplar's. Any other pixel has its own match; it has neither a size nor colours together, which is no match.
  * \param[in] piece_of_label as from \ref groupPatches
  * \param[in] sensor_pose from the cloud's frame to that of the prior's box */
PCL_ATTENTION_EXPORTS Image<float>
priorWeights (const OrganizedCloud& cloud, const PlanarPatches& patches, const std::vector<int>& piece_of_label,
              const Eigen::Isometry3f& sensor_pose, const AttentionPrior& prior);

/** \brief Attention points of a saliency map times weights, and those of the map itself, so that no object loses its points; in the
  * order of \ref sortByWeight, then of weighted saliency.
  * \param[in] weights of the map's size
  * \param[out] result see \ref AttentionPoints; components and skeletons are those of the weighted map, a point that is not of them
  * has component 0 */
PCL_ATTENTION_EXPORTS void
extractAttentionPoints (const Image<float>& saliency, const Image<float>& weights, const std::vector<std::uint8_t>& valid,
                        const AttentionPointParameters& parameters, AttentionPoints& result);

/** \brief Steps of half an octave that a weight lies under 1: 0 from 1 to 0.71, 1 from there to 0.5, ... */
PCL_ATTENTION_EXPORTS float
weightStep (float weight);

/** \brief Order points by how well they match what is asked for, in steps of \ref weightStep; within a step their order
  * stays. */
PCL_ATTENTION_EXPORTS void
sortByWeight (std::vector<AttentionPoint>& points);

} // namespace pcl_attention
