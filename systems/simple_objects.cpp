// SPDX-License-Identifier: BSD-3-Clause
#include "systems/simple_objects.h"

#include <pcl_attention/core/bands.h>

#include <algorithm>
#include <cmath>

namespace pcl_attention
{

namespace
{

/** \brief The depth without holes: beside an object a camera with a projector sees nothing of what is behind, so that
 * the farther surface goes on there. */
Image<float>
filledDepth (const OrganizedCloud& cloud)
{
  Image<float> depth (cloud.width, cloud.height, 0.0f);
  depth.data = cloud.z; // 0 where not valid
  const auto fill = [&depth] (std::size_t first, std::size_t step, int count) {
    for (int begin = 0; begin < count; ++begin)
    {
      if (depth[first + begin * step] > 0)
        continue;
      int end = begin;
      while (end < count && depth[first + end * step] == 0)
        ++end;
      const float before = begin > 0 ? depth[first + (begin - 1) * step] : 0.0f;
      const float after = end < count ? depth[first + end * step] : 0.0f;
      for (int i = begin; i < end; ++i)
        depth[first + i * step] = std::max (before, after);
      begin = end;
    }
  };
  for (int row = 0; row < cloud.height; ++row)
    fill (static_cast<std::size_t> (row) * cloud.width, 1, cloud.width);
  for (int column = 0; column < cloud.width; ++column)
    fill (column, cloud.width, cloud.height);
  return (depth);
}

constexpr int neighbor_columns[8] = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr int neighbor_rows[8] = {0, 1, 1, 1, 0, -1, -1, -1};

/** \brief Whether two neighbours may be of one surface. */
bool
isConnected (float first, float second, float step)
{
  const float farther = std::max (first, second);
  return (std::abs (first - second) < step * farther * farther);
}

/** \brief Connected boundary pixels without a step in depth between them. */
std::vector<std::vector<Pixel>>
groupBoundaries (const OwnedBoundaries& boundaries, float step)
{
  std::vector<std::vector<Pixel>> groups;
  Image<std::uint8_t> done (boundaries.depth.width, boundaries.depth.height, 0);
  for (int row = 0; row < done.height; ++row)
    for (int column = 0; column < done.width; ++column)
    {
      if (!boundaries.boundary (column, row) || done (column, row))
        continue;
      done (column, row) = 1;
      std::vector<Pixel> group{{column, row}};
      for (std::size_t i = 0; i < group.size (); ++i)
        for (int k = 0; k < 8; ++k)
        {
          const Pixel from = group[i], to{from.column + neighbor_columns[k], from.row + neighbor_rows[k]};
          if (!done.contains (to.column, to.row) || done (to.column, to.row) ||
              !boundaries.boundary (to.column, to.row) ||
              !isConnected (boundaries.depth (from.column, from.row), boundaries.depth (to.column, to.row), step))
            continue;
          done (to.column, to.row) = 1;
          group.push_back (to);
        }
      groups.push_back (std::move (group));
    }
  return (groups);
}

/** \brief The middle of what the boundary's pixels see when they look inwards, as far as the surface reaches. */
Pixel
fixationOf (const std::vector<Pixel>& group, const OwnedBoundaries& boundaries,
            const SimpleObjectParameters& parameters)
{
  Image<std::uint8_t> is_seen (boundaries.depth.width, boundaries.depth.height, 0);
  std::vector<Pixel> seen;
  for (const Pixel& start : group)
  {
    const Eigen::Vector2f inward = boundaries.inward (start.column, start.row);
    float depth = boundaries.depth (start.column, start.row);
    for (int distance = 1; distance <= parameters.longest_ray; ++distance)
    {
      const auto column = static_cast<int> (std::lround (start.column + distance * inward.x ()));
      const auto row = static_cast<int> (std::lround (start.row + distance * inward.y ()));
      if (!is_seen.contains (column, row) || boundaries.table (column, row) ||
          !isConnected (depth, boundaries.depth (column, row), parameters.step))
        break;
      depth = boundaries.depth (column, row);
      if (!is_seen (column, row))
        seen.push_back ({column, row});
      is_seen (column, row) = 1;
    }
  }
  if (seen.empty ())
    return (group[group.size () / 2]);
  Eigen::Vector2d middle = Eigen::Vector2d::Zero ();
  for (const Pixel& pixel : seen)
    middle += Eigen::Vector2d (pixel.column, pixel.row) / static_cast<double> (seen.size ());
  const auto distance = [&middle] (const Pixel& pixel) {
    return ((Eigen::Vector2d (pixel.column, pixel.row) - middle).squaredNorm ());
  };
  return (*std::min_element (seen.begin (), seen.end (),
                             [&distance] (const Pixel& a, const Pixel& b) { return (distance (a) < distance (b)); }));
}

/** \brief Share of a region's contour that is, within two pixels, boundary whose owner is on the region's side. The
 * image's border is nobody's. */
float
ownedShare (const Image<std::uint8_t>& mask, const OwnedBoundaries& boundaries)
{
  constexpr int near = 2;
  int contour = 0, owned = 0;
  for (int row = 1; row + 1 < mask.height; ++row)
    for (int column = 1; column + 1 < mask.width; ++column)
    {
      if (!mask (column, row))
        continue;
      Eigen::Vector2f inward = Eigen::Vector2f::Zero ();
      for (int k = 0; k < 8; ++k)
        if (!mask (column + neighbor_columns[k], row + neighbor_rows[k]))
          inward -= Eigen::Vector2f (neighbor_columns[k], neighbor_rows[k]);
      if (inward.isZero ())
        continue;
      ++contour;
      bool is_owned = false;
      for (int y = row - near; y <= row + near; ++y)
        for (int x = column - near; x <= column + near; ++x)
          is_owned = is_owned ||
                     (mask.contains (x, y) && boundaries.boundary (x, y) && inward.dot (boundaries.inward (x, y)) > 0);
      owned += is_owned;
    }
  return (contour > 0 ? static_cast<float> (owned) / static_cast<float> (contour) : 0.0f);
}

float
intersectionOverUnion (const Image<std::uint8_t>& first, const Image<std::uint8_t>& second)
{
  int of_both = 0, of_either = 0;
  for (std::size_t i = 0; i < first.size (); ++i)
  {
    of_both += first[i] & second[i];
    of_either += first[i] | second[i];
  }
  return (of_either > 0 ? static_cast<float> (of_both) / static_cast<float> (of_either) : 0.0f);
}

} // namespace

OwnedBoundaries
findOwnedBoundaries (const OrganizedCloud& cloud, const std::vector<SupportingPlane>& planes,
                     const SimpleObjectParameters& parameters)
{
  const int width = cloud.width, height = cloud.height;
  OwnedBoundaries result;
  result.depth = filledDepth (cloud);
  result.boundary.assign (width, height, 0);
  result.inward.assign (width, height, Eigen::Vector2f::Zero ());
  result.table.assign (width, height, 0);
  for (const SupportingPlane& plane : planes)
  {
    for (const pcl::index_t index : plane.indices)
      result.table[index] = 1;
    for (std::size_t i = 0; i < cloud.size (); ++i)
      if (cloud.valid[i] &&
          std::abs (plane.coefficients.dot (Eigen::Vector4f (cloud.x[i], cloud.y[i], cloud.z[i], 1))) <
              parameters.table_height * std::max (1.0f, cloud.z[i] * cloud.z[i]))
        result.table[i] = 1;
  }

  const auto isStep = [&parameters] (float depth, float beyond) {
    return (beyond > depth && !isConnected (depth, beyond, parameters.step));
  };
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      const float depth = result.depth (column, row);
      if (!cloud.valid[static_cast<std::size_t> (row) * width + column] || result.table (column, row))
        continue;
      Eigen::Vector2f outward = Eigen::Vector2f::Zero ();
      bool is_boundary = false;
      for (int k = 0; k < 8; ++k)
      {
        const int next_column = column + neighbor_columns[k], next_row = row + neighbor_rows[k];
        const int far_column = column + 2 * neighbor_columns[k], far_row = row + 2 * neighbor_rows[k];
        if (!result.depth.contains (far_column, far_row))
          continue;
        // A step may be spread over two pixels; one beyond the next pixel is that pixel's own.
        const float next = result.depth (next_column, next_row), far = result.depth (far_column, far_row);
        const bool is_step = isStep (depth, next) || (isStep (depth, far) && !isStep (next, far));
        const bool is_contact = result.table (next_column, next_row) != 0;
        if (!is_step && !is_contact)
          continue;
        is_boundary = true;
        outward += Eigen::Vector2f (neighbor_columns[k], neighbor_rows[k]).normalized ();
      }
      if (!is_boundary)
        continue;
      result.boundary (column, row) = 1;
      if (outward.norm () > 1e-3f)
        result.inward (column, row) = -outward.normalized ();
    }
  return (result);
}

