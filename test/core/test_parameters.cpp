// SPDX-License-Identifier: BSD-3-Clause
// The one table that flags, help and JSON are made from.
#include <pcl_attention/core/parameters.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

using namespace pcl_attention;

namespace
{

const ParameterDescription&
rowOf (const std::string& name)
{
  for (const ParameterDescription& row : parameterTable ())
    if (row.name == name)
      return (row);
  throw std::out_of_range (name);
}

/** \brief A value inside the range, other than the given one. */
double
otherValue (const ParameterDescription& row, double value)
{
  double other = value != row.minimum ? row.minimum : row.maximum;
  if (!row.integer)
    other = 0.25 * row.minimum + 0.75 * row.maximum;
  return (other);
}

} // namespace

TEST (ParameterTable, RowsAreCompleteAndTheirNamesUnique)
{
  const std::set<std::string> stages{"normals",     "saliency", "attention_points", "image_symmetry", "patches",
                                     "patch_graph", "support",  "clustering",       "segmentation"};
  const std::set<std::string> units{"m", "pixels", "1/m", "radians", "share", "m^2", "cells", ""};
  std::set<std::string> names;
  for (const ParameterDescription& row : parameterTable ())
  {
    SCOPED_TRACE (row.name);
    EXPECT_TRUE (names.insert (row.name).second) << "twice";
    EXPECT_EQ (row.name.find_first_not_of ("abcdefghijklmnopqrstuvwxyz_0123456789"), std::string::npos);
    EXPECT_TRUE (stages.count (row.stage)) << row.stage;
    EXPECT_TRUE (units.count (row.unit)) << row.unit;
    EXPECT_FALSE (row.help.empty ());
    EXPECT_LT (row.minimum, row.maximum + (row.choices.size () == 1 ? 1.0 : 0.0));
    if (!row.choices.empty ())
    {
      EXPECT_TRUE (row.integer);
      EXPECT_EQ (row.minimum, 0.0);
      EXPECT_EQ (row.maximum, static_cast<double> (row.choices.size ()) - 1.0);
      EXPECT_EQ (std::set<std::string> (row.choices.begin (), row.choices.end ()).size (), row.choices.size ());
    }
  }
  EXPECT_GT (names.size (), 30u);
}

TEST (ParameterTable, DefaultsAndThePapersPresetAreInRange)
{
  EXPECT_EQ (validate (AttentionParameters ()), "");
  EXPECT_EQ (validate (AttentionParameters::paper ()), "");
}

TEST (ParameterTable, EveryRowReadsAndWritesAFieldOfItsOwn)
{
  const AttentionParameters defaults;
  for (const ParameterDescription& row : parameterTable ())
  {
    SCOPED_TRACE (row.name);
    if (row.minimum == row.maximum)
      continue;
    AttentionParameters changed;
    const double value = otherValue (row, row.get (defaults));
    row.set (changed, value);
    EXPECT_NEAR (row.get (changed), value, 1e-6 * std::abs (value));
    for (const ParameterDescription& other : parameterTable ())
      if (other.name != row.name)
      {
        EXPECT_EQ (other.get (changed), other.get (defaults)) << "changes " << other.name << " as well";
      }
  }
}

TEST (ParameterTable, TextIsReadBackAsItWasWritten)
{
  for (const ParameterDescription& row : parameterTable ())
  {
    SCOPED_TRACE (row.name);
    for (const double value : {row.minimum, row.maximum, otherValue (row, row.minimum)})
    {
      AttentionParameters written, read;
      row.set (written, row.integer ? std::floor (value) : value);
      EXPECT_EQ (row.parse (row.toString (written), read), "") << row.toString (written);
      EXPECT_EQ (row.get (read), row.get (written)) << row.toString (written);
    }
    for (const std::string& choice : row.choices)
    {
      AttentionParameters parameters;
      EXPECT_EQ (row.parse (choice, parameters), "");
      EXPECT_EQ (row.toString (parameters), choice);
    }
  }
}

TEST (ParameterTable, EveryFloatIsReadBackExactly)
{
  const ParameterDescription& row = rowOf ("patch_reassign_distance");
  AttentionParameters written, read;
  for (float value = 0.1f; value < 0.1002f; value = std::nextafter (value, 1.0f))
  {
    row.set (written, value);
    EXPECT_EQ (row.parse (row.toString (written), read), "");
    EXPECT_EQ (row.get (read), row.get (written)) << row.toString (written);
  }
  EXPECT_EQ (row.parse ("0.0001", written), "");
  EXPECT_EQ (row.toString (written), "0.0001");
  EXPECT_EQ (rowOf ("coverage_size").parse ("10000000", written), "");
  EXPECT_EQ (rowOf ("coverage_size").toString (written), "10000000");
}

