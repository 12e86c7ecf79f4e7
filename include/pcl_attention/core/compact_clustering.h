// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/attention_points.h>
#include <pcl_attention/core/color_histogram.h>
#include <pcl_attention/core/patch_graph.h>
#include <pcl_attention/core/visible_hull.h>

#include <Eigen/Geometry>

#include <functional>
#include <memory>
#include <optional>

namespace pcl_attention
{

class ObjectHull;
struct HullGrid;
struct RowSpans;

/** \brief Which patches an object starts with (paper IV-B: "all patches bordering this point with a 5 pixel radius"). */
enum class InitialPatches
{
  within_radius, /**< all of them, as printed */
  connected      /**< the patch at the point, and those within the radius that are connected to it in 3D and not concave */
};

/** \brief How the colours of a patch, the object and the not-object are compared. Chi-square is a distance, so that the printed
  * CS_out < CS_in prefers patches that look like the background. */
enum class ColorConstraint
{
  off,          /**< not at all */
  nearer_object, /**< CS_in < CS_out: the patch looks more like the object */
  as_printed    /**< CS_out < CS_in, the paper's text */
};

/** \brief Settings of the clustering of patches (paper IV-B). */
struct ClusteringParameters
{
  InitialPatches initial_patches{InitialPatches::connected};
  int initial_radius{5};              /**< around the attention point, pixels */
  ColorConstraint color_constraint{ColorConstraint::off};
  float compactness_threshold{0.005f}; /**< theta_com, metres */
  float compactness_noise{2.5f};      /**< added to it, standard deviations of the depth: noise moves a hull outwards */
  int compactness_samples{100};       /**< points of a patch that kappa is the mean of, at most */
  HullMethod hull_method{HullMethod::growing};
  FaceDistance face_distance{FaceDistance::plane};
  float minimum_connection{0.5f};     /**< share of the common border that is connected in 3D, 0..1; 0: off */
  float minimum_convexity{-0.2f};     /**< of the common border, -2 (concave) .. 2; -2: off */
  float color_convexity{0.3f};        /**< how much more convexity differing colours ask for, and like colours spare */
  float color_compactness{0.6f};      /**< share by which the compactness threshold is smaller where a patch has no colours in
                                        common with the object, 0..1; not where they are rather alike, see
                                        \ref colorContrast */
  float color_contact{0.15f};         /**< share of the shorter outline, as far as it borders on patches, over which a patch with no
                                        colours in common has to be connected, 0..1; less where they have some, none for a patch
                                        that is a small part of the object, or the object of it */
  bool stay_off_support{true};        /**< patches of a supporting plane are not added */
  bool recognize_hollows{true};       /**< patches that curve inwards together are the inside of one hollow, concave as their
                                        borders are */
  float minimum_hollowness{0.01f};    /**< mean cosine between the normals of such a patch and the direction to its middle, -1..1 */
  bool separate_floors{false};        /**< borders within a hollow are not as concave where one of the patches is a plane, as the flat
                                        floor of a pot is; on with -parts */
  float certain_hollowness{0.15f};    /**< the same of what is the inside of a bowl or mug for certain, its negative of an outside */
  int certain_size{200};              /**< the shape of fewer pixels says nothing */
  float rim_convexity{0.5f};          /**< of a border, -2 .. 2: where it is more convex, the inside of a hollow turns over its rim and
                                        ends; 2: off */
  float surface_tolerance{0.01f};     /**< how far the points of one rim may lie off its plane (rms), and planes that go on behind an
                                        occluder off each other, metres; compactness_noise is added */
  float handle_width{0.02f};          /**< what is wider is no handle, metres */
  int handle_size{4};                 /**< nor is what is larger than this part (1 / n) of the object */
  float occluded_distance{0.3f};      /**< pieces of an object behind an occluder are no farther apart, metres */
  float joined_color{0.5f};           /**< nor are their colours if only one face goes on behind it, nor those of a handle and its
                                        object, chi-square, 0..1 */
  int contour_width{3};               /**< an object gets the points at its contour that have its colours and not those around it, at
                                        most so far off, pixels; 0: off. The planes' ends are known to some pixels only */
  int smoothed_contour_width{6};      /**< the same where the sensor smooths its depth, with which colours take points away too, and
                                        jumps do not tell to the pixel where an object ends; 0: as with other sensors */
  bool join_hollows{true};            /**< join the inside of a hollow and the wall before it; off with -parts */
  bool join_handles{true};            /**< join a thin piece that hangs on an object and on nothing else; off with -parts */
  bool join_occluded{true};           /**< join pieces of one object that an occluder separates; off with -parts */

