// SPDX-License-Identifier: BSD-3-Clause
#include "frame.h"
#include <pcl_attention/version.h>

#include <memory>
#include <mutex>
#include <pybind11/stl.h>

namespace py = pybind11;
using namespace pcl_attention;

namespace
{

/** \brief An array that looks at values of an object, which it keeps alive. */
template <typename T>
py::array_t<T>
viewOf (const T* values, std::vector<py::ssize_t> shape, const py::object& owner)
{
  py::array_t<T> array (std::move (shape), values, owner);
  array.attr ("setflags") (py::arg ("write") = false);
  return (array);
}

template <int size>
py::array_t<float>
arrayOf (const Eigen::Matrix<float, size, 1>& vector)
{
  return (py::array_t<float> (size, vector.data ()));
}

/** \brief An object together with the points it was found in. */
struct Segment
{
  AttentionSegment data;
  Points points;

  py::array_t<bool>
  mask () const
  {
    py::array_t<bool> mask ({points.shape (0), points.shape (1)});
    std::fill_n (mask.mutable_data (), mask.size (), false);
    for (const pcl::index_t index : data.indices)
      mask.mutable_data ()[index] = true;
    return (mask);
  }

  py::array_t<float>
  pointsOf () const
  {
    py::array_t<float> selected ({static_cast<py::ssize_t> (data.indices.size ()), py::ssize_t{3}});
    const auto at = points.unchecked<3> ();
    float* output = selected.mutable_data ();
    for (const pcl::index_t index : data.indices)
      for (py::ssize_t axis = 0; axis < 3; ++axis)
        *output++ = at (index / at.shape (1), index % at.shape (1), axis);
    return (selected);
  }
};

/** \brief Everything that was found in a frame. */
struct Segmentation
{
  std::vector<std::shared_ptr<Segment>> segments;
  std::vector<std::shared_ptr<SupportingPlane>> supporting_planes;
  StageTimes times;
  int width{0}, height{0};

  py::array_t<std::int32_t>
  labels () const
  {
    py::array_t<std::int32_t> labels ({height, width});
    std::fill_n (labels.mutable_data (), labels.size (), 0);
    for (auto segment = segments.rbegin (); segment != segments.rend (); ++segment)
      for (const pcl::index_t index : (*segment)->data.indices)
        labels.mutable_data ()[index] = (*segment)->data.rank;
    return (labels);
  }
};

/** \brief The objects of a frame one by one. */
struct SegmentIterator
{
  Frame frame;
  std::mutex executing{};

  std::shared_ptr<Segment>
  next ()
  {
    // Another thread may come while this one computes without the interpreter's lock: refused as by a generator.
    const std::unique_lock<std::mutex> lock (executing, std::try_to_lock);
    if (!lock)
      throw py::value_error ("iterator already executing");
    const auto segment = std::make_shared<Segment> ();
    bool found = false;
    {
      const py::gil_scoped_release released;
      found = frame.pipeline.next (segment->data);
    }
    if (!found)
      throw py::stop_iteration ();
    segment->points = frame.points;
    return (segment);
  }
};

std::unique_ptr<SegmentIterator>
iterate (const Points& xyz, const py::kwargs& arguments)
{
  return (std::unique_ptr<SegmentIterator> (new SegmentIterator{{xyz, arguments}}));
}

Segmentation
segment (const Points& xyz, const py::kwargs& arguments)
{
  Frame frame (xyz, arguments);
  Segmentation result;
  result.width = frame.width;
  result.height = frame.height;
  std::vector<AttentionSegment> segments;
  {
    const py::gil_scoped_release released;
    for (AttentionSegment next; frame.pipeline.next (next);)
      segments.push_back (std::move (next));
    result.times = frame.pipeline.times ();
    for (const SupportingPlane& plane : frame.pipeline.supportingPlanes ())
      result.supporting_planes.push_back (std::make_shared<SupportingPlane> (plane));
  }
  for (AttentionSegment& found : segments)
    result.segments.push_back (std::make_shared<Segment> (Segment{std::move (found), frame.points}));
  return (result);
}

py::array_t<float>
saliency (const Points& xyz, const py::kwargs& arguments)
{
  Frame frame (xyz, arguments);
  {
    const py::gil_scoped_release released;
    frame.pipeline.saliency ();
  }
  return (py::array_t<float> ({frame.height, frame.width}, frame.pipeline.saliency ().saliency.data.data ()));
}

std::vector<AttentionPoint>
attentionPoints (const Points& xyz, const py::kwargs& arguments)
{
  Frame frame (xyz, arguments);
  const py::gil_scoped_release released;
  return (frame.pipeline.attentionPoints ().points);
}

py::array_t<std::int32_t>
patches (const Points& xyz, const py::kwargs& arguments)
{
  Frame frame (xyz, arguments);
  {
    const py::gil_scoped_release released;
    frame.pipeline.patches ();
  }
  return (py::array_t<std::int32_t> ({frame.height, frame.width}, frame.pipeline.patches ().labels.data.data ()));
}

py::object
valueOf (const ParameterDescription& row, const AttentionParameters& parameters)
{
  static const std::vector<std::string> off_and_on{"off", "on"};
  const double value = row.get (parameters);
  if (row.choices == off_and_on)
    return (py::bool_ (value != 0.0));
  if (!row.choices.empty ())
    return (py::str (row.toString (parameters)));
  if (row.integer)
    return (py::int_ (static_cast<long> (value)));
  // 0.1 instead of the 0.10000000149 of a float; read by Python, which unlike std::stod does not follow the locale.
  return (py::float_ (py::str (row.toString (parameters))));
}

py::dict
parameters (const py::kwargs& arguments)
{
  py::dict values;
  const AttentionParameters parameters = parametersOf (arguments);
  for (const ParameterDescription& row : parameterTable ())
    values[py::str (row.name)] = valueOf (row, parameters);
  return (values);
}

constexpr const char* segment_documentation = R"(Segment every object of a frame, in order of attention.

xyz: (height, width, 3), float32, metres in the camera's frame (x right, y down, z forward), NaN for holes. Any memory
  layout is read in place; other types are converted first.
rgb: (height, width, 3), uint8; without it the colour constraint is off.
mask: (height, width), bool: points that are not True count as holes.
sensor_origin, sensor_orientation: the camera's pose (x, y, z; w, x, y, z) where xyz is in another frame.
saliency: (height, width), from 0 up: used instead of 2.5D symmetry.
fixations: pairs of column and row to look at first, in this order, instead of those of the saliency.
prior_map, prior_region, prior_box, prior_color, prior_color_exemplar, prior_size, prior_distance: what is asked for
  comes first, nothing is left out; those that are given multiply, and given fixations keep their order.
  map: (height, width), 0..1 or bool. region: column, row, width, height in pixels. box: its smaller and its larger
  corner, metres, where xyz is. color: red, green, blue in 0..255, or a name like 'red'. color_exemplar: (n, 3), uint8,
  the colours of an example. size: smallest and largest length, metres. distance: the same, from the viewpoint.
threads: 0 takes all processors. The result does not depend on it.
preset: 'default' or 'paper'.
parts: visible pieces instead of whole objects.
parameters: any of pcl_attention.parameters ().

The interpreter's lock is released. Raises ValueError or TypeError that says what is wrong.)";

} // namespace

