// SPDX-License-Identifier: BSD-3-Clause
#include "region_growing.h"

#include <pcl/point_types.h>
#include <pcl/segmentation/region_growing.h>

namespace pcl_attention
{

namespace
{

/** \brief pcl::RegionGrowing on the pixel grid, with the plane of the seed or of the growing patch. */
class OrganizedRegionGrowing : public pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal>
{
public:
  OrganizedRegionGrowing (const OrganizedCloud& cloud, const PatchParameters& parameters)
  : width_ (cloud.width),
    height_ (cloud.height),
    plane_ (parameters)
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
    constexpr int offsets[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    point_neighbours_.resize (input_->size ());
    std::vector<bool> selected (input_->size (), false);
    for (const pcl::index_t index : *indices_)
      selected[index] = true;
    for (const pcl::index_t index : *indices_)
    {
      pcl::Indices& neighbors = point_neighbours_[index];
      neighbors.reserve (4);
      const int column = index % width_, row = index / width_;
      for (const auto& offset : offsets)
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
      plane_.start (pointOf (seed), normalOf (seed));
    }
    is_a_seed = plane_.takes (pointOf (neighbor), normalOf (neighbor), pointOf (point), normalOf (point));
    if (is_a_seed)
      plane_.add (pointOf (neighbor), normalOf (neighbor));
    return (is_a_seed);
  }

private:
  Eigen::Vector3f
  pointOf (pcl::index_t index) const { return ((*input_)[index].getVector3fMap ()); }

  Eigen::Vector3f
  normalOf (pcl::index_t index) const { return ((*normals_)[index].getNormalVector3fMap ()); }

  int width_, height_;
  // The base class asks for one point after another and takes each that is valid, so the plane can follow here.
  mutable GrowingPlane plane_;
  mutable pcl::index_t seed_{-1};
};

} // namespace

void
growWithPcl (const OrganizedCloud& cloud, const NormalImage& normals, const PatchParameters& parameters, Image<int>& labels,
             int label)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr points (new pcl::PointCloud<pcl::PointXYZ> (cloud.width, cloud.height));
  pcl::PointCloud<pcl::Normal>::Ptr point_normals (new pcl::PointCloud<pcl::Normal> (cloud.width, cloud.height));
  pcl::IndicesPtr indices (new pcl::Indices);
  for (std::size_t index = 0; index < cloud.size (); ++index)
  {
    (*points)[index] = pcl::PointXYZ (cloud.x[index], cloud.y[index], cloud.z[index]);
    (*point_normals)[index] = pcl::Normal (normals.x[index], normals.y[index], normals.z[index], normals.curvature[index]);
    if (cloud.valid[index] && normals.valid[index] && labels[index] == 0)
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
  for (const pcl::PointIndices& cluster : clusters)
  {
    ++label;
    for (const pcl::index_t index : cluster.indices)
      labels[index] = label;
  }
}

} // namespace pcl_attention
