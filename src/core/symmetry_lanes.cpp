// SPDX-License-Identifier: BSD-3-Clause
#include "lanes.h"
#include "lane_kernels.h"

namespace pcl_attention::PCL_ATTENTION_INSTRUCTION_SET
{

namespace
{

/** \brief One half of the neighbourhood on one side of a reflective plane. */
struct Half
{
  Lanes count;
  LaneVector mean_point;  /**< relative to the centre, metres */
  LaneVector mean_normal; /**< unit */
};

/** \brief Paper eq. 4, from the signed distances of both mean points to the plane. */
inline Lanes
distanceDifference (const Lanes& distance1, const Lanes& distance2)
{
  return (absolute (absolute (distance1) - absolute (distance2)));
}

/** \brief Paper eq. 5: towards the viewer is the z axis of the sensor frame. */
inline Lanes
depthDifference (const Half& half1, const Half& half2)
{
  return (absolute (half1.mean_point.z - half2.mean_point.z));
}

/** \brief Paper eq. 7, with p_i1 - p_i2 in the denominator, where the text has p_i1 - p_i1. */
inline LaneVector
connectingLine (const Half& half1, const Half& half2)
{
  return (normalized (half1.mean_point - half2.mean_point));
}

/** \brief omega_1, paper eq. 6; 0 for parallel mean normals, where it is undefined. */
inline Lanes
coplanarity (const Half& half1, const Half& half2, const LaneVector& line)
{
  const LaneVector perpendicular = cross (normalized (cross (half1.mean_normal, half2.mean_normal)), line);
  return (squareRoot (dot (perpendicular, perpendicular)));
}

/** \brief omega_2, paper eq. 8. Expanded, (1 - cos (a + b)) (1 - cos (a - b)) is (cos a - cos b)^2. */
inline Lanes
normalOpposition (const Half& half1, const Half& half2, const LaneVector& line)
{
  const Lanes difference = dot (half1.mean_normal - half2.mean_normal, line);
  return (difference * difference);
}

/** \brief Omega_i, paper eq. 3, with the exponents in the given units. */
inline Lanes
reflectiveSymmetry (const Half& half1, const Half& half2, const LaneVector& axis, float distance_scale)
{
  const LaneVector line = connectingLine (half1, half2);
  const Lanes distance = distanceDifference (dot (half1.mean_point, axis), dot (half2.mean_point, axis)) +
                         depthDifference (half1, half2);
  return (exponential (-distance_scale * distance) * coplanarity (half1, half2, line) *
          normalOpposition (half1, half2, line));
}

/** \brief A neighbour in N(p), relative to the centre; 0 where it is not valid. */
struct Sample
{
  LaneVector point, normal;
};

/** \brief Sums over the samples on one side of the plane through the centre (paper eq. 1). */
struct SideSum
{
  LaneMask count{};
  LaneVector point{}, normal{};

  void
  add (const LaneMask& on_side, const Sample& sample)
  {
    count -= on_side; // a mask is -1
    addWhere (on_side, sample.point.x, point.x);
    addWhere (on_side, sample.point.y, point.y);
    addWhere (on_side, sample.point.z, point.z);
    addWhere (on_side, sample.normal.x, normal.x);
    addWhere (on_side, sample.normal.y, normal.y);
    addWhere (on_side, sample.normal.z, normal.z);
  }

