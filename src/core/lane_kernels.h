// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl_attention
{

// The inner loops over pixels. Their sources are compiled once per instruction set and chosen at run time, see
// instruction_set.h, so plain pointers only: code of a library header compiled for a wide instruction set could be linked into
// the rest. All pointers to rows are to the pixel in column 0; "padded" rows may be read some columns before and lane_count
// columns behind the image.

/** \brief A padded row of points with what is summed over their neighbours in the row. */
struct NormalRow
{
  enum Moment
  {
    count,
    sum_x,
    sum_y,
    sum_z,
    sum_xx,
    sum_xy,
    sum_xz,
    sum_yy,
    sum_yz,
    sum_zz,
    moments_size
  };

  /** \brief Depth of points that are not valid, metres: finite, so that a gate shuts them out without a test of its own. */
  static constexpr float far_away = 1e9f;

  float *x, *y, *z;             /**< metres */
  float* moments[moments_size]; /**< relative to the pixel's own point */
};

/** \brief A row of fitted normals. */
struct FittedRow
{
  float *x, *y, *z, *curvature;
  std::uint8_t* valid;
};

/** \brief A padded row of points and normals, all 0 where not valid. */
struct SurfaceRow
{
  enum Channel
  {
    x,
    y,
    z,
    normal_x,
    normal_y,
    normal_z,
    valid, /**< 0 or 1 */
    channels_size
  };

  float* channels[channels_size];
};

/** \brief The even and the odd columns of a padded row. */
struct SplitRow
{
  SurfaceRow even, odd;
};

/** \brief A row of points and normals as they are stored. */
struct StoredRow
{
  const float *x, *y, *z, *normal_x, *normal_y, *normal_z;
  const std::uint8_t *valid, *normal_valid;
};

/** \brief A row of points and normals to be stored. */
struct HalvedRow
{
  float *x, *y, *z, *normal_x, *normal_y, *normal_z;
  std::uint8_t *valid, *normal_valid;
};

/** \brief Settings of the symmetry, see SaliencyParameters. */
struct SymmetrySettings
{
  int radius;
  float distance_scale;
  bool convexity_gate;
};

/** \brief Points, row-major, with normals: 0 where not valid. */
struct PointArrays
{
  const float *x, *y, *z, *normal_x, *normal_y, *normal_z;
  const std::uint8_t* valid;
};

/** \brief A plane as a sensor sees it, and how near to it a point belongs to it. */
struct SurfaceTest
{
  float normal[3], offset;
  float bent[6];               /**< inverse depth as a function of the view ray (u, v): 1, u, v, uu, uv, vv */
  float tolerance;             /**< metres ... */
  float noise_tolerance;       /**< ... plus this times the squared depth, 1/m */
  float below;                 /**< how far below the surface a point still may lie, metres */
  float minimum_cosine;        /**< between a point's normal and the plane's */
};

/** \brief An edge of a convex outline: points whose product with the normal exceeds limit are outside. */
struct OutlineEdge
{
  float x, y, normal_x, normal_y, limit;
};

/** \brief The room over a plane's outline. */
struct RoomTest
{
  float normal[3], offset;
  float lowest, highest; /**< heights over the plane, exclusive, metres */
  float axis1[3], axis2[3];
  const OutlineEdge* edges;
  int edge_count;
};

/** \brief A plane with a unit normal. */
struct FlatPlane
{
  float normal[3], offset;
};

/** \brief Of those to the 26 neighbours in a grid one of each two that are opposite. */
constexpr int direction_count = 13;

struct LaneKernels
{
  int lanes; /**< pixels at a time */

  /** \brief Moments of every pixel's neighbours in its own row that are within the gate. */
  void (*rowMoments) (const NormalRow& row, int width, int radius, float gate);

  /** \brief Normals of a row from the moments of the rows around it.
    * \param[in] around the rows from -radius to radius; null outside the image */
  void (*fitRow) (const NormalRow* const* around, int width, int radius, float gate, const FittedRow& normals);

  /** \brief s (p) of a row, paper eq. 1 to 3.
    * \param[in] around the rows from -radius to radius
    * \param[in] samples room for 4 radius^2 * 6 * lanes floats */
  void (*symmetryOfRow) (const SurfaceRow* const* around, int width, const SymmetrySettings& settings, float* samples,
                         float* symmetry, std::uint8_t* winning_axis);

  /** \brief Points and normals where both are valid, else 0; behind the row 0 as far as the lanes reach. */
  void (*fillRow) (const StoredRow& stored, int width, const SurfaceRow& row);

  /** \brief The same by even and odd columns. */
  void (*fillSplitRow) (const StoredRow& stored, int width, const SplitRow& row);

  /** \brief A row of half the size.
    * \param[in] around the four fine rows under it, split */
  void (*halveRow) (const SplitRow* const* around, int width, const HalvedRow& half);

  /** \brief 1 for points that belong to a surface, else 0. */
  void (*pointsNear) (const PointArrays& points, std::size_t count, const SurfaceTest& test, std::uint8_t* near);

  /** \brief 1 for points in the room over a plane, else 0. */
  void (*pointsOver) (const PointArrays& points, std::size_t count, const RoomTest& test, std::uint8_t* over);

  /** \brief Distance of every point to the nearest plane.
    * \param[in] points of which only the coordinates are looked at */
  void (*nearestPlane) (const PointArrays& points, std::size_t count, const FlatPlane* planes, std::size_t plane_count,
                        float* distances);

  /** \brief Height of every point over the plane that it is least high over.
    * \param[in] points of which only the coordinates are looked at */
  void (*lowestHeight) (const PointArrays& points, std::size_t count, const FlatPlane* planes, std::size_t plane_count,
                        float* heights);

  /** \brief Indices of the points farthest out in \ref direction_count directions and, from the end, in their opposites; of
    * points as far out the first.
    * \param[in] points of which only the coordinates are looked at
    * \param[in] count 1 or more */
  void (*farthestPoints) (const PointArrays& points, std::size_t count, int* farthest);
};

#ifdef PCL_ATTENTION_INSTRUCTION_SET
namespace PCL_ATTENTION_INSTRUCTION_SET
{

void
rowMoments (const NormalRow& row, int width, int radius, float gate);
void
fitRow (const NormalRow* const* around, int width, int radius, float gate, const FittedRow& normals);
void
symmetryOfRow (const SurfaceRow* const* around, int width, const SymmetrySettings& settings, float* samples,
               float* symmetry, std::uint8_t* winning_axis);
void
fillRow (const StoredRow& stored, int width, const SurfaceRow& row);
void
fillSplitRow (const StoredRow& stored, int width, const SplitRow& row);
void
halveRow (const SplitRow* const* around, int width, const HalvedRow& half);
void
pointsNear (const PointArrays& points, std::size_t count, const SurfaceTest& test, std::uint8_t* near);
void
pointsOver (const PointArrays& points, std::size_t count, const RoomTest& test, std::uint8_t* over);
void
nearestPlane (const PointArrays& points, std::size_t count, const FlatPlane* planes, std::size_t plane_count, float* distances);
void
lowestHeight (const PointArrays& points, std::size_t count, const FlatPlane* planes, std::size_t plane_count, float* heights);
void
farthestPoints (const PointArrays& points, std::size_t count, int* farthest);

} // namespace PCL_ATTENTION_INSTRUCTION_SET
#endif

} // namespace pcl_attention