TEST (ParameterTable, ValuesByHand)
{
  AttentionParameters parameters;
  EXPECT_EQ (rowOf ("window_radius").parse ("5", parameters), "");
  EXPECT_EQ (parameters.saliency.window_radius, 5);
  EXPECT_EQ (rowOf ("compactness_threshold").parse ("0.0075", parameters), "");
  EXPECT_FLOAT_EQ (parameters.clustering.compactness_threshold, 0.0075f);
  EXPECT_EQ (rowOf ("convexity_gate").parse ("off", parameters), "");
  EXPECT_FALSE (parameters.saliency.convexity_gate);
  EXPECT_EQ (rowOf ("color_constraint").parse ("as_printed", parameters), "");
  EXPECT_EQ (parameters.clustering.color_constraint, ColorConstraint::as_printed);
  EXPECT_EQ (rowOf ("initial_patches").parse ("within_radius", parameters), "");
  EXPECT_EQ (parameters.clustering.initial_patches, InitialPatches::within_radius);
  EXPECT_EQ (rowOf ("plane_model").parse ("initial", parameters), "");
  EXPECT_EQ (parameters.patches.plane_model, PlaneModel::initial);
  EXPECT_EQ (rowOf ("normal_method").parse ("integral_image", parameters), "");
  EXPECT_EQ (parameters.normals.method, NormalMethod::integral_image);
  EXPECT_EQ (rowOf ("distance_scale").toString (AttentionParameters ()), "1000");
  EXPECT_EQ (rowOf ("convexity_gate").toString (AttentionParameters ()), "on");
}

TEST (ParameterTable, BadTextIsRefusedWithWhatWouldBeRight)
{
  const auto refused = [] (const std::string& name, const std::string& text) {
    AttentionParameters parameters;
    const std::string message = rowOf (name).parse (text, parameters);
    EXPECT_NE (message, "") << name << " " << text;
    EXPECT_NE (message.find (name), std::string::npos) << message;
    EXPECT_NE (message.find ("'" + text + "'"), std::string::npos) << message;
    // Nothing was changed.
    for (const ParameterDescription& row : parameterTable ())
      EXPECT_EQ (row.get (parameters), row.get (AttentionParameters ())) << name << " " << text;
    return (message);
  };
  for (const char* text : {"", " ", "x", "3x", "3 4", "nan", "inf", "-1", "0", "9", "2.5", "1e99", "0x3", "3,5"})
    EXPECT_NE (refused ("window_radius", text).find ("a whole number from 1 to 8 pixels"), std::string::npos);
  for (const char* text : {"", "-0.1", "1.01", "10%", "nan", "1,5"})
    EXPECT_NE (refused ("pixel_threshold", text).find ("a number from 0 to 1"), std::string::npos);
  for (const char* text : {"", "yes", "ON", "1", "on "})
    EXPECT_NE (refused ("convexity_gate", text).find ("one of off on"), std::string::npos);
  EXPECT_NE (refused ("color_constraint", "printed").find ("one of off nearer_object as_printed"), std::string::npos);
}

TEST (Validate, TakesBothEndsOfEveryRange)
{
  for (const ParameterDescription& row : parameterTable ())
    for (const double end : {row.minimum, row.maximum})
    {
      AttentionParameters parameters;
      parameters.image_symmetry.inner_radius = row.name == "image_outer_radius" ? 1 : 7;
      parameters.image_symmetry.outer_radius = 100;
      row.set (parameters, end);
      EXPECT_EQ (validate (parameters), "");
    }
}

TEST (Validate, TakesARingOfOneRadiusButNoneInsideOut)
{
  AttentionParameters parameters;
  parameters.image_symmetry.inner_radius = parameters.image_symmetry.outer_radius = 9;
  EXPECT_EQ (validate (parameters), "");
  parameters.image_symmetry.inner_radius = 10;
  EXPECT_EQ (validate (parameters), "image_inner_radius is 10, but must not exceed image_outer_radius, which is 9");
}

TEST (Validate, NamesTheFirstValueOutOfRange)
{
  for (const ParameterDescription& row : parameterTable ())
    for (const double bad : {row.minimum - 1.0, row.maximum + 1.0, std::numeric_limits<double>::quiet_NaN ()})
    {
      // A field that is a switch or a small enumeration cannot hold every bad value.
      if (!row.choices.empty () || (row.integer && std::isnan (bad)))
        continue;
      AttentionParameters parameters;
      row.set (parameters, bad);
      const std::string message = validate (parameters);
      EXPECT_EQ (message.find (row.name + " is "), 0u) << message;
    }
}
