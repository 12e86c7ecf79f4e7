// SPDX-License-Identifier: BSD-3-Clause
#include "scene_tracer.h"

#include "counter_random.h"

#include <array>
#include <cmath>

namespace pcl_attention
{

namespace
{

using Eigen::Vector3d;

/** \brief A ray in an object's frame that keeps the nearest of the surfaces it is offered. */
class LocalRay
{
public:
  LocalRay (const Vector3d& origin, const Vector3d& direction, double limit)
      : distance (limit), origin_ (origin), direction_ (direction)
  {
  }

  /** \brief The part of a sphere around (0, 0, center) with low <= z <= high. */
  void
  sphere (double center, double radius, double low, double high)
  {
    const Vector3d from_center = origin_ - Vector3d (0, 0, center);
    for (const double t :
         roots (direction_.squaredNorm (), from_center.dot (direction_), from_center.squaredNorm () - radius * radius))
    {
      const Vector3d hit = at (t);
      if (hit.z () >= low && hit.z () <= high)
        offer (t, (hit - Vector3d (0, 0, center)) / radius);
    }
  }

  /** \brief The lateral surface of a cylinder around the z axis. */
  void
  tube (double radius, double low, double high)
  {
    const auto o = origin_.head<2> (), d = direction_.head<2> ();
    for (const double t : roots (d.squaredNorm (), o.dot (d), o.squaredNorm () - radius * radius))
    {
      const Vector3d hit = at (t);
      if (hit.z () >= low && hit.z () <= high)
        offer (t, Vector3d (hit.x () / radius, hit.y () / radius, 0));
    }
  }

  /** \brief The flat ring of inner <= radius <= outer at height z. */
  void
  ring (double z, double inner, double outer)
  {
    const double t = (z - origin_.z ()) / direction_.z (); // infinite or NaN for a parallel ray: offer takes neither
    const double radius = at (t).head<2> ().norm ();
    if (radius >= inner && radius <= outer)
      offer (t, Vector3d::UnitZ ());
  }

  void
  box (const Vector3d& low, const Vector3d& high)
  {
    const double infinity = std::numeric_limits<double>::infinity ();
    double near = -infinity, far = infinity;
    int near_axis = 0, far_axis = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (direction_[axis] == 0.0)
      {
        if (origin_[axis] < low[axis] || origin_[axis] > high[axis])
          return;
        continue;
      }
      double enter = (low[axis] - origin_[axis]) / direction_[axis],
             leave = (high[axis] - origin_[axis]) / direction_[axis];
      if (enter > leave)
        std::swap (enter, leave);
      if (enter > near)
      {
        near = enter;
        near_axis = axis;
      }
      if (leave < far)
      {
        far = leave;
        far_axis = axis;
      }
    }
    if (near > far)
      return;
    offer (near, Vector3d::Unit (near_axis));
    offer (far, Vector3d::Unit (far_axis));
  }

  double distance; // to the nearest surface so far
  Vector3d normal{0, 0, 0};

private:
  Vector3d
  at (double t) const
  {
    return (origin_ + t * direction_);
  }

  /** \brief Solutions of a t^2 + 2 b t + c = 0; NaN where there is none. */
  static std::array<double, 2>
  roots (double a, double b, double c)
  {
    const double root = std::sqrt (b * b - a * c);
    return {(-b - root) / a, (-b + root) / a};
  }

  void
  offer (double t, const Vector3d& n)
  {
    if (t > 0.0 && t < distance)
    {
      distance = t;
      normal = n;
    }
  }

  Vector3d origin_, direction_;
};

void
intersect (const SceneObject& object, LocalRay& ray)
{
  const Vector3d half = 0.5 * object.size;
  const double radius = half.x (), top = half.z (), thickness = object.wall_thickness;
  switch (object.shape)
  {
  case SceneShape::plane:
    ray.ring (0.0, 0.0, 1e3); // far enough for infinite, and its texture stays within integers
    break;
  case SceneShape::box:
    ray.box (-half, half);
    break;
  case SceneShape::cylinder:
    ray.tube (radius, -top, top);
    ray.ring (top, 0.0, radius);
    ray.ring (-top, 0.0, radius);
    break;
  case SceneShape::sphere:
    ray.sphere (0.0, radius, -radius, radius);
    break;
  case SceneShape::bowl:
  {
    const double center = object.bowlCenter (), outer = center + top + 0.5 * thickness, inner = outer - thickness;
    const auto radiusAt = [center] (double sphere, double z) {
      return (std::sqrt (std::max (0.0, sphere * sphere - (z - center) * (z - center))));
    };
    ray.sphere (center, outer, -top, top);
    ray.sphere (center, inner, -top, top);
    ray.ring (top, radiusAt (inner, top), radius);
    ray.ring (-top, 0.0, radiusAt (outer, -top)); // the foot: half the thickness of the bottom is cut off
    break;
  }
  case SceneShape::mug:
  {
    const double inner = radius - thickness, bar = 0.06 * object.size.z (), reach = radius + object.handleReach ();
    ray.tube (radius, -top, top);
    ray.tube (inner, thickness - top, top);
    ray.ring (top, inner, radius);
    ray.ring (thickness - top, 0.0, inner);
    ray.ring (-top, 0.0, radius);
    // The bars begin inside the wall, so that they meet its round outside without a gap.
    for (const double z : {-0.5 * top, 0.7 * top})
      ray.box ({inner, -bar, z - bar}, {reach, bar, z + bar});
    ray.box ({reach - 2.0 * bar, -bar, -0.5 * top}, {reach, bar, 0.7 * top});
    break;
  }
  }
}

/** \brief Noise in [0, 1) that is smooth between the nodes of a grid of unit spacing. */
double
smoothNoise (double u, double v)
{
  static const CounterRandom random (20);
  const double column = std::floor (u), row = std::floor (v), x = u - column, y = v - row;
  const auto node = [column, row] (int dx, int dy) {
    const auto i = static_cast<std::uint32_t> (static_cast<std::int64_t> (column) + dx);
    const auto j = static_cast<std::uint32_t> (static_cast<std::int64_t> (row) + dy);
    return (random.uniform (static_cast<std::uint64_t> (j) << 32 | i));
  };
  return ((1 - y) * ((1 - x) * node (0, 0) + x * node (1, 0)) + y * ((1 - x) * node (0, 1) + x * node (1, 1)));
}

bool
isOdd (double number)
{
  return (static_cast<std::int64_t> (std::floor (number)) % 2 != 0);
}

} // namespace

