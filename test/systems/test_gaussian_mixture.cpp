// SPDX-License-Identifier: BSD-3-Clause
#include "systems/gaussian_mixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pcl_attention
{
namespace
{

const Eigen::Vector3f red (0.7f, 0.2f, 0.2f), blue (0.2f, 0.3f, 0.7f);
constexpr float red_deviation = 0.05f, blue_deviation = 0.03f;

/** \brief Three times as many red ones as blue ones. */
std::vector<Eigen::Vector3f>
redAndBlue ()
{
  std::mt19937 generator (3);
  std::normal_distribution<float> normal;
  std::vector<Eigen::Vector3f> samples;
  for (int i = 0; i < 4000; ++i)
  {
    const Eigen::Vector3f noise (normal (generator), normal (generator), normal (generator));
    samples.push_back (i % 4 ? Eigen::Vector3f (red + red_deviation * noise)
                             : Eigen::Vector3f (blue + blue_deviation * noise));
  }
  return (samples);
}

float
gaussian (const Eigen::Vector3f& color, const Eigen::Vector3f& mean, float deviation)
{
  const float norm = std::pow (2 * static_cast<float> (M_PI) * deviation * deviation, -1.5f);
  return (norm * std::exp (-0.5f * (color - mean).squaredNorm () / (deviation * deviation)));
}

TEST (GaussianMixture, findsTheMixtureThatSamplesWereDrawnFrom)
{
  const GaussianMixture mixture (redAndBlue (), 2);
  for (const Eigen::Vector3f& color :
       {red, blue, Eigen::Vector3f (0.75f, 0.15f, 0.25f), Eigen::Vector3f (0.22f, 0.32f, 0.66f)})
  {
    // The variance is widened by a camera's noise.
    const float expected = 0.75f * gaussian (color, red, std::sqrt (red_deviation * red_deviation + 1e-4f)) +
                           0.25f * gaussian (color, blue, std::sqrt (blue_deviation * blue_deviation + 1e-4f));
    EXPECT_NEAR (mixture.density (color) / expected, 1.0f, 0.15f) << color.transpose ();
  }
}

TEST (GaussianMixture, isADensity)
{
  const GaussianMixture mixture (redAndBlue (), 5);
  constexpr int steps = 60;
  double integral = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      for (int k = 0; k < steps; ++k)
        integral += mixture.density (Eigen::Vector3f (i + 0.5f, j + 0.5f, k + 0.5f) / steps) / std::pow (steps, 3);
  EXPECT_NEAR (integral, 1.0, 0.02);
}

TEST (GaussianMixture, fewSamplesAreEnough)
{
  const GaussianMixture mixture ({red}, 5);
  EXPECT_GT (mixture.density (red), 100.0f);
  EXPECT_LT (mixture.density (blue), 1e-3f);
  EXPECT_TRUE (std::isfinite (GaussianMixture (std::vector<Eigen::Vector3f> (50, red), 5).density (red)));
}

} // namespace
} // namespace pcl_attention
