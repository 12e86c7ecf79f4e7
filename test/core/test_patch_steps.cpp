// SPDX-License-Identifier: BSD-3-Clause
// Steps between and within patches, on surfaces whose steps are known.
#include "shapes.h"
#include <pcl_attention/core/patch_steps.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

using namespace pcl_attention;
using shapes::Frame;

namespace
{

/** \brief Whether two halves of 40 by 30 pixels of 1 mm stay connected. \param[in] depth_left,depth_right of column and row */
template <typename Left, typename Right>
bool
staysConnected (const Left& depth_left, const Right& depth_right, const PatchGraphParameters& parameters = PatchGraphParameters (),
                const std::vector<std::uint8_t>& excluded = {})
{
  Frame frame = shapes::emptyFrame (80, 30);
  PlanarPatches patches;
  patches.labels.assign (80, 30, 1);
  for (int row = 0; row < 30; ++row)
    for (int column = 0; column < 80; ++column)
    {
      if (column >= 40)
        patches.labels (column, row) = 2;
      const double depth = column < 40 ? depth_left (column - 39.5, row - 14.5) : depth_right (column - 39.5, row - 14.5);
      frame.set (frame.index (column, row), {0.001 * (column - 39.5), 0.001 * (row - 14.5), depth}, {0, 0, -1});
    }
  describePatches (frame.cloud, patches);
  PatchGraph graph = buildPatchGraph (frame.cloud, estimateSensor (frame.cloud), frame.normals, patches.labels, 2, parameters);
  EXPECT_GT (graph.border (1, 2).connectedShare (), 0.9f) << "before";
  disconnectSteps (frame.cloud, patches, excluded, parameters, graph);
  return (graph.border (1, 2).connected > 0);
}

const auto level = [] (double, double) { return (1.0); };

} // namespace

TEST (DisconnectSteps, APlaneThatGoesOnStaysConnected)
{
  EXPECT_TRUE (staysConnected (level, level));
}

TEST (DisconnectSteps, OneSideSetBackIsApart)
{
  EXPECT_FALSE (staysConnected (level, [] (double, double) { return (1.004); })) << "4 mm behind";
  EXPECT_FALSE (staysConnected ([] (double, double) { return (1.004); }, level));
  EXPECT_TRUE (staysConnected (level, [] (double, double) { return (1.001); })) << "1 mm is within the tolerance of 2 mm";
  PatchGraphParameters parameters;
  parameters.step_tolerance = 0.0005f;
  EXPECT_FALSE (staysConnected (level, [] (double, double) { return (1.001); }, parameters));
}

TEST (DisconnectSteps, AnEdgeOrACreaseIsNoStep)
{
  const auto falls = [] (double column, double) { return (1.0 + 0.001 * std::abs (column)); };
  const auto rises = [] (double column, double) { return (1.0 - 0.001 * std::abs (column)); };
  EXPECT_TRUE (staysConnected (falls, falls)) << "45 degrees to either side";
  EXPECT_TRUE (staysConnected (rises, rises));
  EXPECT_TRUE (staysConnected (level, falls));
}

TEST (DisconnectSteps, OneSideTurnedAboutTheLineAcrossTheBorderIsApart)
{
  // By 20 degrees: the planes meet in one point of the border of 30 mm; the mean distance is 0, its deviation 3 mm.
  EXPECT_FALSE (staysConnected (level, [] (double, double row) { return (1.0 + 0.00036 * row); }));
  EXPECT_TRUE (staysConnected (level, [] (double, double row) { return (1.0 + 0.0001 * row); })) << "by 6 degrees: 0.9 mm";
}

