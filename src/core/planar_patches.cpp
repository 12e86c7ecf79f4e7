// SPDX-License-Identifier: BSD-3-Clause
#include "point_at.h"
#include "region_growing.h"

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

/** \brief Sums over points p relative to an origin: p and p p'. */
struct Moments
{
  Eigen::Vector3d sum;
  Eigen::Matrix3d square;
};

/** \param[in] pixels ascending: most lie beside each other, and are summed several at a time */
Moments
momentsOf (const OrganizedCloud& cloud, const pcl::Indices& pixels, const Eigen::Vector3d& origin)
{
  constexpr int together = 4;
  using Several = Eigen::Array<double, together, 1>;
  using Stored = Eigen::Map<const Eigen::Array<float, together, 1>>;
  Several sums[3], squares[6]; // of the coordinates; of xx, xy, xz, yy, yz, zz
  for (Several& values : sums)
    values.setZero ();
  for (Several& values : squares)
    values.setZero ();
  const auto add = [&] (const Several& x, const Several& y, const Several& z) {
    sums[0] += x;
    sums[1] += y;
    sums[2] += z;
    squares[0] += x * x;
    squares[1] += x * y;
    squares[2] += x * z;
    squares[3] += y * y;
    squares[4] += y * z;
    squares[5] += z * z;
  };
  for (std::size_t i = 0; i < pixels.size ();)
  {
    const pcl::index_t first = pixels[i];
    if (i + together <= pixels.size () && pixels[i + together - 1] == first + together - 1)
    {
      add (Stored (&cloud.x[first]).cast<double> () - origin.x (), Stored (&cloud.y[first]).cast<double> () - origin.y (),
           Stored (&cloud.z[first]).cast<double> () - origin.z ());
      i += together;
    }
    else
    {
      const auto alone = [] (double value) { return (Several (value, 0.0, 0.0, 0.0)); };
      add (alone (cloud.x[first] - origin.x ()), alone (cloud.y[first] - origin.y ()), alone (cloud.z[first] - origin.z ()));
      ++i;
    }
  }
  const double xx = squares[0].sum (), xy = squares[1].sum (), xz = squares[2].sum (), yy = squares[3].sum (),
               yz = squares[4].sum (), zz = squares[5].sum ();
  Moments moments;
  moments.sum << sums[0].sum (), sums[1].sum (), sums[2].sum ();
  moments.square << xx, xy, xz,
                    xy, yy, yz,
                    xz, yz, zz;
  return (moments);
}

} // namespace

void
reassignLeftOvers (const OrganizedCloud& cloud, float maximum_distance, PlanarPatches& patches)
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
  for (int index = 0; index < static_cast<int> (cloud.size ()); ++index)
    if (cloud.valid[index] && !labels[index])
      front.push_back (index);
  while (!front.empty ())
  {
    std::vector<std::pair<int, int>> assigned;
    std::vector<int> rest;
    for (const int index : front)
    {
      const int label = bestNeighbor (index);
      if (label)
        assigned.emplace_back (index, label);
      else
        rest.push_back (index);
    }
    for (const auto& assignment : assigned)
      labels[assignment.first] = assignment.second;
    if (assigned.empty ())
      break;
    front = std::move (rest);
  }
  describePatches (cloud, patches);
}

void
extractPlanarPatches (const OrganizedCloud& cloud, const NormalImage& normals, const PatchParameters& parameters,
                      PlanarPatches& result)
{
  extractPlanarPatches (cloud, normals, Image<int> (cloud.width, cloud.height, 0), parameters, result);
}

void
extractPlanarPatches (const OrganizedCloud& cloud, const NormalImage& normals, Image<int>&& taken,
                      const PatchParameters& parameters, PlanarPatches& result)
{
  const int last = taken.size () == 0 ? 0 : *std::max_element (taken.data.begin (), taken.data.end ());
  result.labels = std::move (taken);
  (parameters.method == PatchMethod::grid_growing ? growOnGrid : growWithPcl) (cloud, normals, parameters, result.labels,
                                                                               last);
  describePatches (cloud, result);
  if (parameters.reassign_distance > 0.0f)
    reassignLeftOvers (cloud, parameters.reassign_distance, result);
}

void
describePatches (const OrganizedCloud& cloud, PlanarPatches& result)
{
  const int count = result.labels.size () == 0
                      ? 0 : *std::max_element (result.labels.data.begin (), result.labels.data.end ());
  std::vector<std::size_t> sizes (count + 1, 0);
  for (const int label : result.labels.data)
    ++sizes[std::max (label, 0)];
  result.patches.assign (count, PlanarPatch ());
  std::vector<pcl::index_t*> ends (count);
  for (int k = 0; k < count; ++k)
  {
    result.patches[k].pixels.resize (sizes[k + 1]);
    ends[k] = result.patches[k].pixels.data ();
  }
  for (std::size_t index = 0; index < cloud.size (); ++index)
    if (result.labels[index] > 0)
      *ends[result.labels[index] - 1]++ = static_cast<pcl::index_t> (index);
  for (PlanarPatch& patch : result.patches)
  {
    if (patch.pixels.empty ())
      continue;
    const Eigen::Vector3d origin = pointAt (cloud, patch.pixels.front ()).cast<double> ();
    const Moments moments = momentsOf (cloud, patch.pixels, origin);
    const auto size = static_cast<double> (patch.pixels.size ());
    const Eigen::Vector3d mean = moments.sum / size;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (moments.square / size - mean * mean.transpose ());
    patch.centroid = (origin + mean).cast<float> ();
    patch.normal = solver.eigenvectors ().col (0).cast<float> ();
    if (patch.normal.dot (patch.centroid) > 0.0f)
      patch.normal = -patch.normal;
    patch.rms = static_cast<float> (std::sqrt (std::max (0.0, solver.eigenvalues () (0))));
  }
}

} // namespace pcl_attention
