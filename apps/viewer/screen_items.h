// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "png_image.h"

#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief A rectangle of the window, pixels from its lower left corner. */
struct Rectangle
{
  int left{0}, bottom{0}, width{0}, height{0};

  int
  right () const
  {
    return (left + width);
  }
  int
  top () const
  {
    return (bottom + height);
  }
};

/** \brief Area that two rectangles share, square pixels. */
int overlap (const Rectangle& a, const Rectangle& b);

/** \brief A text in the window; no larger than its font makes it.
 * \param[in] size of the font, pixels */
vtkSmartPointer<vtkTextActor> makeText (const std::string& text, int size, const Color& color);

/** \brief Put a text's upper left corner somewhere, pixels from the window's lower left. */
void placeText (vtkTextActor& text, int left, int top);

/** \brief A filled rectangle, shaded from left to right over the colours. */
vtkSmartPointer<vtkActor2D> makeRectangle (const Rectangle& place, const std::vector<Color>& colors,
                                           double opacity = 1.0);

/** \brief A filled disc around the origin, to be put somewhere by its position coordinate. */
vtkSmartPointer<vtkActor2D> makeDisc (double radius, const Color& color);

/** \brief Let an item stay so many pixels beside a point of the scene, wherever the camera sees it. */
void pinTo (vtkActor2D& item, const double* point, double right, double up);

/** \brief Things that are drawn anew with every change, in one renderer. */
class ScreenItems
{
public:
  explicit ScreenItems (vtkRenderer* renderer) : renderer_ (renderer) {}

  void clear ();

  void add (vtkProp* item);

  /** \brief Add a text.
   * \return its actor */
  vtkTextActor* addText (const std::string& text, int left, int top, int size, const Color& color);

  /** \brief Add a text that is legible over a picture.
   * \return its actor */
  vtkTextActor* addLabel (const std::string& text, int left, int top, int size, const Color& color);

  /** \brief Width of a text, pixels. */
  int widthOf (const std::string& text, int size) const;

private:
  vtkSmartPointer<vtkRenderer> renderer_;
  std::vector<vtkSmartPointer<vtkProp>> items_;
};

} // namespace pcl_attention
