// SPDX-License-Identifier: BSD-3-Clause
// Normals (paper III-A: "locally fitting planes to neighboring points") against windowed PCA and analytic surfaces.
#include "shapes.h"
#include <pcl_attention/core/normals.h>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl_attention;
using Eigen::Vector3d;
using shapes::Frame;

namespace
{

NormalImage
normalsOf (const OrganizedCloud& cloud, const NormalParameters& parameters = NormalParameters (), int threads = 1)
{
  NormalImage normals;
  estimateNormals (cloud, parameters, threads, normals);
  return (normals);
}

double
angleBetween (const Vector3d& a, const Vector3d& b)
{
  return (std::atan2 (a.cross (b).norm (), a.dot (b)) * 180.0 / std::acos (-1.0));
}

struct Fit
{
  int count{0};
  Vector3d normal{Vector3d::Zero ()}, eigenvalues{Vector3d::Zero ()};
};

/** \brief PCA of the window in double precision. A neighbour counts if its row's pixel in the centre's column is within
 * the gate of the centre, and it within the gate of that pixel. \param[out] gated whether the gate shut out any valid
 * neighbour */
Fit
windowedFit (const Frame& frame, int column, int row, int radius, double gate, bool* gated = nullptr)
{
  const OrganizedCloud& cloud = frame.cloud;
  const auto usable = [&] (int c, int r) {
    return (c >= 0 && c < cloud.width && r >= 0 && r < cloud.height && cloud.valid[frame.index (c, r)]);
  };
  std::vector<Vector3d> points;
  int all = 0;
  for (int r = row - radius; r <= row + radius; ++r)
    for (int c = column - radius; c <= column + radius; ++c)
    {
      if (!usable (c, r))
        continue;
      ++all;
      if (!usable (column, r))
        continue;
      const double center = frame.point (frame.index (column, row)).z (),
                   middle = frame.point (frame.index (column, r)).z ();
      const Vector3d point = frame.point (frame.index (c, r));
      if (std::abs (middle - center) < gate && std::abs (point.z () - middle) < gate)
        points.push_back (point);
    }
  if (gated)
    *gated = all != static_cast<int> (points.size ());
  Fit fit;
  fit.count = static_cast<int> (points.size ());
  if (points.size () < 3)
    return (fit);
  Vector3d mean = Vector3d::Zero ();
  for (const Vector3d& point : points)
    mean += point / static_cast<double> (points.size ());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero ();
  for (const Vector3d& point : points)
    covariance += (point - mean) * (point - mean).transpose () / static_cast<double> (points.size ());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (covariance);
  fit.normal = solver.eigenvectors ().col (0);
  fit.eigenvalues = solver.eigenvalues ();
  if (fit.normal.dot (frame.point (frame.index (column, row))) > 0.0)
    fit.normal = -fit.normal;
  return (fit);
}

struct Comparison
{
  int compared{0}, ungated{0};
  double largest_angle{0.0}, largest_curvature{0.0};
};

Comparison
compare (const Frame& frame, const NormalParameters& parameters)
{
  const NormalImage normals = normalsOf (frame.cloud, parameters);
  Comparison comparison;
  for (int row = 0; row < frame.cloud.height; ++row)
    for (int column = 0; column < frame.cloud.width; ++column)
    {
      const std::size_t index = frame.index (column, row);
      if (!frame.cloud.valid[index])
      {
        EXPECT_FALSE (normals.valid[index]);
        continue;
      }
      bool gated = false;
      const Fit fit = windowedFit (frame, column, row, parameters.radius, parameters.depth_gate, &gated);
      EXPECT_TRUE (fit.count >= 4 || !normals.valid[index]);
      // Float differences of depths that are a gate apart may fall on either side of it; a normal needs two dimensions,
      // and one that stands out.
      if (fit.count < 4 || fit.eigenvalues[1] < 1e-3 * fit.eigenvalues[2] ||
          fit.eigenvalues[1] - fit.eigenvalues[0] < 0.05 * fit.eigenvalues[1])
        continue;
      EXPECT_TRUE (normals.valid[index]) << column << " " << row;
      const Vector3d normal (normals.x[index], normals.y[index], normals.z[index]);
      ++comparison.compared;
      comparison.ungated += !gated;
      comparison.largest_angle = std::max (comparison.largest_angle, angleBetween (normal, fit.normal));
      comparison.largest_curvature =
          std::max (comparison.largest_curvature,
                    std::abs (normals.curvature[index] - fit.eigenvalues[0] / fit.eigenvalues.sum ()));
    }
  std::printf (
      "             compared %d, of them ungated %d, largest angle %.2e degrees, largest curvature difference %.2e\n",
      comparison.compared, comparison.ungated, comparison.largest_angle, comparison.largest_curvature);
  return (comparison);
}

} // namespace

