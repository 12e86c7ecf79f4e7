// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_renderer.h"
#include <pcl_attention/core/normals.h>

#include <Eigen/Geometry>
#include <pcl/segmentation/impl/organized_cloud.hpp>

#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <vector>

/** \brief Surfaces whose points and normals are known exactly, seen by a pinhole camera. */
namespace shapes
{

using Eigen::Vector3d;
using pcl_attention::NormalImage;
using pcl_attention::OrganizedCloud;

/** \brief A cloud with its normals. */
struct Frame
{
  OrganizedCloud cloud;
  NormalImage normals;

  std::size_t
  index (int column, int row) const
  {
    return (static_cast<std::size_t> (row) * cloud.width + column);
  }

  Vector3d
  point (std::size_t i) const
  {
    return {cloud.x[i], cloud.y[i], cloud.z[i]};
  }

  Vector3d
  normal (std::size_t i) const
  {
    return {normals.x[i], normals.y[i], normals.z[i]};
  }

  void
  set (std::size_t i, const Vector3d& point, const Vector3d& normal)
  {
    const Eigen::Vector3f p = point.cast<float> (), n = normal.cast<float> ();
    cloud.x[i] = p.x ();
    cloud.y[i] = p.y ();
    cloud.z[i] = p.z ();
    normals.x[i] = n.x ();
    normals.y[i] = n.y ();
    normals.z[i] = n.z ();
    cloud.valid[i] = normals.valid[i] = 1;
  }

  void
  invalidate (std::size_t i)
  {
    cloud.x[i] = cloud.y[i] = cloud.z[i] = normals.x[i] = normals.y[i] = normals.z[i] = normals.curvature[i] = 0.0f;
    cloud.valid[i] = normals.valid[i] = 0;
  }
};

inline Frame
emptyFrame (int width, int height)
{
  Frame frame;
  frame.cloud.reset (width, height);
  frame.normals.reset (frame.cloud.size ());
  return (frame);
}

struct Camera
{
  int width{64}, height{48};
  double focal_length{525.0};

  /** \brief Through a pixel; the principal point is the middle of the image. */
  Vector3d
  ray (double column, double row) const
  {
    return {(column - 0.5 * (width - 1)) / focal_length, (row - 0.5 * (height - 1)) / focal_length, 1.0};
  }
};

/** \brief Where a ray meets a surface. */
struct Hit
{
  double depth;
  Vector3d normal; /**< unit, out of the body */
};

using Surface = std::function<std::optional<Hit> (const Vector3d& ray)>;

inline Frame
look (const Surface& surface, const Camera& camera = Camera ())
{
  Frame frame = emptyFrame (camera.width, camera.height);
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column)
    {
      const Vector3d ray = camera.ray (column, row);
      if (const std::optional<Hit> hit = surface (ray))
        frame.set (frame.index (column, row), ray * hit->depth, hit->normal);
    }
  return (frame);
}

inline Surface
plane (const Vector3d& through, const Vector3d& normal)
{
  const Vector3d n = normal.normalized ();
  return ([=] (const Vector3d& ray) -> std::optional<Hit> {
    const double depth = n.dot (through) / n.dot (ray);
    if (!(depth > 0.0))
      return (std::nullopt);
    return (Hit{depth, n.dot (ray) > 0.0 ? Vector3d (-n) : n});
  });
}

inline Surface
sphere (const Vector3d& center, double radius)
{
  return ([=] (const Vector3d& ray) -> std::optional<Hit> {
    const double a = ray.squaredNorm (), b = ray.dot (center), c = center.squaredNorm () - radius * radius;
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0)
      return (std::nullopt);
    const double depth = (b - std::sqrt (discriminant)) / a;
    return (Hit{depth, (ray * depth - center) / radius});
  });
}

/** \brief An endless cylinder. */
inline Surface
cylinder (const Vector3d& through, const Vector3d& direction, double radius)
{
  const Vector3d along = direction.normalized ();
  const auto across = [=] (const Vector3d& v) { return (Vector3d (v - along * along.dot (v))); };
  return ([=] (const Vector3d& ray) -> std::optional<Hit> {
    const Vector3d r = across (ray), c = across (through);
    const double a = r.squaredNorm (), b = r.dot (c), discriminant = b * b - a * (c.squaredNorm () - radius * radius);
    if (discriminant < 0.0)
      return (std::nullopt);
    const double depth = (b - std::sqrt (discriminant)) / a;
    return (Hit{depth, (r * depth - c) / radius});
  });
}

/** \brief The nearer of two surfaces: of two planes, a valley. */
inline Surface
nearer (const Surface& first, const Surface& second)
{
  return ([=] (const Vector3d& ray) {
    const std::optional<Hit> a = first (ray), b = second (ray);
    return (!b || (a && a->depth <= b->depth) ? a : b);
  });
}

