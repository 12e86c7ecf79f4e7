// SPDX-License-Identifier: BSD-3-Clause
#include "systems/color_edges.h"

#include <pcl_attention/core/bands.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_attention
{

namespace
{

constexpr int orientations = 8, sectors = 2 * orientations, bins = 16;
constexpr float pi = static_cast<float> (M_PI);
using Histogram = Eigen::Array<float, bins, 1>;

/** \brief What the halves of a disc are compared by: every pixel counts for two neighbouring bins. */
struct Feature
{
  Image<std::uint8_t> bin; /**< the lower one */
  Image<float> share;      /**< of the next one, 0..1 */
};

/** \brief A value in 0..1 as a feature. */
Feature
featureOf (const Image<float>& values)
{
  Feature feature;
  feature.bin.resize (values.width, values.height);
  feature.share.resize (values.width, values.height);
  for (std::size_t i = 0; i < values.size (); ++i)
  {
    const float place = std::clamp (values[i], 0.0f, 1.0f) * (bins - 1);
    feature.bin[i] = static_cast<std::uint8_t> (std::min (static_cast<int> (place), bins - 2));
    feature.share[i] = place - feature.bin[i];
  }
  return (feature);
}

/** \brief Which way and how strongly the brightness changes, as a feature: strong ones by their orientation, all weak
 * ones alike. */
Feature
textureOf (const Image<float>& brightness)
{
  constexpr float strong = 0.04f; // of the whole range, a pixel: above what a camera's noise gives
  Feature feature;
  feature.bin.assign (brightness.width, brightness.height, 0);
  feature.share.assign (brightness.width, brightness.height, 0.0f);
  for (int row = 1; row + 1 < brightness.height; ++row)
    for (int column = 1; column + 1 < brightness.width; ++column)
    {
      const float dx = 0.5f * (brightness (column + 1, row) - brightness (column - 1, row));
      const float dy = 0.5f * (brightness (column, row + 1) - brightness (column, row - 1));
      const float strength = std::hypot (dx, dy);
      if (strength < strong)
        continue;
      float angle = std::atan2 (dy, dx);
      if (angle < 0)
        angle += pi;
      const int kind = static_cast<int> (angle / pi * 5.0f + 0.5f) % 5;
      feature.bin (column, row) = static_cast<std::uint8_t> (2 + kind + (strength > 3 * strong ? 6 : 0));
    }
  return (feature);
}

/** \brief A pixel of a disc: where it is and the sector it is in. */
struct DiscPixel
{
  int dx, dy, sector;
};

std::vector<DiscPixel>
discOf (int radius)
{
  std::vector<DiscPixel> disc;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx)
    {
      if ((dx == 0 && dy == 0) || dx * dx + dy * dy > radius * radius)
        continue;
      // Turned by half a sector, so that no sector's border is a row or column of pixels.
      const float angle = std::atan2 (static_cast<float> (dy), static_cast<float> (dx)) + pi / sectors;
      const int sector = static_cast<int> (std::floor (angle / (2 * pi) * sectors));
      disc.push_back ({dx, dy, (sector + sectors) % sectors});
    }
  return (disc);
}

/** \brief Add to the strength at every orientation the chi-square distance of the halves of a disc. */
void
addGradient (const Feature& feature, int radius, float weight, int threads,
             std::array<Image<float>, orientations>& strength)
{
  const std::vector<DiscPixel> disc = discOf (radius);
  const int width = feature.bin.width, height = feature.bin.height;
  forEachBand (height, 8, threads, [&] (int begin, int end) {
    for (int row = begin; row < end; ++row)
      for (int column = 0; column < width; ++column)
      {
        std::array<Histogram, sectors> counts;
        counts.fill (Histogram::Zero ());
        for (const DiscPixel& pixel : disc)
        {
          const int x = std::clamp (column + pixel.dx, 0, width - 1), y = std::clamp (row + pixel.dy, 0, height - 1);
          const float share = feature.share (x, y);
          float* bin = &counts[pixel.sector][feature.bin (x, y)];
          bin[0] += 1.0f - share;
          bin[1] += share;
        }
        Histogram half = Histogram::Zero (), whole = Histogram::Zero ();
        for (int sector = 0; sector < sectors; ++sector)
        {
          whole += counts[sector];
          if (sector < orientations)
            half += counts[sector];
        }
        for (int orientation = 0; orientation < orientations; ++orientation)
        {
          const Histogram other = whole - half;
          const float first = std::max (half.sum (), 1.0f), second = std::max (other.sum (), 1.0f);
          const Histogram sum = half / first + other / second, difference = half / first - other / second;
          strength[orientation](column, row) += weight * 0.5f * (difference.square () / (sum + 1e-9f)).sum ();
          half += counts[orientation + orientations] - counts[orientation];
        }
      }
  });
}

} // namespace

