// SPDX-License-Identifier: BSD-3-Clause
// Paper III-B, eq. 9: the across-scale sum and what must hold of the whole map.
#include "pyramid_oracle.h"
#include "shapes.h"
#include <pcl_attention/core/pyramid.h>
#include <pcl_attention/core/saliency.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl_attention;
using shapes::Frame;

namespace
{

SaliencyMaps
saliencyOf (const Frame& frame, const SaliencyParameters& parameters = SaliencyParameters (), int threads = 1)
{
  SaliencyMaps maps;
  computeSaliency (frame.cloud, frame.normals, parameters, threads, maps);
  return (maps);
}

/** \brief The symmetry of every level from the library's own (elsewhere tested) stages, then eq. 9 naively. */
Image<double>
naiveSum (const Frame& frame, const SaliencyParameters& parameters, double* maximum = nullptr)
{
  std::vector<Image<double>> levels;
  Frame level = frame;
  int skipped = 0; // they count nothing
  for (int l = 0; l < parameters.levels + skipped; ++l)
  {
    if (l > 0)
    {
      Frame half;
      halve (level.cloud, level.normals, 1, half.cloud, half.normals);
      level = half;
    }
    if (parameters.maximum_columns > 0 && level.cloud.width > parameters.maximum_columns)
    {
      levels.emplace_back (level.cloud.width, level.cloud.height, 0.0);
      ++skipped;
      continue;
    }
    SymmetryMap map;
    computeSymmetry (level.cloud, level.normals, parameters, 1, map);
    levels.push_back (oracle::toDouble (map.symmetry));
  }
  return (oracle::acrossScaleSum (levels, frame.cloud.valid, parameters, maximum));
}

std::vector<Frame>
frames ()
{
  std::vector<Frame> all;
  all.push_back (shapes::hills (1));
  all.push_back (shapes::hills (2, {61, 43}));
  Frame holes = shapes::hills (3, {80, 60});
  shapes::punchHoles (holes, 3, 0.15);
  all.push_back (holes);
  all.push_back (shapes::look (shapes::sphere ({0.01, 0, 0.8}, 0.03), {96, 72}));
  all.push_back (shapes::rendered (SceneKind::clutter, 2, 160, 120, 1.0));
  return (all);
}

} // namespace

TEST (Saliency, IsTheAcrossScaleSumOfItsLevels)
{
  // Above the floor nothing is mere rounding, which would be divided by its own maximum.
  SaliencyParameters base;
  base.saliency_floor = 1e-6f;
  std::vector<SaliencyParameters> settings (9, base);
  settings[1].levels = 1;
  settings[2].levels = 6;
  settings[3].blur_radius = 0;
  settings[4].normalize_levels = false;
  settings[5].level_threshold = 0.1f;
  settings[6].window_radius = 5;
  settings[7].maximum_columns = 40; // one or two are left out
  settings[8].maximum_columns = 20; // two or three
  for (const Frame& frame : frames ())
    for (std::size_t k = 0; k < settings.size (); ++k)
    {
      SCOPED_TRACE (::testing::Message () << frame.cloud.width << "x" << frame.cloud.height << " settings " << k);
      double maximum = 0.0;
      const Image<double> expected = naiveSum (frame, settings[k], &maximum);
      const SaliencyMaps maps = saliencyOf (frame, settings[k]);
      ASSERT_EQ (static_cast<int> (maps.levels.size ()), settings[k].levels);
      EXPECT_NEAR (maps.maximum, maximum, 1e-5 * maximum);
      EXPECT_GT (maximum, 0.0);
      int different = 0;
      for (std::size_t index = 0; index < expected.size (); ++index)
        different += std::abs (maps.saliency[index] - expected[index]) > 2e-5;
      EXPECT_EQ (different, 0);
    }
}