TEST (Normals, EqualWindowedPcaOnHills)
{
  for (const int radius : {1, 4, 7})
  {
    NormalParameters parameters;
    parameters.radius = radius;
    parameters.depth_gate = 1.0f; // never shuts
    const Frame frame = shapes::hills (2);
    const Comparison comparison = compare (frame, parameters);
    EXPECT_EQ (comparison.ungated, comparison.compared);
    EXPECT_GT (comparison.compared, 2900);
    EXPECT_LT (comparison.largest_angle, 0.005);
    EXPECT_LT (comparison.largest_curvature, 1e-5);
  }
}

TEST (Normals, EqualGatedPcaOnScenes)
{
  for (const double noise : {0.0, 1.0})
  {
    const Frame frame = shapes::rendered (SceneKind::clutter, 6, 240, 180, noise);
    const Comparison comparison = compare (frame, NormalParameters ());
    EXPECT_GT (comparison.compared, 35000);
    EXPECT_LT (comparison.ungated, comparison.compared);
    EXPECT_LT (comparison.largest_angle, 0.01);
    EXPECT_LT (comparison.largest_curvature, 1e-5);
  }
}

TEST (Normals, OfPlanesAreTheirs)
{
  for (const Vector3d& direction : {Vector3d (0, 0, -1), Vector3d (0.5, 0.2, -1), Vector3d (-1, 0.3, -0.6)})
  {
    const Frame frame = shapes::look (shapes::plane ({0, 0, 1}, direction));
    const NormalImage normals = normalsOf (frame.cloud);
    for (std::size_t index = 0; index < frame.cloud.size (); ++index)
    {
      ASSERT_TRUE (normals.valid[index]);
      const Vector3d normal (normals.x[index], normals.y[index], normals.z[index]);
      EXPECT_LT (angleBetween (normal, direction), 0.02);
      EXPECT_NEAR (normal.norm (), 1.0, 1e-6);
      EXPECT_LT (normals.curvature[index], 1e-5f);
    }
  }
}

TEST (Normals, OfASphereAreRadialAndFaceTheViewer)
{
  const Frame frame = shapes::look (shapes::sphere ({0.02, -0.01, 0.9}, 0.08), {120, 120});
  const NormalImage normals = normalsOf (frame.cloud);
  int checked = 0;
  for (int row = 4; row < 116; ++row)
    for (int column = 4; column < 116; ++column)
    {
      const std::size_t index = frame.index (column, row);
      if (!normals.valid[index])
        continue;
      const Vector3d normal (normals.x[index], normals.y[index], normals.z[index]);
      EXPECT_LE (normal.dot (frame.point (index)), 0.0);
      // Away from the rim, where the window is whole.
      if (frame.normal (index).dot (-frame.point (index).normalized ()) < 0.75)
        continue;
      ++checked;
      EXPECT_LT (angleBetween (normal, frame.normal (index)), 1.5);
    }
  EXPECT_GT (checked, 2000);
}

