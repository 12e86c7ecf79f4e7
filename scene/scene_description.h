// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief Labels of a rendered scene, as in the mOSD data set: 0 is an invalid point, 1 to 19 are support, object k has
 * first_object + 10 * k and its separately visible pieces that number + 0, + 1, ...: label / 10 names the object. */
namespace scene_label
{
constexpr std::uint32_t invalid = 0, table = 1, floor = 2, wall = 3, second_wall = 4, first_object = 20;
}

/** \brief Pinhole camera in PCL's optical frame: x right, y down, z forward. The defaults are the Kinect's. */
struct SceneCamera
{
  int width = 640, height = 480;                           /**< \brief pixels */
  double focal_length = 525.0;                             /**< \brief pixels */
  double center_x = 319.5, center_y = 239.5;               /**< \brief principal point, pixels */
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity (); /**< \brief camera to world, metres */

  /** \brief Same view at another resolution: focal length and principal point scale along. Where the aspect ratio
   * differs the old view stays whole, and the image shows more on two of its sides.
   * \param[in] new_width pixels, at least 1
   * \param[in] new_height pixels, at least 1 */
  SceneCamera resized (int new_width, int new_height) const;

  /** \brief Stand at \a eye and look at \a target, world z being up.
   * \param[in] eye metres, in the world frame
   * \param[in] target metres, in the world frame */
  void lookAt (const Eigen::Vector3d& eye, const Eigen::Vector3d& target);

  /** \return pixel (column, row) and depth in metres of a point of the world frame */
  Eigen::Vector3d project (const Eigen::Vector3d& point) const;
};

enum class ScenePattern
{
  plain,
  stripes,
  checker,
  print, /**< a printed label in the middle of each side */
  noise
};

/** \brief Colour of a surface. The pattern is fixed to the object: it is evaluated in its coordinates. */
struct SceneMaterial
{
  ScenePattern pattern = ScenePattern::plain;
  Eigen::Vector3d color{0.7, 0.7, 0.7};        /**< \brief red, green, blue in [0, 1] */
  Eigen::Vector3d second_color{0.3, 0.3, 0.3}; /**< \brief the pattern's other colour */
  double scale = 0.02;                         /**< \brief width of a stripe, a checker field, a blob; metres */
};

/** \brief Shapes, centred at the origin of the object's frame, their axis along z. */
enum class SceneShape
{
  plane,    /**< \brief the plane z = 0 out to 1 km, seen from both sides; has no size */
  box,      /**< \brief size = edge lengths */
  cylinder, /**< \brief size = diameter, diameter, length */
  sphere,   /**< \brief size = diameter, three times */
  bowl,     /**< \brief open at +z: a zone of a spherical shell on a flat foot; size = diameter at the rim (twice),
             * height; not higher than half the diameter, or the rim would turn inwards */
  mug /**< \brief open at +z: size = diameter, diameter, height without the handle, which is built of bars at +x */
};

struct SceneObject
{
  SceneShape shape = SceneShape::box;
  Eigen::Vector3d size{0.1, 0.1, 0.1};                     /**< \brief extent along the object's x, y and z, metres */
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity (); /**< \brief object to world, metres */
  double wall_thickness = 0.004;                           /**< \brief of bowls and mugs, metres */
  SceneMaterial material;
  std::uint32_t label = scene_label::first_object;

  /** \brief Corners of the box around the object, handle included, in the object's frame, metres. */
  Eigen::AlignedBox3d bounds () const;

  /** \return how far a mug's handle reaches out of the wall, metres; 0 for other shapes */
  double
  handleReach () const
  {
    return (shape == SceneShape::mug ? 0.35 * size.x () : 0.0);
  }

  /** \return height of the centre of a bowl's spheres in the object's frame; its outer sphere has the radius
   * bowlCenter () + (size.z () + wall_thickness) / 2, its inner sphere wall_thickness less; metres */
  double bowlCenter () const;
};

/** \brief Whose noise a scene is rendered with. */
enum class SceneSensor
{
  kinect, /**< \brief structured light: noise of a few pixels' width and steps, see SensorNoise */
  stereo  /**< \brief active stereo behind the filters it is shipped with: smooth waves instead of noise, and creases and
           * small steps are smoothed away, see SensorNoise */
};

/** \return the sensor of that name, "kinect" or "stereo", nothing where there is none */
std::optional<SceneSensor> sceneSensorFromName (const std::string& name);