PYBIND11_MODULE (_core, module)
{
  module.attr ("__version__") = PCL_ATTENTION_VERSION;

  py::class_<AttentionPoint> (module, "AttentionPoint", "A fixation: where to look, and why.")
      .def_readonly ("column", &AttentionPoint::column, "pixels from 0")
      .def_readonly ("row", &AttentionPoint::row, "pixels from 0")
      .def_readonly ("saliency", &AttentionPoint::saliency, "mean of its component, 0..1 (paper eq. 10)")
      .def_readonly ("point_saliency", &AttentionPoint::point_saliency, "at the point itself, 0..1")
      .def_property_readonly (
          "kind", [] (const AttentionPoint& point) { return (toString (point.kind)); },
          "'junction', 'midpoint', 'winner', 'coverage' or 'user'")
      .def ("__repr__", [] (const AttentionPoint& point) {
        return ("<AttentionPoint column=" + std::to_string (point.column) + " row=" + std::to_string (point.row) + " " +
                toString (point.kind) + ">");
      });

  py::class_<SupportingPlane, std::shared_ptr<SupportingPlane>> (module, "SupportingPlane",
                                                                 "A plane that objects stand on, or of the background.")
      .def_property_readonly (
          "coefficients", [] (const SupportingPlane& plane) { return (arrayOf<4> (plane.coefficients)); },
          "a, b, c, d of ax + by + cz + d = 0: unit normal towards the viewpoint, metres")
      .def_property_readonly (
          "indices",
          [] (const py::object& self) {
            const auto& indices = self.cast<const SupportingPlane&> ().indices;
            return (viewOf (indices.data (), {static_cast<py::ssize_t> (indices.size ())}, self));
          },
          "of its points, row by row, ascending: (n,), int32")
      .def_readonly ("area", &SupportingPlane::area, "square metres")
      .def_readonly ("confidence", &SupportingPlane::confidence, "0..1")
      .def_readonly ("supports_objects", &SupportingPlane::supports_objects,
                     "False for other planes of the background");

  py::class_<Segment, std::shared_ptr<Segment>> (module, "Segment", "One object: what was found at a fixation.")
      .def_property_readonly (
          "rank", [] (const Segment& segment) { return (segment.data.rank); }, "1, 2, ... in order of attention")
      .def_property_readonly (
          "indices",
          [] (const py::object& self) {
            const auto& indices = self.cast<const Segment&> ().data.indices;
            return (viewOf (indices.data (), {static_cast<py::ssize_t> (indices.size ())}, self));
          },
          "of its points, row by row, ascending: (n,), int32; a view")
      .def_property_readonly ("mask", &Segment::mask, "True on it: (height, width), bool; made anew at every access")
      .def_property_readonly ("points", &Segment::pointsOf,
                              "its points of xyz: (n, 3), float32, metres; made anew at every access")
      .def_property_readonly (
          "attention_point", [] (const Segment& segment) { return (segment.data.attention_point); },
          "the fixation it grew from")
      .def_property_readonly (
          "plane", [] (const Segment& segment) { return (arrayOf<4> (segment.data.plane)); },
          "of the patch at the fixation: a, b, c, d, towards the viewpoint, metres")
      .def_property_readonly (
          "box_center", [] (const Segment& segment) { return (arrayOf<3> (segment.data.box.center)); },
          "of the oriented box, metres")
      .def_property_readonly (
          "box_orientation",
          [] (const Segment& segment) {
            const Eigen::Quaternionf& q = segment.data.box.orientation;
            return (arrayOf<4> ({q.w (), q.x (), q.y (), q.z ()}));
          },
          "w, x, y, z: from the box's axes to those of xyz")
      .def_property_readonly (
          "box_size", [] (const Segment& segment) { return (arrayOf<3> (segment.data.box.size)); },
          "along the box's axes, metres")
      .def_property_readonly (
          "compactness", [] (const Segment& segment) { return (segment.data.compactness); },
          "kappa, metres (paper eq. 13)")
      .def_property_readonly (
          "confidence", [] (const Segment& segment) { return (segment.data.confidence); },
          "0..1: share of the outline where the object ends for a reason")
      .def_property_readonly (
          "patches", [] (const Segment& segment) { return (segment.data.patches); },
          "labels of its patches, in the order they were added")
      .def_property_readonly (
          "growth_end", [] (const Segment& segment) { return (toString (segment.data.growth_end)); },
          "the constraint that refused the neighbour with the longest border")
      .def ("__repr__", [] (const Segment& segment) {
        return ("<Segment rank=" + std::to_string (segment.data.rank) + " of " +
                std::to_string (segment.data.indices.size ()) + " points>");
      });

  py::class_<Segmentation> (module, "Segmentation", "The objects of a frame, a sequence of Segment.")
      .def_readonly ("segments", &Segmentation::segments, "in order of attention")
      .def_readonly ("supporting_planes", &Segmentation::supporting_planes,
                     "the one that objects stand on first, if any")
      .def_property_readonly ("labels", &Segmentation::labels,
                              "0, or the rank of the first segment that claims the point: (height, width), int32")
      .def_property_readonly (
          "milliseconds",
          [] (const Segmentation& result) {
            const StageTimes& times = result.times;
            py::dict milliseconds;
            milliseconds["normals"] = times.normals;
            milliseconds["saliency"] = times.saliency;
            milliseconds["attention_points"] = times.attention_points;
            milliseconds["patches"] = times.patches;
            milliseconds["segmentation"] = times.segmentation;
            milliseconds["total"] = times.total ();
            return (milliseconds);
          },
          "computing time of every stage and the total")
      .def ("__len__", [] (const Segmentation& result) { return (result.segments.size ()); })
      .def ("__getitem__", [] (const Segmentation& result,
                               const py::object& index) { return (py::object (py::cast (result.segments)[index])); })
      .def ("__iter__", [] (const Segmentation& result) { return (py::iter (py::cast (result.segments))); });

  py::class_<SegmentIterator> (module, "_SegmentIterator")
      .def ("__iter__", [] (const py::object& self) { return (self); })
      .def ("__next__", &SegmentIterator::next);

  const auto with_colors = [] (auto function) {
    return ([function] (const Points& xyz, const py::object& rgb, py::kwargs arguments) {
      arguments["rgb"] = rgb;
      return (function (xyz, arguments));
    });
  };
  module.def ("segment", with_colors (&segment), py::arg ("xyz"), py::arg ("rgb") = py::none (), segment_documentation);
  module.def ("iterate", with_colors (&iterate), py::arg ("xyz"), py::arg ("rgb") = py::none (),
              "The segments one by one, the most salient first: each is computed when it is asked for. Arguments as of "
              "segment ().");
  module.def (
      "saliency", with_colors (&saliency), py::arg ("xyz"), py::arg ("rgb") = py::none (),
      "The saliency map of 2.5D symmetry: (height, width), float32, 0..1 (paper III-A and III-B). Arguments as of "
      "segment ().");
  module.def ("attention_points", with_colors (&attentionPoints), py::arg ("xyz"), py::arg ("rgb") = py::none (),
              "Where to look: the attention points in order of saliency (paper III-C). Arguments as of segment ().");
  module.def ("patches", with_colors (&patches), py::arg ("xyz"), py::arg ("rgb") = py::none (),
              "The planar patches that segments are grown from, cut along the planes of the background: labels 1, 2, ... "
              "or 0, (height, width), int32 (paper IV-A). Arguments as of segment ().");
  module.def ("parameters", &parameters,
              "The parameters of all stages by name with their values in a preset. Arguments: preset, parts and any of "
              "the parameters.");
}
