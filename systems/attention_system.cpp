// SPDX-License-Identifier: BSD-3-Clause
#include "systems/attention_system.h"

#include <pcl_attention/core/bands.h>

#include <pcl/segmentation/attention_segmentation.h>

#include <pcl/segmentation/impl/organized_cloud.hpp>

#include <functional>
#include <stdexcept>

namespace pcl_attention
{

namespace
{

/** \brief What the other systems share: the cloud is checked and gathered, empty segments are dropped, ranks given. */
class ImageSystem : public AttentionSystem
{
public:
  explicit ImageSystem (const SystemSettings& settings) : settings_ (settings) {}

  std::vector<AttentionSegment>
  segment (const pcl::PointCloud<pcl::PointXYZRGB>::ConstPtr& cloud) override
  {
    const std::string problem = checkCloud (cloud.get ());
    if (!problem.empty ())
      throw std::runtime_error (problem);
    std::vector<AttentionSegment> segments = segmentImage (gather (*cloud, nullptr));
    segments.erase (std::remove_if (segments.begin (), segments.end (),
                                    [] (const AttentionSegment& segment) { return (segment.indices.empty ()); }),
                    segments.end ());
    for (std::size_t i = 0; i < segments.size (); ++i)
      segments[i].rank = static_cast<int> (i) + 1;
    return (segments);
  }

protected:
  virtual std::vector<AttentionSegment> segmentImage (const OrganizedCloud& cloud) const = 0;

  /** \brief Start the module's stages, which the systems take fixations and supporting planes from. */
  void
  start (AttentionPipeline& pipeline, const OrganizedCloud& cloud, const AttentionParameters& parameters) const
  {
    pipeline.start (OrganizedCloud (cloud), Eigen::Isometry3f::Identity (), parameters, settings_.threads);
  }

  /** \brief The parameters of the fixations. */
  AttentionParameters
  withStrategy (AttentionStrategy strategy) const
  {
    AttentionParameters parameters = settings_.fixations;
    parameters.attention_points.strategy = strategy;
    return (parameters);
  }

  /** \brief Segment around every fixation, up to the greatest number of them.
   * \param[in] mask_of gives the mask of a fixation, of the cloud's size; it throws nothing */
  template <typename MaskOf>
  std::vector<AttentionSegment>
  segmentAll (const OrganizedCloud& cloud, const std::vector<AttentionPoint>& fixations, const MaskOf& mask_of) const
  {
    std::vector<AttentionSegment> segments (
        std::min<std::size_t> (fixations.size (), static_cast<std::size_t> (settings_.maximum_fixations)));
    forEachBand (static_cast<int> (segments.size ()), 1, settings_.threads,
                 [&] (int i, int) { segments[i] = segmentOf (mask_of (fixations[i]), fixations[i], cloud); });
    return (segments);
  }

  /** \brief The valid points of a mask, with the fixation that led to it. */
  static AttentionSegment
  segmentOf (const Image<std::uint8_t>& mask, const AttentionPoint& fixation, const OrganizedCloud& cloud)
  {
    AttentionSegment segment;
    segment.attention_point = fixation;
    for (std::size_t i = 0; i < mask.size (); ++i)
      if (mask[i] && cloud.valid[i])
        segment.indices.push_back (static_cast<pcl::index_t> (i));
    return (segment);
  }

