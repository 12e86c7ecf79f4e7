// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "attention_worker.h"
#include "parameter_io.h"
#include "scene_segmentation.h"

#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief The pictures that the viewer shows side by side, as the paper's figure 2. */
enum class View
{
  color,    /**< the scene's colours, or its depth in grey */
  saliency, /**< the saliency map over them */
  points,   /**< skeletons and numbered fixations */
  patches,  /**< patches, and the growth of an object over them */
  segments  /**< outlined objects and their fixations */
};

/** \brief "color", "saliency", "points", "patches" and "segments". */
const std::vector<std::string>& viewNames ();

/** \brief A parameter that has a slider. */
struct Knob
{
  std::string parameter;  /**< name in the parameter table */
  std::string label;      /**< beside the slider */
  double low, high, step; /**< range of the slider, which is the useful part of the parameter's, and its raster */
};

/** \brief The sliders, from top to bottom. */
const std::vector<Knob>& knobs ();

/** \brief What can be switched on and off. */
struct ViewerSwitches
{
  bool fixations{true};  /**< spheres and numbers */
  bool skeletons{true};  /**< lines and extracted attention points */
  bool outlines{true};   /**< contours of the objects */
  bool normals{false};   /**< normals in place of the colours */
  bool hull{false};      /**< hull of the selected object */
  bool convexity{false}; /**< borders of the patches, by convexity */
  bool errors{false};    /**< wrong pixels, where there are labels */
};

/** \brief An object while it grows. */
struct GrowthState
{
  std::vector<int> patches;        /**< labels of what belongs to the object before the step */
  const GrowthStep* step{nullptr}; /**< the patch that is tried; null: where the growth starts */
};

/** \brief All that the viewer knows, without anything of how it is drawn: the results, what of them is looked at, the
 * parameters, the user's own fixations. */
class ViewerModel
{
public:
  explicit ViewerModel (const NamedParameters& parameters);

  /** \brief Take over new results. The selected object stays selected by its rank, as long as there is one; another
   * scene selects none and forgets the user's own fixations, and those without an object are forgotten as well. \return
   * false if a fixation of the user's own led to no object */
  bool setResults (const AttentionResultsPtr& results);

  /** \brief Empty results before there are any. */
  const AttentionResults&
  results () const
  {
    return (*results_);
  }

  /** \brief What to compute for the parameters and fixations as they are. */
  AttentionRequest request () const;

  const NamedParameters&
  parameters () const
  {
    return (parameters_);
  }

  /** \brief Value of a knob's parameter, within the slider's range. */
  double knobValue (const Knob& knob) const;

  /** \brief The value as it is shown, e.g. "5.0 mm", "on" or "off". */
  std::string knobText (const Knob& knob) const;

  /** \param[in] value is moved to the knob's raster
   * \return whether that changes anything */
  bool setKnob (const Knob& knob, double value);

  /** \brief Go back to the parameters that the viewer was started with. */
  void
  resetParameters ()
  {
    parameters_ = initial_parameters_;
  }

  /** \throws std::runtime_error that names the file; the parameters are then unchanged */
  void loadParameters (const std::string& path);

  /** \brief All objects: those in order of attention, then the user's own, as far as there is one. */
  const std::vector<AttentionSegment>&
  segments () const
  {
    return (segments_);
  }

  /** \brief F of an object against the labels; negative without labels. */
  double score (std::size_t index) const;

  /** \brief The selected object; null for none. */
  const AttentionSegment* selected () const;

  /** \brief Index of the selected object in segments; -1 for none. */
  int
  selection () const
  {
    return (selection_);
  }

  /** \brief The next or previous object, past the last one none, and on. */
  void selectNext (int direction);

  void clearSelection ();

  /** \brief The next or previous step of the growth of the selected object, of the first one where none is selected.
   * After the last step the object is whole. */
  void stepNext (int direction);

  /** \brief How many steps of the growth of the selected object are shown; -1: the whole object, or none is selected. */
  int
  step () const
  {
    return (selected () ? step_ : -1);
  }

  /** \brief The growth at the step that is shown; only where \ref step is not negative. */
  GrowthState growth () const;

  /** \brief Add a fixation of the user's own; it is the selected one as soon as it has an object. */
  void addFixation (int column, int row);

  /** \brief Take back the last of them.
   * \return false when there is none */
  bool undoFixation ();

  const std::vector<AttentionPoint>&
  ownFixations () const
  {
    return (own_points_);
  }

  /** \brief The level of the pyramid whose saliency is shown, 1 is the finest; 0: the sum of all. */
  int
  saliencyLevel () const
  {
    return (saliency_level_);
  }

  /** \brief The next level, after the coarsest one the sum. */
  void nextSaliencyLevel ();

  /** \brief The scene, its size and what was found; or what is being done. */
  std::string sceneText () const;

  /** \brief Times of the stages. */
  std::string timesText () const;

  /** \brief What is known of the selected object, or how to select one, a few short lines. */
  std::string objectText () const;

  /** \brief As pcl_attention_segment would have found them, with the user's own as the last ranks. */
  SceneSegments sceneSegments () const;

  /** \brief The selected object's points, in the frame and with the sensor pose of the scene's file. */
  pcl::PointCloud<pcl::PointXYZRGB> selectedCloud () const;

  ViewerSwitches switches;

private:
  void collectSegments ();

  NamedParameters parameters_;
  const NamedParameters initial_parameters_;
  AttentionResultsPtr results_;
  std::vector<AttentionSegment> segments_;
  std::vector<double> scores_;
  std::vector<AttentionPoint> own_points_;
  int selection_{-1}, step_{-1}, saliency_level_{0};
  bool select_own_{false}; /**< the newest fixation of the user's own is to be selected once it has an object */
};

/** \brief One step of the growth in words, two lines: what happened to which patch, and by which constraint and how
 * much. */
std::string describeStep (const GrowthStep& step);

} // namespace pcl_attention
