#pragma once
/// \file
/// How long the description of a cohort by its model is, and what would shorten it.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"
#include "foramen/correspond/group_options.hpp"

namespace foramen {

struct DescriptionLength {
  double value = 0;                      ///< dimensionless
  std::vector<std::vector<Vec3>> slope;  ///< dF/dx of every point of every shape, 1 / mm
  /// For every shape the points that F draws it to: its own reconstruction with mode m shrunk by
  /// 1 - lambda_c / lambda_m, modes under the cut left out.
  std::vector<std::vector<Vec3>> attractors;
};

/// The description length of Davies et al. \cite davies2008 in the simplified form of Thodberg \cite
/// thodberg2003: \f$ F = \sum_m L(\lambda_m) \f$, L = 1 + log(lambda_m / lambda_c) if lambda_m >= lambda_c,
/// else lambda_m / lambda_c, with lambda_m the eigenvalues of \f$ \frac{1}{n-1} \sum_i \sum_k w_k |x_{ik} -
/// \bar x_k|^2 \f$ (weights w_k sum to 1).
///
/// L is concave in the eigenvalues, and no direction weighs more than 1 / lambda_c, so
/// \f$ F(y) \le F(x) + \frac{1}{(n-1)\lambda_c} \sum_i (|y_i - a_i|_w^2 - |x_i - a_i|_w^2) \f$ with a_i the
/// attractors (deviations taken from the present mean): bringing every shape nearer to its attractor shortens
/// the description. That is how a map is optimised by it, see DescriptionObjective.
///
/// \param aligned  shapes of corresponding points, mm  \param weights  per point, > 0, any scale. Throws
/// InvalidInput for fewer than 2 shapes or numbers that do not fit.
DescriptionLength description_length(const std::vector<std::vector<Vec3>>& aligned,
                                     std::span<const double> weights,
                                     const DescriptionLengthOptions& options = {});

}  // namespace foramen
