// SPDX-License-Identifier: BSD-3-Clause
#include "overview_image.h"

#include <pcl/common/colors.h>
#include <pcl/common/point_tests.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace pcl_attention
{

namespace
{

constexpr Color black{0, 0, 0}, white{255, 255, 255};

/** \brief Digits of 5 x 7 pixels, a byte a row, the left column in bit 4. */
constexpr int digit_width = 5, digit_height = 7;
constexpr std::array<std::array<std::uint8_t, digit_height>, 10> digits{{{0x0e, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0e},
                                                                         {0x04, 0x0c, 0x04, 0x04, 0x04, 0x04, 0x0e},
                                                                         {0x0e, 0x11, 0x01, 0x06, 0x08, 0x10, 0x1f},
                                                                         {0x0e, 0x11, 0x01, 0x06, 0x01, 0x11, 0x0e},
                                                                         {0x02, 0x06, 0x0a, 0x12, 0x1f, 0x02, 0x02},
                                                                         {0x1f, 0x10, 0x1e, 0x01, 0x01, 0x11, 0x0e},
                                                                         {0x06, 0x08, 0x10, 0x1e, 0x11, 0x11, 0x0e},
                                                                         {0x1f, 0x01, 0x02, 0x04, 0x08, 0x08, 0x08},
                                                                         {0x0e, 0x11, 0x11, 0x0e, 0x11, 0x11, 0x0e},
                                                                         {0x0e, 0x11, 0x11, 0x0f, 0x01, 0x02, 0x0c}}};

struct Rectangle
{
  int left, top, width, height;
};

int
overlap (const Rectangle& a, const Rectangle& b)
{
  const int width = std::min (a.left + a.width, b.left + b.width) - std::max (a.left, b.left);
  const int height = std::min (a.top + a.height, b.top + b.height) - std::max (a.top, b.top);
  return (std::max (width, 0) * std::max (height, 0));
}

/** \brief Draws marks whose size follows the image's. */
class Canvas
{
public:
  explicit Canvas (Image<Color> image)
      : image_ (std::move (image)), scale_ (std::max (1, std::min (image_.width, image_.height) / 240))
  {
  }

  const Image<Color>&
  image () const
  {
    return (image_);
  }

  /** \brief The border of a segment, inside it, with a dark line around so that it shows on any colour. */
  void
  outline (const pcl::Indices& indices, const Color& color)
  {
    Image<std::uint8_t> inside (image_.width, image_.height);
    for (const pcl::index_t index : indices)
      inside[index] = 1;
    for (const pcl::index_t index : indices)
    {
      const int column = index % image_.width, row = index / image_.width;
      forEachNear (column, row, 1, [&] (int near_column, int near_row) {
        if (!inside (near_column, near_row))
          image_ (near_column, near_row) = black;
      });
    }
    for (const pcl::index_t index : indices)
    {
      const int column = index % image_.width, row = index / image_.width;
      bool is_border = false;
      forEachNear (column, row, scale_,
                   [&] (int near_column, int near_row) { is_border |= !inside (near_column, near_row); });
      if (is_border)
        image_[index] = color;
    }
  }

  /** \brief A dot with a dark and a light ring. */
  void
  dot (int column, int row, const Color& color)
  {
    const float radius = 2.5f * static_cast<float> (scale_), ring = 0.8f * static_cast<float> (scale_);
    disc (column, row, radius + 2.0f * ring, black);
    disc (column, row, radius + ring, white);
    disc (column, row, radius, color);
    taken_.push_back (around (column, row));
  }

  /** \brief A number beside a dot, where it hides least of the dots and numbers that are there. */
  void
  number (int column, int row, int value)
  {
    const std::string text = std::to_string (value);
    const Rectangle own_dot = around (column, row);
    const int width = (static_cast<int> (text.size ()) * (digit_width + 1) + 1) * scale_;
    const int height = (digit_height + 2) * scale_;
    const int right = own_dot.left + own_dot.width, left = own_dot.left - width;
    const int above = own_dot.top - height, below = own_dot.top + own_dot.height;
    const int middle_row = row - height / 2, middle_column = column - width / 2;
    const std::array<Rectangle, 8> places{{{right, middle_row, width, height},
                                           {left, middle_row, width, height},
                                           {middle_column, above, width, height},
                                           {middle_column, below, width, height},
                                           {right, above, width, height},
                                           {left, above, width, height},
                                           {right, below, width, height},
                                           {left, below, width, height}}};
    const Rectangle whole{0, 0, image_.width, image_.height};
    const auto hidden = [&] (const Rectangle& place) {
      int area = place.width * place.height - overlap (place, whole);
      for (const Rectangle& other : taken_)
        area += overlap (place, other);
      return (area);
    };
    const Rectangle place =
        *std::min_element (places.begin (), places.end (),
                           [&] (const Rectangle& a, const Rectangle& b) { return (hidden (a) < hidden (b)); });
    taken_.push_back (place);
    write (text, place.left + scale_, place.top + scale_);
  }

private:
  template <typename Function>
  void
  forEachNear (int column, int row, int radius, Function function) const
  {
    for (int y = std::max (row - radius, 0); y <= std::min (row + radius, image_.height - 1); ++y)
      for (int x = std::max (column - radius, 0); x <= std::min (column + radius, image_.width - 1); ++x)
        function (x, y);
  }

  Rectangle
  around (int column, int row) const
  {
    const int radius = 4 * scale_;
    return {column - radius, row - radius, 2 * radius + 1, 2 * radius + 1};
  }

  void
  disc (int column, int row, float radius, const Color& color)
  {
    const auto inside = [&] (int x, int y) {
      return (static_cast<float> ((x - column) * (x - column) + (y - row) * (y - row)) <= radius * radius);
    };
    forEachNear (column, row, static_cast<int> (std::ceil (radius)), [&] (int x, int y) {
      if (inside (x, y))
        image_ (x, y) = color;
    });
  }

  void
  write (const std::string& text, int left, int top)
  {
    // First the dark edge of all digits, so that it does not cut into a neighbour.
    for (const int edge : {scale_, 0})
      for (std::size_t i = 0; i < text.size (); ++i)
        digit (text[i] - '0', left + static_cast<int> (i) * (digit_width + 1) * scale_, top, edge);
  }

  void
  digit (int value, int left, int top, int edge)
  {
    for (int row = 0; row < digit_height; ++row)
      for (int column = 0; column < digit_width; ++column)
        if ((digits[value][row] >> (digit_width - 1 - column) & 1) != 0)
          fill (left + column * scale_ - edge, top + row * scale_ - edge, scale_ + 2 * edge, edge > 0 ? black : white);
  }

  void
  fill (int left, int top, int size, const Color& color)
  {
    for (int y = std::max (top, 0); y < std::min (top + size, image_.height); ++y)
      for (int x = std::max (left, 0); x < std::min (left + size, image_.width); ++x)
        image_ (x, y) = color;
  }

  Image<Color> image_;
  int scale_; /**< pixels a font pixel is wide */
  std::vector<Rectangle> taken_;
};

Image<Color>
depthImage (const Scene& scene)
{
  const pcl::PointCloud<pcl::PointXYZRGB>& cloud = *scene.cloud;
  const Eigen::Vector3f forward = cloud.sensor_orientation_ * Eigen::Vector3f::UnitZ ();
  const auto inverseDepth = [&] (const pcl::PointXYZRGB& point) {
    return (1.0f / forward.dot (point.getVector3fMap () - cloud.sensor_origin_.head<3> ()));
  };
  std::vector<float> sorted;
  for (const pcl::PointXYZRGB& point : cloud)
    if (pcl::isFinite (point))
      sorted.push_back (inverseDepth (point));
  std::sort (sorted.begin (), sorted.end ());
  // A few outliers shall not take all the contrast.
  const float far = sorted[sorted.size () / 50], near = sorted[sorted.size () - 1 - sorted.size () / 50];
  const float range = std::max (near - far, 1e-6f);

  Image<Color> image (static_cast<int> (cloud.width), static_cast<int> (cloud.height), black);
  for (std::size_t i = 0; i < cloud.size (); ++i)
    if (pcl::isFinite (cloud[i]))
    {
      const float share = std::min (std::max ((inverseDepth (cloud[i]) - far) / range, 0.0f), 1.0f);
      image[i].fill (static_cast<std::uint8_t> (40.0f + 200.0f * share));
    }
  return (image);
}

} // namespace

Color
segmentColor (int rank)
{
  const pcl::RGB color = pcl::GlasbeyLUT::at (static_cast<unsigned int> (rank - 1) % pcl::GlasbeyLUT::size ());
  return {color.r, color.g, color.b};
}

Image<Color>
backgroundImage (const Scene& scene)
{
  if (!scene.has_color)
    return (depthImage (scene));
  Image<Color> image (static_cast<int> (scene.cloud->width), static_cast<int> (scene.cloud->height));
  for (std::size_t i = 0; i < image.size (); ++i)
    image[i] = {(*scene.cloud)[i].r, (*scene.cloud)[i].g, (*scene.cloud)[i].b};
  return (image);
}

Image<Color>
drawOverview (const Scene& scene, const std::vector<AttentionSegment>& segments)
{
  Canvas canvas (backgroundImage (scene));
  // What is more salient lies on top.
  for (auto segment = segments.rbegin (); segment != segments.rend (); ++segment)
    canvas.outline (segment->indices, segmentColor (segment->rank));
  for (auto segment = segments.rbegin (); segment != segments.rend (); ++segment)
    canvas.dot (segment->attention_point.column, segment->attention_point.row, segmentColor (segment->rank));
  for (const AttentionSegment& segment : segments)
    canvas.number (segment.attention_point.column, segment.attention_point.row, segment.rank);
  return (canvas.image ());
}

} // namespace pcl_attention
