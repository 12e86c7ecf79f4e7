// SPDX-License-Identifier: BSD-3-Clause
// The arithmetic that symmetry and normals are made of, lane by lane.
#include "../../src/core/lanes.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{

Lanes
lanesOf (const float (&values)[lane_count])
{
  return (load (values));
}

/** \brief One symmetric matrix a lane. */
struct Problem
{
  Eigen::Matrix3d matrices[lane_count];

  LaneSymmetricMatrix
  lanes () const
  {
    const auto entry = [this] (int row, int column) {
      float values[lane_count];
      for (int lane = 0; lane < lane_count; ++lane)
        values[lane] = static_cast<float> (matrices[lane](row, column));
      return (load (values));
    };
    return {entry (0, 0), entry (0, 1), entry (0, 2), entry (1, 1), entry (1, 2), entry (2, 2)};
  }
};

struct Errors
{
  double residual{0.0};   /**< largest |A v - l v| in units of the matrix norm */
  double angle{0.0};      /**< largest |cosine| between two eigenvectors */
  double length{0.0};     /**< largest deviation from unit length */
  double eigenvalue{0.0}; /**< largest difference to Eigen's, in units of the matrix norm */

  void
  add (const Problem& problem)
  {
    LaneVector vectors[3];
    Lanes values[3];
    eigenDecomposition (problem.lanes (), vectors, values);
    for (int lane = 0; lane < lane_count; ++lane)
    {
      const Eigen::Matrix3d a = problem.matrices[lane].cast<float> ().cast<double> ();
      const double norm = std::max (a.norm (), 1e-30);
      Eigen::Matrix3d v;
      Eigen::Vector3d l;
      for (int k = 0; k < 3; ++k)
      {
        v.col (k) = Eigen::Vector3d (vectors[k].x[lane], vectors[k].y[lane], vectors[k].z[lane]);
        l[k] = values[k][lane];
        ASSERT_TRUE (v.col (k).allFinite () && std::isfinite (l[k])) << a;
        residual = std::max (residual, (a * v.col (k) - l[k] * v.col (k)).norm () / norm);
      }
      for (int k = 0; k < 3; ++k)
      {
        length = std::max (length, std::abs (v.col (k).norm () - 1.0));
        angle = std::max (angle, std::abs (v.col (k).normalized ().dot (v.col ((k + 1) % 3).normalized ())));
      }
      std::sort (l.data (), l.data () + 3);
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (a, Eigen::EigenvaluesOnly);
      eigenvalue = std::max (eigenvalue, (l - solver.eigenvalues ()).cwiseAbs ().maxCoeff () / norm);
    }
  }

  void
  expectSmall (double tolerance) const
  {
    EXPECT_LT (residual, tolerance);
    EXPECT_LT (angle, 2e-6);
    EXPECT_LT (eigenvalue, 2e-6);
  }
};

class RandomMatrices
{
public:
  Eigen::Matrix3d
  rotation ()
  {
    return (Eigen::Quaterniond (normal_ (random_), normal_ (random_), normal_ (random_), normal_ (random_))
                .normalized ()
                .toRotationMatrix ());
  }

  Eigen::Matrix3d
  withEigenvalues (double a, double b, double c)
  {
    const Eigen::Matrix3d r = rotation ();
    return (r * Eigen::Vector3d (a, b, c).asDiagonal () * r.transpose ());
  }

  double
  uniform (double low, double high)
  {
    return (std::uniform_real_distribution<double> (low, high) (random_));
  }

private:
  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
};

/** \brief Diagonal matrices with one eigenvalue apart on each axis in turn, and multiples of the identity. */
std::vector<Eigen::Matrix3d>
specialMatrices ()
{
  std::vector<Eigen::Matrix3d> matrices;
  for (const double factor : {0.0, 1.0, -2.5, 1e-8, 1e8})
    matrices.push_back (factor * Eigen::Matrix3d::Identity ());
  for (const Eigen::Vector3d& diagonal :
       {Eigen::Vector3d (1, 2, 3), Eigen::Vector3d (3, 1, 2), Eigen::Vector3d (2, 3, 1), Eigen::Vector3d (1, 1, 5),
        Eigen::Vector3d (1, 5, 1), Eigen::Vector3d (5, 1, 1), Eigen::Vector3d (5, 5, 1), Eigen::Vector3d (5, 1, 5),
        Eigen::Vector3d (1, 5, 5), Eigen::Vector3d (0, 0, 1), Eigen::Vector3d (0, 1, 0), Eigen::Vector3d (1, 0, 0)})
    matrices.push_back (diagonal.asDiagonal ());
  return (matrices);
}

