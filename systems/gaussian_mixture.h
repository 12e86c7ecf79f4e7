// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Dense>

#include <vector>

namespace pcl_attention
{

/** \brief A mixture of Gaussians over colours. */
class GaussianMixture
{
public:
  /** \brief Fit to samples by expectation maximization that starts with k-means; the result depends on nothing else.
   * \param[in] samples at least one
   * \param[in] components at least 1; fewer samples than that have as many components as samples */
  GaussianMixture (const std::vector<Eigen::Vector3f>& samples, int components);

  /** \brief Probability density at a colour. */
  float density (const Eigen::Vector3f& color) const;

private:
  struct Component
  {
    float weight;
    Eigen::Vector3f mean;
    Eigen::Matrix3f inverse_covariance;
    float peak; // weight times the density at the mean
  };

  void setComponent (Component& component, float weight, const Eigen::Vector3f& mean,
                     const Eigen::Matrix3f& covariance);

  std::vector<Component> components_;
};

} // namespace pcl_attention
