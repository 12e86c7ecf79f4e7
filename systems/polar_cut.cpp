// SPDX-License-Identifier: BSD-3-Clause
#include "systems/polar_cut.h"

#include "systems/graph_cut.h"

#include <algorithm>
#include <cmath>

namespace pcl_attention
{

namespace
{

constexpr float pi = static_cast<float> (M_PI);
constexpr int angles = 360; // rows of the polar grid
constexpr int rim = 10;     // its columns beyond the farthest corner

/** \brief The row of a direction. */
float
angleOf (float dx, float dy)
{
  return (std::atan2 (dy, dx) * (angles / (2 * pi)));
}

int
wrapped (int angle)
{
  return ((angle % angles + angles) % angles);
}

/** \brief The boundaries in polar coordinates: column = distance in pixels, row = direction in degrees.
 *
 * A boundary is drawn as an elongated Gaussian along its line, the longer the nearer it is to the fixation, where a
 * pixel is many degrees wide; that also closes small gaps. A cell has the strongest one. */
Image<float>
polarEdges (const EdgeMap& edges, int column, int row, int distances, const PolarCutParameters& parameters)
{
  Image<float> polar (distances, angles, 0.0f);
  const auto draw = [&] (int x, int y, float strength, float direction) {
    const auto dx = static_cast<float> (x - column), dy = static_cast<float> (y - row);
    const float distance = std::max (std::hypot (dx, dy), 1.0f), angle = angleOf (dx, dy);
    // Of the line to the ray from the fixation, which the polar grid's columns lie along.
    const float slant = direction - angle * (2 * pi / angles);
    // A step along the line is this far along the ray, and this many degrees across it.
    Eigen::Vector2f line (std::cos (slant), std::sin (slant) * angles / (2 * pi * distance));
    line.normalize ();
    const float degrees = std::atan2 (std::abs (line.y ()), std::abs (line.x ())) * 180 / pi;
    const float shrink = std::pow (distance, 0.7f);
    const float length = (1 + degrees) / std::pow (shrink, std::abs (line.y ()));
    const int window = static_cast<int> (std::max (4.0f, 90 / shrink));
    const auto middle_column = static_cast<int> (std::lround (distance)),
               middle_row = static_cast<int> (std::lround (angle));
    for (int j = -window; j <= window; ++j)
      for (int i = std::max (-window, -middle_column); i <= window && middle_column + i < distances; ++i)
      {
        const float along = i * line.x () + j * line.y (), across = j * line.x () - i * line.y ();
        const float share = std::exp (-along * along / (2 * length * length) - across * across / 4);
        float& cell = polar (middle_column + i, wrapped (middle_row + j));
        cell = std::max (cell, strength * share);
      }
  };
  const int width = edges.strength.width, height = edges.strength.height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
    {
      if (edges.strength (x, y) >= parameters.empty_strength)
        draw (x, y, edges.strength (x, y), edges.direction (x, y));
      if (x == 0 || x == width - 1)
        draw (x, y, parameters.border_strength, 0.5f * pi);
      if (y == 0 || y == height - 1)
        draw (x, y, parameters.border_strength, 0.0f);
    }
  return (polar);
}

} // namespace

Image<std::uint8_t>
segmentAround (const EdgeMap& edges, int column, int row, const PolarCutParameters& parameters)
{
  const int width = edges.strength.width, height = edges.strength.height;
  const double farthest = std::hypot (std::max (column, width - 1 - column), std::max (row, height - 1 - row));
  const int distances = static_cast<int> (std::ceil (farthest)) + 1 + rim;
  const Image<float> polar = polarEdges (edges, column, row, distances, parameters);

  const auto cost = [&parameters] (float first, float second) {
    const float mean = 0.5f * (first + second);
    return (mean < parameters.empty_strength ? parameters.empty_cost : std::exp (-parameters.steepness * mean));
  };
  GraphCut cut (static_cast<int> (polar.size ()));
  for (int angle = 0; angle < angles; ++angle)
    for (int distance = 0; distance < distances; ++distance)
    {
      const int cell = angle * distances + distance;
      const int beside = (angle + 1) % angles * distances + distance;
      const float across = cost (polar[cell], polar[beside]);
      cut.connect (cell, beside, across, across);
      if (distance + 1 < distances)
      {
        const float along = cost (polar[cell], polar[cell + 1]);
        cut.connect (cell, cell + 1, along, along);
      }
      if (distance == 0)
        cut.tieToInside (cell, parameters.tie_cost);
      else if (distance >= distances - rim)
        cut.tieToOutside (cell, parameters.tie_cost);
    }
  const std::vector<std::uint8_t> inside = cut.solve ();

  Image<std::uint8_t> mask (width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
    {
      const auto dx = static_cast<float> (x - column), dy = static_cast<float> (y - row);
      const int angle = wrapped (static_cast<int> (std::lround (angleOf (dx, dy))));
      mask (x, y) = inside[angle * distances + std::lround (std::hypot (dx, dy))];
    }
  return (mask);
}

} // namespace pcl_attention