SceneTracer::SceneTracer (const SceneDescription& scene)
{
  for (const auto* list : {&scene.supports, &scene.objects})
    for (const SceneObject& object : *list)
    {
      const Eigen::AlignedBox3d bounds = object.bounds ();
      const bool infinite = object.shape == SceneShape::plane;
      items_.push_back ({&object, object.pose.inverse (), object.pose * bounds.center (),
                         infinite ? std::numeric_limits<double>::infinity () : 0.5 * bounds.diagonal ().norm ()});
    }
}

SceneHit
SceneTracer::trace (const Vector3d& origin, const Vector3d& direction) const
{
  SceneHit hit;
  for (const Item& item : items_)
  {
    const double reach = item.radius * item.radius * direction.squaredNorm ();
    if ((item.center - origin).cross (direction).squaredNorm () > reach)
      continue;
    const Vector3d local_origin = item.to_local * origin, local_direction = item.to_local.linear () * direction;
    LocalRay ray (local_origin, local_direction, hit.distance);
    intersect (*item.object, ray);
    if (ray.distance >= hit.distance)
      continue;
    hit.object = item.object;
    hit.distance = ray.distance;
    hit.local_point = local_origin + ray.distance * local_direction;
    hit.local_normal = ray.normal.dot (local_direction) > 0.0 ? Vector3d (-ray.normal) : ray.normal;
  }
  if (hit.object != nullptr)
    hit.normal = hit.object->pose.linear () * hit.local_normal;
  return (hit);
}

bool
SceneTracer::blocked (const Vector3d& from, const Vector3d& to) const
{
  const Vector3d direction = to - from;
  const double end_margin = 1e-6; // of the way: keeps clear of the surfaces the two points lie on
  for (const Item& item : items_)
  {
    if ((item.center - from).cross (direction).squaredNorm () > item.radius * item.radius * direction.squaredNorm ())
      continue;
    LocalRay ray (item.to_local * (from + end_margin * direction), item.to_local.linear () * direction,
                  1.0 - 2.0 * end_margin);
    intersect (*item.object, ray);
    if (ray.distance < 1.0 - 2.0 * end_margin)
      return (true);
  }
  return (false);
}

Vector3d
surfaceColor (const SceneHit& hit)
{
  const SceneObject& object = *hit.object;
  const SceneMaterial& material = object.material;
  const Vector3d &p = hit.local_point, n = hit.local_normal.cwiseAbs ();

  // Coordinates along the surface in metres, and how far the side extends from its middle.
  double u = p.x (), v = p.y ();
  double u_extent = 0.5 * object.size.x (), v_extent = 0.5 * object.size.y ();
  const bool is_flat = object.shape == SceneShape::box || object.shape == SceneShape::plane;
  if (n.z () < 0.99 || object.shape == SceneShape::sphere)
  {
    v = p.z ();
    v_extent = 0.5 * object.size.z ();
    if (!is_flat)
      u = std::atan2 (p.y (), p.x ()) * u_extent;
    else if (n.x () > n.y ())
    {
      u = p.y ();
      u_extent = 0.5 * object.size.y ();
    }
  }

  double share = 0.0; // of the second colour
  switch (material.pattern)
  {
  case ScenePattern::plain:
    break;
  case ScenePattern::stripes:
    share = isOdd (v / material.scale);
    break;
  case ScenePattern::checker:
    share = isOdd (u / material.scale) != isOdd (v / material.scale);
    break;
  case ScenePattern::print:
  {
    const bool inside = std::abs (u) < 0.7 * u_extent && std::abs (v) < 0.6 * v_extent;
    const double line = v / (0.5 * material.scale);
    const bool ink = isOdd (line) && smoothNoise (u / (0.3 * material.scale), 7.0 * std::floor (line)) > 0.45;
    share = inside && !ink;
    break;
  }
  case ScenePattern::noise:
    share = 0.7 * smoothNoise (u / material.scale, v / material.scale) +
            0.3 * smoothNoise (3.1 * u / material.scale, 3.1 * v / material.scale);
    break;
  }
  return ((1.0 - share) * material.color + share * material.second_color);
}

} // namespace pcl_attention
