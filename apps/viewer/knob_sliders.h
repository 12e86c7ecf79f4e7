// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "screen_items.h"
#include "viewer_model.h"

#include <vtkRenderWindowInteractor.h>
#include <vtkSliderWidget.h>

#include <functional>

namespace pcl_attention
{

/** \brief A slider for every knob, with its name and value. */
class KnobSliders
{
public:
  /** \param[in] renderer that covers the window
   * \param[in] changed is called when the user has moved a slider to another value of its raster */
  KnobSliders (ViewerModel& model, vtkRenderer* renderer, vtkRenderWindowInteractor* interactor,
               std::function<void ()> changed);
  ~KnobSliders ();

  KnobSliders (const KnobSliders&) = delete;
  KnobSliders& operator= (const KnobSliders&) = delete;

  /** \brief Put the sliders below each other into a rectangle.
   * \param[in] font size, pixels */
  void place (const Rectangle& place, int font);

  /** \brief Height that they need, pixels. */
  static int heightFor (int font);

  /** \brief Show the values that the model has by now. */
  void update ();

private:
  struct Slider
  {
    vtkSmartPointer<vtkSliderWidget> widget;
    vtkSmartPointer<vtkTextActor> label, value;
  };

  void moved (std::size_t index);

  ViewerModel& model_;
  std::function<void ()> changed_;
  std::vector<Slider> sliders_;
};

} // namespace pcl_attention