  /** \brief Whether anything joins what has grown from different patches. */
  bool
  joinsPieces () const
  {
    return (join_hollows || join_handles || join_occluded);
  }

  /** \brief Switch off what joins visible pieces into whole objects (`-parts`). */
  void
  visiblePieces ()
  {
    join_hollows = join_handles = join_occluded = false;
    separate_floors = true;
    minimum_hollowness = 0.03f; // what is nearly flat is no part of an inside either
  }
};

/** \brief What decided about a candidate patch. */
enum class GrowthConstraint
{
  none,        /**< every constraint held */
  connection,  /**< too little of the border, or of the outline where colours differ, is connected in 3D */
  convexity,   /**< the border is concave */
  color,       /**< paper eq. 11 and 12 */
  compactness, /**< paper eq. 13 and 14 */
  support      /**< the patch belongs to a supporting plane */
};

/** \brief "none", "connection", "convexity", "color", "compactness" or "support". */
PCL_ATTENTION_EXPORTS const char*
toString (GrowthConstraint constraint);

/** \brief One step of the growth: which patch was tried, and by which constraint and how much it was refused. */
struct GrowthStep
{
  int patch{0};                                        /**< label */
  GrowthConstraint refused_by{GrowthConstraint::none}; /**< none: the patch was added */
  float value{0.0f};                                   /**< what the deciding constraint measured */
  float limit{0.0f};                                   /**< what it was compared with */
};

/** \brief An oriented box. */
struct OrientedBox
{
  Eigen::Vector3f center{Eigen::Vector3f::Zero ()};                /**< metres */
  Eigen::Quaternionf orientation{Eigen::Quaternionf::Identity ()}; /**< from the box's axes to the cloud's */
  Eigen::Vector3f size{Eigen::Vector3f::Zero ()};                  /**< along the box's axes, metres */
};

/** \brief One object: what was found at a fixation, and why it ended there. */
struct AttentionSegment
{
  pcl::Indices indices;                /**< of its points in the input cloud, ascending */
  AttentionPoint attention_point;      /**< the fixation it grew from */
  int rank{0};                         /**< 1, 2, ... in order of attention */
  std::vector<int> patches;            /**< labels, in the order they were added */
  Eigen::Vector4f plane{Eigen::Vector4f::Zero ()}; /**< of the patch at the fixation: a, b, c, d, towards the viewpoint, metres */
  OrientedBox box;
  float compactness{0.0f};             /**< kappa (eq. 13), metres */
  float confidence{0.0f};              /**< 0..1, about the F to expect: exp (-2 d / n) for n pixels, d the pairs of the contour
                                         where it may be wrong: at the support, a connected neighbour, a depth hole or the
                                         image border, and a quarter of those at an occluder */
  GrowthConstraint growth_end{GrowthConstraint::none}; /**< what refused the neighbour with the longest common border when
                                                         growth ended; none: no neighbour was left */
  std::vector<GrowthStep> steps;       /**< the growth, step by step; starts after the initial patches */
};

/** \brief Grows objects over the patch graph. Holds what is shared by all objects of a scene: samples and hulls of the patches,
  * and their colour histograms. The cloud, patches and graph must outlive it. */
class PCL_ATTENTION_EXPORTS CompactClustering
{
public:
  /** \param[in] support_patches 1 at [label] for patches that belong to a supporting plane; may be empty
    * \param[in] threads number of threads, 0: all processors; for what is made of every patch */
  CompactClustering (const OrganizedCloud& cloud, const SensorModel& sensor, const NormalImage& normals,
                     const PlanarPatches& patches, const PatchGraph& graph, const std::vector<std::uint8_t>& support_patches,
                     const ClusteringParameters& parameters, int threads = 1);
  ~CompactClustering ();

  /** \brief Labels of the patches that the object at an attention point starts with, the nearest first (paper IV-B); empty when
    * there is none within the initial radius. */
  std::vector<int>
  initialPatches (const AttentionPoint& point) const;

  /** \brief Segment the object at an attention point (paper IV-B).
    * \param[in] initial the point's \ref initialPatches
    * \return false when there are none */
  bool
  grow (const AttentionPoint& point, const std::vector<int>& initial, AttentionSegment& segment);

  /** \brief Grow beforehand the pieces that objects are put together from. The results of \ref grow do not depend on it.
    * \param[in] is_over asked before each piece: whether to leave the others */
  void
  growAhead (const std::function<bool ()>& is_over);

private:
  /** \brief A sample of a patch's points. */
  struct Sample
  {
    Eigen::Vector3f point, normal;
    float weight; /**< pixels it stands for */
  };