/** \brief What a sensor adds to the scene. Every component can be switched off on its own. Of a Kinect:
 *
 * - axial: noise along the ray, Gaussian in disparity. Together with the quantization its standard deviation on a wall
 *   facing the camera is 1.425e-3 z^2 metres: half a disparity unit of (m / fb) = 2.85e-3 per metre [1]. Slanted
 *   surfaces add 1e-4 / sqrt (z) * (a / (pi/2 - a))^2 metres [2], a being the angle between ray and normal.
 * - quantization: of the disparity in steps of 1/8 pixel, which is the same unit of 2.85e-3 per metre [1].
 * - lateral: depth edges wobble with a standard deviation of 0.8 pixels [2].
 * - shadows: no depth where the projector, 7.5 cm to the right of the camera, does not reach.
 * - grazing_holes: no depth where the ray grazes the surface, at about 80 degrees.
 * - edge_holes: random holes along depth edges.
 * - color: noise of the colour camera, 2 grey levels.
 *
 * All but the colour's noise is correlated over about 3 pixels, as the Kinect's is by its correlation window.
 *
 * Of a stereo camera, where it differs:
 * - axial: Gaussian in disparity, 3e-3 per metre in 1 / z, correlated over some 10 pixels.
 * - smoothing: 1 / z is smoothed with the same window, except across jumps of more than 0.024 per metre (5/8 pixel of
 *   disparity at a baseline of 5 cm: 15 mm at 0.8 m).
 * - quantization: of the depth, in millimetres.
 * - shadows: the second camera stands 5 cm to the right.
 * Window and deviation are those at which second differences of 1 / z on a plane, taken over 2 to 16 pixels, are as
 * large as in recordings of an Intel RealSense D4xx.
 *
 * [1] K. Khoshelham, S. O. Elberink: Accuracy and Resolution of Kinect Depth Data for Indoor Mapping Applications.
 *     Sensors 12, 2012.
 * [2] C. V. Nguyen, S. Izadi, D. Lovell: Modeling Kinect Sensor Noise for Improved 3D Reconstruction and Tracking.
 *     3DIMPVT 2012. */
struct SensorNoise
{
  SceneSensor sensor = SceneSensor::kinect;
  double level = 1.0; /**< \brief 0 (exact) to 3; scales noise and steps; shadows and smoothing are just there above 0 */
  bool axial = true, quantization = true, lateral = true, shadows = true, grazing_holes = true, edge_holes = true,
       color = true, smoothing = true;

  static constexpr double max_level = 3.0;
  static constexpr double disparity_unit = 2.85e-3;   /**< \brief a Kinect's step in 1 / z, 1 / metres */
  static constexpr double stereo_deviation = 3e-3;    /**< \brief of a stereo camera's 1 / z, 1 / metres */
  static constexpr double stereo_jump = 0.024;        /**< \brief in 1 / z, that is not smoothed, 1 / metres */
  static constexpr double stereo_smoothing = 4.0;     /**< \brief length of each of the four recursions, pixels */

  /** \return from the camera to the projector, or to the second camera of a pair, metres */
  double
  baseline () const
  {
    return (sensor == SceneSensor::kinect ? 0.075 : 0.05);
  }

  /** \return standard deviation on a wall that faces the camera, with axial noise and quantization, metres
   * \param[in] depth metres */
  double
  axialDeviation (double depth) const
  {
    const double deviation = sensor == SceneSensor::kinect ? 0.5 * disparity_unit : stereo_deviation;
    return (level * deviation * depth * depth);
  }
};

/** \brief All that renderScene needs; plain data, to be made by makeScene, by hand, or both. */
struct SceneDescription
{
  SceneCamera camera;
  std::vector<SceneObject> supports;      /**< \brief table, floor and walls; labels below scene_label::first_object */
  std::vector<SceneObject> objects;       /**< \brief labels are multiples of 10, from scene_label::first_object */
  Eigen::Vector3d light{-0.6, -0.8, 1.8}; /**< \brief position of the lamp in the world frame, metres */
  SensorNoise noise;
  bool world_frame = false; /**< \brief the cloud is in the world frame, and its sensor pose is the camera's pose; else
                             * in the camera frame with the identity as sensor pose */
};

enum class SceneKind
{
  clutter,     /**< mixed objects, some touching, stacked or occluding each other */
  boxes,       /**< boxes only */
  stacked,     /**< stacks of boxes */
  occluded,    /**< pairs: a narrow object in front of a wide one, which is often split in two */
  cylinders,   /**< cylindric objects: cylinders upright and lying, bowls, mugs */
  separate,    /**< every object alone and un-occluded */
  empty_table, /**< a table without objects */
  wall,        /**< a bare wall */
  corner,      /**< corner of a room: two walls and the floor */
  single_box,
  single_cylinder,
  single_sphere,
  single_bowl,
  single_mug,
  filled /**< pairs: a bowl and what stands in it */
};

const std::vector<SceneKind>& allSceneKinds ();

/** \return the name as in the enumeration, e.g. "empty_table" */
std::string sceneKindName (SceneKind kind);

/** \return the kind of that name, nothing where there is none */
std::optional<SceneKind> sceneKindFromName (const std::string& name);

/** \brief A random scene of one kind. Objects stand on the table (world z = 0, z up), on or in another object, do not
 * penetrate each other and are whole inside the image; the Kinect looks down at 35 to 45 degrees from about 1 m.
 * \param[in] kind
 * \param[in] seed the same seed gives the same scene
 * \param[in] n_objects how many objects, 0 for as many as is usual for the kind; there are fewer where no more find
 * room within the image, and the kinds without objects and the single ones take no notice of it */
SceneDescription makeScene (SceneKind kind = SceneKind::clutter, std::uint64_t seed = 0, unsigned n_objects = 0);

} // namespace pcl_attention