template <typename Make>
Errors
errorsOver (int rounds, const Make& make)
{
  Errors errors;
  for (int round = 0; round < rounds; ++round)
  {
    Problem problem;
    for (Eigen::Matrix3d& matrix : problem.matrices)
      matrix = make ();
    errors.add (problem);
  }
  return (errors);
}

} // namespace

TEST (Lanes, ExponentialIsWithinTwoRoundingsOfTheLibrarys)
{
  double largest = 0.0;
  for (double x = -87.0; x <= 0.0; x += 87.0 / 200000.0)
  {
    float values[lane_count];
    for (int lane = 0; lane < lane_count; ++lane)
      values[lane] = static_cast<float> (std::min (0.0, x + lane * 1e-4));
    const Lanes result = exponential (lanesOf (values));
    for (int lane = 0; lane < lane_count; ++lane)
    {
      const double expected = std::exp (static_cast<double> (values[lane]));
      largest = std::max (largest, std::abs (result[lane] - expected) / expected);
    }
  }
  std::printf ("             largest relative error %.2e\n", largest);
  EXPECT_LT (largest, 2.0 * std::numeric_limits<float>::epsilon ());
}

TEST (Lanes, ExponentialOfZeroIsOneAndFarBelowItIsZero)
{
  EXPECT_EQ (exponential (broadcast (0.0f))[0], 1.0f);
  EXPECT_EQ (exponential (broadcast (-0.0f))[0], 1.0f);
  for (const float x : {-87.5f, -1e3f, -1e30f, -std::numeric_limits<float>::infinity ()})
    EXPECT_EQ (exponential (broadcast (x))[0], 0.0f) << x;
}

TEST (Lanes, AreIndependentOfEachOther)
{
  float values[lane_count];
  for (int lane = 0; lane < lane_count; ++lane)
    values[lane] = -0.5f * static_cast<float> (lane * lane);
  const Lanes all = exponential (lanesOf (values)), root = squareRoot (-1.0f * lanesOf (values));
  for (int lane = 0; lane < lane_count; ++lane)
  {
    EXPECT_EQ (all[lane], exponential (broadcast (values[lane]))[0]);
    EXPECT_EQ (root[lane], std::sqrt (-values[lane]));
  }
}

TEST (Lanes, MasksKeepAndSelectLaneByLane)
{
  float values[lane_count];
  for (int lane = 0; lane < lane_count; ++lane)
    values[lane] = lane % 2 ? 1.0f : -1.0f;
  const Lanes signs = lanesOf (values);
  const LaneMask positive = signs > 0.0f;
  EXPECT_TRUE (any (positive));
  EXPECT_FALSE (any (signs > 2.0f));
  for (int lane = 0; lane < lane_count; ++lane)
  {
    EXPECT_EQ (keep (positive, broadcast (7.0f))[lane], lane % 2 ? 7.0f : 0.0f);
    EXPECT_EQ (select (positive, broadcast (2.0f), broadcast (3.0f))[lane], lane % 2 ? 2.0f : 3.0f);
    EXPECT_EQ (absolute (signs)[lane], 1.0f);
    EXPECT_EQ (maximum (signs, broadcast (0.0f))[lane], lane % 2 ? 1.0f : 0.0f);
  }
  // What is not a number is not kept.
  const Lanes bad = broadcast (std::numeric_limits<float>::quiet_NaN ());
  EXPECT_EQ (keep (bad > 0.0f, bad)[0], 0.0f);
}

TEST (Lanes, NormalizedVectorsHaveUnitLengthOrAreZero)
{
  const LaneVector v = normalized ({broadcast (3.0f), broadcast (0.0f), broadcast (-4.0f)});
  EXPECT_FLOAT_EQ (v.x[0], 0.6f);
  EXPECT_FLOAT_EQ (v.y[0], 0.0f);
  EXPECT_FLOAT_EQ (v.z[0], -0.8f);
  const LaneVector zero = normalized (LaneVector{});
  EXPECT_EQ (dot (zero, zero)[0], 0.0f);
  const LaneVector x{broadcast (1.0f), {}, {}}, y{{}, broadcast (1.0f), {}};
  EXPECT_EQ (cross (x, y).z[0], 1.0f);
}