  struct Piece;

  /** \brief Patches that nothing can grow from to others, or from others to. */
  struct Island
  {
    std::vector<int> seeds; /**< labels, the largest patch first */
    std::size_t next{0};    /**< the first of them that may have no piece yet */
    std::vector<std::unique_ptr<Piece>> pieces; /**< of the partition, as far as they are known */
  };

  /** \brief The samples of some patches, evenly taken where there are more than it needs. */
  template <typename Visit> void
  forEachSample (const std::vector<int>& labels, const Visit& visit) const;

  void
  findIslands ();

  bool
  isSupport (int label) const { return (!support_patches_.empty () && support_patches_[label]); }

  bool
  isStayedOff (int label) const { return (parameters_.stay_off_support && isSupport (label)); }

  void
  addPatch (int label, Piece& piece);
  /** \param[in] united hull of the piece with the patch */
  void
  addPatch (int label, Piece& piece, ObjectHull&& united);

  /** \brief Try every neighbour, the longest connected border first, until none can be added.
    * \param[in] of_partition stop at what belongs to another piece of the partition */
  void
  growOverBorders (Piece& piece, bool of_partition);

  /** \brief Whether a piece and a patch, neither of them an outside, are parts of the inside of one hollow. */
  bool
  isOneInside (const Piece& piece, int label, const PatchBorder& border);

  /** \brief Share of the shorter outline of a patch and a piece, as far as it borders on patches, that is connected. */
  float
  contactOf (int label, const PatchBorder& border, const Piece& piece) const;

  /** \brief Ask all constraints about a patch.
    * \param[in] border from the piece to the patch
    * \param[out] united hull of the piece with the patch, if it can be added */
  GrowthStep
  tryPatch (int label, const PatchBorder& border, Piece& piece, ObjectHull& united);

  /** \brief kappa of some patches (paper eq. 13), to the hidden faces if they are hollow. */
  float
  compactnessOf (const std::vector<int>& labels, const VisibleHull& hull, bool hollow) const;

  /** \brief A length plus what noise adds to it at a depth, see \ref ClusteringParameters::compactness_noise. */
  float
  withNoise (float length, float depth) const
  {
    return (length + parameters_.compactness_noise * sensor_.depth_noise * depth * depth);
  }

  /** \brief What kappa of an object that a patch is added to must not reach, metres. */
  float
  compactnessLimit (int label) const
  {
    return (withNoise (parameters_.compactness_threshold, patches_.patches[label - 1].centroid.z ()));
  }

  /** \brief CS_in and CS_out (paper eq. 11 and 12). */
  std::pair<float, float>
  colorDistances (int label, Piece& piece) const;

  /** \brief Colours outside the piece's mask enlarged to twice its area (paper IV-B.1). */
  ColorHistogram
  notObject (const Piece& piece) const;

  Eigen::Vector3f
  centroidOf (const std::vector<int>& labels) const;

  /** \brief Mean of n . (c - p) / |c - p| over the points p of some patches, c their centroid: > 0 for the inside of a hollow,
    * < 0 for an outside, about 0 for a plane. */
  float
  hollownessOf (const std::vector<int>& labels) const;
  float
  patchHollowness (int label);

  /** \brief Whether a patch that is large enough to tell is a plane but for the noise. */
  bool
  isPlane (int label) const;

  /** \brief What grows from a patch on its own. */
  Piece
  grownFrom (int label);

  /** \brief The piece of the scene's partition that a patch belongs to. Each piece grows from the largest patch that is left, over
    * what is left. */
  const Piece&
  pieceAt (int label);

  /** \brief Border of a piece to all patches of another that it does not have itself. */
  PatchBorder
  borderBetween (const Piece& piece, const Piece& other) const;

  int
  commonPixels (const Piece& piece, const Piece& other) const;

  /** \brief Whether two pieces, grown from different patches, are mostly one. */
  bool
  isSame (const Piece& piece, const Piece& other) const;

  /** \brief Join the first neighbouring piece that belongs to the object although it is not connected over a border that the
    * constraints allow.
    * \return false when there is none */
  bool
  joinPiece (Piece& object);
  /** \brief See \ref AttentionSegment::confidence. */
  float
  confidenceOf (const Piece& object) const;

  /** \brief Grow from the initial patches and join what belongs to the object. */
  Piece
  wholeObject (const std::vector<int>& initial);

  /** \brief A fixation may lie on a handle: if a much larger neighbour, grown on its own, takes the object in, it is the object. */
  void
  takeLargerObject (Piece& object);