TEST (Saliency, EqualsTheEquationsFromCloudToMap)
{
  // Everything in double precision, from eq. 1 to eq. 9. Pixels whose symmetry is not well defined may differ, and the
  // blur spreads them: the median and the bulk must not.
  const Frame frame = shapes::hills (8, {80, 64});
  SaliencyParameters parameters;
  parameters.levels = 3;
  std::vector<Image<double>> levels;
  oracle::Level level = oracle::levelOf (frame.cloud, frame.normals);
  for (int l = 0; l < parameters.levels; ++l)
  {
    if (l > 0)
      level = oracle::halved (level);
    Frame rounded = shapes::emptyFrame (level.width, level.height);
    for (std::size_t index = 0; index < level.valid.size (); ++index)
      if (level.valid[index])
        rounded.set (index, level.points[index], level.normals[index]);
    const Image<oracle::Symmetry> symmetry = oracle::symmetryMap (rounded.cloud, rounded.normals, parameters);
    levels.emplace_back (symmetry.width, symmetry.height);
    for (std::size_t index = 0; index < symmetry.size (); ++index)
      levels.back ()[index] = symmetry[index].value;
  }
  const Image<double> expected = oracle::acrossScaleSum (levels, frame.cloud.valid, parameters);
  const SaliencyMaps maps = saliencyOf (frame, parameters);
  std::vector<double> differences;
  for (std::size_t index = 0; index < expected.size (); ++index)
    differences.push_back (std::abs (expected[index] - maps.saliency[index]));
  std::sort (differences.begin (), differences.end ());
  std::printf ("             difference median %.2e, 95 %% %.2e, largest %.2e\n", differences[differences.size () / 2],
               differences[differences.size () * 95 / 100], differences.back ());
  EXPECT_LT (differences[differences.size () / 2], 1e-5);
  EXPECT_LT (differences[differences.size () * 95 / 100], 1e-4);
}

TEST (Saliency, IsBetweenZeroAndOneWithItsMaximumAtOneAndZeroWhereThereIsNoPoint)
{
  for (const Frame& frame : frames ())
  {
    const SaliencyMaps maps = saliencyOf (frame);
    const WinningSymmetry winning = findWinningSymmetry (maps, SaliencyParameters ());
    float largest = 0.0f;
    for (std::size_t index = 0; index < maps.saliency.size (); ++index)
    {
      const float value = maps.saliency[index];
      ASSERT_TRUE (std::isfinite (value));
      ASSERT_GE (value, 0.0f);
      ASSERT_LE (value, 1.0f);
      largest = std::max (largest, value);
      if (!frame.cloud.valid[index])
      {
        EXPECT_EQ (value, 0.0f);
      }
      EXPECT_EQ (winning.level[index] != 0, value > 0.0f);
      EXPECT_LE (winning.level[index], 4);
      EXPECT_LE (winning.plane[index], 3);
      if (value == 0.0f)
      {
        EXPECT_EQ (winning.plane[index], 0);
      }
    }
    EXPECT_EQ (largest, 1.0f);
    EXPECT_GT (maps.maximum, 0.0f);
  }
}

TEST (Saliency, IsOneAtItsMaximumAlsoInTheLastPixel)
{
  SaliencyParameters parameters;
  parameters.levels = 1;
  parameters.blur_radius = 0;
  parameters.saliency_floor = 0.0f;
  parameters.convexity_gate = false;
  int in_last_pixel = 0;
  for (unsigned seed = 1; seed <= 400; ++seed)
  {
    const SaliencyMaps maps = saliencyOf (shapes::hills (seed, {7, 5}), parameters);
    EXPECT_EQ (*std::max_element (maps.saliency.data.begin (), maps.saliency.data.end ()), 1.0f) << seed;
    in_last_pixel += maps.saliency.data.back () == 1.0f;
  }
  EXPECT_GT (in_last_pixel, 0) << "the scenes show nothing";
}

TEST (Saliency, TheWinningPlaneIsKnownWhereverThereIsSaliency)
{
  // The header says 1..3, and 0 where S is 0.
  const SaliencyMaps maps = saliencyOf (shapes::hills (1));
  const WinningSymmetry winning = findWinningSymmetry (maps, SaliencyParameters ());
  int unknown = 0;
  for (std::size_t index = 0; index < maps.saliency.size (); ++index)
    unknown += maps.saliency[index] > 0.0f && winning.plane[index] == 0;
  EXPECT_EQ (unknown, 0);
}

TEST (Saliency, RoundingIsNoSymmetry)
{
  // Normals of the coarser levels of a plane differ by single roundings; divided by the level's maximum they would be
  // all there is.
  const SaliencyMaps maps = saliencyOf (shapes::look (shapes::plane ({0, 0, 1}, {0.2, 0.1, -1})));
  EXPECT_EQ (maps.maximum, 0.0f);
}

