// SPDX-License-Identifier: BSD-3-Clause
#include "png_image.h"

#include <pcl_attention/core/organized_cloud.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <png.h>
#include <stdexcept>
#include <sys/stat.h>

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

/** \brief libpng's reader of one file, which is freed with it. */
struct PngReader
{
  explicit PngReader (const std::string& path) : file (std::fopen (path.c_str (), "rb"))
  {
    if (!file)
      throw std::runtime_error (std::string ("cannot be opened: ") + std::strerror (errno));
    const auto stop = [] (png_structp reader, png_const_charp text) {
      std::strncpy (static_cast<PngReader*> (png_get_error_ptr (reader))->error, text, sizeof (error) - 1);
      png_longjmp (reader, 1);
    };
    png = png_create_read_struct (PNG_LIBPNG_VER_STRING, this, stop, [] (png_structp, png_const_charp) {});
    info = png ? png_create_info_struct (png) : nullptr;
  }
  ~PngReader ()
  {
    png_destroy_read_struct (&png, &info, nullptr);
    std::fclose (file);
  }
  PngReader (const PngReader&) = delete;
  PngReader& operator= (const PngReader&) = delete;

  // libpng leaves these two by longjmp: they have nothing to be destroyed.
  bool
  readHeader ()
  {
    if (!info || setjmp (png_jmpbuf (png)) != 0)
      return (false);
    png_init_io (png, file);
    png_read_info (png, info);
    return (true);
  }

  bool
  readRows (png_bytep* rows)
  {
    if (setjmp (png_jmpbuf (png)) != 0)
      return (false);
    png_set_packing (png); // a byte a value where a file has less
    png_set_swap (png);    // PNG stores the high byte first
    png_set_interlace_handling (png);
    png_read_image (png, rows);
    png_read_end (png, nullptr);
    return (true);
  }

  std::uint64_t
  fileSize () const
  {
    struct stat status
    {
    };
    return (fstat (fileno (file), &status) == 0 ? static_cast<std::uint64_t> (status.st_size) : 0);
  }

  std::FILE* file{nullptr};
  png_structp png{nullptr};
  png_infop info{nullptr};
  char error[128]{};
};

PngHeader
headerOf (PngReader& reader)
{
  if (!reader.readHeader ())
    throw std::runtime_error (std::string ("cannot be read as PNG: ") + reader.error);
  const std::string problem =
      imageSizeProblem (png_get_image_width (reader.png, reader.info), png_get_image_height (reader.png, reader.info));
  if (!problem.empty ())
    throw std::runtime_error ("the image is " + problem);
  // Deflate, the compression of PNG files, makes at most 1032 bytes out of one.
  constexpr std::uint64_t largest_compression = 1032;
  const std::uint64_t bytes =
      std::uint64_t{png_get_rowbytes (reader.png, reader.info)} * png_get_image_height (reader.png, reader.info);
  if (bytes / largest_compression > reader.fileSize ())
    throw std::runtime_error ("truncated: the header announces an image that the file cannot hold");
  const int color_type = png_get_color_type (reader.png, reader.info);
  const PngHeader header{png_get_image_width (reader.png, reader.info), png_get_image_height (reader.png, reader.info),
                         png_get_bit_depth (reader.png, reader.info), color_type == PNG_COLOR_TYPE_GRAY,
                         color_type == PNG_COLOR_TYPE_PALETTE};
  return (header);
}

/** \brief The values as they are stored, of one channel. */
template <typename Value>
Image<Value>
readValues (PngReader& reader, const PngHeader& header)
{
  Image<Value> image (static_cast<int> (header.width), static_cast<int> (header.height));
  std::vector<png_bytep> rows;
  for (std::size_t row = 0; row < header.height; ++row)
    rows.push_back (reinterpret_cast<png_bytep> (image.data.data () + row * header.width));
  if (!reader.readRows (rows.data ()))
    throw std::runtime_error (std::string ("damaged: ") + reader.error);
  return (image);
}

} // namespace

PngHeader
readPngHeader (const std::string& path)
{
  PngReader reader (path);
  return (headerOf (reader));
}

Image<Color>
readColorPng (const std::string& path)
{
  readPngHeader (path); // for its checks
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file (&description, path.c_str ()) == 0)
    throw std::runtime_error (std::string ("cannot be read as PNG: ") + description.message);
  const std::unique_ptr<png_image, decltype (&png_image_free)> free_at_end (&description, png_image_free);
  description.format = PNG_FORMAT_RGB;
  Image<Color> image (static_cast<int> (description.width), static_cast<int> (description.height));
  const png_color black{0, 0, 0};
  if (png_image_finish_read (&description, &black, image.data.data (), 0, nullptr) == 0)
    throw std::runtime_error (std::string ("damaged: ") + description.message);
  return (image);
}

Image<std::uint16_t>
readIndexPng (const std::string& path)
{
  PngReader reader (path);
  const PngHeader header = headerOf (reader);
  if (!header.is_grey && !header.is_palette)
    throw std::runtime_error ("neither grey nor with a palette");
  if (header.bit_depth == 16)
    return (readValues<std::uint16_t> (reader, header));
  const Image<std::uint8_t> values = readValues<std::uint8_t> (reader, header);
  Image<std::uint16_t> image (values.width, values.height);
  std::copy (values.data.begin (), values.data.end (), image.data.begin ());
  return (image);
}

Image<std::uint16_t>
readDepthPng (const std::string& path)
{
  PngReader reader (path);
  const PngHeader header = headerOf (reader);
  if (header.bit_depth != 16 || !header.is_grey)
    throw std::runtime_error (
        "not a depth image: that has to be a 16-bit grey PNG, with metres by -depth_scale; a colour "
        "image goes with -color");
  return (readValues<std::uint16_t> (reader, header));
}

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
