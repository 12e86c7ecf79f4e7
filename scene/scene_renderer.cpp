// SPDX-License-Identifier: BSD-3-Clause
#include "scene_renderer.h"

#include "counter_random.h"
#include "scene_tracer.h"

#include <pcl/console/print.h>

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl_attention
{

namespace
{

using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN ();
constexpr double degree = 0.017453292519943295; // radians

/** \brief One value a pixel, row by row. */
template <typename T> class Image
{
public:
  Image (int width, int height, T value = T ())
      : width_ (width), pixels_ (static_cast<std::size_t> (width) * height, value)
  {
  }

  T&
  operator() (int column, int row)
  {
    return (pixels_[static_cast<std::size_t> (row) * width_ + column]);
  }

  const T&
  operator() (int column, int row) const
  {
    return (pixels_[static_cast<std::size_t> (row) * width_ + column]);
  }

private:
  int width_;
  std::vector<T> pixels_;
};

/** \brief Normal numbers (mean 0, deviation 1) under a binomial window of 5 x 5 pixels. */
Image<float>
correlatedNoise (int width, int height, const CounterRandom& random)
{
  constexpr double window[5] = {1.0, 4.0, 6.0, 4.0, 1.0};
  constexpr double deviation = 70.0; // sqrt (sum of squares), squared as the window is applied twice
  Image<float> across (width, height + 4), noise (width, height);
#pragma omp parallel
  {
    std::vector<double> white (width + 4);
#pragma omp for schedule(static)
    for (int row = 0; row < height + 4; ++row)
    {
      // A row and column of their own in the counter: an image of another size has the same noise.
      for (int column = 0; column < width + 4; ++column)
        white[column] = random.normal (static_cast<std::uint64_t> (row) << 32 | static_cast<std::uint64_t> (column));
      for (int column = 0; column < width; ++column)
      {
        double sum = 0.0;
        for (int i = 0; i < 5; ++i)
          sum += window[i] * white[column + i];
        across (column, row) = static_cast<float> (sum);
      }
    }
  }
#pragma omp parallel for schedule(static)
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      double sum = 0.0;
      for (int i = 0; i < 5; ++i)
        sum += window[i] * across (column, row + i);
      noise (column, row) = static_cast<float> (sum / deviation);
    }
  return (noise);
}

/** \brief Recursive smoothing along rows and columns, there and back, twice; what jumps by \a jump or more is not
 * smoothed over, nor are holes. */
template <typename T> void
smooth (Image<T>& image, int width, int height, double jump)
{
  const double weight = 1.0 - std::exp (-1.0 / SensorNoise::stereo_smoothing);
  const auto pass = [weight, jump] (T& value, T& previous) {
    if (std::abs (value - previous) < jump)
      value = static_cast<T> (previous + weight * (value - previous));
  };
  for (int round = 0; round < 2; ++round)
  {
#pragma omp parallel for schedule(static)
    for (int row = 0; row < height; ++row)
    {
      for (int column = 1; column < width; ++column)
        pass (image (column, row), image (column - 1, row));
      for (int column = width - 2; column >= 0; --column)
        pass (image (column, row), image (column + 1, row));
    }
#pragma omp parallel for schedule(static)
    for (int column = 0; column < width; ++column)
    {
      for (int row = 1; row < height; ++row)
        pass (image (column, row), image (column, row - 1));
      for (int row = height - 2; row >= 0; --row)
        pass (image (column, row), image (column, row + 1));
    }
  }
}

/** \brief Normal numbers (mean 0, deviation 1) under the window of smooth. */
Image<float>
wavyNoise (int width, int height, const CounterRandom& random)
{
  Image<float> noise (width, height);
#pragma omp parallel for schedule(static)
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      noise (column, row) = static_cast<float> (
          random.normal (static_cast<std::uint64_t> (row) << 32 | static_cast<std::uint64_t> (column)));
  smooth (noise, width, height, std::numeric_limits<double>::infinity ());
  constexpr int reach = 100; // pixels
  Image<float> impulse (2 * reach + 1, 1);
  impulse (reach, 0) = 1.0F;
  smooth (impulse, 2 * reach + 1, 1, std::numeric_limits<double>::infinity ());
  double deviation = 0.0; // sqrt (sum of squares), squared as the window is applied along rows and along columns
  for (int column = 0; column <= 2 * reach; ++column)
    deviation += impulse (column, 0) * impulse (column, 0);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      noise (column, row) /= static_cast<float> (deviation);
  return (noise);
}

/** \brief Number the visible pieces of every object by decreasing size.
 * \param[in,out] labels one a pixel; in: the object's, out: plus the number of the piece */
void
numberPieces (Image<std::uint32_t>& labels, int width, int height)
{
  constexpr std::size_t smallest_piece = 20; // pixels
  struct Piece
  {
    std::uint32_t label;
    std::vector<std::pair<int, int>> pixels;
  };
  std::vector<Piece> pieces;
  Image<char> seen (width, height, 0);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      const std::uint32_t label = labels (column, row);
      if (label < scene_label::first_object || seen (column, row))
        continue;
      seen (column, row) = 1;
      Piece piece{label, {{column, row}}};
      for (std::size_t i = 0; i < piece.pixels.size (); ++i)
      {
        const auto [x, y] = piece.pixels[i];
        for (int v = std::max (y - 1, 0); v <= std::min (y + 1, height - 1); ++v)
          for (int u = std::max (x - 1, 0); u <= std::min (x + 1, width - 1); ++u)
            if (labels (u, v) == label && !seen (u, v))
            {
              seen (u, v) = 1;
              piece.pixels.emplace_back (u, v);
            }
      }
      if (piece.pixels.size () >= smallest_piece)
        pieces.push_back (std::move (piece));
    }
  // Stable: of two pieces of the same size the upper one comes first.
  std::stable_sort (pieces.begin (), pieces.end (), [] (const Piece& a, const Piece& b) {
    return (a.label != b.label ? a.label < b.label : a.pixels.size () > b.pixels.size ());
  });
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < pieces.size (); ++i)
  {
    number = i > 0 && pieces[i].label == pieces[i - 1].label ? number + 1 : 0;
    for (const auto& [column, row] : pieces[i].pixels)
      labels (column, row) += std::min (number, 9U);
  }
}