TEST (DisconnectSteps, DifferentColorsAskForLess)
{
  // 2 mm and, of half of 70 %, 1.3 mm.
  const auto staysConnectedIfPainted = [] (double step, const std::array<std::uint8_t, 2>& red, float step_color) {
    Frame frame = shapes::emptyFrame (80, 30);
    PlanarPatches patches;
    patches.labels.assign (80, 30, 1);
    for (auto* channel : {&frame.cloud.red, &frame.cloud.green, &frame.cloud.blue})
      channel->assign (frame.cloud.size (), 0);
    for (int row = 0; row < 30; ++row)
      for (int column = 0; column < 80; ++column)
      {
        const bool right = column >= 40;
        patches.labels (column, row) = 1 + right;
        frame.set (frame.index (column, row), {0.001 * (column - 39.5), 0.001 * (row - 14.5), right ? 1.0 + step : 1.0}, {0, 0, -1});
        frame.cloud.red[frame.index (column, row)] = red[right];
      }
    describePatches (frame.cloud, patches);
    PatchGraphParameters parameters;
    parameters.step_color = step_color;
    PatchGraph graph = buildPatchGraph (frame.cloud, estimateSensor (frame.cloud), frame.normals, patches.labels, 2, parameters);
    disconnectSteps (frame.cloud, patches, {}, parameters, graph);
    return (graph.border (1, 2).connected > 0);
  };
  EXPECT_TRUE (staysConnectedIfPainted (0.0016, {200, 200}, 0.7f));
  EXPECT_FALSE (staysConnectedIfPainted (0.0016, {200, 0}, 0.7f));
  EXPECT_TRUE (staysConnectedIfPainted (0.0010, {200, 0}, 0.7f));
  EXPECT_TRUE (staysConnectedIfPainted (0.0016, {200, 0}, 0.0f));
  EXPECT_FALSE (staysConnectedIfPainted (0.0024, {200, 200}, 0.7f)) << "like colours do not ask for more between patches";
}

TEST (DisconnectSteps, RoughSurfacesNeedALargerStep)
{
  // Waves of 3 mm (rms) across the border: 2 mm + 3 mm.
  const auto rough = [] (double column, double row) { return (1.0 + 0.0042 * std::sin (0.5 * column) * std::sin (0.9 * row)); };
  EXPECT_TRUE (staysConnected (rough, [&] (double column, double row) { return (rough (column, row) + 0.0025); }));
}

TEST (DisconnectSteps, IsOffWithoutRoughnessAndForExcludedPatches)
{
  const auto behind = [] (double, double) { return (1.004); };
  PatchGraphParameters parameters;
  parameters.step_roughness = 0.0f;
  EXPECT_TRUE (staysConnected (level, behind, parameters));
  EXPECT_TRUE (staysConnected (level, behind, PatchGraphParameters (), {0, 0, 1}));
  EXPECT_TRUE (staysConnected (level, behind, PatchGraphParameters (), {0, 1, 0}));
  EXPECT_FALSE (staysConnected (level, behind, PatchGraphParameters (), {0, 0, 0}));
}

TEST (DisconnectSteps, WhatWasCutApartStaysApart)
{
  Frame frame = shapes::emptyFrame (20, 10);
  PlanarPatches patches;
  patches.labels.assign (20, 10, 1);
  for (int row = 0; row < 10; ++row)
    for (int column = 0; column < 20; ++column)
    {
      patches.labels (column, row) = 1 + column / 7;
      frame.set (frame.index (column, row), {0.001 * column, 0.001 * row, 1.0}, {0, 0, -1});
    }
  describePatches (frame.cloud, patches);
  patches.patches[0].cuts = {1, 2};
  patches.patches[1].cuts = {3, -2};
  patches.patches[2].cuts = {3, 4};
  PatchGraph graph = buildPatchGraph (frame.cloud, estimateSensor (frame.cloud), frame.normals, patches.labels, 3, PatchGraphParameters ());
  disconnectSteps (frame.cloud, patches, {}, PatchGraphParameters (), graph);
  EXPECT_EQ (graph.border (1, 2).connected, 0) << "either side of step 2";
  EXPECT_GT (graph.border (2, 3).connected, 0) << "the same side of step 3";
}

namespace
{

using Relief = std::function<double (double column, double row)>;
using Rgb = std::array<std::uint8_t, 3>;

/** \brief A surface of 80 by 60 pixels of 1 mm that is one patch. */
struct OnePatch
{
  Frame frame = shapes::emptyFrame (80, 60);
  PlanarPatches patches;