TEST (Normals, OfLonelyPointsAreNotKnown)
{
  Frame frame = shapes::look (shapes::plane ({0, 0, 1}, {0, 0, -1}));
  for (std::size_t index = 0; index < frame.cloud.size (); ++index)
    frame.invalidate (index);
  const auto put = [&] (int column, int row) {
    frame.set (frame.index (column, row), shapes::Camera ().ray (column, row), {0, 0, -1});
  };
  put (5, 5);
  put (20, 5), put (21, 5), put (22, 5);                                // three in a row
  put (40, 5), put (41, 5), put (40, 6);                                // three in a corner
  put (20, 20), put (21, 20), put (22, 20), put (23, 20), put (24, 20); // a line
  put (40, 20), put (41, 20), put (40, 21), put (41, 21);               // four in a square
  const NormalImage normals = normalsOf (frame.cloud);
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column)
    {
      const bool square = column >= 40 && column <= 41 && row >= 20 && row <= 21;
      EXPECT_EQ (normals.valid[frame.index (column, row)] != 0, square) << column << " " << row;
    }
}

TEST (Normals, StaySharpAtAStepInDepth)
{
  // Two walls, 5 cm apart, tilted against each other.
  const shapes::Surface left = shapes::plane ({0, 0, 0.8}, {0.4, 0, -1}),
                        right = shapes::plane ({0, 0, 0.85}, {-0.3, 0.2, -1});
  const Frame frame = shapes::look ([&] (const Vector3d& ray) { return (ray.x () < 0.0 ? left (ray) : right (ray)); });
  const NormalImage normals = normalsOf (frame.cloud);
  for (std::size_t index = 0; index < frame.cloud.size (); ++index)
  {
    ASSERT_TRUE (normals.valid[index]);
    EXPECT_LT (angleBetween ({normals.x[index], normals.y[index], normals.z[index]}, frame.normal (index)), 0.05);
  }
  // Without a gate they bend.
  NormalParameters open;
  open.depth_gate = 1.0f;
  const NormalImage bent = normalsOf (frame.cloud, open);
  const std::size_t edge = frame.index (31, 24);
  EXPECT_GT (angleBetween ({bent.x[edge], bent.y[edge], bent.z[edge]}, frame.normal (edge)), 10.0);
}

TEST (Normals, DoNotDependOnTheNumberOfThreads)
{
  const Frame frame = shapes::rendered (SceneKind::clutter, 2, 160, 181, 1.0);
  const NormalImage one = normalsOf (frame.cloud);
  for (const int threads : {2, 3})
  {
    const NormalImage more = normalsOf (frame.cloud, NormalParameters (), threads);
    EXPECT_EQ (one.x, more.x);
    EXPECT_EQ (one.z, more.z);
    EXPECT_EQ (one.curvature, more.curvature);
    EXPECT_EQ (one.valid, more.valid);
  }
}

// On images of less than its border PCL's class writes out of bounds.
TEST (Normals, OfPclsIntegralImagesAreNoneWhereAllIsBorder)
{
  NormalParameters parameters;
  parameters.method = NormalMethod::integral_image;
  parameters.radius = 3;
  const auto countOf = [&] (int columns, int rows) {
    const NormalImage normals = normalsOf (shapes::hills (3, {columns, rows}, 0.0).cloud, parameters);
    return (std::count (normals.valid.begin (), normals.valid.end (), 1));
  };
  for (const auto& [columns, rows] : {std::pair<int, int> (2, 2), {14, 40}, {40, 14}, {3, 40}, {40, 3}, {15, 7}})
    EXPECT_EQ (countOf (columns, rows), 0) << columns << " x " << rows;
  EXPECT_GT (countOf (15, 15), 0);
}

TEST (Normals, OfPclsIntegralImagesAgreeOnASmoothSurface)
{
  const Frame frame = shapes::hills (3, {96, 96}, 0.0015);
  NormalParameters parameters;
  parameters.method = NormalMethod::integral_image;
  const NormalImage normals = normalsOf (frame.cloud, parameters), own = normalsOf (frame.cloud);
  std::vector<double> angles;
  for (int row = 16; row < 80; ++row)
    for (int column = 16; column < 80; ++column)
    {
      const std::size_t index = frame.index (column, row);
      if (normals.valid[index])
        angles.push_back (angleBetween ({normals.x[index], normals.y[index], normals.z[index]},
                                        {own.x[index], own.y[index], own.z[index]}));
    }
  ASSERT_GT (angles.size (), 3000u);
  std::sort (angles.begin (), angles.end ());
  EXPECT_LT (angles[angles.size () / 2], 2.0);
}
