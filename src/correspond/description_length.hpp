#pragma once
/// \file
/// The description length of a cohort by its model, and how to decrease it.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"
#include "foramen/correspond/registration_options.hpp"

namespace foramen {

struct DescriptionLength {
  double value = 0;                      ///< dimensionless
  std::vector<std::vector<Vec3>> slope;  ///< dF/dx of every point of every shape, 1 / mm
  /// For every shape the points towards which a decrease of F moves it, mm: the shape with the score of mode
  /// m multiplied by 1 - lambda_c / lambda_m, and by 0 for modes below the cut.
  std::vector<std::vector<Vec3>> attractors;
};

/// The description length of Davies et al. \cite davies2008 in the simplified form of Thodberg \cite
/// thodberg2003: \f$ F = \sum_m L(\lambda_m) \f$, L = 1 + log(lambda_m / lambda_c) if lambda_m >= lambda_c,
/// else lambda_m / lambda_c. The lambda_m [mm^2] are the variances of the modes of the n shapes under the
/// weights w_k, which are normalised to sum 1; their sum is \f$ \frac{1}{n-1} \sum_i \sum_k w_k |x_{ik} -
/// \bar x_k|^2 \f$.
///
/// L is concave in the variances, and its slope is at most 1 / lambda_c, so \f$ F(y) \le F(x) +
/// \frac{1}{(n-1)\lambda_c} \sum_i (|y_i - a_i|_w^2 - |x_i - a_i|_w^2) \f$ with the attractors a_i, where
/// deviations are taken from the present mean. Moving every shape nearer to its attractor therefore decreases
/// the description length. DescriptionObjective optimises maps in this way.
///
/// \param aligned  shapes of corresponding points, mm
/// \param weights  one per point, > 0, in any scale
/// Throws InvalidInput for fewer than 2 shapes and for sizes that do not agree.
DescriptionLength description_length(const std::vector<std::vector<Vec3>>& aligned,
                                     std::span<const double> weights,
                                     const DescriptionLengthOptions& options = {});

}  // namespace foramen