  explicit OnePatch (const Relief& depth)
  {
    patches.labels.assign (80, 60, 1);
    for (int row = 0; row < 60; ++row)
      for (int column = 0; column < 80; ++column)
        frame.set (frame.index (column, row), {0.001 * (column - 39.5), 0.001 * (row - 29.5), depth (column - 39.5, row - 29.5)},
                   {0, 0, -1});
    describePatches (frame.cloud, patches);
  }

  /** \brief Paint what is left of a column, and the rest. */
  OnePatch&
  paint (double border, const Rgb& left, const Rgb& right)
  {
    OrganizedCloud& cloud = frame.cloud;
    std::vector<std::uint8_t>* const channels[] = {&cloud.red, &cloud.green, &cloud.blue};
    for (int channel = 0; channel < 3; ++channel)
    {
      channels[channel]->resize (cloud.size ());
      for (std::size_t index = 0; index < cloud.size (); ++index)
        (*channels[channel])[index] = (index % 80 - 39.5 < border ? left : right)[channel];
    }
    return (*this);
  }

  OnePatch&
  cut (const PatchGraphParameters& parameters = PatchGraphParameters (), const std::vector<std::uint8_t>& excluded = {},
       int threads = 1)
  {
    cutAtSteps (frame.cloud, excluded, parameters, patches, threads);
    return (*this);
  }

  std::size_t
  count () const { return (patches.patches.size ()); }

  /** \brief Share of the pixels with another label than they should have. */
  double
  wrong (const std::function<int (double column, double row)>& label) const
  {
    int wrong = 0;
    for (int row = 0; row < 60; ++row)
      for (int column = 0; column < 80; ++column)
        wrong += patches.labels (column, row) != label (column - 39.5, row - 29.5);
    return (wrong / 4800.0);
  }
};

/** \brief So much farther from a column on. */
Relief
stepAt (double border, double height)
{
  return ([=] (double column, double) { return (column < border ? 1.0 : 1.0 + height); });
}

constexpr Rgb red{200, 20, 20}, blue{20, 20, 200};

} // namespace

TEST (CutAtSteps, DescribesEveryPartAsIfItHadBeenAlone)
{
  OnePatch surface (stepAt (4.0, 0.008));
  surface.cut ();
  ASSERT_EQ (surface.count (), 2u);
  PlanarPatches alone;
  alone.labels = surface.patches.labels;
  describePatches (surface.frame.cloud, alone);
  for (std::size_t k = 0; k < 2; ++k)
  {
    const PlanarPatch &part = surface.patches.patches[k], &expected = alone.patches[k];
    EXPECT_EQ (part.pixels, expected.pixels);
    EXPECT_LT ((part.centroid - expected.centroid).norm (), 1e-6f);
    EXPECT_LT ((part.normal - expected.normal).norm (), 1e-5f);
    EXPECT_NEAR (part.rms, expected.rms, 1e-6f);
  }
}

TEST (CutAtSteps, TwoFacesThatLieAStepApartAreTwoPatches)
{
  const OnePatch two = OnePatch (stepAt (15, 0.003)).cut ();
  ASSERT_EQ (two.count (), 2u);
  EXPECT_LT (two.wrong ([] (double column, double) { return (column < 15 ? 1 : 2); }), 2.0 / 80) << "the larger one keeps its label";
  ASSERT_EQ (two.patches.patches[0].cuts.size (), 1u);
  EXPECT_EQ (std::abs (two.patches.patches[0].cuts[0]), 1);
  EXPECT_EQ (two.patches.patches[1].cuts, (std::vector<int>{-two.patches.patches[0].cuts[0]}));
  EXPECT_EQ (two.patches.patches[0].pixels.size () + two.patches.patches[1].pixels.size (), 4800u);
  EXPECT_NEAR (two.patches.patches[0].centroid.z (), 1.0, 2e-4);
  EXPECT_NEAR (two.patches.patches[1].centroid.z (), 1.003, 2e-4);
  EXPECT_EQ (OnePatch (stepAt (15, 0.0015)).cut ().count (), 1u) << "1.5 mm are within 2 mm";
  EXPECT_EQ (OnePatch (stepAt (15, -0.003)).cut ().count (), 2u);
}

