// SPDX-License-Identifier: BSD-3-Clause
#include "lanes.h"
#include "lane_kernels.h"

namespace pcl_attention::PCL_ATTENTION_INSTRUCTION_SET
{

namespace
{

inline LaneVector
pointsOf (const NormalRow& row, int column)
{
  return {load (row.x + column), load (row.y + column), load (row.z + column)};
}

/** \brief The difference of two points, 0 where they are not within the gate. */
inline LaneVector
gatedDifference (const LaneVector& to, const LaneVector& from, float gate, LaneMask& near)
{
  const LaneVector difference = to - from;
  near = absolute (difference.z) < gate;
  return {keep (near, difference.x), keep (near, difference.y), keep (near, difference.z)};
}

} // namespace

void
rowMoments (const NormalRow& row, int width, int radius, float gate)
{
  for (int column = 0; column < width; column += lane_count)
  {
    const LaneVector center = pointsOf (row, column);
    Lanes sums[NormalRow::moments_size] = {};
    for (int step = -radius; step <= radius; ++step)
    {
      LaneMask near;
      const LaneVector d = gatedDifference (pointsOf (row, column + step), center, gate, near);
      sums[NormalRow::count] += keep (near, broadcast (1.0f));
      sums[NormalRow::sum_x] += d.x;
      sums[NormalRow::sum_y] += d.y;
      sums[NormalRow::sum_z] += d.z;
      sums[NormalRow::sum_xx] += d.x * d.x;
      sums[NormalRow::sum_xy] += d.x * d.y;
      sums[NormalRow::sum_xz] += d.x * d.z;
      sums[NormalRow::sum_yy] += d.y * d.y;
      sums[NormalRow::sum_yz] += d.y * d.z;
      sums[NormalRow::sum_zz] += d.z * d.z;
    }
    for (int moment = 0; moment < NormalRow::moments_size; ++moment)
      store (sums[moment], row.moments[moment] + column);
  }
}

void
fitRow (const NormalRow* const* around, int width, int radius, float gate, const FittedRow& normals)
{
  for (int column = 0; column < width; column += lane_count)
  {
    const LaneVector center = pointsOf (*around[radius], column);
    const LaneMask center_valid = center.z < 0.5f * NormalRow::far_away;
    Lanes count{};
    LaneVector sum{};
    LaneSymmetricMatrix square{};
    if (any (center_valid))
      for (int step = 0; step <= 2 * radius; ++step)
      {
        if (!around[step])
          continue;
        const NormalRow& row = *around[step];
        LaneMask near;
        const LaneVector d = gatedDifference (pointsOf (row, column), center, gate, near);
        const auto moment = [&] (int index) { return (keep (near, load (row.moments[index] + column))); };
        const Lanes n = moment (NormalRow::count);
        const LaneVector s{moment (NormalRow::sum_x), moment (NormalRow::sum_y), moment (NormalRow::sum_z)};
        const LaneVector moved = s + d * n; // to this row's centre: sum (p + d) (p + d)' = sum p p' + s d' + d moved'
        count += n;
        sum = sum + moved;
        square.xx += moment (NormalRow::sum_xx) + d.x * (s.x + moved.x);
        square.xy += moment (NormalRow::sum_xy) + (s.x * d.y + d.x * moved.y);
        square.xz += moment (NormalRow::sum_xz) + (s.x * d.z + d.x * moved.z);
        square.yy += moment (NormalRow::sum_yy) + d.y * (s.y + moved.y);
        square.yz += moment (NormalRow::sum_yz) + (s.y * d.z + d.y * moved.z);
        square.zz += moment (NormalRow::sum_zz) + d.z * (s.z + moved.z);
      }
    const Lanes inverse = 1.0f / select (count > 0.0f, count, broadcast (1.0f));
    const LaneVector mean = sum * inverse;
    const LaneSymmetricMatrix covariance{
      square.xx * inverse - mean.x * mean.x, square.xy * inverse - mean.x * mean.y,
      square.xz * inverse - mean.x * mean.z, square.yy * inverse - mean.y * mean.y,
      square.yz * inverse - mean.y * mean.z, square.zz * inverse - mean.z * mean.z};
    LaneVector vectors[3];
    Lanes values[3];
    eigenDecomposition (covariance, vectors, values);
    LaneVector normal = select (values[1] < values[0], vectors[1], vectors[0]);
    Lanes smallest = select (values[1] < values[0], values[1], values[0]);
    normal = select (values[2] < smallest, vectors[2], normal);
    smallest = maximum (select (values[2] < smallest, values[2], smallest), Lanes{});
    const Lanes trace = covariance.xx + covariance.yy + covariance.zz;
    const Lanes largest = maximum (maximum (values[0], values[1]), values[2]);
    const Lanes middle = trace - smallest - largest;
    // Three points span no more than a line if the middle eigenvalue vanishes.
    const LaneMask defined = (count >= 4.0f) & (middle > 1e-6f * trace) & center_valid;
    normal = select (dot (normal, center) > 0.0f, normal * broadcast (-1.0f), normal);
    normal = normalized (normal);
    const Lanes curvature = smallest / select (trace > 0.0f, trace, broadcast (1.0f));

    const int lanes = width - column;
    store (keep (defined, normal.x), normals.x + column, lanes);
    store (keep (defined, normal.y), normals.y + column, lanes);
    store (keep (defined, normal.z), normals.z + column, lanes);
    store (keep (defined, curvature), normals.curvature + column, lanes);
    storeBytes (defined & 1, normals.valid + column, lanes);
  }
}

} // namespace pcl_attention::PCL_ATTENTION_INSTRUCTION_SET
