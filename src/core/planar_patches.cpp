// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/planar_patches.h>

#include <Eigen/Eigenvalues>
#include <pcl/point_types.h>
#include <pcl/segmentation/region_growing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pcl_attention
{

namespace
{

constexpr std::array<std::array<int, 2>, 4> four_neighbors{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/** \brief Whether the surface steps between two neighbouring pixels: apart along the view, and off the first one's tangent
  * plane, so that a slanted surface is no step. */
bool
isStep (const Eigen::Vector3f& from, const Eigen::Vector3f& normal, const Eigen::Vector3f& to, float maximum_step)
{
  const Eigen::Vector3f difference = to - from;
  return (difference.squaredNorm () > maximum_step * maximum_step && std::abs (normal.dot (difference)) > 0.5f * maximum_step);
}

/** \brief pcl::RegionGrowing on the pixel grid, with the plane of the seed or of the growing patch. */
class OrganizedRegionGrowing : public pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal>
{
public:
  OrganizedRegionGrowing (const OrganizedCloud& cloud, const PatchParameters& parameters)
  : width_ (cloud.width),
    height_ (cloud.height),
    running_ (parameters.plane_model == PlaneModel::running),
    minimum_cosine_ (std::cos (parameters.maximum_angle)),
    maximum_distance_ (parameters.maximum_distance),
    maximum_step_ (parameters.maximum_step)
  {
    setMinClusterSize (parameters.minimum_size);
    setMaxClusterSize (static_cast<pcl::uindex_t> (cloud.size ()));
    setSmoothModeFlag (false);
    setCurvatureTestFlag (false);
    setResidualTestFlag (false);
    setNumberOfNeighbours (4);
  }

protected:
  /** \brief The grid knows the neighbours: no search structure is built, which the base class would do for nothing. */
  bool
  prepareForSegmentation () override
  {
    return (input_ && normals_ && input_->size () == normals_->size () && !indices_->empty ());
  }

  void
  findPointNeighbours () override
  {
    point_neighbours_.resize (input_->size ());
    std::vector<bool> selected (input_->size (), false);
    for (const pcl::index_t index : *indices_)
      selected[index] = true;
    for (const pcl::index_t index : *indices_)
    {
      pcl::Indices& neighbors = point_neighbours_[index];
      neighbors.reserve (4);
      const int column = index % width_, row = index / width_;
      for (const auto& offset : four_neighbors)
      {
        const int c = column + offset[0], r = row + offset[1];
        if (c >= 0 && c < width_ && r >= 0 && r < height_ && selected[r * width_ + c])
          neighbors.push_back (r * width_ + c);
      }
    }
  }

  bool
  validatePoint (pcl::index_t seed, pcl::index_t point, pcl::index_t neighbor, bool& is_a_seed) const override
  {
    if (seed != seed_)
    {
      seed_ = seed;
      count_ = 1.0f;
      normal_sum_ = normalOf (seed);
      point_sum_ = pointOf (seed);
    }
    const Eigen::Vector3f position = pointOf (neighbor), normal = normalOf (neighbor);
    const Eigen::Vector3f plane_normal = running_ ? normal_sum_.normalized () : normalOf (seed);
    const Eigen::Vector3f plane_point = running_ ? Eigen::Vector3f (point_sum_ / count_) : pointOf (seed);
    if (normal.dot (plane_normal) < minimum_cosine_ ||
        std::abs (plane_normal.dot (position - plane_point)) > maximum_distance_ ||
        isStep (pointOf (point), normalOf (point), position, maximum_step_))
      return (false);
    if (running_)
    {
      count_ += 1.0f;
      normal_sum_ += normal;
      point_sum_ += position;
    }
    is_a_seed = true;
    return (true);
  }

private:
  Eigen::Vector3f
  pointOf (pcl::index_t index) const { return ((*input_)[index].getVector3fMap ()); }

  Eigen::Vector3f
  normalOf (pcl::index_t index) const { return ((*normals_)[index].getNormalVector3fMap ()); }

  int width_, height_;
  bool running_;
  float minimum_cosine_, maximum_distance_, maximum_step_;
  // The base class asks for one point after another and takes each that is valid, so the plane can follow here.
  mutable pcl::index_t seed_{-1};
  mutable float count_{0.0f};
  mutable Eigen::Vector3f normal_sum_{Eigen::Vector3f::Zero ()}, point_sum_{Eigen::Vector3f::Zero ()};
};

} // namespace

void
reassignLeftOvers (const OrganizedCloud& cloud, float maximum_distance, Image<int>& labels)
{
  std::vector<int> front;
  const auto position = [&] (int index) { return (Eigen::Vector3f (cloud.x[index], cloud.y[index], cloud.z[index])); };
  const auto bestNeighbor = [&] (int index) {
    const int column = index % cloud.width, row = index / cloud.width;
    int best = 0;
    float nearest = maximum_distance * maximum_distance;
    for (const auto& offset : four_neighbors)
    {
      const int c = column + offset[0], r = row + offset[1];
      if (!labels.contains (c, r) || !labels (c, r))
        continue;
      const float distance = (position (r * cloud.width + c) - position (index)).squaredNorm ();
      if (distance < nearest)
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
      return;
    front = std::move (rest);
  }
}

void
extractPlanarPatches (const OrganizedCloud& cloud, const NormalImage& normals, const PatchParameters& parameters,
                      PlanarPatches& result)
{
  result = PlanarPatches ();
  result.labels.assign (cloud.width, cloud.height, 0);
  pcl::PointCloud<pcl::PointXYZ>::Ptr points (new pcl::PointCloud<pcl::PointXYZ> (cloud.width, cloud.height));
  pcl::PointCloud<pcl::Normal>::Ptr point_normals (new pcl::PointCloud<pcl::Normal> (cloud.width, cloud.height));
  pcl::IndicesPtr indices (new pcl::Indices);
  for (std::size_t index = 0; index < cloud.size (); ++index)
  {
    (*points)[index] = pcl::PointXYZ (cloud.x[index], cloud.y[index], cloud.z[index]);
    (*point_normals)[index] = pcl::Normal (normals.x[index], normals.y[index], normals.z[index], normals.curvature[index]);
    if (cloud.valid[index] && normals.valid[index])
      indices->push_back (static_cast<pcl::index_t> (index));
  }
  if (indices->empty ())
    return;

  OrganizedRegionGrowing growing (cloud, parameters);
  growing.setInputCloud (points);
  growing.setInputNormals (point_normals);
  growing.setIndices (indices);
  std::vector<pcl::PointIndices> clusters;
  growing.extract (clusters);
  int label = 0;
  for (const pcl::PointIndices& cluster : clusters)
  {
    ++label;
    for (const pcl::index_t index : cluster.indices)
      result.labels[index] = label;
  }
  if (parameters.reassign_distance > 0.0f)
    reassignLeftOvers (cloud, parameters.reassign_distance, result.labels);
  describePatches (cloud, result);
}

void
describePatches (const OrganizedCloud& cloud, PlanarPatches& result)
{
  const int count = result.labels.size () == 0
                      ? 0 : *std::max_element (result.labels.data.begin (), result.labels.data.end ());
  result.patches.assign (count, PlanarPatch ());
  for (std::size_t index = 0; index < cloud.size (); ++index)
    if (result.labels[index] > 0)
      result.patches[result.labels[index] - 1].pixels.push_back (static_cast<pcl::index_t> (index));
  for (PlanarPatch& patch : result.patches)
  {
    if (patch.pixels.empty ())
      continue;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero ();
    Eigen::Matrix3d square = Eigen::Matrix3d::Zero ();
    const pcl::index_t first = patch.pixels.front ();
    const Eigen::Vector3d origin (cloud.x[first], cloud.y[first], cloud.z[first]);
    for (const pcl::index_t index : patch.pixels)
    {
      const Eigen::Vector3d point = Eigen::Vector3d (cloud.x[index], cloud.y[index], cloud.z[index]) - origin;
      sum += point;
      square += point * point.transpose ();
    }
    const double size = static_cast<double> (patch.pixels.size ());
    const Eigen::Vector3d mean = sum / size;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (square / size - mean * mean.transpose ());
    patch.centroid = (origin + mean).cast<float> ();
    patch.normal = solver.eigenvectors ().col (0).cast<float> ();
    if (patch.normal.dot (patch.centroid) > 0.0f)
      patch.normal = -patch.normal;
    patch.rms = static_cast<float> (std::sqrt (std::max (0.0, solver.eigenvalues () (0))));
  }
}

} // namespace pcl_attention
