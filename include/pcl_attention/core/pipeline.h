// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/attention_prior.h>
#include <pcl_attention/core/compact_clustering.h>
#include <pcl_attention/core/image_symmetry.h>
#include <pcl_attention/core/normals.h>
#include <pcl_attention/core/saliency.h>
#include <pcl_attention/core/supporting_plane.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

namespace pcl_attention
{

/** \brief Settings of the way through the stages. */
struct SegmentationParameters
{
  bool prefer_supported{true};     /**< what stands on the supporting plane first, then the rest, each by saliency */
  bool ignore_surroundings{true};  /**< fixations below a certain supporting plane, on the floor or under the table, and beside it give no
                                     object, unless something is asked for */
  bool inhibition_of_return{true}; /**< skip attention points that lie in an earlier segment or lead to one again */
  float full_size{0.01f};          /**< smaller segments are less salient by as much, m^2 of frontal area; 0: off */
  int fixation_margin{8};          /**< a fixation nearer than this to its segment's contour moves inside, pixels; 0: off */
  bool coverage{true};             /**< every patch that no segment claims becomes an attention point, after all others; with
                                     a supporting plane only what stands on it */
  int coverage_size{100};          /**< smaller patches do not, pixels */
  int minimum_segment_size{50};    /**< smaller segments are no objects, pixels */
  float minimum_certain_area{4e-4f}; /**< nor are those whose frontal area times their confidence is smaller, m^2: shreds at holes of
                                        the depth and slivers between objects */
};

/** \brief The settings of all stages. */
struct AttentionParameters
{
  NormalParameters normals;
  SaliencyParameters saliency;
  AttentionPointParameters attention_points;
  ImageSymmetryParameters image_symmetry; /**< for the strategy that looks at the colours alone */
  PatchParameters patches;
  PatchGraphParameters patch_graph;
  SupportParameters support;
  ClusteringParameters clustering;
  SegmentationParameters segmentation;

  /** \brief The paper's text with the repairs that its literal reading needs. */
  PCL_ATTENTION_EXPORTS static AttentionParameters
  paper ();

  /** \brief Segment visible pieces, however small, instead of whole objects: see \ref ClusteringParameters::visiblePieces. */
  PCL_ATTENTION_EXPORTS void
  visiblePieces ();
};

/** \brief Wall time of every stage, milliseconds. */
struct StageTimes
{
  double normals{0.0}, saliency{0.0}, attention_points{0.0}, patches{0.0}, segmentation{0.0};
  double overlap{0.0}; /**< in which stages ran beside each other, so that the sum of all counts it twice */

  double
  total () const { return (normals + saliency + attention_points + patches + segmentation - overlap); }
};

/** \brief A result that is worked out when it is first asked for. To forget it keeps its memory for the next one. */
template <typename T>
class KeptResult
{
public:
  KeptResult&
  operator= (T&& value)
  {
    value_ = std::move (value);
    known_ = true;
    return (*this);
  }

  explicit operator bool () const { return (known_); }

  T&
  operator* () { return (value_); }

  T*
  operator-> () { return (&value_); }

  const T*
  operator-> () const { return (&value_); }

  void
  forget () { known_ = false; }

  /** \brief From now on it is known: put it into what this gives, which holds an older one. */
  T&
  renew ()
  {
    known_ = true;
    return (value_);
  }

private:
  T value_;
  bool known_{false};
};

/** \brief Cloud in, objects out, one fixation at a time; every stage runs when its result is first asked for, and each can be
  * replaced by the user's own result. */
class PCL_ATTENTION_EXPORTS AttentionPipeline
{
public:
  AttentionPipeline () = default;
  // The clustering refers to the pipeline's own patches.
  AttentionPipeline (const AttentionPipeline&) = delete;
  AttentionPipeline&
  operator= (const AttentionPipeline&) = delete;

  /** \brief Forget all results and start with a new frame.
    * \param[in] cloud in the sensor frame
    * \param[in] sensor_pose from the sensor frame to the frame of the user's cloud, in which planes and boxes are given
    * \param[in] threads 0: all processors; the result does not depend on it */
  void
  start (OrganizedCloud&& cloud, const Eigen::Isometry3f& sensor_pose, const AttentionParameters& parameters, int threads);

