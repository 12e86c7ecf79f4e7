// SPDX-License-Identifier: BSD-3-Clause
#include "png_image.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <stdexcept>

namespace pcl_attention
{

namespace
{

std::string
encode (const std::uint8_t* values, int width, int height, int channels)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions (width, height, 1);
  image->AllocateScalars (VTK_UNSIGNED_CHAR, channels);
  auto* output = static_cast<std::uint8_t*> (image->GetScalarPointer ());
  const std::size_t row_size = static_cast<std::size_t> (width) * channels;
  for (int row = 0; row < height; ++row) // VTK's first row is the lowest
    std::copy_n (values + row * row_size, row_size, output + (height - 1 - row) * row_size);

  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn ();
  writer->SetInputData (image);
  writer->Write ();
  vtkUnsignedCharArray* result = writer->GetResult ();
  if (!result || result->GetNumberOfValues () == 0)
    throw std::runtime_error ("an image cannot be encoded as PNG");
  const unsigned char* bytes = result->GetPointer (0);
  return (std::string (bytes, bytes + result->GetNumberOfValues ()));
}

} // namespace

std::string
encodePng (const Image<std::uint8_t>& image)
{
  return (encode (image.data.data (), image.width, image.height, 1));
}

std::string
encodePng (const Image<Color>& image)
{
  static_assert (sizeof (Color) == 3, "pixels are stored without gaps");
  return (encode (image.data.front ().data (), image.width, image.height, 3));
}

} // namespace pcl_attention