class Renderer
{
public:
  using Cloud = pcl::PointCloud<pcl::PointXYZRGBL>;

  Renderer (const SceneDescription& scene, std::uint64_t seed)
      : scene_ (scene), camera_ (scene.camera), noise_ (scene.noise), tracer_ (scene), color_random_ (seed, 0),
        jitter_x_ (field (seed, 1, noise_.lateral)), jitter_y_ (field (seed, 2, noise_.lateral)),
        axial_ (axialField (seed)), holes_ (field (seed, 4, noise_.grazing_holes || noise_.edge_holes)),
        labels_ (camera_.width, camera_.height), depth_ (camera_.width, camera_.height, nan),
        angle_ (camera_.width, camera_.height)
  {
  }

  Cloud::Ptr
  render ()
  {
    Cloud::Ptr cloud (new Cloud (camera_.width, camera_.height));
    cloud->is_dense = false;
    if (scene_.world_frame)
    {
      cloud->sensor_origin_.head<3> () = camera_.pose.translation ().cast<float> ();
      cloud->sensor_orientation_ = Eigen::Quaterniond (camera_.pose.linear ()).cast<float> ();
    }
#pragma omp parallel for schedule(dynamic, 8)
    for (int row = 0; row < camera_.height; ++row)
      for (int column = 0; column < camera_.width; ++column)
        castRay (column, row, (*cloud)[pixelIndex (column, row)]);
    numberPieces (labels_, camera_.width, camera_.height);
    if (noise_.sensor == SceneSensor::stereo && noise_.smoothing && noise_.level > 0.0)
      smoothDepths ();
#pragma omp parallel for schedule(static)
    for (int row = 0; row < camera_.height; ++row)
      for (int column = 0; column < camera_.width; ++column)
        measure (column, row, (*cloud)[pixelIndex (column, row)]);
    return (cloud);
  }

private:
  /** \brief The cloud's own at (column, row) takes a cloud of one row for an unorganized one, and throws. */
  std::size_t
  pixelIndex (int column, int row) const
  {
    return (static_cast<std::size_t> (row) * camera_.width + column);
  }

  Image<float>
  field (std::uint64_t seed, std::uint64_t stream, bool is_used) const
  {
    if (!is_used || noise_.level == 0.0)
      return {camera_.width, camera_.height, 0.0F};
    return (correlatedNoise (camera_.width, camera_.height, CounterRandom (seed, stream)));
  }

