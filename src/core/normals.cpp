// SPDX-License-Identifier: BSD-3-Clause
#include "lanes.h"

#include <pcl_attention/core/normals.h>

#include <pcl/features/integral_image_normal.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_attention
{

namespace
{

/** \brief Depth of invalid points: finite, so that a gate shuts it out without a test of its own. */
constexpr float far_away = 1e9f;

/** \brief What is summed over neighbours, relative to a point: their number, coordinates and products of coordinates. */
enum Moment
{
  moment_count,
  moment_x,
  moment_y,
  moment_z,
  moment_xx,
  moment_xy,
  moment_xz,
  moment_yy,
  moment_yz,
  moment_zz,
  moments_size
};

/** \brief The moments of every pixel of a row. */
struct RowMoments
{
  std::vector<float> channels[moments_size];
};

/** \brief Coordinates with a margin of far-away points left and right. */
class PaddedRows
{
public:
  PaddedRows (const OrganizedCloud& cloud, int margin)
  : margin_ (margin), stride_ (cloud.width + 2 * margin + lane_count)
  {
    const std::size_t count = static_cast<std::size_t> (stride_) * cloud.height;
    x.assign (count, 0.0f);
    y.assign (count, 0.0f);
    z.assign (count, far_away);
    for (int row = 0; row < cloud.height; ++row)
      for (int column = 0; column < cloud.width; ++column)
      {
        const std::size_t source = static_cast<std::size_t> (row) * cloud.width + column;
        if (!cloud.valid[source])
          continue;
        const std::ptrdiff_t target = offset (column, row);
        x[target] = cloud.x[source];
        y[target] = cloud.y[source];
        z[target] = cloud.z[source];
      }
  }

  std::ptrdiff_t
  offset (int column, int row) const { return (static_cast<std::ptrdiff_t> (row) * stride_ + column + margin_); }

  LaneVector
  points (std::ptrdiff_t at) const { return {load (&x[at]), load (&y[at]), load (&z[at])}; }

  std::vector<float> x, y, z;

private:
  int margin_, stride_;
};

/** \brief Moments of every pixel's neighbours in its own row, relative to the pixel. */
void
rowMoments (const PaddedRows& rows, int row, int width, int radius, float gate, RowMoments& moments)
{
  for (int column = 0; column < width; column += lane_count)
  {
    const std::ptrdiff_t center = rows.offset (column, row);
    const LaneVector point = rows.points (center);
    Lanes sums[moments_size] = {};
    for (int step = -radius; step <= radius; ++step)
    {
      const LaneVector difference = rows.points (center + step) - point;
      const LaneMask near = absolute (difference.z) < gate;
      const LaneVector d{keep (near, difference.x), keep (near, difference.y), keep (near, difference.z)};
      sums[moment_count] += keep (near, broadcast (1.0f));
      sums[moment_x] += d.x;
      sums[moment_y] += d.y;
      sums[moment_z] += d.z;
      sums[moment_xx] += d.x * d.x;
      sums[moment_xy] += d.x * d.y;
      sums[moment_xz] += d.x * d.z;
      sums[moment_yy] += d.y * d.y;
      sums[moment_yz] += d.y * d.z;
      sums[moment_zz] += d.z * d.z;
    }
    for (int channel = 0; channel < moments_size; ++channel)
      store (sums[channel], &moments.channels[channel][column]);
  }
}

/** \brief Normals of one row from the row moments around it. */
void
fitRow (const PaddedRows& rows, int row, const OrganizedCloud& cloud, int radius, float gate,
        const std::vector<const RowMoments*>& around, NormalImage& normals)
{
  for (int column = 0; column < cloud.width; column += lane_count)
  {
    const LaneVector center = rows.points (rows.offset (column, row));
    Lanes count{};
    LaneVector sum{};
    LaneSymmetricMatrix square{};
    for (int step = -radius; step <= radius; ++step)
    {
      const RowMoments* moments = around[step + radius];
      if (!moments)
        continue;
      const LaneVector difference = rows.points (rows.offset (column, row + step)) - center;
      const LaneMask near = absolute (difference.z) < gate;
      const LaneVector d{keep (near, difference.x), keep (near, difference.y), keep (near, difference.z)};
      const auto moment = [&] (int channel) { return (keep (near, load (&moments->channels[channel][column]))); };
      const Lanes n = moment (moment_count);
      const LaneVector s{moment (moment_x), moment (moment_y), moment (moment_z)};
      count += n;
      sum = sum + s + d * n;
      square.xx += moment (moment_xx) + 2.0f * s.x * d.x + n * d.x * d.x;
      square.xy += moment (moment_xy) + s.x * d.y + s.y * d.x + n * d.x * d.y;
      square.xz += moment (moment_xz) + s.x * d.z + s.z * d.x + n * d.x * d.z;
      square.yy += moment (moment_yy) + 2.0f * s.y * d.y + n * d.y * d.y;
      square.yz += moment (moment_yz) + s.y * d.z + s.z * d.y + n * d.y * d.z;
      square.zz += moment (moment_zz) + 2.0f * s.z * d.z + n * d.z * d.z;
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
    const LaneMask defined = (count >= 4.0f) & (middle > 1e-6f * trace) & (absolute (center.z) < 0.5f * far_away);
    normal = select (dot (normal, center) > 0.0f, normal * broadcast (-1.0f), normal);
    normal = normalized (normal);
    const Lanes curvature = smallest / select (trace > 0.0f, trace, broadcast (1.0f));

    const int lanes = std::min (lane_count, cloud.width - column);
    for (int lane = 0; lane < lanes; ++lane)
    {
      const std::size_t index = static_cast<std::size_t> (row) * cloud.width + column + lane;
      if (!defined[lane] || !cloud.valid[index])
        continue;
      normals.valid[index] = 1;
      normals.x[index] = normal.x[lane];
      normals.y[index] = normal.y[lane];
      normals.z[index] = normal.z[lane];
      normals.curvature[index] = curvature[lane];
    }
  }
}

/** \brief Separable: moments along the rows first, then the rows' moments along the columns; both gated in depth. */
void
fitGatedWindows (const OrganizedCloud& cloud, int radius, float gate, [[maybe_unused]] int threads, NormalImage& normals)
{
  const PaddedRows rows (cloud, radius);
  const int ring_size = 2 * radius + 1;
  // Bands of a fixed height, whatever the number of threads; each fills a ring of row moments of its own.
  constexpr int band_height = 60;
  const int bands = (cloud.height + band_height - 1) / band_height;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (int band = 0; band < bands; ++band)
  {
    const int begin = band * band_height, end = std::min (cloud.height, begin + band_height);
    std::vector<RowMoments> ring (ring_size);
    for (RowMoments& moments : ring)
      for (auto& channel : moments.channels)
        channel.resize (cloud.width + lane_count);
    std::vector<const RowMoments*> around (ring_size);
    int filled = std::max (0, begin - radius);
    for (int row = begin; row < end; ++row)
    {
      for (; filled <= std::min (cloud.height - 1, row + radius); ++filled)
        rowMoments (rows, filled, cloud.width, radius, gate, ring[filled % ring_size]);
      for (int step = -radius; step <= radius; ++step)
      {
        const int other = row + step;
        around[step + radius] = other < 0 || other >= cloud.height ? nullptr : &ring[other % ring_size];
      }
      fitRow (rows, row, cloud, radius, gate, around, normals);
    }
  }
}

/** \brief PCL's own normals, in the sensor frame. */
void
fitIntegralImages (const OrganizedCloud& cloud, int radius, float gate, NormalImage& normals)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr points (new pcl::PointCloud<pcl::PointXYZ> (cloud.width, cloud.height));
  constexpr float nan = std::numeric_limits<float>::quiet_NaN ();
  for (std::size_t index = 0; index < cloud.size (); ++index)
    (*points)[index] = cloud.valid[index] ? pcl::PointXYZ (cloud.x[index], cloud.y[index], cloud.z[index])
                                          : pcl::PointXYZ (nan, nan, nan);
  points->is_dense = false;
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod (estimation.COVARIANCE_MATRIX);
  estimation.setMaxDepthChangeFactor (gate);
  estimation.setNormalSmoothingSize (static_cast<float> (2 * radius + 1));
  estimation.setInputCloud (points);
  pcl::PointCloud<pcl::Normal> estimated;
  estimation.compute (estimated);
  for (std::size_t index = 0; index < std::min (cloud.size (), estimated.size ()); ++index)
  {
    const pcl::Normal& normal = estimated[index];
    if (!cloud.valid[index] || !std::isfinite (normal.normal_x) || !std::isfinite (normal.normal_y) ||
        !std::isfinite (normal.normal_z))
      continue;
    normals.valid[index] = 1;
    normals.x[index] = normal.normal_x;
    normals.y[index] = normal.normal_y;
    normals.z[index] = normal.normal_z;
    normals.curvature[index] = std::isfinite (normal.curvature) ? normal.curvature : 1.0f / 3.0f;
  }
}

} // namespace

void
estimateNormals (const OrganizedCloud& cloud, const NormalParameters& parameters, int threads, NormalImage& normals)
{
  normals.reset (cloud.size ());
  if (parameters.method == NormalMethod::gated_window)
    fitGatedWindows (cloud, parameters.radius, parameters.depth_gate, threads, normals);
  else
    fitIntegralImages (cloud, parameters.radius, parameters.depth_gate, normals);
}

} // namespace pcl_attention