  SystemSettings settings_;
};

/** \brief M09: a polar cut on colour edges around every fixation of a strategy. */
class ActiveSegmentation : public ImageSystem
{
public:
  ActiveSegmentation (const SystemSettings& settings, AttentionStrategy strategy)
      : ImageSystem (settings), strategy_ (strategy)
  {
  }

protected:
  std::vector<AttentionSegment>
  segmentImage (const OrganizedCloud& cloud) const override
  {
    AttentionPipeline pipeline;
    start (pipeline, cloud, withStrategy (strategy_));
    const EdgeMap edges = detectColorEdges (colorsOf (cloud), settings_.color_edges, settings_.threads);
    return (segmentAll (cloud, pipeline.attentionPoints ().points, [&] (const AttentionPoint& point) {
      return (segmentAround (edges, point.column, point.row, settings_.polar_cut));
    }));
  }

private:
  AttentionStrategy strategy_;
};

/** \brief M11: simple objects by the ownership of boundaries. */
class SimpleObjectSegmentation : public ImageSystem
{
public:
  using ImageSystem::ImageSystem;

protected:
  std::vector<AttentionSegment>
  segmentImage (const OrganizedCloud& cloud) const override
  {
    AttentionPipeline pipeline;
    start (pipeline, cloud, AttentionParameters ());
    const OwnedBoundaries boundaries =
        findOwnedBoundaries (cloud, pipeline.supportingPlanes (), settings_.simple_objects);
    const EdgeMap edges = detectColorEdges (colorsOf (cloud), settings_.color_edges, settings_.threads);
    std::vector<AttentionSegment> segments;
    for (const SimpleObject& object :
         findSimpleObjects (boundaries, edges, settings_.simple_objects, settings_.threads))
    {
      AttentionPoint fixation;
      fixation.column = object.fixation.column;
      fixation.row = object.fixation.row;
      fixation.saliency = fixation.point_saliency = object.owned_share;
      segments.push_back (segmentOf (object.mask, fixation, cloud));
    }
    return (segments);
  }
};

/** \brief G10: strokes along the lines of symmetry. */
class StrokeSegmentation : public ImageSystem
{
public:
  using ImageSystem::ImageSystem;

protected:
  std::vector<AttentionSegment>
  segmentImage (const OrganizedCloud& cloud) const override
  {
    AttentionPipeline pipeline;
    start (pipeline, cloud, withStrategy (AttentionStrategy::symmetry_lines));
    const AttentionPoints& attention = pipeline.attentionPoints ();
    // A component has one skeleton, and with it one stroke, whatever the number of its points.
    std::vector<AttentionPoint> points;
    for (const AttentionPoint& point : attention.points)
      if (std::none_of (points.begin (), points.end (),
                        [&] (const AttentionPoint& other) { return (other.component == point.component); }))
        points.push_back (point);
    const ColorImage colors = colorsOf (cloud);
    const Image<std::uint8_t> background = rectangle (cloud.width, cloud.height);
    return (segmentAll (cloud, points, [&] (const AttentionPoint& point) {
      return (segmentFromStrokes (colors, stroke (attention, point.component), background, settings_.star_cut));
    }));
  }

private:
  /** \brief A rectangle 20 % smaller than the image, one pixel wide. */
  static Image<std::uint8_t>
  rectangle (int width, int height)
  {
    Image<std::uint8_t> stroke (width, height, 0);
    const int left = width / 10, right = width - 1 - left, top = height / 10, bottom = height - 1 - top;
    for (int column = left; column <= right; ++column)
      stroke (column, top) = stroke (column, bottom) = 1;
    for (int row = top; row <= bottom; ++row)
      stroke (left, row) = stroke (right, row) = 1;
    return (stroke);
  }

  /** \brief The skeleton of a component, dilated twice. */
  static Image<std::uint8_t>
  stroke (const AttentionPoints& attention, int component)
  {
    constexpr int dilations = 2;
    const Image<std::uint8_t>& skeleton = attention.skeleton;
    Image<std::uint8_t> result (skeleton.width, skeleton.height, 0);
    for (int row = 0; row < skeleton.height; ++row)
      for (int column = 0; column < skeleton.width; ++column)
        if (skeleton (column, row) && attention.components (column, row) == component)
          for (int y = std::max (0, row - dilations); y <= std::min (skeleton.height - 1, row + dilations); ++y)
            for (int x = std::max (0, column - dilations); x <= std::min (skeleton.width - 1, column + dilations); ++x)
              result (x, y) = 1;
    return (result);
  }
};

/** \brief This module. */
class ProposedSystem : public AttentionSystem
{
public:
  explicit ProposedSystem (const SystemSettings& settings) : segmentation_ (settings.proposed)
  {
    segmentation_.setNumberOfThreads (static_cast<unsigned int> (settings.threads));
  }

  std::vector<AttentionSegment>
  segment (const pcl::PointCloud<pcl::PointXYZRGB>::ConstPtr& cloud) override
  {
    std::vector<AttentionSegment> segments;
    segmentation_.setInputCloud (cloud);
    if (!segmentation_.segment (segments))
      throw std::runtime_error ("the scene could not be segmented, see above");
    return (segments);
  }

private:
  pcl::AttentionSegmentation<pcl::PointXYZRGB> segmentation_;
};

/** \brief A row of Table I. */
struct SystemRow
{
  std::string name;
  std::function<std::unique_ptr<AttentionSystem> (const SystemSettings&)> make;
};

template <typename System, typename... Arguments>
SystemRow
row (const std::string& name, Arguments... arguments)
{
  return {name, [=] (const SystemSettings& settings) { return (std::make_unique<System> (settings, arguments...)); }};
}

const std::vector<SystemRow>&
systemRows ()
{
  static const std::vector<SystemRow> rows{
      row<ActiveSegmentation> ("M09+TJ3D", AttentionStrategy::symmetry_lines),
      row<ActiveSegmentation> ("M09+WTA2D", AttentionStrategy::image_winner_take_all),
      row<ActiveSegmentation> ("M09+WTA3D", AttentionStrategy::winner_take_all),
      row<SimpleObjectSegmentation> ("M11"),
      row<StrokeSegmentation> ("G10"),
      row<ProposedSystem> ("proposed")};
  return (rows);
}

} // namespace

const std::vector<std::string>&
systemNames ()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const SystemRow& row : systemRows ())
      all.push_back (row.name);
    return (all);
  }();
  return (names);
}

std::unique_ptr<AttentionSystem>
makeSystem (const std::string& name, const SystemSettings& settings)
{
  std::string all;
  for (const SystemRow& row : systemRows ())
  {
    if (row.name == name)
      return (row.make (settings));
    all += (all.empty () ? "" : ", ") + row.name;
  }
  throw std::invalid_argument ("there is no system \"" + name + "\", only " + all);
}

} // namespace pcl_attention