  Image<float>
  axialField (std::uint64_t seed) const
  {
    if (noise_.sensor == SceneSensor::kinect || !noise_.axial || noise_.level == 0.0)
      return (field (seed, 3, noise_.axial));
    return (wavyNoise (camera_.width, camera_.height, CounterRandom (seed, 3)));
  }

  /** \return the direction of a pixel's ray in the camera's frame, of unit z: distances along it are depths */
  Vector3d
  direction (double column, double row) const
  {
    return {(column - camera_.center_x) / camera_.focal_length, (row - camera_.center_y) / camera_.focal_length, 1.0};
  }

  /** \brief Colour and label of a pixel, and the depth of the surface the sensor sees there: not yet its axial noise.
   */
  void
  castRay (int column, int row, pcl::PointXYZRGBL& point)
  {
    const Vector3d eye = camera_.pose.translation ();
    const Vector3d ray = camera_.pose.linear () * direction (column, row);
    SceneHit hit = tracer_.trace (eye, ray);
    shade (hit, eye + hit.distance * ray, column, row, point);
    if (hit.object != nullptr)
      labels_ (column, row) = hit.object->label;

    double depth = hit.distance;
    Vector3d position = eye + depth * ray;
    if (noise_.lateral && noise_.level > 0.0)
    {
      const double wobble = 0.8 * noise_.level; // pixels
      const Vector3d other_ray = camera_.pose.linear () * direction (column + wobble * jitter_x_ (column, row),
                                                                     row + wobble * jitter_y_ (column, row));
      hit = tracer_.trace (eye, other_ray);
      // The tangent plane there, seen from this pixel: depth edges wobble, slanted surfaces stay flat.
      const double slant = hit.normal.dot (ray), other_slant = hit.normal.dot (other_ray);
      depth = hit.distance;
      position = eye + depth * other_ray;
      if (slant < -0.1 * ray.norm ())
        depth *= other_slant / slant;
    }
    if (hit.object == nullptr)
      return;
    const double cosine = std::min (1.0, -hit.normal.dot (ray) / ray.norm ());
    angle_ (column, row) = static_cast<float> (std::acos (std::max (0.0, cosine)));
    if (noise_.level > 0.0)
    {
      const Vector3d projector = camera_.pose * Vector3d (noise_.baseline (), 0, 0);
      const double limit = (80.0 + 3.0 * noise_.level * holes_ (column, row)) * degree;
      if ((noise_.grazing_holes && angle_ (column, row) > limit) ||
          (noise_.shadows && tracer_.blocked (position + 1e-4 * hit.normal, projector)))
        return;
    }
    depth_ (column, row) = depth;
  }

  void
  shade (const SceneHit& hit, const Vector3d& position, int column, int row, pcl::PointXYZRGBL& point) const
  {
    Vector3d color (0, 0, 0);
    if (hit.object != nullptr)
    {
      // Lambert, and a room bright enough that the shade is not black.
      const Vector3d to_light = scene_.light - position;
      double light = std::max (0.0, hit.normal.dot (to_light.normalized ()));
      if (light > 0.0 && tracer_.blocked (position + 1e-4 * hit.normal, scene_.light))
        light *= 0.4;
      color = 255.0 * (0.45 + 0.55 * light) * surfaceColor (hit);
    }
    if (noise_.color && noise_.level > 0.0)
      for (int channel = 0; channel < 3; ++channel)
      {
        const auto counter = (static_cast<std::uint64_t> (row) << 32 | static_cast<std::uint64_t> (column)) * 3;
        color[channel] += 2.0 * noise_.level * color_random_.normal (counter + channel);
      }
    const auto toByte = [] (double value) {
      return (static_cast<std::uint8_t> (std::clamp (value + 0.5, 0.0, 255.0)));
    };
    point.r = toByte (color.x ());
    point.g = toByte (color.y ());
    point.b = toByte (color.z ());
    point.a = 255;
  }

  /** \return whether the depth changes by more than 3 % around a pixel, or ends there */
  bool
  isDepthEdge (int column, int row) const
  {
    for (int v = std::max (row - 1, 0); v <= std::min (row + 1, camera_.height - 1); ++v)
      for (int u = std::max (column - 1, 0); u <= std::min (column + 1, camera_.width - 1); ++u)
        if (!(std::abs (depth_ (u, v) - depth_ (column, row)) < 0.03 * depth_ (column, row)))
          return (true);
    return (false);
  }