/** \brief The farther of two surfaces, where a ray meets both: of two planes, a roof. */
inline Surface
farther (const Surface& first, const Surface& second)
{
  return ([=] (const Vector3d& ray) -> std::optional<Hit> {
    const std::optional<Hit> a = first (ray), b = second (ray);
    if (!a || !b)
      return (std::nullopt);
    return (a->depth >= b->depth ? a : b);
  });
}

/** \brief Two planes that meet at a vertical edge at (0, y, depth), each turned away from the viewer by slope radians.
 */
inline Surface
roof (double depth, double slope)
{
  return (farther (plane ({0, 0, depth}, {-std::sin (slope), 0, -std::cos (slope)}),
                   plane ({0, 0, depth}, {std::sin (slope), 0, -std::cos (slope)})));
}

inline Surface
valley (double depth, double slope)
{
  return (nearer (plane ({0, 0, depth}, {-std::sin (slope), 0, -std::cos (slope)}),
                  plane ({0, 0, depth}, {std::sin (slope), 0, -std::cos (slope)})));
}

/** \brief Random hills: a sum of waves in all directions, normals from the derivatives. */
inline Frame
hills (unsigned seed, const Camera& camera = Camera (), double amplitude = 0.004)
{
  std::mt19937 random (seed);
  std::uniform_real_distribution<double> uniform (0.0, 1.0);
  struct Wave
  {
    double u, v, phase, height;
  };
  std::vector<Wave> waves;
  for (int k = 0; k < 6; ++k)
  {
    const double direction = 6.283185307 * uniform (random), frequency = 0.08 + 0.35 * uniform (random);
    waves.push_back ({frequency * std::cos (direction), frequency * std::sin (direction),
                      6.283185307 * uniform (random), amplitude * (0.3 + uniform (random))});
  }
  Frame frame = emptyFrame (camera.width, camera.height);
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column)
    {
      double depth = 0.8, by_column = 0.0, by_row = 0.0;
      for (const Wave& wave : waves)
      {
        const double at = wave.u * column + wave.v * row + wave.phase;
        depth += wave.height * std::sin (at);
        by_column += wave.height * wave.u * std::cos (at);
        by_row += wave.height * wave.v * std::cos (at);
      }
      const Vector3d ray = camera.ray (column, row);
      const Vector3d along_row = ray * by_column + Vector3d (depth / camera.focal_length, 0, 0);
      const Vector3d along_column = ray * by_row + Vector3d (0, depth / camera.focal_length, 0);
      Vector3d normal = along_row.cross (along_column).normalized ();
      if (normal.dot (ray) > 0.0)
        normal = -normal;
      frame.set (frame.index (column, row), ray * depth, normal);
    }
  return (frame);
}

/** \brief A rendered scene in the sensor frame, with estimated normals. */
inline Frame
rendered (pcl_attention::SceneKind kind, std::uint64_t seed, int width, int height, double noise)
{
  pcl_attention::SceneDescription scene = pcl_attention::makeScene (kind, seed);
  scene.camera = scene.camera.resized (width, height);
  scene.noise.level = noise;
  Frame frame;
  frame.cloud = pcl_attention::gather (*pcl_attention::renderScene (scene, seed), nullptr);
  pcl_attention::estimateNormals (frame.cloud, pcl_attention::NormalParameters (), 1, frame.normals);
  return (frame);
}

/** \brief Every k-th point taken away, and a block. */
inline void
punchHoles (Frame& frame, unsigned seed, double share)
{
  std::mt19937 random (seed);
  std::bernoulli_distribution hole (share);
  for (int row = 0; row < frame.cloud.height; ++row)
    for (int column = 0; column < frame.cloud.width; ++column)
      if (hole (random) ||
          (std::abs (column - frame.cloud.width / 3) < 4 && std::abs (row - frame.cloud.height / 2) < 3))
        frame.invalidate (frame.index (column, row));
}

/** \brief Left and right exchanged. */
inline Frame
mirrored (const Frame& frame)
{
  Frame mirror = emptyFrame (frame.cloud.width, frame.cloud.height);
  const Vector3d flip (-1, 1, 1);
  for (int row = 0; row < frame.cloud.height; ++row)
    for (int column = 0; column < frame.cloud.width; ++column)
    {
      const std::size_t from = frame.index (frame.cloud.width - 1 - column, row), to = frame.index (column, row);
      if (frame.cloud.valid[from] && frame.normals.valid[from])
        mirror.set (to, frame.point (from).cwiseProduct (flip), frame.normal (from).cwiseProduct (flip));
    }
  return (mirror);
}

/** \brief The frame inside a larger one whose other points are invalid. */
inline Frame
withMargins (const Frame& frame, int left, int top, int right, int bottom)
{
  Frame larger = emptyFrame (frame.cloud.width + left + right, frame.cloud.height + top + bottom);
  for (int row = 0; row < frame.cloud.height; ++row)
    for (int column = 0; column < frame.cloud.width; ++column)
    {
      const std::size_t from = frame.index (column, row);
      if (frame.cloud.valid[from])
        larger.set (larger.index (column + left, row + top), frame.point (from), frame.normal (from));
    }
  return (larger);
}

} // namespace shapes