std::vector<SimpleObject>
findSimpleObjects (const OwnedBoundaries& boundaries, const EdgeMap& color_edges,
                   const SimpleObjectParameters& parameters, int threads)
{
  EdgeMap edges = color_edges;
  for (std::size_t i = 0; i < edges.strength.size (); ++i)
    if (boundaries.boundary[i])
    {
      edges.strength[i] = 1.0f;
      edges.direction[i] =
          std::atan2 (boundaries.inward[i].y (), boundaries.inward[i].x ()) + static_cast<float> (M_PI_2);
    }
    else if (edges.strength[i] > 0)
      edges.strength[i] = parameters.color_strength;

  std::vector<std::vector<Pixel>> groups = groupBoundaries (boundaries, parameters.step);
  std::stable_sort (groups.begin (), groups.end (),
                    [] (const auto& a, const auto& b) { return (a.size () > b.size ()); });
  while (!groups.empty () && (groups.size () > static_cast<std::size_t> (parameters.maximum_fixations) ||
                              groups.back ().size () < static_cast<std::size_t> (parameters.shortest_boundary)))
    groups.pop_back ();

  std::vector<SimpleObject> objects (groups.size ());
  forEachBand (static_cast<int> (groups.size ()), 1, threads, [&] (int i, int) {
    const Pixel fixation = fixationOf (groups[i], boundaries, parameters);
    objects[i].fixation = fixation;
    objects[i].mask = segmentAround (edges, fixation.column, fixation.row, parameters.cut);
    objects[i].owned_share = ownedShare (objects[i].mask, boundaries);
  });
  std::stable_sort (objects.begin (), objects.end (),
                    [] (const SimpleObject& a, const SimpleObject& b) { return (a.owned_share > b.owned_share); });
  std::vector<SimpleObject> kept;
  for (SimpleObject& object : objects)
    if (object.owned_share >= parameters.owned_share &&
        std::none_of (kept.begin (), kept.end (), [&] (const SimpleObject& other) {
          return (intersectionOverUnion (object.mask, other.mask) > parameters.overlap);
        }))
      kept.push_back (std::move (object));
  return (kept);
}

} // namespace pcl_attention