ColorImage
colorsOf (const OrganizedCloud& cloud)
{
  ColorImage colors (cloud.width, cloud.height, Eigen::Vector3f::Zero ());
  for (std::size_t i = 0; i < colors.size (); ++i)
    colors[i] = Eigen::Vector3f (cloud.red[i], cloud.green[i], cloud.blue[i]) / 255.0f;
  return (colors);
}

Eigen::Vector3f
labOf (const Eigen::Vector3f& rgb)
{
  const Eigen::Array3f linear =
      (rgb.array () <= 0.04045f).select (rgb.array () / 12.92f, ((rgb.array () + 0.055f) / 1.055f).pow (2.4f));
  Eigen::Matrix3f to_xyz;                                                        // over the white point
  to_xyz << 0.4124564f / 0.95047f, 0.3575761f / 0.95047f, 0.1804375f / 0.95047f, //
      0.2126729f, 0.7151522f, 0.0721750f,                                        //
      0.0193339f / 1.08883f, 0.1191920f / 1.08883f, 0.9503041f / 1.08883f;
  const Eigen::Array3f xyz = (to_xyz * linear.matrix ()).array ();
  const Eigen::Array3f f = (xyz > 0.008856f).select (xyz.max (1e-6f).pow (1.0f / 3.0f), 7.787f * xyz + 16.0f / 116.0f);
  return (Eigen::Vector3f (116.0f * f.y () - 16.0f, 500.0f * (f.x () - f.y ()), 200.0f * (f.y () - f.z ())));
}

EdgeMap
detectColorEdges (const ColorImage& colors, const ColorEdgeParameters& parameters, int threads)
{
  const int width = colors.width, height = colors.height;
  Image<float> brightness (width, height), a (width, height), b (width, height);
  for (std::size_t i = 0; i < colors.size (); ++i)
  {
    const Eigen::Vector3f lab = labOf (colors[i]);
    brightness[i] = lab.x () / 100.0f;
    // What surfaces reflect is hardly ever beyond +-75.
    a[i] = 0.5f + lab.y () / 150.0f;
    b[i] = 0.5f + lab.z () / 150.0f;
  }
  std::array<Image<float>, orientations> gradient;
  gradient.fill (Image<float> (width, height, 0.0f));
  addGradient (featureOf (brightness), parameters.brightness_radius, parameters.brightness_weight, threads, gradient);
  addGradient (featureOf (a), parameters.color_radius, parameters.color_weight, threads, gradient);
  addGradient (featureOf (b), parameters.color_radius, parameters.color_weight, threads, gradient);
  addGradient (textureOf (brightness), parameters.texture_radius, parameters.texture_weight, threads, gradient);

  // A line is where the gradient is largest across it. Across orientation k points to the middle of the first half.
  EdgeMap edges{Image<float> (width, height, 0.0f), Image<float> (width, height, 0.0f)};
  for (int row = 1; row + 1 < height; ++row)
    for (int column = 1; column + 1 < width; ++column)
    {
      int strongest = 0;
      for (int orientation = 1; orientation < orientations; ++orientation)
        if (gradient[orientation](column, row) > gradient[strongest](column, row))
          strongest = orientation;
      const Image<float>& map = gradient[strongest];
      const float value = map (column, row);
      if (value < parameters.threshold)
        continue;
      const float across = (strongest + 0.5f * (orientations - 1)) * pi / orientations;
      const int dx = static_cast<int> (std::lround (std::cos (across))),
                dy = static_cast<int> (std::lround (std::sin (across)));
      if (value < map (column + dx, row + dy) || value <= map (column - dx, row - dy))
        continue;
      edges.strength (column, row) = std::min (value, 1.0f);
      edges.direction (column, row) = std::fmod (across + 0.5f * pi, pi);
    }
  return (edges);
}

} // namespace pcl_attention
