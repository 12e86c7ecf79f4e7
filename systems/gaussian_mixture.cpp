// SPDX-License-Identifier: BSD-3-Clause
#include "systems/gaussian_mixture.h"

#include <algorithm>
#include <cmath>

namespace pcl_attention
{

namespace
{

constexpr int k_means_rounds = 10, maximization_rounds = 10;
constexpr float least_variance = 1e-4f; // (2.5 grey levels)^2 for colours in 0..1: a camera's noise

/** \brief Middles of as many clusters: first farthest from each other, then moved by k-means. */
std::vector<Eigen::Vector3f>
clusterMeans (const std::vector<Eigen::Vector3f>& samples, int clusters)
{
  Eigen::Vector3f mean = Eigen::Vector3f::Zero ();
  for (const Eigen::Vector3f& sample : samples)
    mean += sample / static_cast<float> (samples.size ());
  std::vector<Eigen::Vector3f> means;
  std::vector<float> distances (samples.size (), std::numeric_limits<float>::max ());
  for (Eigen::Vector3f next = mean; static_cast<int> (means.size ()) < clusters;)
  {
    means.push_back (next);
    for (std::size_t i = 0; i < samples.size (); ++i)
      distances[i] = std::min (distances[i], (samples[i] - next).squaredNorm ());
    next = samples[std::max_element (distances.begin (), distances.end ()) - distances.begin ()];
  }
  for (int round = 0; round < k_means_rounds; ++round)
  {
    std::vector<Eigen::Vector3f> sums (clusters, Eigen::Vector3f::Zero ());
    std::vector<int> counts (clusters, 0);
    for (const Eigen::Vector3f& sample : samples)
    {
      const auto nearest = std::min_element (means.begin (), means.end (), [&sample] (const auto& a, const auto& b) {
        return ((sample - a).squaredNorm () < (sample - b).squaredNorm ());
      });
      sums[nearest - means.begin ()] += sample;
      ++counts[nearest - means.begin ()];
    }
    for (int cluster = 0; cluster < clusters; ++cluster)
      if (counts[cluster] > 0)
        means[cluster] = sums[cluster] / static_cast<float> (counts[cluster]);
  }
  return (means);
}

} // namespace

GaussianMixture::GaussianMixture (const std::vector<Eigen::Vector3f>& samples, int components)
    : components_ (std::min<std::size_t> (components, samples.size ()))
{
  const std::vector<Eigen::Vector3f> means = clusterMeans (samples, static_cast<int> (components_.size ()));
  constexpr float first_variance = 0.01f;
  for (std::size_t i = 0; i < components_.size (); ++i)
    setComponent (components_[i], 1.0f / static_cast<float> (components_.size ()), means[i],
                  first_variance * Eigen::Matrix3f::Identity ());

  Eigen::MatrixXf shares (components_.size (), samples.size ());
  for (int round = 0; round < maximization_rounds; ++round)
  {
    for (std::size_t j = 0; j < samples.size (); ++j)
    {
      for (std::size_t i = 0; i < components_.size (); ++i)
      {
        const Eigen::Vector3f from_mean = samples[j] - components_[i].mean;
        shares (i, j) =
            components_[i].peak * std::exp (-0.5f * from_mean.dot (components_[i].inverse_covariance * from_mean));
      }
      const float sum = shares.col (j).sum ();
      shares.col (j) =
          sum > 0 ? Eigen::VectorXf (shares.col (j) / sum)
                  : Eigen::VectorXf::Constant (components_.size (), 1.0f / static_cast<float> (components_.size ()));
    }
    for (std::size_t i = 0; i < components_.size (); ++i)
    {
      const float total = std::max (shares.row (i).sum (), 1e-6f);
      Eigen::Vector3f mean = Eigen::Vector3f::Zero ();
      for (std::size_t j = 0; j < samples.size (); ++j)
        mean += shares (i, j) / total * samples[j];
      Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero ();
      for (std::size_t j = 0; j < samples.size (); ++j)
        covariance += shares (i, j) / total * (samples[j] - mean) * (samples[j] - mean).transpose ();
      setComponent (components_[i], total / static_cast<float> (samples.size ()), mean, covariance);
    }
  }
}

float
GaussianMixture::density (const Eigen::Vector3f& color) const
{
  float density = 0;
  for (const Component& component : components_)
  {
    const Eigen::Vector3f from_mean = color - component.mean;
    density += component.peak * std::exp (-0.5f * from_mean.dot (component.inverse_covariance * from_mean));
  }
  return (density);
}

void
GaussianMixture::setComponent (Component& component, float weight, const Eigen::Vector3f& mean,
                               const Eigen::Matrix3f& covariance)
{
  const Eigen::Matrix3f widened = covariance + least_variance * Eigen::Matrix3f::Identity ();
  component.weight = weight;
  component.mean = mean;
  component.inverse_covariance = widened.inverse ();
  component.peak = weight / std::sqrt (std::pow (2 * static_cast<float> (M_PI), 3.0f) * widened.determinant ());
}

} // namespace pcl_attention