TEST (EigenDecomposition, OfRandomSymmetricMatrices)
{
  RandomMatrices random;
  const Errors errors = errorsOver (50000, [&] {
    return (random.withEigenvalues (random.uniform (-1, 1), random.uniform (-1, 1), random.uniform (-1, 1)));
  });
  errors.expectSmall (2e-6);
  EXPECT_LT (errors.length, 2e-6);
  std::printf ("             residual %.2e, cosine %.2e, length %.2e, eigenvalues %.2e\n", errors.residual,
               errors.angle, errors.length, errors.eigenvalue);
}

TEST (EigenDecomposition, OfCovariancesOfAnySize)
{
  RandomMatrices random;
  const Errors errors = errorsOver (50000, [&] {
    const double size = std::pow (10.0, random.uniform (-12, 6));
    return (random.withEigenvalues (size * random.uniform (0, 1e-3), size * random.uniform (0, 1), size));
  });
  errors.expectSmall (2e-6);
  EXPECT_LT (errors.length, 2e-6);
}

TEST (EigenDecomposition, OfRepeatedEigenvalues)
{
  RandomMatrices random;
  errorsOver (20000, [&] { return (random.withEigenvalues (0.2, 0.2, 1.0)); }).expectSmall (2e-6);
  errorsOver (20000, [&] { return (random.withEigenvalues (0.2, 1.0, 1.0)); }).expectSmall (2e-6);
  errorsOver (20000, [&] {
    const double close = random.uniform (-1, 1) * std::pow (10.0, random.uniform (-8, -2));
    return (random.withEigenvalues (0.7 + close, 0.7, random.uniform (-1, 1)));
  }).expectSmall (2e-6);
}

TEST (EigenDecomposition, OfRankOneMatrices)
{
  RandomMatrices random;
  errorsOver (20000, [&] { return (random.withEigenvalues (0.0, 0.0, 1.0)); }).expectSmall (2e-6);
  errorsOver (20000, [&] { return (random.withEigenvalues (0.0, 0.0, 1e-9)); }).expectSmall (2e-6);
}

TEST (EigenDecomposition, OfMultiplesOfTheIdentityAndDiagonalMatrices)
{
  for (const Eigen::Matrix3d& matrix : specialMatrices ())
    errorsOver (1, [&] { return (matrix); }).expectSmall (1e-6);
}

TEST (EigenDecomposition, VectorsHaveUnitLengthWhereTwoEigenvaluesAreEqual)
{
  for (const Eigen::Matrix3d& matrix : specialMatrices ())
    EXPECT_LT (errorsOver (1, [&] { return (matrix); }).length, 1e-6) << matrix;
  RandomMatrices random;
  EXPECT_LT (errorsOver (20000, [&] { return (random.withEigenvalues (0.0, 0.0, 1.0)); }).length, 2e-6);
  EXPECT_LT (errorsOver (20000, [&] { return (random.withEigenvalues (0.2, 1.0, 1.0)); }).length, 2e-6);
}

TEST (EigenDecomposition, FindsTheVectorsOfAMatrixByHand)
{
  // Eigenvalues 1 and 3 along the diagonals of the xy plane, 7 along z.
  Problem problem;
  for (Eigen::Matrix3d& matrix : problem.matrices)
    matrix << 2, 1, 0, 1, 2, 0, 0, 0, 7;
  LaneVector vectors[3];
  Lanes values[3];
  eigenDecomposition (problem.lanes (), vectors, values);
  const float s = std::sqrt (0.5f);
  bool found[3] = {};
  for (int k = 0; k < 3; ++k)
  {
    const float x = std::abs (vectors[k].x[0]), y = std::abs (vectors[k].y[0]), z = std::abs (vectors[k].z[0]);
    if (std::abs (values[k][0] - 7.0f) < 1e-5f)
      found[0] = z > 0.99999f;
    else
    {
      EXPECT_NEAR (x, s, 1e-5f);
      EXPECT_NEAR (y, s, 1e-5f);
      const bool along = vectors[k].x[0] * vectors[k].y[0] > 0.0f;
      EXPECT_NEAR (values[k][0], along ? 3.0f : 1.0f, 1e-5f);
      found[along ? 1 : 2] = true;
    }
  }
  EXPECT_TRUE (found[0] && found[1] && found[2]);
}