  /** \brief The patches of a piece that tell whether it is the inside of a hollow: those that are, or all that have grown
    * together. */
  static const std::vector<int>&
  insideOf (const Piece& piece);
  /** \brief Whether what is between two pieces parts the inside of one hollow. */
  bool
  areHalvesOfInside (const Piece& piece, const Piece& other) const;
  /** \brief A piece that with a grown one makes up the inside of a hollow in which something stands between them.
    * \return null when there is none */
  const Piece*
  otherHalfOf (const Piece& piece);
  /** \brief Add what a piece does not have yet of another. \param[in] inside those of the other's patches that become part of its
    * inside */
  void
  addPiece (const Piece& other, const std::vector<int>& inside, Piece& piece);
  void
  joinHalf (const Piece& half, Piece& piece);
  /** \brief A piece of the partition with all others that make up the inside of one hollow with it. */
  const Piece&
  withHalves (const Piece& piece);

  /** \brief The pixels within the convex hull of some patches in the image; empty where that has no area. */
  RowSpans
  outlineOf (const std::vector<int>& labels) const;
  /** \brief Whether such a share of a piece's pixels lies within an outline. */
  bool
  liesWithin (const RowSpans& outline, const Piece& piece, float share) const;
  /** \brief Whether a piece is before next to nothing, as what is seen in a hollow. */
  bool
  hidesNothing (const Piece& piece) const;
  /** \brief Ascending; with what was taken for the support, but is seen through the mouth of an object: its floor. */
  pcl::Indices
  pixelsOf (const Piece& object) const;

  bool
  isHandleOf (const Piece& object, const Piece& piece);
  bool
  isFloorOf (const Piece& object, const Piece& piece) const;
  bool
  isHollowOf (const Piece& object, const Piece& piece);
  /** \brief Whether the edge where a wall ends before the inside of a hollow and the far edge of that inside lie in one plane, as
    * the rim of a bowl does, and what happens to stand before it does not. */
  bool
  isRim (const Piece& wall, const Piece& inside) const;
  /** \brief What a wall hides and an inside does not: things that stand in the hollow.
    * \param[in] mouth outline of the inside */
  std::vector<const Piece*>
  standingBetween (const Piece& wall, const Piece& inside, const RowSpans& mouth);
  /** \brief Patches that are no small part of a piece. */
  std::vector<int>
  largePatches (const Piece& piece) const;
  /** \brief Whether two parallel patches lie in one plane. */
  bool
  inOnePlane (const PlanarPatch& first, const PlanarPatch& second) const;
  /** \brief Whether a large patch that shows a shape goes on in one of the other piece, and none is set off from one parallel to it.
    * \param[in] look_alike of the two; if they do not, two faces that are about square to each other must go on */
  bool
  goesOnIn (const Piece& piece, const Piece& other, bool look_alike) const;

  bool
  isBehindSameOccluder (const Piece& object, const Piece& piece);

  /** \brief Work on every patch that an object may have, by several threads. */
  void
  forEachSeed (const std::function<void (int label)>& work) const;

  const ObjectHull&
  patchHull (int label);

  const OrganizedCloud& cloud_;
  const PlanarPatches& patches_;
  const PatchGraph& graph_;
  const std::vector<std::uint8_t> support_patches_;
  const ClusteringParameters parameters_;
  const SensorModel sensor_;
  const int threads_;
  const std::unique_ptr<HullGrid> hull_grid_;
  std::vector<std::vector<Sample>> samples_;                /**< of label k at [k] */
  std::vector<RowSpans> rows_;                              /**< of label k at [k] */
  std::vector<std::unique_ptr<ObjectHull>> hulls_;          /**< of label k at [k]; null until asked for */
  std::vector<const Piece*> piece_of_;                      /**< of label k at [k], in the partition; null until known */
  std::vector<std::optional<std::unique_ptr<Piece>>> with_halves_; /**< of the piece that begins with label k at [k], once asked for;
                                                                      null: it has no other half */
  std::vector<int> seeds_;                                  /**< labels, the largest patch first */
  std::vector<Island> islands_;
  std::vector<int> island_of_;                              /**< of label k at [k], place in islands_ */
  std::vector<std::optional<float>> patch_hollowness_;      /**< of label k at [k], once asked for */
  std::vector<HexconeHistogram> colors_;                    /**< of label k at [k]; empty without colour */
  std::vector<ColorHistogram> histograms_;                  /**< of label k at [k]; empty without the colour constraint */
  ColorHistogram scene_histogram_;                          /**< of all points; empty without the colour constraint */
  std::vector<std::uint8_t> color_bins_;                    /**< of every pixel; empty without colour and without the constraint */
};

} // namespace pcl_attention
