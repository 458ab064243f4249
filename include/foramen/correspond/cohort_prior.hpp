#pragma once
/// \file
/// The prior of the displacement onto a shape, learnt from the other shapes of its cohort.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"
#include "foramen/match/displacement_prior.hpp"

namespace foramen {

struct CohortPriorOptions {
  double noise_mm = 0.25;
  double independent_area_mm2 = 20;
  double least_share = 0.02;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<CohortPriorOptions> auto& o) {
  visit(o.noise_mm, {.name = "noise",
                     .unit = "mm",
                     .range = above(0),
                     .meaning = "standard deviation of a corresponding point"});
  visit(o.independent_area_mm2, {.name = "independent_area",
                                 .unit = "mm^2",
                                 .range = above(0),
                                 .meaning = "area of a patch that counts as one independent point"});
  visit(o.least_share,
        {.name = "least_share",
         .range = above(0).up_to(1),
         .meaning = "least share of the smooth process's variance that is left to what no other shape does"});
}

/// The coefficients of all shapes. The prior of one shape is made from them when it is needed, since the
/// priors of all shapes together would grow with the square of their number.
struct CohortPriors {
  Eigen::MatrixXd coefficients;  ///< a column per shape; empty: fewer than 3 shapes
  double unexplained_share = 1;  ///< see cohort_priors()

  DisplacementPrior of_member(int shape) const;  ///< from the others
  DisplacementPrior of_newcomer() const;         ///< from all
};

/// The prior of shape i is a normal distribution. Its mean is the mean of the other shapes' coefficients. Its
/// covariance is that of the other shapes' coefficients plus the smooth process times the share v that the
/// other shapes do not explain,
/// \f$ v = \sum_i |a_i - \hat a_i|^2 / \sum_i |a_i - m_i|^2 \f$, at most 1, where
///
/// - \f$ a_i \f$ are the coefficients of shape i: the most probable ones given its points and the smooth
///   process,
/// - \f$ m_i \f$ is the mean of the other shapes' coefficients,
/// - \f$ \hat a_i \f$ is the least-squares fit of \f$ a_i \f$ by the other shapes' coefficients.
///
/// If the shapes vary in few ways, v is small, and points on a featureless wall are placed as on the other
/// shapes. If each shape differs in its own way, v is near 1, and the smooth process decides.
///
/// \param functions  of smooth_displacements() at the template's vertices
/// \param corresponding  per shape, where it has the template's vertices, in the template's frame. With fewer
/// than 3 shapes the prior is the smooth process. Throws InvalidInput for numbers that do not fit.
CohortPriors cohort_priors(const Mesh& surface, const Eigen::MatrixXd& functions,
                           std::span<const std::vector<Vec3>> corresponding,
                           const CohortPriorOptions& options = {});

}  // namespace foramen