  Half
  mean (const LaneVector& center_normal) const
  {
    const Lanes size = __builtin_convertvector (count, Lanes);
    const Lanes inverse = 1.0f / select (count > 0, size, broadcast (1.0f));
    return {size, point * inverse, normalized (center_normal + normal * inverse)};
  }
};

inline LaneVector
pointsOf (const SurfaceRow& row, int column)
{
  return {load (row.channels[SurfaceRow::x] + column), load (row.channels[SurfaceRow::y] + column),
          load (row.channels[SurfaceRow::z] + column)};
}

inline LaneVector
normalsOf (const SurfaceRow& row, int column)
{
  return {load (row.channels[SurfaceRow::normal_x] + column), load (row.channels[SurfaceRow::normal_y] + column),
          load (row.channels[SurfaceRow::normal_z] + column)};
}

/** \brief The symmetry of lane_count pixels, paper eq. 1 to 3.
  * \param[out] winner 1..3, 0 where the symmetry is 0 */
inline Lanes
localSymmetry (const SurfaceRow* const* around, int column, const SymmetrySettings& settings, Sample* samples,
               LaneMask& winner)
{
  winner = LaneMask{};
  const int radius = settings.radius;
  const SurfaceRow& center_row = *around[radius];
  const LaneMask center_valid = load (center_row.channels[SurfaceRow::valid] + column) > 0.0f;
  if (!any (center_valid))
    return (Lanes{});

  const LaneVector center_point = pointsOf (center_row, column), center_normal = normalsOf (center_row, column);
  SideSum total;
  LaneSymmetricMatrix square{};
  int size = 0;
  for (int row_step = -radius; row_step <= radius; ++row_step)
  {
    if (row_step == 0)
      continue;
    const SurfaceRow& row = *around[radius + row_step];
    for (int column_step = -radius; column_step <= radius; ++column_step)
    {
      if (column_step == 0)
        continue;
      // Differences to the centre keep the covariance of nearly equal normals exact.
      const int at = column + column_step;
      const LaneMask valid = load (row.channels[SurfaceRow::valid] + at) > 0.0f;
      const LaneVector point = pointsOf (row, at) - center_point, normal = normalsOf (row, at) - center_normal;
      const Sample sample{{keep (valid, point.x), keep (valid, point.y), keep (valid, point.z)},
                          {keep (valid, normal.x), keep (valid, normal.y), keep (valid, normal.z)}};
      samples[size++] = sample;
      total.count -= valid;
      total.point = total.point + sample.point;
      total.normal = total.normal + sample.normal;
      square.xx += sample.normal.x * sample.normal.x;
      square.xy += sample.normal.x * sample.normal.y;
      square.xz += sample.normal.x * sample.normal.z;
      square.yy += sample.normal.y * sample.normal.y;
      square.yz += sample.normal.y * sample.normal.z;
      square.zz += sample.normal.z * sample.normal.z;
    }
  }
  const Lanes inverse = 1.0f / select (total.count > 0, __builtin_convertvector (total.count, Lanes), broadcast (1.0f));
  const LaneVector mean = total.normal * inverse;
  const LaneSymmetricMatrix covariance{
    square.xx * inverse - mean.x * mean.x, square.xy * inverse - mean.x * mean.y, square.xz * inverse - mean.x * mean.z,
    square.yy * inverse - mean.y * mean.y, square.yz * inverse - mean.y * mean.z, square.zz * inverse - mean.z * mean.z};
  LaneVector axes[3];
  Lanes variances[3];
  eigenDecomposition (covariance, axes, variances);

  Lanes best{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const LaneVector plane_normal = axes[axis];
    SideSum side1;
    LaneMask behind{};
    for (int k = 0; k < size; ++k)
    {
      const Lanes distance = dot (samples[k].point, plane_normal);
      side1.add (distance > 0.0f, samples[k]);
      behind -= distance < 0.0f;
    }
    // The other side is the rest, unless samples lie exactly on the plane.
    SideSum side2{total.count - side1.count, total.point - side1.point, total.normal - side1.normal};
    const LaneMask on_plane = side2.count != behind;
    if (any (on_plane))
    {
      SideSum summed;
      for (int k = 0; k < size; ++k)
        summed.add (dot (samples[k].point, plane_normal) < 0.0f, samples[k]);
      side2 = {behind, select (on_plane, summed.point, side2.point), select (on_plane, summed.normal, side2.normal)};
    }

    const Half half1 = side1.mean (center_normal), half2 = side2.mean (center_normal);
    LaneMask defined = center_valid & (half1.count > 0.0f) & (half2.count > 0.0f);
    if (settings.convexity_gate)
      defined &= (dot (half1.mean_normal, plane_normal) > 0.0f) & (dot (half2.mean_normal, plane_normal) < 0.0f);
    if (!any (defined))
      continue;
    const Lanes symmetry = keep (defined, reflectiveSymmetry (half1, half2, plane_normal, settings.distance_scale));
    const LaneMask better = symmetry > best;
    best = select (better, symmetry, best);
    winner = (winner & ~better) | (better & (axis + 1));
  }
  return (best);
}

} // namespace

void
symmetryOfRow (const SurfaceRow* const* around, int width, const SymmetrySettings& settings, float* samples,
               float* symmetry, std::uint8_t* winning_axis)
{
  for (int column = 0; column < width; column += lane_count)
  {
    LaneMask winner;
    const Lanes values = localSymmetry (around, column, settings, reinterpret_cast<Sample*> (samples), winner);
    store (values, symmetry + column, width - column);
    storeBytes (winner, winning_axis + column, width - column);
  }
}

} // namespace pcl_attention::PCL_ATTENTION_INSTRUCTION_SET
