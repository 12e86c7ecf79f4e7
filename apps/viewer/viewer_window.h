// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "attention_worker.h"
#include "layers.h"
#include "scene_sequence.h"
#include "viewer_model.h"

#include <memory>
#include <optional>
#include <string>

namespace pcl_attention
{

/** \brief How the viewer is opened. */
struct WindowSettings
{
  int width{1280}, height{800}; /**< pixels */
  std::optional<View> view;     /**< the one that is shown large; none: all of them */
  std::string output_dir;       /**< where things are saved */
  std::string parameters_file;  /**< what is loaded; empty: parameters.json of output_dir */
  int turn_frames{36};          /**< pictures of a camera turn */
};

/** \brief Why no window can be opened and what to do about it; empty where one can. VTK aborts without asking. */
std::string checkDisplay ();

/** \brief The window on PCLVisualizer: draws the model and turns keys, clicks and sliders into changes of it. */
class ViewerWindow
{
public:
  /** \brief Open the window.
   * \param[in] model,worker,scenes must outlive it */
  ViewerWindow (const WindowSettings& settings, ViewerModel& model, AttentionWorker& worker, SceneSequence& scenes);
  ~ViewerWindow ();

  ViewerWindow (const ViewerWindow&) = delete;
  ViewerWindow& operator= (const ViewerWindow&) = delete;

  /** \brief Draw the results as they are, and save the window as PNG.
   * \throws std::runtime_error that names the file */
  void saveScreenshot (const std::string& path);

  /** \brief Stay until the user closes the window. */
  void run ();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace pcl_attention
