// SPDX-License-Identifier: BSD-3-Clause
#include "knob_sliders.h"

#include <vtkCommand.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkProperty2D.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkTextProperty.h>

namespace pcl_attention
{

namespace
{

constexpr Color label_color{190, 195, 205}, value_color{255, 255, 255};

/** \brief Calls a function at every event. */
class Observer : public vtkCommand
{
public:
  static Observer*
  New ()
  {
    return (new Observer);
  }

  void
  Execute (vtkObject* /*caller*/, unsigned long /*event*/, void* /*data*/) override
  {
    function ();
  }

  std::function<void ()> function;
};

vtkSliderRepresentation2D&
representationOf (vtkSliderWidget& widget)
{
  return (*vtkSliderRepresentation2D::SafeDownCast (widget.GetRepresentation ()));
}

} // namespace

KnobSliders::KnobSliders (ViewerModel& model, vtkRenderer* renderer, vtkRenderWindowInteractor* interactor,
                          std::function<void ()> changed)
    : model_ (model), changed_ (std::move (changed))
{
  for (std::size_t index = 0; index < knobs ().size (); ++index)
  {
    const Knob& knob = knobs ()[index];
    vtkNew<vtkSliderRepresentation2D> slider;
    slider->SetMinimumValue (knob.low);
    slider->SetMaximumValue (knob.high);
    slider->ShowSliderLabelOff ();
    slider->GetTubeProperty ()->SetColor (0.36, 0.38, 0.43);
    slider->GetCapProperty ()->SetColor (0.36, 0.38, 0.43);
    slider->GetSliderProperty ()->SetColor (0.30, 0.65, 0.95);
    slider->GetSelectedProperty ()->SetColor (1.0, 0.80, 0.25);
    slider->GetPoint1Coordinate ()->SetCoordinateSystemToDisplay ();
    slider->GetPoint2Coordinate ()->SetCoordinateSystemToDisplay ();

    Slider item;
    item.widget = vtkSmartPointer<vtkSliderWidget>::New ();
    item.widget->SetInteractor (interactor);
    item.widget->SetRepresentation (slider);
    item.widget->SetDefaultRenderer (renderer);
    item.widget->SetCurrentRenderer (renderer);
    item.widget->SetAnimationModeToJump ();
    item.widget->KeyPressActivationOff (); // "i" would switch the slider off
    vtkNew<Observer> observer;
    observer->function = [this, index] { moved (index); };
    item.widget->AddObserver (vtkCommand::InteractionEvent, observer);
    item.widget->AddObserver (vtkCommand::EndInteractionEvent, observer);
    item.label = makeText (knob.label, 12, label_color);
    item.value = makeText ("", 12, value_color);
    item.value->GetTextProperty ()->SetJustificationToRight ();
    renderer->AddViewProp (item.label);
    renderer->AddViewProp (item.value);
    item.widget->EnabledOn ();
    sliders_.push_back (item);
  }
  update ();
}

KnobSliders::~KnobSliders ()
{
  for (const Slider& slider : sliders_)
    slider.widget->EnabledOff ();
}

int
KnobSliders::heightFor (int font)
{
  return (static_cast<int> (knobs ().size ()) * 5 * font / 2);
}

void
KnobSliders::place (const Rectangle& place, int font)
{
  const int row = 5 * font / 2;
  for (std::size_t index = 0; index < sliders_.size (); ++index)
  {
    const Slider& slider = sliders_[index];
    const int top = place.top () - static_cast<int> (index) * row;
    slider.label->GetTextProperty ()->SetFontSize (font);
    slider.value->GetTextProperty ()->SetFontSize (font);
    placeText (*slider.label, place.left, top);
    placeText (*slider.value, place.right (), top);
    vtkSliderRepresentation2D& representation = representationOf (*slider.widget);
    const double y = top - 1.9 * font, radius = 0.5 * font;
    representation.GetPoint1Coordinate ()->SetValue (place.left + radius, y, 0.0);
    representation.GetPoint2Coordinate ()->SetValue (place.right () - radius, y, 0.0);
    // Sizes are shares of the slider's length.
    const double length = std::max (1.0, place.width - 2.0 * radius);
    representation.SetSliderLength (0.25 * font / length);
    representation.SetSliderWidth (0.25 * font / length);
    representation.SetTubeWidth (0.12 * font / length);
    representation.SetEndCapLength (0.0);
    representation.SetEndCapWidth (0.0);
    representation.Modified ();
  }
}

void
KnobSliders::update ()
{
  for (std::size_t index = 0; index < sliders_.size (); ++index)
  {
    const Knob& knob = knobs ()[index];
    representationOf (*sliders_[index].widget).SetValue (model_.knobValue (knob));
    sliders_[index].value->SetInput (model_.knobText (knob).c_str ());
  }
}

void
KnobSliders::moved (std::size_t index)
{
  const bool differs = model_.setKnob (knobs ()[index], representationOf (*sliders_[index].widget).GetValue ());
  update ();
  if (differs)
    changed_ ();
}

} // namespace pcl_attention
