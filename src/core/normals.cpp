// SPDX-License-Identifier: BSD-3-Clause
#include "instruction_set.h"

#include <pcl_attention/core/bands.h>
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

/** \brief A ring of padded rows: those that the window of the row in work covers. */
class NormalRing
{
public:
  NormalRing (const OrganizedCloud& cloud, int radius, float gate, const LaneKernels& kernels)
  : cloud_ (cloud), radius_ (radius), gate_ (gate), kernels_ (kernels), rows_ (2 * radius + 1)
  {
    constexpr int channels_size = 3 + NormalRow::moments_size;
    const std::size_t stride = cloud.width + 2 * radius + kernels.lanes;
    memory_.assign (stride * channels_size * rows_.size (), 0.0f);
    float* channel = memory_.data () + radius;
    for (NormalRow& row : rows_)
    {
      for (float** pointer : {&row.x, &row.y, &row.z})
      {
        *pointer = channel;
        channel += stride;
      }
      std::fill_n (row.z - radius, stride, NormalRow::far_away);
      for (float*& moment : row.moments)
      {
        moment = channel;
        channel += stride;
      }
    }
  }

  /** \brief Take in the next row. */
  void
  fill (int row)
  {
    const NormalRow& target = at (row);
    const std::size_t begin = static_cast<std::size_t> (row) * cloud_.width;
    std::copy_n (&cloud_.x[begin], cloud_.width, target.x);
    std::copy_n (&cloud_.y[begin], cloud_.width, target.y);
    for (int column = 0; column < cloud_.width; ++column)
      target.z[column] = cloud_.valid[begin + column] ? cloud_.z[begin + column] : NormalRow::far_away;
    kernels_.rowMoments (target, cloud_.width, radius_, gate_);
  }

  const NormalRow&
  at (int row) const { return (rows_[row % rows_.size ()]); }

private:
  const OrganizedCloud& cloud_;
  int radius_;
  float gate_;
  const LaneKernels& kernels_;
  std::vector<NormalRow> rows_;
  std::vector<float> memory_;
};

/** \brief Separable: moments along the rows first, then the rows' moments along the columns; both gated in depth. */
void
fitGatedWindows (const OrganizedCloud& cloud, int radius, float gate, int threads, NormalImage& normals)
{
  const LaneKernels& kernels = laneKernels ();
  // Bands of a fixed height, whatever the number of threads; each fills a ring of its own.
  constexpr int band_height = 60;
  forEachBand (cloud.height, band_height, threads, [&] (int begin, int end) {
    NormalRing ring (cloud, radius, gate, kernels);
    std::vector<const NormalRow*> around (2 * radius + 1);
    int filled = std::max (0, begin - radius);
    for (int row = begin; row < end; ++row)
    {
      for (; filled <= std::min (cloud.height - 1, row + radius); ++filled)
        ring.fill (filled);
      for (int step = -radius; step <= radius; ++step)
      {
        const int other = row + step;
        around[step + radius] = other < 0 || other >= cloud.height ? nullptr : &ring.at (other);
      }
      const std::size_t at = static_cast<std::size_t> (row) * cloud.width;
      kernels.fitRow (around.data (), cloud.width, radius, gate,
                      {&normals.x[at], &normals.y[at], &normals.z[at], &normals.curvature[at], &normals.valid[at]});
    }
  });
}

/** \brief PCL's own normals, in the sensor frame. */
void
fitIntegralImages (const OrganizedCloud& cloud, int radius, float gate, NormalImage& normals)
{
  // PCL gives none to a border of this width, and writes out of bounds where the image is not wider than that.
  const int border = 2 * radius + 1;
  if (cloud.width <= 2 * border || cloud.height <= 2 * border)
    return;
  pcl::PointCloud<pcl::PointXYZ>::Ptr points (new pcl::PointCloud<pcl::PointXYZ> (cloud.width, cloud.height));
  constexpr float nan = std::numeric_limits<float>::quiet_NaN ();
  for (std::size_t index = 0; index < cloud.size (); ++index)
    (*points)[index] = cloud.valid[index] ? pcl::PointXYZ (cloud.x[index], cloud.y[index], cloud.z[index])
                                          : pcl::PointXYZ (nan, nan, nan);
  points->is_dense = false;
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod (estimation.COVARIANCE_MATRIX);
  estimation.setMaxDepthChangeFactor (gate);
  estimation.setNormalSmoothingSize (static_cast<float> (border));
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
  if (parameters.method == NormalMethod::gated_window)
  {
    normals.resize (cloud.size ());
    fitGatedWindows (cloud, parameters.radius, parameters.depth_gate, threads, normals);
    return;
  }
  normals.reset (cloud.size ());
  fitIntegralImages (cloud, parameters.radius, parameters.depth_gate, normals);
}

} // namespace pcl_attention