  /** \brief The cloud of the frame that is over, so that the next one can be put into its memory. Then only \ref start. */
  OrganizedCloud
  releaseCloud () { return (std::move (cloud_)); }

  /** \brief Go on with the same frame and other parameters: the results that do not depend on what has changed are kept with
    * their times, the others are forgotten, the user's own too, and \ref next begins again with the first object. */
  void
  changeParameters (const AttentionParameters& parameters);

  /** \brief The user's own normals, saliency (of the cloud's size, from 0 up), patches or attention points (whose order stands)
    * instead of the computed ones. Before the first result that depends on them is asked for. */
  void
  setNormals (NormalImage&& normals);
  void
  setSaliency (Image<float>&& saliency);
  void
  setPatches (PlanarPatches&& patches);
  void
  setAttentionPoints (AttentionPoints&& points);

  /** \brief Ask for something, or with an empty prior for nothing in particular any more. \ref next starts again; of the results
    * of the stages only the attention points are forgotten, the user's too. */
  void
  setPrior (AttentionPrior&& prior);

  const OrganizedCloud&
  cloud () const { return (cloud_); }
  /** \brief Number of threads that the frame is worked on with, at least 1. */
  int
  threads () const { return (threads_); }
  const NormalImage&
  normals ();
  const SaliencyMaps&
  saliency ();
  /** \brief See \ref findWinningSymmetry. */
  WinningSymmetry
  winningSymmetry () { return (findWinningSymmetry (saliency (), parameters_.saliency)); }
  /** \brief See \ref computeImageSaliency. */
  const Image<float>&
  imageSaliency ();
  /** \brief See \ref pcl_attention::priorWeights; empty without a prior. */
  const Image<float>&
  priorWeights ();
  const AttentionPoints&
  attentionPoints ();
  /** \brief The patches that are clustered: cut along the planes of the background, unless those are not stayed off. */
  const PlanarPatches&
  patches ();
  /** \brief Of the patches that are clustered: those of \ref patches. */
  const PatchGraph&
  patchGraph ();

  /** \brief In the frame of the user's cloud; the plane that objects stand on first, if there is one. */
  const std::vector<SupportingPlane>&
  supportingPlanes ();

  /** \brief The next object in order of attention.
    * \return false when there is none left */
  bool
  next (AttentionSegment& segment);

  /** \brief All objects that \ref next would give, in its order; several threads work them out together.
    * \param[out] segments nothing else than the objects that are left */
  void
  all (std::vector<AttentionSegment>& segments);

  /** \brief The object at a point of the user's choice; does not change what \ref next gives.
    * \return false when there is no patch at the point */
  bool
  segmentAt (const AttentionPoint& point, AttentionSegment& segment);

  const StageTimes&
  times () const { return (times_); }

private:
  /** \brief Begin again with the first object. */
  void
  restart ();
  void
  forgetAttentionPoints ();
  /** \brief With all that is made of the patches but the attention points. */
  void
  forgetPatches ();

  /** \brief Patches, their graph and the planes of the background. */
  void
  preparePatches ();
  /** \brief Patches beside the planes, and their graph. */
  void
  makePatches ();

  /** \brief All that the first object needs: with several threads one of them prepares the patches while the others share the
    * saliency, in which it then joins them. */
  void
  prepareObjects ();
  /** \brief The coarser levels of the pyramid, for the saliency and the supporting planes. */
  const std::vector<PyramidLevel>&
  coarser ();
  CompactClustering&
  clustering ();
  void
  fillQueue ();
  std::vector<AttentionPoint>
  coveragePoints () const;
  std::size_t
  indexOf (const AttentionPoint& point) const { return (static_cast<std::size_t> (point.row) * cloud_.width + point.column); }
  /** \brief Whether a point stands on the supporting plane, where that counts; coverage points do, the user's order stands. */
  bool
  isPreferred (const AttentionPoint& point) const;
  /** \brief Whether a point stands on the supporting plane, or there is none. */
  bool
  isSupported (const AttentionPoint& point) const;
  /** \brief Whether a point lies below a certain supporting plane or beside it, where that counts. */
  bool
  isIgnored (const AttentionPoint& point) const;
  /** \brief Whether a point is not to find again what was found. */
  bool
  avoidsReturn (const AttentionPoint& point) const
  {
    return (parameters_.segmentation.inhibition_of_return || point.kind == AttentionPointKind::coverage);
  }
  /** \brief Whether an earlier segment has claimed a point that is therefore skipped. */
  bool
  isInhibited (const AttentionPoint& point) const { return (avoidsReturn (point) && claimed_[indexOf (point)]); }