  void
  smoothDepths ()
  {
    const auto invert = [this] {
#pragma omp parallel for schedule(static)
      for (int row = 0; row < camera_.height; ++row)
        for (int column = 0; column < camera_.width; ++column)
          depth_ (column, row) = 1.0 / depth_ (column, row);
    };
    invert ();
    smooth (depth_, camera_.width, camera_.height, SensorNoise::stereo_jump);
    invert ();
  }

  /** \brief Depth of a Kinect with axial noise and quantization. */
  double
  kinectDepth (int column, int row, double depth) const
  {
    const double step = noise_.level * SensorNoise::disparity_unit;
    double inverse = 1.0 / depth;
    if (noise_.axial)
    {
      // Quantization contributes 1/12 of a squared step to the (1/2)^2 that were measured in all.
      const double angle = std::min<double> (angle_ (column, row), 85.0 * degree);
      const double slant = noise_.level * 1e-4 / std::sqrt (depth) * std::pow (angle / (90.0 * degree - angle), 2);
      inverse += axial_ (column, row) * (step * std::sqrt (0.25 - 1.0 / 12.0) + slant * inverse * inverse);
    }
    if (noise_.quantization)
      inverse = step * std::round (inverse / step);
    return (inverse > 0.0 ? 1.0 / inverse : nan);
  }

  /** \brief Depth of a stereo camera with axial noise and quantization. */
  double
  stereoDepth (int column, int row, double depth) const
  {
    double inverse = 1.0 / depth;
    if (noise_.axial)
      inverse += axial_ (column, row) * noise_.level * SensorNoise::stereo_deviation;
    if (!(inverse > 0.0))
      return (nan);
    return (noise_.quantization ? std::round (1000.0 / inverse) / 1000.0 : 1.0 / inverse);
  }

  /** \brief The point of a pixel: axial noise, quantization, holes along edges. */
  void
  measure (int column, int row, pcl::PointXYZRGBL& point) const
  {
    double depth = depth_ (column, row);
    if (noise_.edge_holes && noise_.level * holes_ (column, row) > 1.0 && isDepthEdge (column, row))
      depth = nan;
    if (noise_.level > 0.0)
      depth = noise_.sensor == SceneSensor::kinect ? kinectDepth (column, row, depth) : stereoDepth (column, row, depth);
    Vector3d position = depth * direction (column, row);
    if (scene_.world_frame)
      position = camera_.pose * position;
    point.getVector3fMap () = position.cast<float> ();
    point.label = std::isnan (depth) ? scene_label::invalid : labels_ (column, row);
  }

  const SceneDescription& scene_;
  const SceneCamera& camera_;
  const SensorNoise& noise_;
  SceneTracer tracer_;
  CounterRandom color_random_;
  Image<float> jitter_x_, jitter_y_, axial_, holes_;
  Image<std::uint32_t> labels_;
  Image<double> depth_;
  Image<float> angle_; // between ray and normal, radians
};

} // namespace

pcl::PointCloud<pcl::PointXYZRGBL>::Ptr
renderScene (const SceneDescription& scene, std::uint64_t seed, unsigned threads)
{
  const SceneCamera& camera = scene.camera;
  if (camera.width < 1 || camera.height < 1 || !(camera.focal_length > 0.0))
  {
    PCL_ERROR (
        "[pcl_attention::renderScene] A camera of %d x %d pixels and a focal length of %g pixels sees nothing.\n",
        camera.width, camera.height, camera.focal_length);
    return (pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGBL>> ());
  }
  if (!(scene.noise.level >= 0.0 && scene.noise.level <= SensorNoise::max_level))
  {
    PCL_ERROR ("[pcl_attention::renderScene] The noise level is %g, it has to be in [0, %g].\n", scene.noise.level,
               SensorNoise::max_level);
    return (pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGBL>> ());
  }
#ifdef _OPENMP
  // The setting is the calling thread's: put it back.
  const int previous_threads = omp_get_max_threads ();
  omp_set_num_threads (threads == 0 ? omp_get_num_procs () : static_cast<int> (threads));
  auto cloud = Renderer (scene, seed).render ();
  omp_set_num_threads (previous_threads);
  return (cloud);
#else
  static_cast<void> (threads);
  return (Renderer (scene, seed).render ());
#endif
}

} // namespace pcl_attention