TEST (Saliency, OfNothingSymmetricIsZeroAboveATinyFloor)
{
  SaliencyParameters parameters;
  parameters.saliency_floor = 1e-6f;
  for (const Frame& frame :
       {shapes::emptyFrame (40, 30), shapes::emptyFrame (1, 1),
        shapes::look (shapes::plane ({0, 0, 1}, {0.2, 0.1, -1})), shapes::look (shapes::valley (0.9, 0.6))})
  {
    const SaliencyMaps maps = saliencyOf (frame, parameters);
    EXPECT_EQ (maps.maximum, 0.0f);
    EXPECT_EQ (maps.saliency.size (), frame.cloud.size ());
    for (const float value : maps.saliency.data)
      ASSERT_EQ (value, 0.0f);
  }
}

TEST (Saliency, TheFloorDropsWhatIsFaintWhateverTheMaximum)
{
  const Frame frame = shapes::hills (1);
  SaliencyParameters parameters;
  parameters.levels = 1;
  const SaliencyMaps all = saliencyOf (frame, parameters);
  const float peak = *std::max_element (all.levels[0].symmetry.data.begin (), all.levels[0].symmetry.data.end ());
  parameters.saliency_floor = 0.5f * peak;
  const SaliencyMaps upper = saliencyOf (frame, parameters);
  int dropped = 0, kept = 0;
  for (std::size_t index = 0; index < frame.cloud.size (); ++index)
  {
    const float before = all.levels[0].symmetry[index];
    EXPECT_EQ (upper.levels[0].symmetry[index], before < parameters.saliency_floor ? 0.0f : before);
    dropped += before > 0.0f && before < parameters.saliency_floor;
    kept += before >= parameters.saliency_floor;
  }
  EXPECT_GT (dropped, 0);
  EXPECT_GT (kept, 0);
  parameters.saliency_floor = 1.01f * peak;
  const SaliencyMaps none = saliencyOf (frame, parameters);
  EXPECT_EQ (none.maximum, 0.0f);
}

TEST (Saliency, TheMirroredCloudHasTheMirroredMap)
{
  // 64 and 48 are halved evenly at all four levels.
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    const Frame frame = shapes::hills (seed, {64, 48});
    const SaliencyMaps maps = saliencyOf (frame), mirror = saliencyOf (shapes::mirrored (frame));
    double largest = 0.0;
    for (int row = 0; row < 48; ++row)
      for (int column = 0; column < 64; ++column)
        largest =
            std::max<double> (largest, std::abs (maps.saliency (column, row) - mirror.saliency (63 - column, row)));
    std::printf ("             largest difference %.2e\n", largest);
    EXPECT_LT (largest, 1e-4) << "seed " << seed;
  }
}

TEST (Saliency, DoesNotDependOnTheNumberOfThreads)
{
  for (const Frame& frame : frames ())
  {
    const SaliencyMaps one = saliencyOf (frame);
    for (const int threads : {2, 3})
    {
      const SaliencyMaps more = saliencyOf (frame, SaliencyParameters (), threads);
      EXPECT_EQ (one.saliency.data, more.saliency.data);
      EXPECT_EQ (one.maximum, more.maximum);
    }
  }
}

TEST (Saliency, InvalidMarginsChangeNothing)
{
  // Margins of whole pixels of the coarsest level, around a sphere that has nothing near the border.
  const Frame frame = shapes::look (shapes::sphere ({0, 0, 0.8}, 0.02), {160, 128});
  const SaliencyMaps maps = saliencyOf (frame), larger = saliencyOf (shapes::withMargins (frame, 16, 8, 24, 32));
  EXPECT_GT (maps.maximum, 0.0f);
  for (int row = 0; row < 128; ++row)
    for (int column = 0; column < 160; ++column)
      ASSERT_EQ (maps.saliency (column, row), larger.saliency (column + 16, row + 8));
}

TEST (Saliency, OfASphereIsHighestAtItsNearestPointOverAllLevels)
{
  const Frame frame = shapes::look (shapes::sphere ({0, 0, 0.8}, 0.035), {81, 61});
  const SaliencyMaps maps = saliencyOf (frame);
  const auto best =
      std::max_element (maps.saliency.data.begin (), maps.saliency.data.end ()) - maps.saliency.data.begin ();
  EXPECT_NEAR (static_cast<double> (best % 81), 40, 2);
  EXPECT_NEAR (static_cast<double> (best / 81), 30, 2);
}