TEST (CutAtSteps, AlongTheStepWhateverItsDirection)
{
  for (const double degrees : {20.0, 65.0, 100.0, 150.0})
  {
    const double c = std::cos (degrees * 0.0174533), s = std::sin (degrees * 0.0174533);
    const OnePatch two =
      OnePatch ([=] (double column, double row) { return (c * column + s * row < -6 ? 1.0 : 1.003); }).cut ();
    ASSERT_EQ (two.count (), 2u) << degrees;
    EXPECT_LT (two.wrong ([=] (double column, double row) { return (c * column + s * row < -6 ? 2 : 1); }), 0.05) << degrees;
  }
}

TEST (CutAtSteps, LikeColorsAskForMoreAndDifferentOnesForLess)
{
  // 2 mm, 70 % more or less: 3.4 mm or 0.6 mm.
  EXPECT_EQ (OnePatch (stepAt (10, 0.003)).paint (10, red, red).cut ().count (), 1u);
  EXPECT_EQ (OnePatch (stepAt (10, 0.0045)).paint (10, red, red).cut ().count (), 2u);
  EXPECT_EQ (OnePatch (stepAt (10, 0.001)).paint (10, red, blue).cut ().count (), 2u);
  EXPECT_EQ (OnePatch (stepAt (10, 0.0004)).paint (10, red, blue).cut ().count (), 1u);
  EXPECT_EQ (OnePatch (stepAt (10, 0.0)).paint (10, red, blue).cut ().count (), 1u) << "a label on a box";
  PatchGraphParameters parameters;
  parameters.step_color = 0.0f;
  EXPECT_EQ (OnePatch (stepAt (10, 0.003)).paint (10, red, red).cut (parameters).count (), 2u);
  EXPECT_EQ (OnePatch (stepAt (10, 0.001)).paint (10, red, blue).cut (parameters).count (), 1u);
}

TEST (CutAtSteps, NoEdgeNoCreaseNoCylinderIsCut)
{
  const Relief falls = [] (double column, double) { return (1.0 + 0.0003 * std::abs (column)); };
  const Relief rises = [] (double column, double) { return (1.0 - 0.0003 * std::abs (column)); };
  const Relief cylinder = [] (double column, double) { return (1.1 - std::sqrt (0.01 - 1e-6 * column * column)); };
  const Relief sphere = [] (double column, double row) { return (1.1 - std::sqrt (0.01 - 1e-6 * (column * column + row * row))); };
  for (const Relief& surface : {falls, rises, cylinder, sphere})
    EXPECT_EQ (OnePatch (surface).paint (0, red, blue).cut ().count (), 1u);
}

TEST (CutAtSteps, OneSideTurnedAboutTheLineAcrossTheBorder)
{
  // By 11 degrees along 60 mm: the mean step is 0, its deviation 3.5 mm.
  EXPECT_EQ (OnePatch ([] (double column, double row) { return (column < 5 ? 1.0 : 1.0 + 0.0002 * row); }).cut ().count (), 2u);
}

TEST (CutAtSteps, AStaircaseFallsIntoItsStepsAndNoneIsConnected)
{
  OnePatch stairs ([] (double column, double) { return (column < -15 ? 1.0 : column < 15 ? 1.004 : 1.008); });
  stairs.cut ();
  ASSERT_EQ (stairs.count (), 3u);
  PatchGraph graph = buildPatchGraph (stairs.frame.cloud, estimateSensor (stairs.frame.cloud), stairs.frame.normals, stairs.patches.labels, 3, PatchGraphParameters ());
  ASSERT_EQ (graph.borders.size (), 2u);
  disconnectSteps (stairs.frame.cloud, stairs.patches, {}, PatchGraphParameters (), graph);
  for (const auto& [names, border] : graph.borders)
    EXPECT_EQ (border.connected, 0) << names.first << " and " << names.second;
}

TEST (CutAtSteps, AtAStepAlthoughACutAlongACreaseLeavesLess)
{
  // Of h = 6 mm at p = .56 of the width the best plane leaves h sqrt (p (1 - p) - 3 p^2 (1 - p)^2) = 1.52 mm rms, of .18 mm a row
  // 30 * .18 / sqrt (12) = 1.56 mm.
  const OnePatch cut = OnePatch ([] (double column, double row) {
                         return ((column < 5 ? 1.0 : 1.006) + 0.00018 * std::abs (row));
                       }).cut ();
  ASSERT_EQ (cut.count (), 2u);
  EXPECT_LT (cut.wrong ([] (double column, double) { return (column < 5 ? 1 : 2); }), 0.05);
}

