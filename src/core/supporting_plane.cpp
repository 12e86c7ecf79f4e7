// SPDX-License-Identifier: BSD-3-Clause
#include "convex_hull.h"
#include "instruction_set.h"
#include "point_at.h"

#include <pcl_attention/core/bands.h>
#include <pcl_attention/core/normals.h>
#include <pcl_attention/core/pyramid.h>
#include <pcl_attention/core/skeleton.h>
#include <pcl_attention/core/supporting_plane.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace pcl_attention
{

namespace
{

/** \brief Area a pixel covers on a surface with this normal, m^2. */
float
pixelArea (const Eigen::Vector3f& point, const Eigen::Vector3f& normal, float focal_length)
{
  constexpr float smallest_cosine = 0.1f;
  const float side = point.z () / focal_length, distance = point.norm ();
  return (side * side * point.z () / std::max (smallest_cosine * distance, std::abs (normal.dot (point))));
}

/** \brief Test all points of a cloud, some rows at a time.
  * \param[in] normals null where the test needs none
  * \param[in] test takes the arrays of some points, how many these are, and where to write 1 for what passes
  * \return 1 for those, of the cloud's size */
template <typename Test> std::vector<std::uint8_t>
testPoints (const OrganizedCloud& cloud, const NormalImage* normals, int threads, const Test& test)
{
  constexpr int band_height = 120;
  std::vector<std::uint8_t> passed (cloud.size ());
  forEachBand (cloud.height, band_height, threads, [&] (int begin, int end) {
    const std::size_t first = static_cast<std::size_t> (begin) * cloud.width;
    const std::size_t count = static_cast<std::size_t> (end - begin) * cloud.width;
    const auto from = [&] (const auto& values) { return (values.data () + first); };
    PointArrays points{from (cloud.x), from (cloud.y), from (cloud.z), nullptr, nullptr, nullptr, from (cloud.valid)};
    if (normals)
    {
      points.normal_x = from (normals->x);
      points.normal_y = from (normals->y);
      points.normal_z = from (normals->z);
    }
    test (points, count, passed.data () + first);
  });
  return (passed);
}

/** \brief The outline of a plane's points, to ask what lies over it. */
class Footprint
{
public:
  /** \param[in] indices of its points, ascending */
  Footprint (const OrganizedCloud& cloud, const pcl::Indices& indices, const Eigen::Vector3f& normal)
  {
    axis1_ = normal.unitOrthogonal ();
    axis2_ = normal.cross (axis1_);
    // What is convex in the plane is so in the image: the outline goes through ends of rows.
    std::vector<Eigen::Vector3f> flat;
    for (std::size_t i = 0; i < indices.size (); ++i)
      if (isRowEnd (indices, i, cloud.width))
      {
        const Eigen::Vector3f point = pointAt (cloud, indices[i]);
        flat.emplace_back (point.dot (axis1_), point.dot (axis2_), 0.0f);
      }
    outline_ = computeConvexHull (flat, 2).vertices;
    float area = 0.0f;
    for (std::size_t i = 0; i < outline_.size (); ++i)
    {
      const Eigen::Vector3f& a = outline_[i];
      const Eigen::Vector3f& b = outline_[(i + 1) % outline_.size ()];
      area += a.x () * b.y () - a.y () * b.x ();
    }
    if (area < 0.0f)
      std::reverse (outline_.begin (), outline_.end ());
  }

  /** \brief Its corners, counter-clockwise as seen from where the normal points.
    * \param[in] plane it is of */
  std::vector<Eigen::Vector3f>
  corners (const Eigen::Vector4f& plane) const
  {
    std::vector<Eigen::Vector3f> result;
    for (const Eigen::Vector3f& corner : outline_)
      result.push_back (corner.x () * axis1_ + corner.y () * axis2_ - plane[3] * plane.head<3> ());
    return (result);
  }

  /** \brief Which points lie over it, margin metres around it counting.
    * \param[in] plane it is of
    * \param[in] lowest,highest above the plane, metres
    * \return 1 for those, of the cloud's size */
  std::vector<std::uint8_t>
  pointsOver (const OrganizedCloud& cloud, const Eigen::Vector4f& plane, float margin, float lowest, float highest, int threads) const
  {
    const std::vector<OutlineEdge> outline = edges (margin);
    if (outline.empty ())
      return (std::vector<std::uint8_t> (cloud.size (), 0));
    RoomTest test;
    std::copy_n (plane.data (), 3, test.normal);
    test.offset = plane[3];
    test.lowest = lowest;
    test.highest = highest;
    std::copy_n (axis1_.data (), 3, test.axis1);
    std::copy_n (axis2_.data (), 3, test.axis2);
    test.edges = outline.data ();
    test.edge_count = static_cast<int> (outline.size ());
    return (testPoints (cloud, nullptr, threads, [&] (const PointArrays& points, std::size_t count, std::uint8_t* over) {
      laneKernels ().pointsOver (points, count, test, over);
    }));
  }

private:
  /** \brief The outline, margin metres wider. */
  std::vector<OutlineEdge>
  edges (float margin) const
  {
    std::vector<OutlineEdge> result;
    for (std::size_t i = 0; i < outline_.size () && outline_.size () >= 3; ++i)
    {
      const Eigen::Vector2f a = outline_[i].head<2> (), edge = outline_[(i + 1) % outline_.size ()].head<2> () - a;
      result.push_back ({a.x (), a.y (), edge.y (), -edge.x (), margin * edge.norm ()});
    }
    return (result);
  }

  Eigen::Vector3f axis1_, axis2_;
  std::vector<Eigen::Vector3f> outline_; /**< counter-clockwise, in plane coordinates */
};

struct PlaneFit
{
  Eigen::Vector3f normal;
  float offset;
};

PlaneFit
fitPlane (const OrganizedCloud& cloud, const pcl::Indices& indices)
{
  const Eigen::Vector3d origin = pointAt (cloud, indices.front ()).cast<double> ();
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero ();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero ();
  double weights = 0.0;
  const std::size_t step = stepOf (indices.size ());
  for (std::size_t i = 0; i < indices.size (); i += step)
  {
    const Eigen::Vector3d point = pointAt (cloud, indices[i]).cast<double> () - origin;
    // A point's weight falls with the noise of its depth, which grows with z^2.
    const double depth = cloud.z[indices[i]], weight = 1.0 / std::max (1e-6, depth * depth * depth * depth);
    weights += weight;
    sum += weight * point;
    square += weight * point * point.transpose ();
  }
  const Eigen::Vector3d mean = sum / weights;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (square / weights - mean * mean.transpose ());
  Eigen::Vector3d normal = solver.eigenvectors ().col (0);
  const Eigen::Vector3d center = origin + mean;
  if (normal.dot (center) > 0.0)
    normal = -normal;
  return {normal.cast<float> (), static_cast<float> (-normal.dot (center))};
}

/** \brief A plane as a sensor sees it: the inverse depth as a quadratic function of the view ray, which is linear for a true
  * plane and takes up the sensor's slow distortion, which bends a table by centimetres in the corners of the image. */
class BentPlane
{
public:
  BentPlane (const OrganizedCloud& cloud, const pcl::Indices& indices) : plane (fitPlane (cloud, indices))
  {
    // The normal equations are made of sums over u^i v^j, i + j <= 4, few of which are different.
    std::array<double, 15> sums{};
    Eigen::Matrix<double, 6, 1> products = Eigen::Matrix<double, 6, 1>::Zero ();
    const std::size_t step = stepOf (indices.size ());
    for (std::size_t i = 0; i < indices.size (); i += step)
    {
      const Eigen::Vector3f point = pointAt (cloud, indices[i]);
      const double inverse_depth = 1.0 / point.z (), u = point.x () * inverse_depth, v = point.y () * inverse_depth;
      const double uu = u * u, uv = u * v, vv = v * v;
      const std::array<double, 15> monomials{1.0,    u,      v,      uu,      uv,      vv,      uu * u, uu * v,
                                             u * vv, vv * v, uu * uu, uu * uv, uu * vv, uv * vv, vv * vv};
      for (std::size_t k = 0; k < sums.size (); ++k)
        sums[k] += monomials[k];
      for (int k = 0; k < products.size (); ++k)
        products[k] += monomials[k] * inverse_depth;
    }
    constexpr std::array<std::array<int, 2>, 6> exponents{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
    Eigen::Matrix<double, 6, 6> square;
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 6; ++column)
      {
        const int i = exponents[row][0] + exponents[column][0], j = exponents[row][1] + exponents[column][1];
        square (row, column) = sums[(i + j) * (i + j + 1) / 2 + j];
      }
    coefficients_ = square.ldlt ().solve (products).cast<float> ();
  }

  /** \brief Inverse depth as a function of the view ray (u, v): the factors of 1, u, v, uu, uv, vv. */
  const Eigen::Matrix<float, 6, 1>&
  coefficients () const { return (coefficients_); }

  PlaneFit plane;

private:
  Eigen::Matrix<float, 6, 1> coefficients_;
};

/** \brief Points within a tolerance of a plane. */
pcl::Indices
pointsOf (const OrganizedCloud& cloud, const NormalImage& normals, float noise, const SupportParameters& parameters,
          const BentPlane& surface, int threads)
{
  SurfaceTest test;
  std::copy_n (surface.plane.normal.data (), 3, test.normal);
  test.offset = surface.plane.offset;
  std::copy_n (surface.coefficients ().data (), 6, test.bent);
  test.tolerance = parameters.tolerance;
  test.noise_tolerance = parameters.noise_tolerance * noise;
  test.below = 0.03f;
  test.minimum_cosine = std::cos (0.6f);
  const std::vector<std::uint8_t> near =
    testPoints (cloud, &normals, threads, [&] (const PointArrays& points, std::size_t count, std::uint8_t* is_near) {
      laneKernels ().pointsNear (points, count, test, is_near);
    });
  pcl::Indices indices;
  for (std::size_t index = 0; index < near.size (); ++index)
    if (near[index])
      indices.push_back (static_cast<pcl::index_t> (index));
  return (indices);
}

/** \brief Take away islands: small pieces, and pieces that go over into objects along their edge, such as the floor of a
  * bowl. */
void
dropIslands (const OrganizedCloud& cloud, pcl::Indices& indices)
{
  constexpr int smallest = 60;
  constexpr float touching_distance = 0.02f, touching_share = 0.35f;
  Image<std::uint8_t> mask (cloud.width, cloud.height, 0);
  for (const pcl::index_t index : indices)
    mask[index] = 1;
  Image<int> components;
  const int count = labelConnectedComponents (mask, components);
  std::vector<int> sizes (count + 1, 0), contour (count + 1, 0), touching (count + 1, 0);
  for (const pcl::index_t index : indices)
    ++sizes[components[index]];
  const int largest = static_cast<int> (std::max_element (sizes.begin (), sizes.end ()) - sizes.begin ());
  for (const pcl::index_t index : indices)
  {
    const int component = components[index];
    if (component == largest)
      continue; // which stays
    const int column = index % cloud.width, row = index / cloud.width;
    for (const auto& [c, r] : {std::pair<int, int> (column + 1, row), {column - 1, row}, {column, row + 1}, {column, row - 1}})
      if (!mask.contains (c, r) || !mask (c, r))
      {
        ++contour[component];
        const int other = r * cloud.width + c;
        touching[component] += mask.contains (c, r) && cloud.valid[other] &&
                               (pointAt (cloud, other) - pointAt (cloud, index)).norm () < touching_distance;
      }
  }
  std::vector<std::uint8_t> is_island (count + 1);
  for (int component = 0; component <= count; ++component)
    is_island[component] = component != largest && (sizes[component] < smallest ||
                                                    touching[component] > touching_share * contour[component]);
  indices.erase (std::remove_if (indices.begin (), indices.end (),
                                 [&] (pcl::index_t index) { return (is_island[components[index]] != 0); }),
                 indices.end ());
}

/** \brief Of each row the outermost points of a plane that are not of its small pieces, like a seat behind a table that happens to be
  * as high, which narrow bridges do not join.
  * \param[in] indices of all its points, ascending
  * \param[in] spacing of the points that are looked at, pixels: bridges of two or less are narrow */
pcl::Indices
rowEndsOfLargePieces (const OrganizedCloud& cloud, const pcl::Indices& indices, int spacing)
{
  constexpr float smallest_share = 0.1f;
  const auto beginOf = [&] (int row) { return (std::lower_bound (indices.begin (), indices.end (), row * cloud.width)); };
  Image<std::uint8_t> samples ((cloud.width + spacing - 1) / spacing, (cloud.height + spacing - 1) / spacing, 0);
  for (int row = 0; row < samples.height; ++row)
    std::for_each (beginOf (row * spacing), beginOf (row * spacing + 1), [&] (pcl::index_t index) {
      if (const int column = index - row * spacing * cloud.width; column % spacing == 0)
        samples (column / spacing, row) = 1;
    });
  const auto isOn = [&] (int column, int row) { return (!samples.contains (column, row) || samples (column, row)); };
  Image<std::uint8_t> inner (samples.width, samples.height, 0);
  for (int row = 0; row < samples.height; ++row)
    for (int column = 0; column < samples.width; ++column)
      inner (column, row) = isOn (column, row) && isOn (column + 1, row) && isOn (column - 1, row) && isOn (column, row + 1) &&
                            isOn (column, row - 1);
  Image<int> pieces;
  std::vector<int> sizes (labelConnectedComponents (inner, pieces) + 1, 0);
  for (const int piece : pieces.data)
    ++sizes[piece];
  sizes[0] = 0;
  const float smallest = smallest_share * static_cast<float> (*std::max_element (sizes.begin (), sizes.end ()));
  const bool is_all_bridges = smallest == 0.0f; // full of holes
  pcl::Indices ends;
  for (int row = 0; row < cloud.height; ++row)
  {
    const auto isLarge = [&] (pcl::index_t index) {
      const int piece = pieces ((index - row * cloud.width) / spacing, row / spacing);
      return (is_all_bridges || (piece > 0 && static_cast<float> (sizes[piece]) >= smallest));
    };
    const auto begin = beginOf (row), end = beginOf (row + 1);
    const auto first = std::find_if (begin, end, isLarge);
    if (first == end)
      continue;
    const auto last = std::find_if (std::make_reverse_iterator (end), std::make_reverse_iterator (first + 1), isLarge);
    ends.push_back (*first);
    if (last != std::make_reverse_iterator (first + 1))
      ends.push_back (*last);
  }
  return (ends);
}

float
areaOf (const OrganizedCloud& cloud, const pcl::Indices& indices, const Eigen::Vector3f& normal, float focal_length)
{
  float area = 0.0f;
  const std::size_t step = stepOf (indices.size ());
  for (std::size_t i = 0; i < indices.size (); i += step)
    area += pixelArea (pointAt (cloud, indices[i]), normal, focal_length);
  return (area * static_cast<float> (step));
}

bool
touchesImageBorder (const OrganizedCloud& cloud, const pcl::Indices& indices)
{
  return (std::any_of (indices.begin (), indices.end (), [&] (pcl::index_t index) {
    const int column = index % cloud.width, row = index / cloud.width;
    return (column == 0 || row == 0 || column == cloud.width - 1 || row == cloud.height - 1);
  }));
}

/** \brief Pairs of a patch's border that are connected where the surface bends inwards. */
double
concaveBorder (const PatchGraph& graph, int label)
{
  double concave = 0.0;
  for (const int neighbor : graph.neighbors[label])
  {
    const PatchBorder border = graph.border (label, neighbor);
    if (border.convexity () < -0.2f)
      concave += border.connected;
  }
  return (concave);
}

/** \brief Planar patches of a coarse scene.
  * \param[in] scale columns of the scene itself to one of these
  * \param[in] noise of the scene itself, standard deviation over the square of the depth, 1/m
  * \param[out] normals estimated anew */
PlanarPatches
coarsePatches (const OrganizedCloud& cloud, int scale, float noise, NormalImage& normals)
{
  PlanarPatches patches;
  std::vector<float> depths;
  for (std::size_t index = 0; index < cloud.size (); ++index)
    if (cloud.valid[index])
      depths.push_back (cloud.z[index]);
  if (depths.empty ())
    return (patches);
  std::nth_element (depths.begin (), depths.begin () + depths.size () / 2, depths.end ());
  const float median = depths[depths.size () / 2], deviation = noise * median * median;
  NormalParameters normal_parameters;
  normal_parameters.depth_gate = std::max (static_cast<float> (scale) * normal_parameters.depth_gate, 6.0f * deviation);
  estimateNormals (cloud, normal_parameters, 1, normals);
  PatchParameters parameters;
  parameters.minimum_size = 9; // what is a fragment at full size may be a table far away here
  parameters.maximum_distance += 3.0f * deviation;
  parameters.maximum_step = std::max (static_cast<float> (scale) * parameters.maximum_step, 6.0f * deviation);
  extractPlanarPatches (cloud, normals, parameters, patches);
  return (patches);
}

/** \brief Fill in a plane's outline and where it ends.
  * \param[in] spacing see \ref rowEndsOfLargePieces */
void
describeOutline (const OrganizedCloud& cloud, const SensorModel& sensor, int spacing, SupportingPlane& plane)
{
  constexpr float beyond = 0.03f, step = 0.01f, clearance = 0.02f, most_samples = 100.0f;
  const Eigen::Vector3f normal = plane.coefficients.head<3> (), known = pointAt (cloud, plane.indices.front ());
  plane.outline = Footprint (cloud, rowEndsOfLargePieces (cloud, plane.indices, spacing), normal).corners (plane.coefficients);
  const auto isHidden = [&] (const Eigen::Vector3f& place) {
    if (place.z () <= 0.0f)
      return (true);
    const Eigen::Array2f pixel =
      Eigen::Array2f (plane.indices.front () % cloud.width, plane.indices.front () / cloud.width) +
      sensor.focal_length * (place.head<2> () / place.z () - known.head<2> () / known.z ()).array () + 0.5f;
    // Written so that what is no number is outside too.
    if (!(pixel.x () >= 0.0f && pixel.y () >= 0.0f && pixel.x () < cloud.width && pixel.y () < cloud.height))
      return (true);
    const int index = static_cast<int> (pixel.y ()) * cloud.width + static_cast<int> (pixel.x ());
    return (cloud.valid[index] && normal.dot (pointAt (cloud, index)) + plane.coefficients[3] > clearance);
  };
  for (std::size_t i = 0; i < plane.outline.size (); ++i)
  {
    const Eigen::Vector3f& corner = plane.outline[i];
    const Eigen::Vector3f edge = plane.outline[(i + 1) % plane.outline.size ()] - corner;
    const Eigen::Vector3f outwards = edge.cross (normal).normalized ();
    const int samples = 1 + static_cast<int> (std::min (most_samples, edge.norm () / step));
    int hidden = 0;
    for (int k = 0; k < samples; ++k)
      hidden += isHidden (corner + (static_cast<float> (k) + 0.5f) / static_cast<float> (samples) * edge + beyond * outwards);
    // Edges are straight: where a part of one is seen is seen where it ends.
    plane.ends.push_back (3 * hidden <= 2 * samples);
  }
}

/** \brief How far a point's foot lies outside of the edge after a corner of a plane's outline, metres; inside less than 0. */
float
beyondEdge (const SupportingPlane& plane, std::size_t corner, const Eigen::Vector3f& point)
{
  const Eigen::Vector3f& begin = plane.outline[corner];
  const Eigen::Vector3f edge = plane.outline[(corner + 1) % plane.outline.size ()] - begin;
  return (plane.coefficients.head<3> ().dot ((point - begin).cross (edge.normalized ())));
}

/** \brief A plane of the background as far as the coarse scene shows it. */
struct CoarsePlane
{
  SupportingPlane plane;
  int label;    /**< of the patch that it was found by */
  double score; /**< how likely it is the supporting plane */
};

/** \brief The patch's plane and all the points on it, after a few rounds of one and the other.
  * \return no indices where it is none */
SupportingPlane
fitToPatch (const OrganizedCloud& cloud, const NormalImage& normals, const PlanarPatch& patch, float noise,
            const SupportParameters& parameters, std::size_t smallest, int threads)
{
  SupportingPlane plane;
  plane.indices = patch.pixels;
  constexpr int rounds = 4;
  for (int round = 0; round < rounds && plane.indices.size () >= smallest; ++round)
  {
    const BentPlane surface (cloud, plane.indices);
    plane.coefficients << surface.plane.normal, surface.plane.offset;
    pcl::Indices indices = pointsOf (cloud, normals, noise, parameters, surface, threads);
    const bool stays = indices == plane.indices;
    plane.indices = std::move (indices);
    if (stays)
      break;
  }
  if (plane.indices.size () < std::max (smallest, patch.pixels.size () / 2))
    plane.indices.clear ();
  return (plane);
}

} // namespace

int
supportLevels (int width)
{
  constexpr int columns = 160;
  int levels = 0;
  for (; width > columns; width = (width + 1) / 2)
    ++levels;
  return (levels);
}

std::vector<SupportingPlane>
findSupportingPlanes (const OrganizedCloud& cloud, const SensorModel& sensor, const NormalImage& normals,
                      const std::vector<PyramidLevel>& coarser, const SupportParameters& parameters, int threads)
{
  const float focal_length = sensor.focal_length, noise = sensor.depth_noise;
  if (focal_length <= 0.0f)
    return {};
  // The mean over many points shows planes whose noise breaks them into fragments at full size, in a fraction of the time.
  const int levels = supportLevels (cloud.width), scale = 1 << levels;
  const OrganizedCloud& coarse = levels == 0 ? cloud : coarser[levels - 1].cloud;
  NormalImage coarse_normals;
  const PlanarPatches patches = coarsePatches (coarse, scale, noise, coarse_normals);
  const SensorModel coarse_sensor{focal_length / static_cast<float> (scale), noise};

  constexpr std::size_t smallest = 12;
  std::vector<int> candidates; // labels
  for (std::size_t k = 0; k < patches.patches.size (); ++k)
    if (patches.patches[k].pixels.size () >= smallest)
      candidates.push_back (static_cast<int> (k) + 1);
  const auto sizeOf = [&] (int label) { return (patches.patches[label - 1].pixels.size ()); };
  std::stable_sort (candidates.begin (), candidates.end (), [&] (int a, int b) { return (sizeOf (a) > sizeOf (b)); });

  std::vector<std::uint8_t> taken (coarse.size (), 0);
  const auto isMostlyTaken = [&] (const pcl::Indices& indices) {
    const auto count =
      std::count_if (indices.begin (), indices.end (), [&] (pcl::index_t index) { return (taken[index] != 0); });
    return (2 * static_cast<std::size_t> (count) > indices.size ());
  };
  std::vector<CoarsePlane> found;
  const auto judge = [&] (int label, float minimum_area) {
    const PlanarPatch& patch = patches.patches[label - 1];
    if (isMostlyTaken (patch.pixels) || areaOf (coarse, patch.pixels, patch.normal, coarse_sensor.focal_length) < minimum_area)
      return;
    SupportingPlane plane = fitToPatch (coarse, coarse_normals, patch, noise, parameters, smallest, threads);
    if (plane.indices.empty ())
      return;
    const Eigen::Vector3f normal = plane.coefficients.head<3> ();
    const Footprint footprint (coarse, rowEndsOfLargePieces (coarse, plane.indices, 1), normal);
    const double pixels = scale * scale; // of the scene itself to one of these
    // The floor under a box faces as its top does; a wall that goes on down behind a table does not.
    constexpr float facing_alike = 0.7f;
    const auto facesAlike = [&] (std::size_t index) {
      return (coarse_normals.valid[index] &&
              normal.dot (Eigen::Vector3f (coarse_normals.x[index], coarse_normals.y[index], coarse_normals.z[index])) > facing_alike);
    };
    constexpr float clearance = 0.02f;
    const std::vector<std::uint8_t> above = footprint.pointsOver (coarse, plane.coefficients, 0.05f, clearance, 0.4f, threads);
    const std::vector<std::uint8_t> under = footprint.pointsOver (coarse, plane.coefficients, 0.15f, -0.3f, -clearance, threads);
    double over = 0.0, below = 0.0;
    for (std::size_t index = 0; index < coarse.size (); ++index)
    {
      if (!above[index] && !under[index])
        continue;
      const Eigen::Vector3f point = pointAt (coarse, index);
      const float height = normal.dot (point) + plane.coefficients[3];
      const float clear = clearance + parameters.noise_tolerance * noise * point.z () * point.z ();
      if (height > clear)
        over += pixels;
      else if (height < -clear && facesAlike (index))
        below += pixels;
    }
    plane.confidence = static_cast<float> ((over + 100.0) / (over + below + 100.0));
    const double score = static_cast<double> (plane.indices.size ()) * (over + 300.0) * plane.confidence * plane.confidence;
    for (const pcl::index_t index : plane.indices)
      taken[index] = 1;
    found.push_back ({std::move (plane), label, score});
  };
  // Of a floor under many things, as in a bin, little shows between them.
  constexpr float share_between = 0.1f;
  for (const float share : {1.0f, share_between})
  {
    if (std::any_of (found.begin (), found.end (), [&] (const CoarsePlane& candidate) {
          return (candidate.plane.confidence >= parameters.minimum_confidence);
        }))
      break;
    found.clear ();
    std::fill (taken.begin (), taken.end (), 0);
    std::for_each (candidates.begin (), candidates.end (), [&] (int label) { judge (label, share * parameters.minimum_area); });
  }

  // What stands on a plane meets it in a concave edge.
  if (found.size () > 1)
  {
    PatchGraphParameters graph_parameters;
    graph_parameters.connection_distance *= 2.0f;
    graph_parameters.maximum_gap /= scale;
    graph_parameters.sample_distance = std::max (2, graph_parameters.sample_distance / scale);
    const PatchGraph graph = buildPatchGraph (coarse, coarse_sensor, coarse_normals, patches.labels,
                                              static_cast<int> (patches.patches.size ()), graph_parameters);
    for (CoarsePlane& candidate : found)
      candidate.score *= scale * concaveBorder (graph, candidate.label) + 20.0;
  }
  const auto best = std::max_element (found.begin (), found.end (), [] (const CoarsePlane& a, const CoarsePlane& b) {
    return (a.score < b.score);
  });
  if (best != found.end ())
  {
    best->plane.supports_objects = best->plane.confidence >= parameters.minimum_confidence;
    std::iter_swap (found.begin (), best);
  }

  std::vector<SupportingPlane> planes;
  taken.assign (cloud.size (), 0);
  const auto valid_points = static_cast<float> (std::count (cloud.valid.begin (), cloud.valid.end (), 1));
  for (CoarsePlane& candidate : found)
  {
    SupportingPlane& plane = candidate.plane;
    if (!plane.supports_objects && !touchesImageBorder (coarse, plane.indices))
      continue;
    const BentPlane surface (coarse, plane.indices);
    plane.coefficients << surface.plane.normal, surface.plane.offset;
    plane.indices = pointsOf (cloud, normals, noise, parameters, surface, threads);
    dropIslands (cloud, plane.indices);
    plane.area = areaOf (cloud, plane.indices, surface.plane.normal, focal_length);
    const float share = static_cast<float> (plane.indices.size ()) / valid_points;
    const bool large = plane.area >= parameters.background_area || share >= parameters.background_share;
    if (plane.indices.empty () || isMostlyTaken (plane.indices) ||
        !(plane.supports_objects || (large && touchesImageBorder (cloud, plane.indices))))
      continue;
    for (const pcl::index_t index : plane.indices)
      taken[index] = 1;
    if (plane.supports_objects)
      describeOutline (cloud, sensor, scale, plane);
    planes.push_back (std::move (plane));
  }
  return (planes);
}

bool
standsOn (const SupportingPlane& plane, const Eigen::Vector3f& point)
{
  constexpr float margin = 0.05f, highest = 0.5f;
  const Eigen::Vector3f normal = plane.coefficients.head<3> ();
  const float height = normal.dot (point) + plane.coefficients[3];
  bool is_over = !plane.outline.empty () && height >= 0.0f && height <= highest;
  for (std::size_t i = 0; i < plane.outline.size () && is_over; ++i)
    is_over = beyondEdge (plane, i, point) <= margin;
  return (is_over);
}

bool
liesBeside (const SupportingPlane& plane, const Eigen::Vector3f& point, float margin)
{
  const Eigen::Vector3f normal = plane.coefficients.head<3> ();
  const std::size_t corners = plane.outline.size ();
  Eigen::Vector3f middle = Eigen::Vector3f::Zero ();
  for (const Eigen::Vector3f& corner : plane.outline)
    middle += corner / static_cast<float> (corners);
  // Which side of the line from the middle to the point a corner lies on.
  const auto isLeft = [&] (const Eigen::Vector3f& corner) { return (normal.dot ((point - middle).cross (corner - middle)) > 0.0f); };
  for (std::size_t i = 0; i < corners; ++i)
  {
    const Eigen::Vector3f& corner = plane.outline[i];
    const Eigen::Vector3f& next = plane.outline[(i + 1) % corners];
    if (isLeft (corner) || !isLeft (next))
      continue;
    return (plane.ends[i] && beyondEdge (plane, i, point) > margin);
  }
  return (false);
}

Image<int>
labelPlanes (const OrganizedCloud& cloud, const std::vector<SupportingPlane>& planes)
{
  Image<int> labels (cloud.width, cloud.height, 0);
  for (std::size_t plane = 0; plane < planes.size (); ++plane)
    for (const pcl::index_t index : planes[plane].indices)
      if (!labels[index])
        labels[index] = static_cast<int> (plane) + 1;
  return (labels);
}

std::vector<std::uint8_t>
cutAlongPlanes (const OrganizedCloud& cloud, const std::vector<SupportingPlane>& planes, const PatchParameters& parameters,
                PlanarPatches& patches)
{
  Image<int> labels = labelPlanes (cloud, planes);
  std::vector<std::uint8_t> is_background (planes.size () + 1, 1);
  is_background[0] = 0;

  // Pieces of the same old patch that hang together become a patch, in the order of the old ones.
  std::vector<pcl::index_t> stack;
  for (const PlanarPatch& patch : patches.patches)
    for (const pcl::index_t seed : patch.pixels)
    {
      if (labels[seed] != 0)
        continue;
      const int old_label = patches.labels[seed], label = static_cast<int> (is_background.size ());
      pcl::Indices piece;
      labels[seed] = label;
      stack.push_back (seed);
      while (!stack.empty ())
      {
        const pcl::index_t index = stack.back ();
        stack.pop_back ();
        piece.push_back (index);
        const int column = index % cloud.width, row = index / cloud.width;
        for (const auto& [c, r] :
             {std::pair<int, int> (column + 1, row), {column - 1, row}, {column, row + 1}, {column, row - 1}})
          if (labels.contains (c, r) && patches.labels (c, r) == old_label && labels (c, r) == 0)
          {
            labels (c, r) = label;
            stack.push_back (r * cloud.width + c);
          }
      }
      if (static_cast<int> (piece.size ()) >= parameters.minimum_size)
        is_background.push_back (0);
      else
        for (const pcl::index_t index : piece)
          labels[index] = -1;
    }
  const bool has_left_overs = std::find (labels.data.begin (), labels.data.end (), -1) != labels.data.end ();
  for (int& label : labels.data)
    label = std::max (label, 0);
  patches.labels = std::move (labels);
  describePatches (cloud, patches);
  if (has_left_overs && parameters.reassign_distance > 0.0f)
    reassignLeftOvers (cloud, parameters.reassign_distance, patches);
  is_background.resize (patches.patches.size () + 1, 0);
  return (is_background);
}

} // namespace pcl_attention
