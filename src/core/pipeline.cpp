// SPDX-License-Identifier: BSD-3-Clause
#include "point_at.h"

#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/object_contour.h>
#include <pcl_attention/core/parameters.h>
#include <pcl_attention/core/patch_steps.h>
#include <pcl_attention/core/pipeline.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>

namespace pcl_attention
{

namespace
{

/** \brief Adds the time until it goes out of scope to a stage's. */
class StageTimer
{
public:
  explicit StageTimer (double& milliseconds) : milliseconds_ (milliseconds) {}

  ~StageTimer ()
  {
    milliseconds_ += std::chrono::duration<double, std::milli> (std::chrono::steady_clock::now () - start_).count ();
  }

  StageTimer (const StageTimer&) = delete;
  StageTimer&
  operator= (const StageTimer&) = delete;

private:
  double& milliseconds_;
  std::chrono::steady_clock::time_point start_{std::chrono::steady_clock::now ()};
};

/** \brief Work in one thread of a team, which an exception must not leave. */
template <typename Work> std::exception_ptr
exceptionOf (const Work& work)
{
  try
  {
    work ();
  }
  catch (...)
  {
    return (std::current_exception ());
  }
  return (nullptr);
}

/** \brief Box along the principal axes of the points, the first axis upright where an upright direction is known.
  * \param[in] upright unit, or zero */
OrientedBox
fitBox (const OrganizedCloud& cloud, const pcl::Indices& indices, const Eigen::Vector3f& upright)
{
  const auto count = static_cast<float> (indices.size ());
  const Eigen::Vector3f first = pointAt (cloud, indices.front ()); // near the others, so that sums of floats stay exact enough
  Eigen::Vector3f mean = Eigen::Vector3f::Zero ();
  for (const pcl::index_t index : indices)
    mean += pointAt (cloud, index) - first;
  mean = first + mean / count;
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero ();
  for (const pcl::index_t index : indices)
  {
    Eigen::Vector3f difference = pointAt (cloud, index) - mean;
    difference -= upright * upright.dot (difference);
    covariance += difference * difference.transpose ();
  }
  covariance /= count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver (covariance);
  Eigen::Matrix3f axes;
  axes.col (0) = upright.isZero () ? Eigen::Vector3f (solver.eigenvectors ().col (0)) : upright;
  axes.col (1) = solver.eigenvectors ().col (2);
  axes.col (1) = (axes.col (1) - axes.col (0) * axes.col (0).dot (axes.col (1))).normalized ();
  axes.col (2) = axes.col (0).cross (axes.col (1));
  Eigen::Vector3f low = Eigen::Vector3f::Constant (std::numeric_limits<float>::max ()), high = -low;
  for (const pcl::index_t index : indices)
  {
    const Eigen::Vector3f local = axes.transpose () * (pointAt (cloud, index) - mean);
    low = low.cwiseMin (local);
    high = high.cwiseMax (local);
  }
  OrientedBox box;
  box.center = mean + axes * (0.5f * (low + high));
  box.orientation = Eigen::Quaternionf (axes);
  box.size = high - low;
  return (box);
}

Eigen::Vector4f
transformPlane (const Eigen::Isometry3f& pose, const Eigen::Vector4f& plane)
{
  Eigen::Vector4f moved;
  moved.head<3> () = pose.linear () * plane.head<3> ();
  moved[3] = plane[3] - moved.head<3> ().dot (pose.translation ());
  return (moved);
}

/** \brief How many pixels lie between each of a mask and the nearest that is none, itself included, along rows, columns
 * and diagonals; what lies beyond the image is none. */
Image<int>
depthsInside (const Image<std::uint8_t>& mask)
{
  Image<int> depths (mask.width, mask.height, 0);
  const auto at = [&] (int column, int row) { return (depths.contains (column, row) ? depths (column, row) : 0); };
  for (int row = 0; row < mask.height; ++row)
    for (int column = 0; column < mask.width; ++column)
      if (mask (column, row))
        depths (column, row) = 1 + std::min ({at (column - 1, row), at (column - 1, row - 1), at (column, row - 1),
                                              at (column + 1, row - 1)});
  for (int row = mask.height - 1; row >= 0; --row)
    for (int column = mask.width - 1; column >= 0; --column)
      if (mask (column, row))
        depths (column, row) = std::min (depths (column, row),
                                         1 + std::min ({at (column + 1, row), at (column + 1, row + 1),
                                                        at (column, row + 1), at (column - 1, row + 1)}));
  return (depths);
}

} // namespace

AttentionParameters
AttentionParameters::paper ()
{
  AttentionParameters parameters;
  parameters.normals.method = NormalMethod::integral_image;
  parameters.saliency.window_radius = 5;
  parameters.saliency.maximum_columns = 0;
  parameters.patches.method = PatchMethod::region_growing;
  parameters.patches.plane_model = PlaneModel::initial;
  parameters.patches.minimum_size = 9;
  parameters.patch_graph.step_roughness = 0.0f;
  parameters.clustering.initial_patches = InitialPatches::within_radius;
  parameters.clustering.color_constraint = ColorConstraint::nearer_object;
  parameters.clustering.compactness_threshold = 0.005f;
  parameters.clustering.hull_method = HullMethod::qhull;
  parameters.clustering.compactness_noise = 0.0f;
  parameters.clustering.face_distance = FaceDistance::triangle;
  parameters.clustering.minimum_connection = 0.0f;
  parameters.clustering.minimum_convexity = -2.0f;
  parameters.clustering.stay_off_support = false;
  parameters.clustering.color_convexity = 0.0f;
  parameters.clustering.color_compactness = 0.0f;
  parameters.clustering.color_contact = 0.0f;
  parameters.clustering.recognize_hollows = false;
  parameters.clustering.contour_width = 0;
  parameters.clustering.smoothed_contour_width = 0;
  parameters.clustering.visiblePieces ();
  parameters.segmentation.prefer_supported = false;
  parameters.segmentation.ignore_surroundings = false;
  parameters.segmentation.full_size = 0.0f;
  parameters.segmentation.inhibition_of_return = false;
  parameters.segmentation.fixation_margin = 0;
  parameters.segmentation.coverage = false;
  parameters.segmentation.minimum_segment_size = 1;
  parameters.segmentation.minimum_certain_area = 0.0f;
  return (parameters);
}

void
AttentionParameters::visiblePieces ()
{
  clustering.visiblePieces ();
  segmentation.minimum_certain_area = 0.0f;
}

void
AttentionPipeline::start (OrganizedCloud&& cloud, const Eigen::Isometry3f& sensor_pose,
                          const AttentionParameters& parameters, int threads)
{
  parameters_ = parameters;
  threads_ = threads > 0 ? threads : static_cast<int> (std::max (1u, std::thread::hardware_concurrency ()));
  sensor_pose_ = sensor_pose;
  forgetPatches ();
  cloud_ = std::move (cloud);
  normals_.forget ();
  coarser_.clear ();
  saliency_.forget ();
  image_saliency_.reset ();
  setPrior (AttentionPrior ());
  times_ = StageTimes ();
  expects_all_ = false;
}

void
AttentionPipeline::setPrior (AttentionPrior&& prior)
{
  prior_ = std::move (prior);
  prior_weights_ = Image<float> ();
  forgetAttentionPoints ();
  restart ();
}

void
AttentionPipeline::forgetAttentionPoints ()
{
  attention_points_.reset ();
  points_are_users_ = false;
  times_.attention_points = 0.0;
}

void
AttentionPipeline::forgetPatches ()
{
  clustering_.reset ();
  patches_.reset ();
  patch_graph_.reset ();
  supporting_planes_.reset ();
  support_patches_.clear ();
  prior_weights_ = Image<float> ();
  times_.patches = 0.0;
}

void
AttentionPipeline::restart ()
{
  queue_.clear ();
  next_point_ = 0;
  waiting_.clear ();
  fruitless_.clear ();
  grown_ahead_.clear ();
  queue_filled_ = false;
  claimed_.assign (cloud_.size (), 0);
  segments_found_ = 0;
  times_.segmentation = 0.0;
  times_.overlap = 0.0;
}

void
AttentionPipeline::changeParameters (const AttentionParameters& parameters)
{
  const auto changed = [&] (const char* stage) {
    const std::vector<ParameterDescription>& table = parameterTable ();
    return (std::any_of (table.begin (), table.end (), [&] (const ParameterDescription& row) {
      return (row.stage == stage && row.get (parameters) != row.get (parameters_));
    }));
  };
  const bool normals_changed = changed ("normals");
  const bool saliency_changed = normals_changed || changed ("saliency");
  const bool image_saliency_changed = changed ("image_symmetry");
  const bool points_changed = saliency_changed || image_saliency_changed || changed ("attention_points");
  // The patches are cut in place, so that whether they are cut is as good as a setting of theirs.
  const bool patches_changed = normals_changed || changed ("patches") || changed ("patch_graph") || changed ("support") ||
                               parameters.clustering.stay_off_support != parameters_.clustering.stay_off_support;
  if (changed ("clustering"))
    clustering_.reset ();
  parameters_ = parameters;
  if (normals_changed)
  {
    normals_.forget ();
    coarser_.clear ();
    times_.normals = 0.0;
  }
  if (saliency_changed)
  {
    saliency_.forget ();
    times_.saliency = 0.0;
  }
  if (image_saliency_changed)
    image_saliency_.reset ();
  if (points_changed || (patches_changed && !prior_.empty ()))
    forgetAttentionPoints ();
  if (patches_changed)
    forgetPatches ();
  restart ();
}

void
AttentionPipeline::setNormals (NormalImage&& normals)
{
  normals_ = std::move (normals);
}

void
AttentionPipeline::setSaliency (Image<float>&& saliency)
{
  saliency_ = SaliencyMaps ();
  saliency_->maximum = saliency.data.empty () ? 0.0f : *std::max_element (saliency.data.begin (), saliency.data.end ());
  saliency_->saliency = std::move (saliency);
}

void
AttentionPipeline::setPatches (PlanarPatches&& patches)
{
  patches_ = std::move (patches);
  describePatches (cloud_, *patches_);
}

void
AttentionPipeline::setAttentionPoints (AttentionPoints&& points)
{
  attention_points_ = std::move (points);
  points_are_users_ = true;
  for (AttentionPoint& point : attention_points_->points)
    point.weight = 1.0f; // their order is the user's, whatever they matched before
}

const NormalImage&
AttentionPipeline::normals ()
{
  if (!normals_)
  {
    const StageTimer timer (times_.normals);
    estimateNormals (cloud_, parameters_.normals, threads_, normals_.renew ());
  }
  return (*normals_);
}

const std::vector<PyramidLevel>&
AttentionPipeline::coarser ()
{
  const int count = std::max (skippedLevels (cloud_.width, parameters_.saliency) + parameters_.saliency.levels - 1,
                              supportLevels (cloud_.width));
  if (static_cast<int> (coarser_.size ()) < count)
    coarser_ = coarserLevels (cloud_, *normals_, count, threads_);
  return (coarser_);
}

const SaliencyMaps&
AttentionPipeline::saliency ()
{
  if (!saliency_)
  {
    normals ();
    const StageTimer timer (times_.saliency);
    computeSaliency (cloud_, *normals_, coarser (), parameters_.saliency, threads_, saliency_.renew ());
  }
  return (*saliency_);
}

const Image<float>&
AttentionPipeline::imageSaliency ()
{
  if (!image_saliency_)
  {
    const StageTimer timer (times_.attention_points); // only the attention points are made of it
    image_saliency_ = computeImageSaliency (cloud_, parameters_.image_symmetry, threads_);
  }
  return (*image_saliency_);
}

const Image<float>&
AttentionPipeline::priorWeights ()
{
  if (!prior_.empty () && prior_weights_.data.empty ())
  {
    preparePatches ();
    const StageTimer timer (times_.attention_points);
    prior_weights_ = pcl_attention::priorWeights (cloud_, *patches_, groupPatches (*patches_, *patch_graph_, support_patches_),
                                                  sensor_pose_, prior_);
  }
  return (prior_weights_);
}

const AttentionPoints&
AttentionPipeline::attentionPoints ()
{
  if (!attention_points_)
  {
    const Image<float>& map = parameters_.attention_points.strategy == AttentionStrategy::image_winner_take_all
                                ? imageSaliency () : saliency ().saliency;
    priorWeights ();
    const StageTimer timer (times_.attention_points);
    attention_points_.emplace ();
    if (!prior_.empty ())
      extractAttentionPoints (map, prior_weights_, cloud_.valid, parameters_.attention_points, *attention_points_);
    else
      extractAttentionPoints (map, cloud_.valid, parameters_.attention_points, *attention_points_);
  }
  return (*attention_points_);
}

void
AttentionPipeline::preparePatches ()
{
  if (patch_graph_)
    return;
  normals ();
  const StageTimer timer (times_.patches);
  sensor_ = estimateSensor (cloud_);
  supporting_planes_ = findSupportingPlanes (cloud_, sensor_, *normals_, coarser (), parameters_.support, threads_);
  makePatches ();
  for (SupportingPlane& plane : *supporting_planes_)
  {
    plane.coefficients = transformPlane (sensor_pose_, plane.coefficients);
    for (Eigen::Vector3f& corner : plane.outline)
      corner = sensor_pose_ * corner;
  }
}

void
AttentionPipeline::makePatches ()
{
  const bool stays_off = !supporting_planes_->empty () && parameters_.clustering.stay_off_support;
  if (!patches_)
  {
    // What the planes take needs no growing.
    Image<int> taken = labelPlanes (cloud_, stays_off ? *supporting_planes_ : std::vector<SupportingPlane> ());
    patches_.emplace ();
    extractPlanarPatches (cloud_, *normals_, std::move (taken), parameters_.patches, *patches_, threads_);
    if (stays_off)
    {
      support_patches_.assign (patches_->patches.size () + 1, 0);
      std::fill_n (support_patches_.begin () + 1, supporting_planes_->size (), 1);
    }
    cutAtSteps (cloud_, support_patches_, parameters_.patch_graph, *patches_, threads_);
    if (stays_off)
      support_patches_.resize (patches_->patches.size () + 1, 0);
  }
  else if (stays_off)
    support_patches_ = cutAlongPlanes (cloud_, *supporting_planes_, parameters_.patches, *patches_);
  patch_graph_ = buildPatchGraph (cloud_, sensor_, *normals_, patches_->labels, static_cast<int> (patches_->patches.size ()),
                                  parameters_.patch_graph, threads_);
  disconnectSteps (cloud_, *patches_, support_patches_, parameters_.patch_graph, *patch_graph_);
}

const PlanarPatches&
AttentionPipeline::patches ()
{
  preparePatches ();
  return (*patches_);
}

const PatchGraph&
AttentionPipeline::patchGraph ()
{
  preparePatches ();
  return (*patch_graph_);
}

const std::vector<SupportingPlane>&
AttentionPipeline::supportingPlanes ()
{
  preparePatches ();
  return (*supporting_planes_);
}

CompactClustering&
AttentionPipeline::clustering ()
{
  if (!clustering_)
  {
    preparePatches ();
    const StageTimer timer (times_.segmentation);
    clustering_ = std::make_unique<CompactClustering> (cloud_, sensor_, *normals_, *patches_, *patch_graph_, support_patches_,
                                                       parameters_.clustering, threads_);
  }
  return (*clustering_);
}

void
AttentionPipeline::prepareObjects ()
{
  // What is asked for is weighed over the patches, and so cannot be made beside them.
  if (threads_ == 1 || attention_points_ || patch_graph_ || !prior_.empty ())
    return;
  normals ();
  {
    const StageTimer timer (times_.saliency);
    coarser (); // which both need
  }
  double milliseconds = 0.0;
  const double before = times_.total ();
  std::exception_ptr patch_error, point_error;
  std::atomic<bool> points_are_there{false};
  {
    const StageTimer timer (milliseconds);
#pragma omp parallel num_threads(threads_)
#pragma omp single
    {
#pragma omp task
      patch_error = exceptionOf ([&] {
        clustering ();
        const StageTimer piece_timer (times_.segmentation);
        if (parameters_.clustering.joinsPieces ()) // else only what a fixation leads to is grown
          clustering_->growAhead ([&] { return (points_are_there && !expects_all_); });
      });
      point_error = exceptionOf ([this] { attentionPoints (); });
      points_are_there = true;
    }
  }
  times_.overlap += std::max (0.0, times_.total () - before - milliseconds);
  for (const std::exception_ptr& error : {patch_error, point_error})
    if (error)
      std::rethrow_exception (error);
}

void
AttentionPipeline::fillQueue ()
{
  if (queue_filled_)
    return;
  prepareObjects ();
  preparePatches ();
  queue_ = attentionPoints ().points;
  queue_.erase (std::remove_if (queue_.begin (), queue_.end (), [this] (const AttentionPoint& point) { return (isIgnored (point)); }),
                queue_.end ());
  coarser_.clear (); // nothing that is still to come needs them
  const auto rest = std::stable_partition (queue_.begin (), queue_.end (),
                                           [this] (const AttentionPoint& point) { return (isPreferred (point)); });
  if (parameters_.segmentation.coverage)
  {
    const std::vector<AttentionPoint> points = coveragePoints ();
    queue_.insert (rest, points.begin (), points.end ());
  }
  // What is asked for comes first even where it is not salient at all.
  sortByWeight (queue_);
  queue_filled_ = true;
}

std::vector<AttentionPoint>
AttentionPipeline::coveragePoints () const
{
  std::vector<int> patches; // the largest first
  for (int k = 0; k < static_cast<int> (patches_->patches.size ()); ++k)
    if (static_cast<int> (patches_->patches[k].pixels.size ()) >= parameters_.segmentation.coverage_size &&
        (support_patches_.empty () || !support_patches_[k + 1]))
      patches.push_back (k);
  std::stable_sort (patches.begin (), patches.end (), [this] (int a, int b) {
    return (patches_->patches[a].pixels.size () > patches_->patches[b].pixels.size ());
  });
  std::vector<pcl::index_t> centers (patches.size ());
  constexpr int together = 4; // few, as the first ones are large
  forEachBand (static_cast<int> (patches.size ()), together, threads_, [&] (int begin, int end) {
    std::transform (patches.begin () + begin, patches.begin () + end, centers.begin () + begin, [this] (int k) {
      // The pixel nearest to the patch's centroid: a fixation lies on its patch.
      const PlanarPatch& patch = patches_->patches[k];
      pcl::index_t center = 0;
      float nearest = std::numeric_limits<float>::max ();
      for (const pcl::index_t pixel : patch.pixels)
        if (const float distance = (pointAt (cloud_, pixel) - patch.centroid).squaredNorm (); distance < nearest)
        {
          nearest = distance;
          center = pixel;
        }
      return (center);
    });
  });
  std::vector<AttentionPoint> points;
  for (const pcl::index_t center : centers)
  {
    AttentionPoint point;
    point.column = center % cloud_.width;
    point.row = center / cloud_.width;
    point.kind = AttentionPointKind::coverage;
    if (isIgnored (point) || !isSupported (point))
      continue;
    if (!prior_weights_.data.empty ())
      point.weight = prior_weights_[center];
    points.push_back (point);
  }
  return (points);
}

bool
AttentionPipeline::isPreferred (const AttentionPoint& point) const
{
  return (points_are_users_ || point.kind == AttentionPointKind::coverage ||
          !parameters_.segmentation.prefer_supported || isSupported (point));
}

bool
AttentionPipeline::isSupported (const AttentionPoint& point) const
{
  return (supporting_planes_->empty () || !supporting_planes_->front ().supports_objects ||
          standsOn (supporting_planes_->front (), sensor_pose_ * pointAt (cloud_, indexOf (point))));
}

bool
AttentionPipeline::isIgnored (const AttentionPoint& point) const
{
  // A table's top is some centimetres thick, and bent as the sensor sees it.
  constexpr float certain = 0.9f, clearly_below = 0.05f, clearly_beside = 0.02f;
  if (!parameters_.segmentation.ignore_surroundings || points_are_users_ || !prior_.empty () || supporting_planes_->empty ())
    return (false);
  const SupportingPlane& plane = supporting_planes_->front ();
  if (!plane.supports_objects || plane.confidence < certain)
    return (false);
  const Eigen::Vector3f position = sensor_pose_ * pointAt (cloud_, indexOf (point));
  return (plane.coefficients.head<3> ().dot (position) + plane.coefficients[3] < -clearly_below ||
          liesBeside (plane, position, clearly_beside));
}

AttentionPipeline::Priority
AttentionPipeline::priorityOf (std::size_t place, float size_weight) const
{
  // What is not salient at all still has its size.
  constexpr float least = 0.1f;
  const AttentionPoint& point = queue_[place];
  const bool keeps_order =
    point.kind == AttentionPointKind::winner || (points_are_users_ && point.kind != AttentionPointKind::coverage);
  const float saliency = keeps_order ? std::numeric_limits<float>::infinity () : point.saliency;
  return {-weightStep (point.weight), isPreferred (point), (least + saliency) * size_weight};
}

float
AttentionPipeline::frontalArea (const AttentionSegment& segment) const
{
  const float focal_length = sensor_.focal_length;
  if (focal_length <= 0.0f)
    return (std::numeric_limits<float>::infinity ());
  float area = 0.0f;
  for (const pcl::index_t index : segment.indices)
    area += cloud_.z[index] * cloud_.z[index] / (focal_length * focal_length);
  return (area);
}

bool
AttentionPipeline::isLargeEnough (const AttentionSegment& segment, float area) const
{
  const SegmentationParameters& parameters = parameters_.segmentation;
  return (static_cast<int> (segment.indices.size ()) >= parameters.minimum_segment_size &&
          area * segment.confidence >= parameters.minimum_certain_area);
}

float
AttentionPipeline::sizeWeight (float area) const
{
  const float full_size = parameters_.segmentation.full_size;
  return (full_size > 0.0f ? std::min (1.0f, area / full_size) : 1.0f);
}

bool
AttentionPipeline::next (AttentionSegment& segment)
{
  if (!find (segment))
    return (false);
  const StageTimer timer (times_.segmentation);
  moveInside (segment);
  describe (segment);
  return (true);
}

void
AttentionPipeline::all (std::vector<AttentionSegment>& segments)
{
  segments.clear ();
  expects_all_ = true;
  fillQueue ();
  if (threads_ > 1)
    growAhead ();
  for (AttentionSegment segment; find (segment);)
    segments.push_back (std::move (segment));
  grown_ahead_.clear ();
  const StageTimer timer (times_.segmentation);
  forEachBand (static_cast<int> (segments.size ()), 1, threads_, [&] (int place, int) {
    moveInside (segments[place]);
    describe (segments[place]);
  });
}

bool
AttentionPipeline::find (AttentionSegment& segment)
{
  fillQueue ();
  while (true)
  {
    const auto best = std::max_element (waiting_.begin (), waiting_.end (), [] (const Waiting& a, const Waiting& b) {
      return (a.priority < b.priority);
    });
    // No segment of a later point can come before one that is as salient as that point.
    if (next_point_ < queue_.size () && (best == waiting_.end () || best->priority < priorityOf (next_point_, 1.0f)))
    {
      growAt (next_point_++);
      continue;
    }
    if (best == waiting_.end ())
      break;
    segment = std::move (best->segment);
    const std::vector<std::size_t> others = std::move (best->others);
    waiting_.erase (best);
    const AttentionPoint& point = segment.attention_point;
    const bool is_duplicate = avoidsReturn (point) && isDuplicate (segment);
    if (is_duplicate)
      fruitless_.insert (clustering ().initialPatches (point));
    if (is_duplicate || isInhibited (point))
    {
      std::for_each (others.begin (), others.end (), [this] (std::size_t place) { growAt (place); });
      continue;
    }
    segment.rank = ++segments_found_;
    for (const pcl::index_t index : segment.indices)
      claimed_[index] = 1;
    return (true);
  }
  segment = AttentionSegment ();
  return (false);
}

void
AttentionPipeline::growAhead ()
{
  CompactClustering& grower = clustering ();
  const StageTimer timer (times_.segmentation);
  std::atomic<std::size_t> next_place{next_point_};
  std::mutex mutex; // of what the threads share
  std::vector<std::uint8_t> taken (patches_->patches.size () + 1, 0); // at [label]
  const auto take = [&taken] (const std::vector<int>& labels) {
    bool is_new = false;
    for (const int label : labels)
    {
      is_new = is_new || !taken[label];
      taken[label] = 1;
    }
    return (is_new);
  };
  const auto growNext = [&] (std::size_t place) {
    const AttentionPoint& point = queue_[place];
    const std::vector<int> initial = isInhibited (point) ? std::vector<int> () : grower.initialPatches (point);
    {
      const std::lock_guard<std::mutex> lock (mutex);
      if (!take (initial) && avoidsReturn (point))
        return; // most likely on an object that is grown already
    }
    AttentionSegment segment;
    if (!grower.grow (point, initial, segment))
      return;
    const bool is_object = isLargeEnough (segment, frontalArea (segment));
    const std::lock_guard<std::mutex> lock (mutex);
    if (is_object)
      take (segment.patches);
    grown_ahead_.emplace (place, std::move (segment));
  };
  grower.growAhead ([] { return (false); });
  forEachBand (threads_, 1, threads_, [&] (int, int) {
    for (std::size_t place; (place = next_place++) < queue_.size ();)
      growNext (place);
  });
}

void
AttentionPipeline::growAt (std::size_t place)
{
  const AttentionPoint& point = queue_[place];
  if (isInhibited (point))
    return;
  CompactClustering& grower = clustering ();
  const StageTimer timer (times_.segmentation);
  const std::vector<int> initial = grower.initialPatches (point);
  if (avoidsReturn (point))
  {
    // From the same patches the same object would grow.
    if (fruitless_.count (initial) > 0)
      return;
    const auto startsWithin = [&] (const auto& contains) {
      return (std::all_of (initial.begin (), initial.end (),
                           [&] (int label) { return (contains (patches_->patches[label - 1].pixels.front ())); }));
    };
    if (startsWithin ([this] (pcl::index_t index) { return (claimed_[index] != 0); }))
      return;
    for (Waiting& waiting : waiting_)
      if (startsWithin ([&indices = waiting.segment.indices] (pcl::index_t index) {
            return (std::binary_search (indices.begin (), indices.end (), index));
          }))
        return (waiting.others.push_back (place));
  }
  AttentionSegment segment;
  if (const auto ahead = grown_ahead_.find (place); ahead != grown_ahead_.end ())
    segment = std::move (ahead->second);
  else if (!grower.grow (point, initial, segment))
    return;
  const float area = frontalArea (segment);
  if (isLargeEnough (segment, area))
  {
    const Priority priority = priorityOf (place, sizeWeight (area));
    waiting_.push_back ({std::move (segment), priority, {}});
  }
  else
    fruitless_.insert (initial);
}

bool
AttentionPipeline::segmentAt (const AttentionPoint& point, AttentionSegment& segment)
{
  CompactClustering& grower = clustering ();
  const StageTimer timer (times_.segmentation);
  if (!grower.grow (point, grower.initialPatches (point), segment))
    return (false);
  describe (segment);
  return (true);
}

bool
AttentionPipeline::isDuplicate (const AttentionSegment& segment) const
{
  const auto claimed = std::count_if (segment.indices.begin (), segment.indices.end (),
                                      [this] (pcl::index_t index) { return (claimed_[index]); });
  return (2 * static_cast<std::size_t> (claimed) > segment.indices.size ());
}

void
AttentionPipeline::moveInside (AttentionSegment& segment) const
{
  const int margin = parameters_.segmentation.fixation_margin;
  if (margin == 0)
    return;
  const int reach = 4 * margin, around = reach + 2 * margin;
  AttentionPoint& point = segment.attention_point;
  Image<std::uint8_t> member (2 * around + 1, 2 * around + 1, 0);
  for (const pcl::index_t index : segment.indices)
  {
    const int column = index % cloud_.width - point.column + around, row = index / cloud_.width - point.row + around;
    if (member.contains (column, row))
      member (column, row) = 1;
  }
  bool is_inside = true; // where every pixel nearer than the margin is a member
  for (int row = around - margin + 1; row < around + margin; ++row)
    for (int column = around - margin + 1; column < around + margin; ++column)
      is_inside = is_inside && member (column, row);
  if (is_inside)
    return;
  const Image<int> depths = depthsInside (member);
  // Beyond twice the margin deeper is no better.
  const auto depth = [&] (int column, int row) { return (std::min (depths (column, row), 2 * margin)); };
  float best_score = -1e9f;
  Pixel best{around, around};
  for (int row = around - reach; row <= around + reach; ++row)
    for (int column = around - reach; column <= around + reach; ++column)
    {
      const float shift = std::hypot (static_cast<float> (column - around), static_cast<float> (row - around));
      if (!member (column, row) || shift > static_cast<float> (reach))
        continue;
      const float score = 2.0f * static_cast<float> (depth (column, row)) - 0.3f * shift;
      if (score > best_score)
      {
        best_score = score;
        best = {column, row};
      }
    }
  point.column += best.column - around;
  point.row += best.row - around;
  if (saliency_)
    point.point_saliency = saliency_->saliency (point.column, point.row) * point.weight;
}

void
AttentionPipeline::describe (AttentionSegment& segment) const
{
  Eigen::Vector3f upright = Eigen::Vector3f::Zero ();
  if (!supporting_planes_->empty () && supporting_planes_->front ().supports_objects)
    upright = sensor_pose_.linear ().transpose () * supporting_planes_->front ().coefficients.head<3> ();
  segment.box = fitBox (cloud_, segment.indices, upright);
  segment.box.center = sensor_pose_ * segment.box.center;
  segment.box.orientation = Eigen::Quaternionf (sensor_pose_.linear ()) * segment.box.orientation;
  segment.plane = transformPlane (sensor_pose_, segment.plane);
  // Last: the box is that of what the depth shows to be the object.
  if (sensor_.smoothed_depth && parameters_.clustering.smoothed_contour_width > 0)
    fitToColors (cloud_, parameters_.clustering.smoothed_contour_width, threads_, segment.indices);
  else
    extendToColors (cloud_, parameters_.clustering.contour_width, threads_, segment.indices);
}

} // namespace pcl_attention