TEST (CutAtSteps, BetweenColorsAlthoughACutAlongACreaseLeavesLess)
{
  // 1.2 mm of (2 mm + 1.56 mm rms) * 30 %; a cut along the crease leaves less than a quarter of the residual of one at the step.
  const Relief surface = [] (double column, double row) { return ((column < 5 ? 1.0 : 1.0012) + 0.00018 * std::abs (row)); };
  const OnePatch cut = OnePatch (surface).paint (5, red, blue).cut ();
  ASSERT_EQ (cut.count (), 2u);
  EXPECT_LT (cut.wrong ([] (double column, double) { return (column < 5 ? 1 : 2); }), 0.05);
  EXPECT_EQ (OnePatch (surface).paint (5, red, red).cut ().count (), 1u);
  PatchGraphParameters parameters;
  parameters.cut_color = 1.1f;
  EXPECT_EQ (OnePatch (surface).paint (5, red, blue).cut (parameters).count (), 1u) << "off";
  const Relief crease = [] (double, double row) { return (1.0 + 0.00018 * std::abs (row)); };
  EXPECT_EQ (OnePatch (crease).paint (5, red, blue).cut ().count (), 1u) << "colours alone are no step";
}

TEST (CutAtSteps, NoSideHasFewerThan200Pixels)
{
  // 60 pixels a column.
  EXPECT_EQ (OnePatch (stepAt (-35, 0.01)).cut ().count (), 2u);
  for (double border = -39; border < 40; border += 1)
  {
    const OnePatch cut = OnePatch (stepAt (border, 0.01)).cut ();
    for (const PlanarPatch& piece : cut.patches.patches)
      EXPECT_GE (piece.pixels.size (), 180u) << "400 of 4800 pixels tell how many there are; border at " << border;
  }
}

TEST (CutAtSteps, NamesThePiecesOfSeveralPatchesInOrder)
{
  const auto cutWith = [] (int threads, const std::vector<std::uint8_t>& excluded) {
    OnePatch patch ([] (double column, double row) {
      const double in_half = column + 39.5 < 40 ? column + 20 : column - 20;
      return (in_half < 3 ? 1.0 : row < 0 ? 1.003 : 1.01);
    });
    for (int row = 0; row < 60; ++row)
      for (int column = 0; column < 80; ++column)
        patch.patches.labels (column, row) = 1 + column / 40 + 2 * (row / 30);
    describePatches (patch.frame.cloud, patch.patches);
    return (patch.cut (PatchGraphParameters (), excluded, threads).patches);
  };
  const PlanarPatches all = cutWith (1, {});
  ASSERT_EQ (all.patches.size (), 8u);
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_EQ (all.patches[k].cuts.size (), 1u);
    EXPECT_EQ (std::abs (all.patches[k].cuts[0]), k + 1) << "each has a step of its own";
    EXPECT_EQ (all.patches[4 + k].cuts[0], -all.patches[k].cuts[0]);
    EXPECT_EQ (all.labels[all.patches[4 + k].pixels.front ()], 5 + k);
  }
  EXPECT_EQ (cutWith (2, {}).labels.data, all.labels.data);
  const PlanarPatches some = cutWith (1, {0, 1, 0, 0, 1});
  ASSERT_EQ (some.patches.size (), 6u);
  EXPECT_TRUE (some.patches[0].cuts.empty () && some.patches[3].cuts.empty ()) << "excluded";
}

TEST (CutAtSteps, IsOffWithoutRoughnessAndFindsNothingInNothing)
{
  PatchGraphParameters parameters;
  parameters.step_roughness = 0.0f;
  EXPECT_EQ (OnePatch (stepAt (0, 0.01)).cut (parameters).count (), 1u);
  PlanarPatches none;
  cutAtSteps (OrganizedCloud (), {}, PatchGraphParameters (), none);
  EXPECT_TRUE (none.patches.empty ());
}
