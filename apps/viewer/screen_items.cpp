// SPDX-License-Identifier: BSD-3-Clause
#include "screen_items.h"

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace pcl_attention
{

int
overlap (const Rectangle& a, const Rectangle& b)
{
  const int width = std::min (a.right (), b.right ()) - std::max (a.left, b.left);
  const int height = std::min (a.top (), b.top ()) - std::max (a.bottom, b.bottom);
  return (std::max (width, 0) * std::max (height, 0));
}

vtkSmartPointer<vtkTextActor>
makeText (const std::string& text, int size, const Color& color)
{
  const auto actor = vtkSmartPointer<vtkTextActor>::New ();
  actor->SetInput (text.c_str ());
  actor->SetTextScaleModeToNone ();
  vtkTextProperty& property = *actor->GetTextProperty ();
  property.SetFontFamilyToArial ();
  property.SetFontSize (size);
  property.SetColor (color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  property.SetLineSpacing (1.15);
  actor->PickableOff ();
  return (actor);
}

void
placeText (vtkTextActor& text, int left, int top)
{
  text.GetTextProperty ()->SetVerticalJustificationToTop ();
  text.SetPosition (left, top);
}

vtkSmartPointer<vtkActor2D>
makeRectangle (const Rectangle& place, const std::vector<Color>& colors, double opacity)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> scalars;
  scalars->SetNumberOfComponents (3);
  vtkNew<vtkCellArray> strips;
  const std::size_t columns = colors.size () < 2 ? 2 : colors.size ();
  strips->InsertNextCell (static_cast<int> (2 * columns));
  for (std::size_t column = 0; column < columns; ++column)
    for (const int y : {place.bottom, place.top ()})
    {
      const double share = static_cast<double> (column) / static_cast<double> (columns - 1);
      strips->InsertCellPoint (points->InsertNextPoint (place.left + share * place.width, y, 0.0));
      scalars->InsertNextTypedTuple (colors[colors.size () < 2 ? 0 : column].data ());
    }
  vtkNew<vtkPolyData> data;
  data->SetPoints (points);
  data->SetStrips (strips);
  data->GetPointData ()->SetScalars (scalars);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData (data);
  const auto actor = vtkSmartPointer<vtkActor2D>::New ();
  actor->SetMapper (mapper);
  actor->GetProperty ()->SetOpacity (opacity);
  actor->PickableOff ();
  return (actor);
}

vtkSmartPointer<vtkActor2D>
makeDisc (double radius, const Color& color)
{
  constexpr int corners = 24;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygon;
  polygon->InsertNextCell (corners);
  for (int corner = 0; corner < corners; ++corner)
  {
    const double angle = 2.0 * M_PI * corner / corners;
    polygon->InsertCellPoint (points->InsertNextPoint (radius * std::cos (angle), radius * std::sin (angle), 0.0));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints (points);
  data->SetPolys (polygon);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData (data);
  const auto actor = vtkSmartPointer<vtkActor2D>::New ();
  actor->SetMapper (mapper);
  actor->GetProperty ()->SetColor (color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  actor->PickableOff ();
  return (actor);
}

void
pinTo (vtkActor2D& item, const double* point, double right, double up)
{
  vtkNew<vtkCoordinate> anchor;
  anchor->SetCoordinateSystemToWorld ();
  anchor->SetValue (point[0], point[1], point[2]);
  item.GetPositionCoordinate ()->SetCoordinateSystemToViewport ();
  item.GetPositionCoordinate ()->SetReferenceCoordinate (anchor);
  item.GetPositionCoordinate ()->SetValue (right, up, 0.0);
}

void
ScreenItems::clear ()
{
  for (const auto& item : items_)
    renderer_->RemoveViewProp (item);
  items_.clear ();
}

void
ScreenItems::add (vtkProp* item)
{
  renderer_->AddViewProp (item);
  items_.emplace_back (item);
}

vtkTextActor*
ScreenItems::addText (const std::string& text, int left, int top, int size, const Color& color)
{
  const auto actor = makeText (text, size, color);
  placeText (*actor, left, top);
  add (actor);
  return (actor);
}

vtkTextActor*
ScreenItems::addLabel (const std::string& text, int left, int top, int size, const Color& color)
{
  vtkTextActor* actor = addText (text, left, top, size, color);
  actor->GetTextProperty ()->SetBackgroundColor (0.05, 0.055, 0.065);
  actor->GetTextProperty ()->SetBackgroundOpacity (0.6);
  return (actor);
}

int
ScreenItems::widthOf (const std::string& text, int size) const
{
  const auto actor = makeText (text, size, {255, 255, 255});
  double extent[2]{0.0, 0.0};
  actor->GetSize (renderer_, extent);
  return (static_cast<int> (extent[0]));
}

} // namespace pcl_attention
