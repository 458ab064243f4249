#pragma once
/// \file
/// The prior of the displacement onto a shape, learnt from the other shapes of its cohort.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/match/displacement_prior.hpp"

namespace foramen {

/// The coefficients of all shapes. The prior of one shape is made from them when it is needed, since the
/// priors of all shapes together would grow with the square of their number.
struct CohortPriors {
  Eigen::MatrixXd coefficients;  ///< one column per shape; empty for fewer than 3 shapes
  double unexplained_share = 1;  ///< see cohort_priors()

  DisplacementPrior of_member(int shape) const;  ///< the prior from the other shapes
  DisplacementPrior of_newcomer() const;         ///< the prior from all shapes
};

/// The prior of shape i is a normal distribution. Its mean is the mean of the other shapes' coefficients. Its
/// covariance is that of the other shapes' coefficients plus the smooth process times the share v that the
/// other shapes do not explain,
/// \f$ v = \sum_i |a_i - \hat a_i|^2 / \sum_i |a_i - m_i|^2 \f$, at most 1, where
///
/// - \f$ a_i \f$ are the coefficients of shape i: the most probable ones given its points and the smooth
/// process,
/// - \f$ m_i \f$ is the mean of the other shapes' coefficients,
/// - \f$ \hat a_i \f$ is the least-squares fit of \f$ a_i \f$ by the other shapes' coefficients.
///
/// If the shapes vary in few ways, v is small, and points on a featureless wall are placed as on the other
/// shapes. If each shape differs in its own way, v is near 1, and the smooth process decides.
///
/// \param functions  values of smooth_displacements() at the template's vertices
/// \param corresponding  per shape, the points that correspond to the template's vertices, in the coordinates
/// of the template; with fewer than 3 shapes the prior is the smooth process
/// Throws InvalidInput for sizes that do not agree.
CohortPriors cohort_priors(const Mesh& surface, const Eigen::MatrixXd& functions,
                           std::span<const std::vector<Vec3>> corresponding,
                           const CohortPriorOptions& options = {});

}  // namespace foramen
