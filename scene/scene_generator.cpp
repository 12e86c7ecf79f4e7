// SPDX-License-Identifier: BSD-3-Clause
#include "counter_random.h"
#include "scene_description.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl_attention
{

namespace
{

using Eigen::AngleAxisd;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = 3.141592653589793;

struct KindName
{
  SceneKind kind;
  const char* name;
};

constexpr std::array<KindName, 15> kind_names{{{SceneKind::clutter, "clutter"},
                                               {SceneKind::boxes, "boxes"},
                                               {SceneKind::stacked, "stacked"},
                                               {SceneKind::occluded, "occluded"},
                                               {SceneKind::cylinders, "cylinders"},
                                               {SceneKind::separate, "separate"},
                                               {SceneKind::empty_table, "empty_table"},
                                               {SceneKind::wall, "wall"},
                                               {SceneKind::corner, "corner"},
                                               {SceneKind::single_box, "single_box"},
                                               {SceneKind::single_cylinder, "single_cylinder"},
                                               {SceneKind::single_sphere, "single_sphere"},
                                               {SceneKind::single_bowl, "single_bowl"},
                                               {SceneKind::single_mug, "single_mug"},
                                               {SceneKind::filled, "filled"}}};

/** \brief One random number after the other. */
class Random
{
public:
  Random (std::uint64_t seed, std::uint64_t stream) : random_ (seed, stream) {}

  double
  uniform (double low, double high)
  {
    return (low + (high - low) * random_.uniform (counter_++));
  }

  bool
  chance (double probability)
  {
    return (uniform (0.0, 1.0) < probability);
  }

  /** \return in [0, count) */
  std::size_t
  index (std::size_t count)
  {
    return (static_cast<std::size_t> (uniform (0.0, static_cast<double> (count))));
  }

private:
  CounterRandom random_;
  std::uint64_t counter_ = 0;
};

/** \brief What an object covers of the table: a rectangle with rounded corners, which is exact for a box, upright round
 * things (no rectangle at all) and a mug with its handle (a segment), and the heights it takes. */
struct Footprint
{
  Vector2d center, x_axis, half;
  double radius, bottom, top;

  explicit Footprint (const SceneObject& object)
  {
    const Eigen::AlignedBox3d bounds = object.bounds ();
    const Vector3d size = bounds.sizes ();
    const Eigen::Matrix3d rotation = object.pose.linear ();
    center = (object.pose * bounds.center ()).head<2> ();
    const double half_height = 0.5 * rotation.row (2).cwiseAbs ().dot (size);
    bottom = object.pose.translation ().z () - half_height;
    top = bottom + 2.0 * half_height;
    x_axis = rotation.col (0).head<2> ().normalized ();
    radius = 0.0;
    half = 0.5 * size.head<2> ();
    if (std::abs (rotation (2, 2)) < 0.5) // lying: the axis is horizontal
    {
      x_axis = rotation.col (2).head<2> ().normalized ();
      half = Vector2d (0.5 * size.z (), 0.5 * size.x ());
    }
    else if (object.shape != SceneShape::box)
    {
      radius = 0.5 * object.size.x ();
      half = Vector2d (0.5 * object.handleReach (), 0.0);
    }
  }

  std::array<Vector2d, 4>
  corners () const
  {
    const Vector2d x = half.x () * x_axis, y = half.y () * yAxis ();
    return {center + x + y, center + x - y, center - x - y, center - x + y};
  }

  Vector2d
  yAxis () const
  {
    return {-x_axis.y (), x_axis.x ()};
  }

  /** \return distance of a point from the rectangle */
  double
  distance (const Vector2d& point) const
  {
    const Vector2d d = point - center;
    const Vector2d outside (std::abs (d.dot (x_axis)) - half.x (), std::abs (d.dot (yAxis ())) - half.y ());
    return (outside.cwiseMax (0.0).norm ());
  }
};

/** \return distance of two objects as seen from above, at most 0 if they overlap there; infinite if one is above the
 * other */
double
gap (const Footprint& a, const Footprint& b)
{
  if (a.bottom > b.top - 1e-9 || b.bottom > a.top - 1e-9)
    return (std::numeric_limits<double>::infinity ());
  bool is_separable = false;
  for (const Vector2d& axis : {a.x_axis, a.yAxis (), b.x_axis, b.yAxis ()})
  {
    const auto extent = [&axis] (const Footprint& f) {
      return (f.half.x () * std::abs (axis.dot (f.x_axis)) + f.half.y () * std::abs (axis.dot (f.yAxis ())));
    };
    is_separable |= std::abs (axis.dot (a.center - b.center)) > extent (a) + extent (b);
  }
  if (!is_separable)
    return (-a.radius - b.radius);
  double distance = std::numeric_limits<double>::infinity ();
  for (const Vector2d& corner : a.corners ())
    distance = std::min (distance, b.distance (corner));
  for (const Vector2d& corner : b.corners ())
    distance = std::min (distance, a.distance (corner));
  return (distance - a.radius - b.radius);
}

class Generator
{
public:
  Generator (SceneKind kind, std::uint64_t seed) : kind_ (kind), random_ (seed, static_cast<std::uint64_t> (kind)) {}

  SceneDescription
  make (unsigned n_objects)
  {
    if (kind_ == SceneKind::wall || kind_ == SceneKind::corner)
    {
      buildRoom ();
      return (scene_);
    }
    buildTable ();
    if (kind_ == SceneKind::empty_table)
      return (scene_);
    if (isSingle ())
      n_objects = 1;
    else if (n_objects == 0)
      n_objects = usualNumber ();
    for (unsigned i = 0; i < n_objects; ++i)
      addObject (i);
    return (scene_);
  }

private:
  bool
  isSingle () const
  {
    return (kind_ >= SceneKind::single_box && kind_ <= SceneKind::single_mug);
  }

  unsigned
  usualNumber ()
  {
    if (kind_ == SceneKind::occluded || kind_ == SceneKind::filled) // pairs
      return (random_.chance (0.5) ? 6 : 8);
    const unsigned least = kind_ == SceneKind::clutter ? 8 : kind_ == SceneKind::separate ? 5 : 6;
    return (least + static_cast<unsigned> (random_.index (4)));
  }

  /** \brief A wall, or two walls and a floor. */
  void
  buildRoom ()
  {
    const Vector3d color = Vector3d (0.75, 0.73, 0.68) * random_.uniform (0.85, 1.15);
    addPlane (scene_label::wall, {0, 0, 0}, {0, -1, 0}, color);
    if (kind_ == SceneKind::wall)
    {
      const double distance = random_.uniform (0.9, 1.8);
      scene_.camera.lookAt ({random_.uniform (-0.3, 0.3) * distance, -distance, 1.2 + random_.uniform (-0.2, 0.2)},
                            {0, 0, 1.2});
    }
    else
    {
      addPlane (scene_label::second_wall, {0, 0, 0}, {-1, 0, 0}, 0.9 * color);
      addPlane (scene_label::floor, {0, 0, 0}, {0, 0, 1}, {0.45, 0.36, 0.28});
      scene_.camera.lookAt ({-random_.uniform (0.9, 1.5), -random_.uniform (0.9, 1.5), random_.uniform (0.8, 1.3)},
                            {0, 0, 0.15});
    }
    scene_.light = {-1.5, -2.0, 2.4};
  }

  /** \brief A table in front of a wall, its top at z = 0, and the camera. */
  void
  buildTable ()
  {
    static const std::array<std::array<Vector3d, 2>, 4> surfaces{
        {{Vector3d (0.66, 0.49, 0.33), Vector3d (0.56, 0.39, 0.25)},
         {Vector3d (0.82, 0.81, 0.79), Vector3d (0.78, 0.77, 0.75)},
         {Vector3d (0.47, 0.33, 0.24), Vector3d (0.39, 0.26, 0.18)},
         {Vector3d (0.52, 0.55, 0.57), Vector3d (0.48, 0.51, 0.53)}}};
    const auto& surface = surfaces[random_.index (surfaces.size ())];
    SceneObject table;
    table.label = scene_label::table;
    table.size = {random_.uniform (1.3, 1.7), random_.uniform (1.0, 1.2), 0.03};
    table.pose.translation ().z () = -0.5 * table.size.z ();
    table.material = {ScenePattern::noise, surface[0], surface[1], 0.03};
    scene_.supports.push_back (table);
    addPlane (scene_label::floor, {0, 0, -0.74}, {0, 0, 1}, {0.42, 0.41, 0.43});
    addPlane (scene_label::wall, {0, random_.uniform (0.75, 1.3), 0}, {0, -1, 0}, {0.72, 0.72, 0.68});

    const double pitch = random_.uniform (35.0, 45.0) * pi / 180.0, distance = random_.uniform (0.85, 1.05);
    scene_.camera.lookAt ({0, -distance * std::cos (pitch), distance * std::sin (pitch)}, {0, 0, 0});
    scene_.light = {random_.uniform (-1.2, 1.2), -0.8, 1.8};
  }

  void
  addPlane (std::uint32_t label, const Vector3d& point, const Vector3d& normal, const Vector3d& color)
  {
    SceneObject plane;
    plane.shape = SceneShape::plane;
    plane.label = label;
    plane.pose.linear () = Eigen::Quaterniond::FromTwoVectors (Vector3d::UnitZ (), normal).toRotationMatrix ();
    plane.pose.translation () = point;
    plane.material = {ScenePattern::noise, color, 0.95 * color, 0.15};
    scene_.supports.push_back (plane);
  }

  /** \brief Try places at random until the object has one; the longer it takes, the smaller it gets. */
  void
  addObject (unsigned number)
  {
    constexpr int max_attempts = 600;
    for (int attempt = 0; attempt < max_attempts; ++attempt)
    {
      SceneObject object = makeObject (number);
      const double shrink = 1.0 - 0.6 * attempt / max_attempts;
      object.size *= shrink;
      object.pose.translation () *= shrink; // its height above the table
      container_ = 0;
      place (object, number);
      if (!isPlaceFree (object))
        continue;
      object.material = makeMaterial (object.shape);
      object.label = scene_label::first_object + 10 * static_cast<std::uint32_t> (scene_.objects.size ());
      scene_.objects.push_back (object);
      return;
    }
  }

  SceneShape
  chooseShape (unsigned number)
  {
    static const std::array<SceneShape, 8> mixed{SceneShape::box,      SceneShape::box,      SceneShape::box,
                                                 SceneShape::cylinder, SceneShape::cylinder, SceneShape::bowl,
                                                 SceneShape::mug,      SceneShape::sphere};
    static const std::array<SceneShape, 5> round{SceneShape::cylinder, SceneShape::cylinder, SceneShape::cylinder,
                                                 SceneShape::bowl, SceneShape::mug};
    static const std::array<SceneShape, 4> contents{SceneShape::cylinder, SceneShape::cylinder, SceneShape::box, SceneShape::sphere};
    switch (kind_)
    {
    case SceneKind::boxes:
    case SceneKind::stacked:
    case SceneKind::single_box:
      return (SceneShape::box);
    case SceneKind::occluded:
      return (number % 2 == 0 || random_.chance (0.4) ? SceneShape::box : SceneShape::cylinder);
    case SceneKind::cylinders:
      return (round[random_.index (round.size ())]);
    case SceneKind::filled:
      return (number % 2 == 0 ? SceneShape::bowl : contents[random_.index (contents.size ())]);
    case SceneKind::single_cylinder:
      return (SceneShape::cylinder);
    case SceneKind::single_sphere:
      return (SceneShape::sphere);
    case SceneKind::single_bowl:
      return (SceneShape::bowl);
    case SceneKind::single_mug:
      return (SceneShape::mug);
    default:
      return (mixed[random_.index (mixed.size ())]);
    }
  }

  /** \brief An object of random size on the table's centre, turned as it is to stand or lie. */
  SceneObject
  makeObject (unsigned number)
  {
    SceneObject object;
    object.shape = chooseShape (number);
    auto& size = object.size;
    bool is_turned_over = false, is_lying = false;
    switch (object.shape)
    {
    case SceneShape::plane:
    case SceneShape::box:
      size = makeBox (number);
      break;
    case SceneShape::cylinder:
      if (kind_ == SceneKind::occluded)
        size << Vector2d::Constant (random_.uniform (0.045, 0.065)), random_.uniform (0.17, 0.25);
      else if (kind_ == SceneKind::filled)
        size << Vector2d::Constant (random_.uniform (0.04, 0.075)), random_.uniform (0.06, 0.14);
      else if (random_.chance (0.5)) // a tin
        size << Vector2d::Constant (random_.uniform (0.06, 0.10)), random_.uniform (0.06, 0.13);
      else // a bottle, a roll
        size << Vector2d::Constant (random_.uniform (0.04, 0.08)), random_.uniform (0.14, 0.26);
      is_lying = kind_ != SceneKind::occluded && kind_ != SceneKind::filled && random_.chance (0.3);
      break;
    case SceneShape::sphere:
      size.setConstant (random_.uniform (0.05, kind_ == SceneKind::filled ? 0.09 : 0.17));
      break;
    case SceneShape::bowl:
      size.head<2> ().setConstant (random_.uniform (0.12, 0.22));
      size.z () = size.x () * random_.uniform (0.3, 0.48);
      is_turned_over = kind_ != SceneKind::single_bowl && kind_ != SceneKind::filled && random_.chance (0.2);
      break;
    case SceneShape::mug:
      size << Vector2d::Constant (random_.uniform (0.07, 0.095)), random_.uniform (0.08, 0.115);
      is_turned_over = kind_ != SceneKind::single_mug && random_.chance (0.15);
      break;
    }
    // Occluded boxes face the camera, roughly: the pairs are to hide one another.
    const double turn = kind_ == SceneKind::occluded ? 0.25 : pi;
    object.pose.linear () = AngleAxisd (random_.uniform (-turn, turn), Vector3d::UnitZ ()).toRotationMatrix ();
    if (is_turned_over)
      object.pose.rotate (AngleAxisd (pi, Vector3d::UnitX ()));
    if (is_lying)
      object.pose.rotate (AngleAxisd (0.5 * pi, Vector3d::UnitX ()));
    object.pose.translation ().z () = 0.5 * (is_lying ? size.x () : size.z ());
    return (object);
  }

  Vector3d
  makeBox (unsigned number)
  {
    if (kind_ == SceneKind::occluded)
    {
      if (number % 2 == 0) // wide and low, to stand behind
        return {random_.uniform (0.18, 0.26), random_.uniform (0.04, 0.06), random_.uniform (0.06, 0.09)};
      return {random_.uniform (0.045, 0.065), random_.uniform (0.03, 0.05), random_.uniform (0.17, 0.25)};
    }
    if (kind_ == SceneKind::filled)
      return {random_.uniform (0.03, 0.07), random_.uniform (0.03, 0.05), random_.uniform (0.06, 0.12)};
    if (kind_ == SceneKind::stacked)
      return {random_.uniform (0.12, 0.24), random_.uniform (0.10, 0.18), random_.uniform (0.04, 0.11)};
    switch (random_.index (4))
    {
    case 0: // a book
      return {random_.uniform (0.13, 0.20), random_.uniform (0.18, 0.26), random_.uniform (0.02, 0.045)};
    case 1: // a packet of cereals
      return {random_.uniform (0.13, 0.20), random_.uniform (0.05, 0.08), random_.uniform (0.18, 0.28)};
    case 2: // a small one
      return {random_.uniform (0.05, 0.09), random_.uniform (0.04, 0.07), random_.uniform (0.04, 0.10)};
    default: // a carton
      return {random_.uniform (0.09, 0.17), random_.uniform (0.08, 0.15), random_.uniform (0.08, 0.17)};
    }
  }

  SceneMaterial
  makeMaterial (SceneShape shape)
  {
    static const std::array<Vector3d, 12> palette{
        Vector3d (0.80, 0.13, 0.12), Vector3d (0.12, 0.28, 0.66), Vector3d (0.15, 0.50, 0.22),
        Vector3d (0.92, 0.75, 0.14), Vector3d (0.90, 0.46, 0.11), Vector3d (0.92, 0.91, 0.88),
        Vector3d (0.14, 0.14, 0.16), Vector3d (0.44, 0.70, 0.84), Vector3d (0.64, 0.46, 0.28),
        Vector3d (0.52, 0.20, 0.48), Vector3d (0.86, 0.58, 0.62), Vector3d (0.35, 0.40, 0.34)};
    const bool is_dish = shape == SceneShape::bowl || shape == SceneShape::mug;
    SceneMaterial material;
    if (!random_.chance (is_dish ? 0.6 : 0.3))
      material.pattern = static_cast<ScenePattern> (1 + random_.index (4));
    const std::size_t first = random_.index (palette.size ());
    material.color = palette[first] * random_.uniform (0.85, 1.05);
    material.second_color = palette[(first + 1 + random_.index (palette.size () - 1)) % palette.size ()];
    material.scale = random_.uniform (0.01, 0.03);
    return (material);
  }

  void
  moveTo (SceneObject& object, const Vector2d& place)
  {
    object.pose.translation ().head<2> () = place;
  }

  /** \brief Move the object to a random place that suits the kind of scene; it may turn out to be taken. */
  void
  place (SceneObject& object, unsigned number)
  {
    const bool is_first = scene_.objects.empty ();
    if (kind_ == SceneKind::stacked && number % 3 != 0 && !is_first)
      placeOn (object, scene_.objects.back ());
    else if (kind_ == SceneKind::occluded && number % 2 != 0 && !is_first)
      placeInFrontOf (object, scene_.objects.back ());
    else if (kind_ == SceneKind::filled && number % 2 != 0 && !is_first)
      placeIn (object, scene_.objects.back ());
    else if (kind_ == SceneKind::clutter && !is_first && random_.chance (0.15))
      placeOn (object, scene_.objects[random_.index (scene_.objects.size ())]);
    else if (kind_ != SceneKind::separate && kind_ != SceneKind::occluded && !is_first && random_.chance (0.5))
      placeBeside (object, scene_.objects[random_.index (scene_.objects.size ())]);
    else if (isSingle ())
      moveTo (object, {random_.uniform (-0.08, 0.08), random_.uniform (-0.08, 0.08)});
    else if (kind_ == SceneKind::clutter)
      moveTo (object, {random_.uniform (-0.35, 0.35), random_.uniform (-0.32, 0.28)});
    else
      moveTo (object, {random_.uniform (-0.5, 0.5), random_.uniform (-0.38, 0.42)});
  }

  /** \brief On top of a box, near its centre; elsewhere than on a box nothing would stay. */
  void
  placeOn (SceneObject& object, const SceneObject& below)
  {
    const double x = random_.uniform (-0.15, 0.15) * below.size.x (),
                 y = random_.uniform (-0.15, 0.15) * below.size.y ();
    const double turn = random_.uniform (-0.3, 0.3);
    const bool is_too_large =
        std::min (object.size.x (), object.size.y ()) > 0.95 * std::min (below.size.x (), below.size.y ()) ||
        std::max (object.size.x (), object.size.y ()) > 0.95 * std::max (below.size.x (), below.size.y ());
    if (below.shape != SceneShape::box || object.shape == SceneShape::sphere || is_too_large)
    {
      moveTo (object, below.pose.translation ().head<2> ()); // where it does not fit, as the caller will find
      return;
    }
    if (object.shape == SceneShape::box)
    {
      object.pose.linear () = below.pose.linear () * AngleAxisd (turn, Vector3d::UnitZ ());
      if ((object.size.x () > object.size.y ()) != (below.size.x () > below.size.y ()))
        object.pose.rotate (AngleAxisd (0.5 * pi, Vector3d::UnitZ ()));
    }
    const Vector3d top = below.pose * Vector3d (x, y, 0.5 * below.size.z ());
    moveTo (object, top.head<2> ());
    object.pose.translation ().z () += top.z ();
  }

  /** \brief Upright in the middle of a bowl, as deep as its inner sphere lets it; not in another thing, nor where it is too wide. */
  void
  placeIn (SceneObject& object, const SceneObject& bowl)
  {
    moveTo (object, bowl.pose.translation ().head<2> ());
    const bool is_round = object.shape == SceneShape::sphere;
    const double inner = bowl.bowlCenter () + 0.5 * (bowl.size.z () - bowl.wall_thickness);
    const double radius = 0.5 * (object.shape == SceneShape::box ? object.size.head<2> ().norm () : object.size.x ());
    if (bowl.shape != SceneShape::bowl || radius > 0.6 * 0.5 * bowl.size.x ())
      return; // where it does not fit, as the caller will find
    const double bottom = bowl.bowlCenter () - (is_round ? inner : std::sqrt (inner * inner - radius * radius));
    object.pose.translation ().z () = bowl.pose.translation ().z () + bottom + 0.5 * object.size.z ();
    container_ = bowl.label;
  }

  /** \brief Towards the camera, with a narrow gap, a little to the side. */
  void
  placeInFrontOf (SceneObject& object, const SceneObject& behind)
  {
    const Vector2d from = behind.pose.translation ().head<2> ();
    const Vector2d to_camera = (scene_.camera.pose.translation ().head<2> () - from).normalized ();
    const Vector2d aside (-to_camera.y (), to_camera.x ());
    touch (object, behind, from + random_.uniform (-0.03, 0.03) * aside, to_camera, random_.uniform (0.01, 0.03));
  }

  /** \brief In any direction, touching or nearly so. */
  void
  placeBeside (SceneObject& object, const SceneObject& neighbor)
  {
    const double angle = random_.uniform (-pi, pi);
    touch (object, neighbor, neighbor.pose.translation ().head<2> (), {std::cos (angle), std::sin (angle)},
           random_.chance (0.5) ? contact_gap : random_.uniform (contact_gap, 0.02));
  }

  /** \brief Bisect the place along a direction where two objects are a given distance apart. */
  void
  touch (SceneObject& object, const SceneObject& neighbor, const Vector2d& start, const Vector2d& direction,
         double distance)
  {
    double near = 0.0, far = 0.6;
    for (int i = 0; i < 40; ++i)
    {
      const double middle = 0.5 * (near + far);
      moveTo (object, start + middle * direction);
      (gap (Footprint (object), Footprint (neighbor)) < distance ? near : far) = middle;
    }
    moveTo (object, start + far * direction);
  }

  bool
  isPlaceFree (const SceneObject& object) const
  {
    const Footprint footprint (object);
    const bool is_separate = kind_ == SceneKind::separate;
    for (const SceneObject& other : scene_.objects)
      if (other.label != container_ && gap (footprint, Footprint (other)) < (is_separate ? 0.03 : 0.999 * contact_gap))
        return (false);

    const Vector2d edge = 0.5 * scene_.supports.front ().size.head<2> () - Vector2d::Constant (0.01 + footprint.radius);
    for (const Vector2d& corner : footprint.corners ())
      if ((corner.cwiseAbs ().array () > edge.array ()).any ())
        return (false);

    const Eigen::AlignedBox2d image (Vector2d (10, 10), Vector2d (scene_.camera.width - 11, scene_.camera.height - 11));
    const Eigen::AlignedBox2d view = imageBounds (object);
    return (image.contains (view) && (!is_separate || std::none_of (scene_.objects.begin (), scene_.objects.end (),
                                                                    [&] (const SceneObject& other) {
                                                                      return (view.intersects (imageBounds (other)));
                                                                    })));
  }

  Eigen::AlignedBox2d
  imageBounds (const SceneObject& object) const
  {
    Eigen::AlignedBox2d view;
    const Eigen::AlignedBox3d bounds = object.bounds ();
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vector3d point = bounds.corner (static_cast<Eigen::AlignedBox3d::CornerType> (corner));
      view.extend (Vector2d (scene_.camera.project (object.pose * point).head<2> ()));
    }
    return (view);
  }

  static constexpr double contact_gap = 5e-4; // metres; what touches still is two things

  SceneKind kind_;
  Random random_;
  SceneDescription scene_;
  std::uint32_t container_{0}; /**< label of the bowl that the object to be placed stands in, 0: in none */
};

} // namespace

const std::vector<SceneKind>&
allSceneKinds ()
{
  static const std::vector<SceneKind> kinds = [] {
    std::vector<SceneKind> all;
    for (const KindName& entry : kind_names)
      all.push_back (entry.kind);
    return (all);
  }();
  return (kinds);
}

std::string
sceneKindName (SceneKind kind)
{
  return (kind_names[static_cast<std::size_t> (kind)].name);
}

std::optional<SceneKind>
sceneKindFromName (const std::string& name)
{
  for (const KindName& entry : kind_names)
    if (name == entry.name)
      return (entry.kind);
  return (std::nullopt);
}

std::optional<SceneSensor>
sceneSensorFromName (const std::string& name)
{
  if (name == "kinect")
    return (SceneSensor::kinect);
  if (name == "stereo")
    return (SceneSensor::stereo);
  return (std::nullopt);
}

SceneDescription
makeScene (SceneKind kind, std::uint64_t seed, unsigned n_objects)
{
  return (Generator (kind, seed).make (n_objects));
}

} // namespace pcl_attention
