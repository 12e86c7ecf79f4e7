// SPDX-License-Identifier: BSD-3-Clause
#include "point_at.h"
#include "region_growing.h"

#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/planar_patches.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_attention
{

namespace
{

constexpr std::array<std::array<int, 2>, 4> four_neighbors{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/** \brief Sums over the points of a patch, several beside each other at a time. */
class PatchSums
{
public:
  /** \brief Add pixels of a row. */
  void
  add (const OrganizedCloud& cloud, int begin, int end)
  {
    count_ += end - begin;
    int pixel = begin;
    for (; pixel + together <= end; pixel += together)
      add (Stored (&cloud.x[pixel]).cast<double> (), Stored (&cloud.y[pixel]).cast<double> (), Stored (&cloud.z[pixel]).cast<double> ());
    const auto alone = [] (double value) { return (Several (value, 0.0, 0.0, 0.0)); };
    for (; pixel < end; ++pixel)
      add (alone (cloud.x[pixel]), alone (cloud.y[pixel]), alone (cloud.z[pixel]));
  }

  PatchSums&
  operator+= (const PatchSums& other)
  {
    count_ += other.count_;
    for (std::size_t i = 0; i < sums_.size (); ++i)
      sums_[i] += other.sums_[i];
    for (std::size_t i = 0; i < squares_.size (); ++i)
      squares_[i] += other.squares_[i];
    return (*this);
  }

  std::size_t
  count () const { return (count_); }

  /** \brief Centroid, normal and deviation of the patch. */
  void
  fit (PlanarPatch& patch) const
  {
    if (count_ == 0)
      return;
    const auto size = static_cast<double> (count_);
    const Eigen::Vector3d mean = Eigen::Vector3d (sums_[0].sum (), sums_[1].sum (), sums_[2].sum ()) / size;
    const double xx = squares_[0].sum (), xy = squares_[1].sum (), xz = squares_[2].sum (), yy = squares_[3].sum (),
                 yz = squares_[4].sum (), zz = squares_[5].sum ();
    Eigen::Matrix3d square;
    square << xx, xy, xz,
              xy, yy, yz,
              xz, yz, zz;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (square / size - mean * mean.transpose ());
    patch.centroid = mean.cast<float> ();
    patch.normal = solver.eigenvectors ().col (0).cast<float> ();
    if (patch.normal.dot (patch.centroid) > 0.0f)
      patch.normal = -patch.normal;
    patch.rms = static_cast<float> (std::sqrt (std::max (0.0, solver.eigenvalues () (0))));
  }

private:
  static constexpr int together = 4;
  using Several = Eigen::Array<double, together, 1>;
  using Stored = Eigen::Map<const Eigen::Array<float, together, 1>>;

  void
  add (const Several& x, const Several& y, const Several& z)
  {
    sums_[0] += x;
    sums_[1] += y;
    sums_[2] += z;
    squares_[0] += x * x;
    squares_[1] += x * y;
    squares_[2] += x * z;
    squares_[3] += y * y;
    squares_[4] += y * z;
    squares_[5] += z * z;
  }

  std::size_t count_{0};
  std::array<Several, 3> sums_{Several::Zero (), Several::Zero (), Several::Zero ()};
  std::array<Several, 6> squares_{Several::Zero (), Several::Zero (), Several::Zero (),
                                  Several::Zero (), Several::Zero (), Several::Zero ()}; /**< xx, xy, xz, yy, yz, zz */
};

/** \brief The largest label; 0 without one. */
int
lastLabel (const Image<int>& labels)
{
  return (labels.size () == 0 ? 0 : Eigen::Map<const Eigen::ArrayXi> (labels.data.data (), static_cast<Eigen::Index> (labels.size ())).maxCoeff ());
}

std::vector<PatchSums>
sumsOf (const OrganizedCloud& cloud, const Image<int>& labels, int threads)
{
  const int count = lastLabel (labels);
  std::array<std::vector<PatchSums>, 2> halves;
  const int band_height = std::max (1, (labels.height + 1) / 2);
  forEachBand (labels.height, band_height, threads, [&] (int band_begin, int band_end) {
    std::vector<PatchSums>& sums = halves[band_begin / band_height];
    sums.resize (count);
    for (int row = band_begin; row < band_end; ++row)
      for (int begin = row * labels.width, row_end = begin + labels.width, end; begin < row_end; begin = end)
      {
        const int label = labels[begin];
        for (end = begin + 1; end < row_end && labels[end] == label;)
          ++end;
        if (label > 0)
          sums[label - 1].add (cloud, begin, end);
      }
  });
  for (std::size_t k = 0; k < halves[1].size (); ++k)
    halves[0][k] += halves[1][k];
  return (std::move (halves[0]));
}

void
fitPlanes (const std::vector<PatchSums>& sums, std::vector<PlanarPatch>& patches)
{
  patches.assign (sums.size (), PlanarPatch ());
  for (std::size_t k = 0; k < sums.size (); ++k)
    sums[k].fit (patches[k]);
}

void
collectPixels (const std::vector<PatchSums>& sums, PlanarPatches& result)
{
  std::vector<pcl::index_t*> ends (sums.size ());
  for (std::size_t k = 0; k < sums.size (); ++k)
  {
    result.patches[k].pixels.resize (sums[k].count ());
    ends[k] = result.patches[k].pixels.data ();
  }
  for (std::size_t index = 0; index < result.labels.size (); ++index)
    if (result.labels[index] > 0)
      *ends[result.labels[index] - 1]++ = static_cast<pcl::index_t> (index);
}

/** \brief \ref reassignLeftOvers for patches whose pixels are still to be collected.
  * \param[in,out] sums of the patches, and then with what they got */
void
assignLeftOvers (const OrganizedCloud& cloud, float maximum_distance, int threads, PlanarPatches& patches,
                 std::vector<PatchSums>& sums)
{
  constexpr float farthest_deviation = 2.0f; // a curved patch is no plane
  Image<int>& labels = patches.labels;
  std::vector<int> front;
  const auto bestNeighbor = [&] (int index) {
    const int column = index % cloud.width, row = index / cloud.width;
    const Eigen::Vector3f point = pointAt (cloud, index);
    int best = 0;
    float nearest = maximum_distance * maximum_distance;
    for (const auto& offset : four_neighbors)
    {
      const int c = column + offset[0], r = row + offset[1];
      if (!labels.contains (c, r) || !labels (c, r))
        continue;
      const float distance = (pointAt (cloud, r * cloud.width + c) - point).squaredNorm ();
      if (distance >= nearest)
        continue;
      const PlanarPatch& patch = patches.patches[labels (c, r) - 1];
      if (std::abs (patch.normal.dot (point - patch.centroid)) < maximum_distance + farthest_deviation * patch.rms)
      {
        nearest = distance;
        best = labels (c, r);
      }
    }
    return (best);
  };
  const auto isFree = [&] (int index) { return (cloud.valid[index] && !labels[index]); };
  for (int index = 0; index < static_cast<int> (cloud.size ()); ++index)
    if (isFree (index))
      front.push_back (index);
  while (!front.empty ())
  {
    std::vector<int> best (front.size ());
    constexpr int together = 1024;
    forEachBand (static_cast<int> (front.size ()), together, threads, [&] (int begin, int end) {
      std::transform (front.begin () + begin, front.begin () + end, best.begin () + begin, bestNeighbor);
    });
    std::vector<int> beside; // only what lies beside a new one may find more than before
    for (std::size_t i = 0; i < front.size (); ++i)
      if (best[i])
      {
        labels[front[i]] = best[i];
        sums[best[i] - 1].add (cloud, front[i], front[i] + 1);
      }
    for (std::size_t i = 0; i < front.size (); ++i)
      if (best[i])
        for (const auto& offset : four_neighbors)
        {
          const int column = front[i] % cloud.width + offset[0], row = front[i] / cloud.width + offset[1];
          if (labels.contains (column, row) && isFree (row * cloud.width + column))
            beside.push_back (row * cloud.width + column);
        }
    std::sort (beside.begin (), beside.end ());
    beside.erase (std::unique (beside.begin (), beside.end ()), beside.end ());
    front = std::move (beside);
  }
  fitPlanes (sums, patches.patches);
}

} // namespace

void
reassignLeftOvers (const OrganizedCloud& cloud, float maximum_distance, PlanarPatches& patches)
{
  std::vector<PatchSums> sums = sumsOf (cloud, patches.labels, 1);
  assignLeftOvers (cloud, maximum_distance, 1, patches, sums);
  collectPixels (sums, patches);
}

void
extractPlanarPatches (const OrganizedCloud& cloud, const NormalImage& normals, const PatchParameters& parameters,
                      PlanarPatches& result, int threads)
{
  extractPlanarPatches (cloud, normals, Image<int> (cloud.width, cloud.height, 0), parameters, result, threads);
}

void
extractPlanarPatches (const OrganizedCloud& cloud, const NormalImage& normals, Image<int>&& taken,
                      const PatchParameters& parameters, PlanarPatches& result, int threads)
{
  const int last = lastLabel (taken);
  result.labels = std::move (taken);
  if (parameters.method == PatchMethod::grid_growing)
    growOnGrid (cloud, normals, parameters, threads, result.labels, last);
  else
    growWithPcl (cloud, normals, parameters, result.labels, last);
  std::vector<PatchSums> sums = sumsOf (cloud, result.labels, threads);
  fitPlanes (sums, result.patches);
  if (parameters.reassign_distance > 0.0f)
    assignLeftOvers (cloud, parameters.reassign_distance, threads, result, sums);
  collectPixels (sums, result);
}

void
describePatch (const OrganizedCloud& cloud, PlanarPatch& patch)
{
  PatchSums sums;
  for (std::size_t begin = 0, end; begin < patch.pixels.size (); begin = end)
  {
    end = begin + 1;
    while (end < patch.pixels.size () && patch.pixels[end] == patch.pixels[end - 1] + 1)
      ++end;
    sums.add (cloud, patch.pixels[begin], patch.pixels[end - 1] + 1);
  }
  sums.fit (patch);
}

void
describePatches (const OrganizedCloud& cloud, PlanarPatches& result)
{
  const std::vector<PatchSums> sums = sumsOf (cloud, result.labels, 1);
  fitPlanes (sums, result.patches);
  collectPixels (sums, result);
}

} // namespace pcl_attention