  /** \brief What is asked for first, then what is preferred, then by saliency. */
  using Priority = std::tuple<float, bool, float>;
  Priority
  priorityOf (std::size_t place, float size_weight) const;
  /** \brief What its pixels cover at their depth, facing the camera, m^2; infinite where the focal length is not known. */
  float
  frontalArea (const AttentionSegment& segment) const;
  /** \brief Whether a segment of this frontal area may be an object. */
  bool
  isLargeEnough (const AttentionSegment& segment, float area) const;
  /** \brief 0..1: a fragment that happens to be salient does not come before the objects. */
  float
  sizeWeight (float area) const;
  /** \brief Grow at points of the queue side by side what \ref growAt will most likely need. The results do not depend on it. */
  void
  growAhead ();
  /** \brief Segment at a point of the queue; what is found waits for its turn. */
  void
  growAt (std::size_t place);
  /** \brief Whether most of a segment was already found. */
  bool
  isDuplicate (const AttentionSegment& segment) const;

  /** \brief Move a fixation on the edge of its segment inwards, where a robot's gripper or a person would look. */
  void
  moveInside (AttentionSegment& segment) const;

  /** \brief Find the next object, without what follows from its pixels alone. */
  bool
  find (AttentionSegment& segment);
  /** \brief The rest of an object that was found. */
  void
  describe (AttentionSegment& segment) const;

  AttentionParameters parameters_;
  int threads_{1};
  Eigen::Isometry3f sensor_pose_{Eigen::Isometry3f::Identity ()};
  OrganizedCloud cloud_;
  SensorModel sensor_; /**< known with the planes */
  KeptResult<NormalImage> normals_;
  std::vector<PyramidLevel> coarser_; /**< until all that needs them is done */
  KeptResult<SaliencyMaps> saliency_;
  std::optional<Image<float>> image_saliency_;
  AttentionPrior prior_;
  Image<float> prior_weights_; /**< empty without a prior, and until asked for */
  std::optional<AttentionPoints> attention_points_;
  std::optional<PlanarPatches> patches_;
  std::optional<PatchGraph> patch_graph_;
  std::optional<std::vector<SupportingPlane>> supporting_planes_;
  std::vector<std::uint8_t> support_patches_; /**< 1 at [label] for the patches that are background */
  std::unique_ptr<CompactClustering> clustering_;
  /** \brief A segment that was grown and has not been given out. */
  struct Waiting
  {
    AttentionSegment segment;
    Priority priority;
    std::vector<std::size_t> others; /**< places of later points on it, which need no segment of their own if it is found */
  };

  std::vector<AttentionPoint> queue_; /**< in the order they are visited: the preferred points, coverage points, the others */
  std::size_t next_point_{0};
  bool queue_filled_{false};
  bool points_are_users_{false}; /**< the order is the user's as well */
  std::vector<Waiting> waiting_; /**< in the order of their points */
  std::map<std::size_t, AttentionSegment> grown_ahead_; /**< at a place of the queue */
  std::vector<std::uint8_t> claimed_; /**< 1 where a segment was found */
  std::set<std::vector<int>> fruitless_; /**< initial patches from which what was found, or too small, would grow again */
  int segments_found_{0};
  bool expects_all_{false}; /**< so that what is worked out ahead is not in vain */
  StageTimes times_;
};

} // namespace pcl_attention
