// SPDX-License-Identifier: BSD-3-Clause
#include "lanes.h"

#include <pcl_attention/core/symmetry.h>

#include <algorithm>

namespace pcl_attention
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

/** \brief Points and normals of a level with a margin of invalid ones, so that no window needs a border test. */
class PaddedLevel
{
public:
  PaddedLevel (const OrganizedCloud& cloud, const NormalImage& normals, int margin)
  : margin_ (margin), stride_ (cloud.width + 2 * margin + lane_count)
  {
    const std::size_t count = static_cast<std::size_t> (stride_) * (cloud.height + 2 * margin);
    for (auto& channel : channels_)
      channel.assign (count, 0.0f);
    const float* sources[6] = {cloud.x.data (),   cloud.y.data (),   cloud.z.data (),
                               normals.x.data (), normals.y.data (), normals.z.data ()};
    for (int row = 0; row < cloud.height; ++row)
      for (int column = 0; column < cloud.width; ++column)
      {
        const std::size_t index = static_cast<std::size_t> (row) * cloud.width + column;
        if (!cloud.valid[index] || !normals.valid[index])
          continue;
        const std::size_t target = offset (column, row);
        for (int channel = 0; channel < 6; ++channel)
          channels_[channel][target] = sources[channel][index];
        channels_[6][target] = 1.0f;
      }
  }

  std::ptrdiff_t
  offset (int column, int row) const
  {
    return (static_cast<std::ptrdiff_t> (row + margin_) * stride_ + column + margin_);
  }

  LaneVector
  points (std::ptrdiff_t at) const
  {
    return {load (&channels_[0][at]), load (&channels_[1][at]), load (&channels_[2][at])};
  }

  LaneVector
  normals (std::ptrdiff_t at) const
  {
    return {load (&channels_[3][at]), load (&channels_[4][at]), load (&channels_[5][at])};
  }

  Lanes
  valid (std::ptrdiff_t at) const { return (load (&channels_[6][at])); }

private:
  int margin_;
  int stride_;
  std::vector<float> channels_[7];
};

/** \brief A neighbour in N(p), relative to the centre; 0 where it is not valid. */
struct Sample
{
  LaneVector point, normal;
  Lanes valid;
};

/** \brief Sums over the samples on one side of the plane through the centre (paper eq. 1). */
struct SideSum
{
  Lanes count{};
  LaneVector point{}, normal{};

  void
  add (const LaneMask& on_side, const Sample& sample)
  {
    count += keep (on_side, sample.valid);
    point.x += keep (on_side, sample.point.x);
    point.y += keep (on_side, sample.point.y);
    point.z += keep (on_side, sample.point.z);
    normal.x += keep (on_side, sample.normal.x);
    normal.y += keep (on_side, sample.normal.y);
    normal.z += keep (on_side, sample.normal.z);
  }

  Half
  mean (const LaneVector& center_normal) const
  {
    const Lanes inverse = 1.0f / select (count > 0.0f, count, broadcast (1.0f));
    return {count, point * inverse, normalized (center_normal + normal * inverse)};
  }
};

/** \brief The symmetry of lane_count pixels, paper eq. 1 to 3.
  * \param[out] winner 1..3, 0 where the symmetry is 0 */
inline Lanes
localSymmetry (const PaddedLevel& level, std::ptrdiff_t center, const std::vector<std::ptrdiff_t>& offsets,
               const SaliencyParameters& parameters, std::vector<Sample>& samples, Lanes& winner)
{
  winner = Lanes{};
  const LaneMask center_valid = level.valid (center) > 0.0f;
  if (!any (center_valid))
    return (Lanes{});

  const LaneVector center_point = level.points (center), center_normal = level.normals (center);
  SideSum total;
  LaneSymmetricMatrix square{};
  for (std::size_t k = 0; k < offsets.size (); ++k)
  {
    // Differences to the centre keep the covariance of nearly equal normals exact.
    const std::ptrdiff_t at = center + offsets[k];
    const Lanes valid = level.valid (at);
    const Sample sample{(level.points (at) - center_point) * valid, (level.normals (at) - center_normal) * valid, valid};
    samples[k] = sample;
    total.count += valid;
    total.point = total.point + sample.point;
    total.normal = total.normal + sample.normal;
    square.xx += sample.normal.x * sample.normal.x;
    square.xy += sample.normal.x * sample.normal.y;
    square.xz += sample.normal.x * sample.normal.z;
    square.yy += sample.normal.y * sample.normal.y;
    square.yz += sample.normal.y * sample.normal.z;
    square.zz += sample.normal.z * sample.normal.z;
  }
  const Lanes inverse = 1.0f / select (total.count > 0.0f, total.count, broadcast (1.0f));
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
    SideSum side1, side2;
    LaneMask on_plane{};
    for (const Sample& sample : samples)
    {
      const Lanes distance = dot (sample.point, axes[axis]);
      side1.add (distance > 0.0f, sample);
      on_plane |= (distance == 0.0f) & (sample.valid > 0.0f);
    }
    if (!any (on_plane))
      side2 = {total.count - side1.count, total.point - side1.point, total.normal - side1.normal};
    else
      for (const Sample& sample : samples)
        side2.add (dot (sample.point, axes[axis]) < 0.0f, sample);

    const Half half1 = side1.mean (center_normal), half2 = side2.mean (center_normal);
    LaneMask defined = center_valid & (half1.count > 0.0f) & (half2.count > 0.0f);
    if (parameters.convexity_gate)
      defined &= (dot (half1.mean_normal, axes[axis]) > 0.0f) & (dot (half2.mean_normal, axes[axis]) < 0.0f);
    const Lanes symmetry = keep (defined, reflectiveSymmetry (half1, half2, axes[axis], parameters.distance_scale));
    const LaneMask better = symmetry > best;
    best = select (better, symmetry, best);
    winner = select (better, broadcast (static_cast<float> (axis + 1)), winner);
  }
  return (best);
}

} // namespace

void
computeSymmetry (const OrganizedCloud& cloud, const NormalImage& normals, const SaliencyParameters& parameters,
                 [[maybe_unused]] int threads, SymmetryMap& map)
{
  map.symmetry.assign (cloud.width, cloud.height, 0.0f);
  map.winning_axis.assign (cloud.width, cloud.height, 0);
  const int radius = parameters.window_radius;
  const PaddedLevel level (cloud, normals, radius);
  std::vector<std::ptrdiff_t> offsets;
  for (int row = -radius; row <= radius; ++row)
    for (int column = -radius; column <= radius; ++column)
      if (row != 0 && column != 0)
        offsets.push_back (level.offset (column, row) - level.offset (0, 0));

#pragma omp parallel num_threads(threads)
  {
    std::vector<Sample> samples (offsets.size ());
#pragma omp for schedule(dynamic, 8)
    for (int row = 0; row < cloud.height; ++row)
      for (int column = 0; column < cloud.width; column += lane_count)
      {
        Lanes winner;
        const Lanes symmetry = localSymmetry (level, level.offset (column, row), offsets, parameters, samples, winner);
        const int lanes = std::min (lane_count, cloud.width - column);
        for (int lane = 0; lane < lanes; ++lane)
        {
          map.symmetry (column + lane, row) = symmetry[lane];
          map.winning_axis (column + lane, row) = static_cast<std::uint8_t> (winner[lane]);
        }
      }
  }
}

} // namespace pcl_attention
