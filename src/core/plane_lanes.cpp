// SPDX-License-Identifier: BSD-3-Clause
#include "lanes.h"
#include "lane_kernels.h"

namespace pcl_attention::PCL_ATTENTION_INSTRUCTION_SET
{

namespace
{

/** \brief Some points, the lanes behind the last one not valid. */
struct Points
{
  LaneVector position;
  LaneMask valid;
};

inline Points
pointsFrom (const PointArrays& points, std::size_t index, int count)
{
  return {{load (points.x + index, count), load (points.y + index, count), load (points.z + index, count)},
          loadFlags (points.valid + index, count)};
}

inline Lanes
product (const float (&a)[3], const LaneVector& b)
{
  return (a[0] * b.x + (a[1] * b.y + a[2] * b.z));
}

/** \brief The least of what is made of a point's heights over all planes. */
template <typename Make> inline void
leastOverPlanes (const PointArrays& points, std::size_t count, const FlatPlane* planes, std::size_t plane_count, float* values,
                 const Make& make)
{
  // Some at a time, so that a plane is read once for all of them and no minimum waits for the one before.
  constexpr int together = 4;
  for (std::size_t begin = 0; begin < count; begin += together * lane_count)
  {
    LaneVector position[together];
    Lanes least[together];
    const auto indexOf = [&] (int k) {
      const std::size_t index = begin + k * lane_count;
      return (index < count ? index : count);
    };
    const auto lanesOf = [&] (int k) {
      const std::size_t left = count - indexOf (k);
      return (left >= lane_count ? lane_count : static_cast<int> (left));
    };
    for (int k = 0; k < together; ++k)
    {
      const std::size_t index = indexOf (k);
      const int lanes = lanesOf (k);
      position[k] = {load (points.x + index, lanes), load (points.y + index, lanes), load (points.z + index, lanes)};
      least[k] = broadcast (3.402823466e38f);
    }
    for (const FlatPlane* plane = planes; plane != planes + plane_count; ++plane)
      for (int k = 0; k < together; ++k)
        least[k] = minimum (make (plane->normal[0] * position[k].x + plane->normal[1] * position[k].y +
                                  plane->normal[2] * position[k].z + plane->offset), least[k]);
    for (int k = 0; k < together; ++k)
      store (least[k], values + indexOf (k), lanesOf (k));
  }
}

} // namespace

void
pointsNear (const PointArrays& points, std::size_t count, const SurfaceTest& test, std::uint8_t* near)
{
  for (std::size_t index = 0; index < count; index += lane_count)
  {
    const int lanes = count - index >= lane_count ? lane_count : static_cast<int> (count - index);
    const Points p = pointsFrom (points, index, lanes);
    const Lanes z = p.position.z;
    const Lanes tolerance = test.tolerance + test.noise_tolerance * z * z;
    // The bent surface is only trusted near the plane itself, and beyond the points it was fitted to the plane is the better one.
    const Lanes flat_height = product (test.normal, p.position) + test.offset;
    LaneMask result = p.valid & (absolute (flat_height) <= test.below + 3.0f * tolerance);
    if (any (result))
    {
      const Lanes depth = select (p.valid, z, broadcast (1.0f));
      const Lanes u = p.position.x / depth, v = p.position.y / depth;
      const Lanes inverse_depth = ((test.bent[0] + test.bent[2] * v) + (test.bent[1] * u + test.bent[3] * (u * u))) +
                                  (test.bent[4] * (u * v) + test.bent[5] * (v * v));
      const LaneMask bends = inverse_depth > 1e-3f;
      const Lanes bent_height = (z - 1.0f / select (bends, inverse_depth, broadcast (1.0f))) *
                                (test.normal[0] * u + (test.normal[1] * v + test.normal[2]));
      const Lanes height = select (~bends | (absolute (flat_height) < absolute (bent_height)), flat_height, bent_height);
      const Lanes lowest = -maximum (broadcast (test.below), tolerance);
      const LaneVector normal{load (points.normal_x + index, lanes), load (points.normal_y + index, lanes),
                              load (points.normal_z + index, lanes)};
      result &= (height < tolerance) & (height >= lowest) &
                ((product (test.normal, normal) > test.minimum_cosine) | (height < 0.5f * tolerance));
    }
    storeBytes (result & 1, near + index, lanes);
  }
}

void
pointsOver (const PointArrays& points, std::size_t count, const RoomTest& test, std::uint8_t* over)
{
  for (std::size_t index = 0; index < count; index += lane_count)
  {
    const int lanes = count - index >= lane_count ? lane_count : static_cast<int> (count - index);
    const Points p = pointsFrom (points, index, lanes);
    const Lanes height = product (test.normal, p.position) + test.offset;
    LaneMask result = p.valid & (height > test.lowest) & (height < test.highest);
    if (any (result))
    {
      const Lanes x = product (test.axis1, p.position), y = product (test.axis2, p.position);
      for (const OutlineEdge* edge = test.edges; edge != test.edges + test.edge_count; ++edge)
        result &= edge->normal_x * (x - edge->x) + edge->normal_y * (y - edge->y) <= edge->limit;
    }
    storeBytes (result & 1, over + index, lanes);
  }
}

void
nearestPlane (const PointArrays& points, std::size_t count, const FlatPlane* planes, std::size_t plane_count, float* distances)
{
  leastOverPlanes (points, count, planes, plane_count, distances, [] (const Lanes& height) { return (absolute (height)); });
}

void
lowestHeight (const PointArrays& points, std::size_t count, const FlatPlane* planes, std::size_t plane_count, float* heights)
{
  leastOverPlanes (points, count, planes, plane_count, heights, [] (const Lanes& height) { return (height); });
}

void
farthestPoints (const PointArrays& points, std::size_t count, int* farthest)
{
  LaneMask lanes_in_order{};
  for (int lane = 0; lane < lane_count; ++lane)
    lanes_in_order[lane] = lane;
  for (int direction = 0; direction < direction_count; ++direction)
  {
    const auto x = static_cast<float> (direction / 9 - 1), y = static_cast<float> (direction / 3 % 3 - 1),
               z = static_cast<float> (direction % 3 - 1);
    Lanes most = broadcast (-3.402823466e38f), least = -most;
    LaneMask most_at{}, least_at{};
    for (std::size_t index = 0; index < count; index += lane_count)
    {
      const int lanes = count - index >= lane_count ? lane_count : static_cast<int> (count - index);
      const Lanes reach = x * load (points.x + index, lanes) + y * load (points.y + index, lanes) + z * load (points.z + index, lanes);
      const LaneMask place = lanes_in_order + static_cast<std::int32_t> (index);
      const LaneMask is_point = lanes_in_order < lanes;
      const LaneMask is_more = (reach > most) & is_point, is_less = (reach < least) & is_point;
      most = select (is_more, reach, most);
      least = select (is_less, reach, least);
      most_at = is_more ? place : most_at;
      least_at = is_less ? place : least_at;
    }
    int best = 0, worst = 0; // lanes; of those as far the first point
    for (int lane = 1; lane < lane_count; ++lane)
    {
      if (most[lane] > most[best] || (most[lane] == most[best] && most_at[lane] < most_at[best]))
        best = lane;
      if (least[lane] < least[worst] || (least[lane] == least[worst] && least_at[lane] < least_at[worst]))
        worst = lane;
    }
    farthest[direction] = most_at[best];
    farthest[2 * direction_count - 1 - direction] = least_at[worst];
  }
}

} // namespace pcl_attention::PCL_ATTENTION_INSTRUCTION_SET
