#pragma once
/// \file
/// What the shapes of a cohort tell of the displacement onto one more.

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

/// What all shapes tell, from which the priors are made when they are needed: together they would grow with
/// the square of the number of shapes.
struct CohortPriors {
  Eigen::MatrixXd coefficients;  ///< a column per shape; empty: too few shapes to teach anything
  double unexplained_share = 1;  ///< see cohort_priors()

  DisplacementPrior of_member(int shape) const;  ///< from the others
  DisplacementPrior of_newcomer() const;         ///< from all
};

/// For every shape the distribution of its displacement as the other shapes have it: mean and covariance of
/// the others' coefficients, plus the smooth process with its variance times the part of a shape that the
/// others do not explain, \f$ v = \sum_i |a_i - \hat a_i|^2 / \sum_i |a_i - m_i|^2 \f$, m_i the others' mean
/// and \f$ \hat a_i \f$ the least-squares fit of a_i by their span (and at most 1). Where shapes vary in few
/// ways, what slides along a featureless wall slides as in the other shapes; where each is a case of its own,
/// v is near 1 and the smooth process decides as before. Coefficients are the most probable ones given the
/// points and the smooth process.
///
/// \param functions  of smooth_displacements() at the template's vertices
/// \param corresponding  per shape, where it has the template's vertices, in the template's frame. Fewer than
/// 3 shapes teach nothing: the smooth process for all. Throws InvalidInput for numbers that do not fit.
CohortPriors cohort_priors(const Mesh& surface, const Eigen::MatrixXd& functions,
                           std::span<const std::vector<Vec3>> corresponding,
                           const CohortPriorOptions& options = {});

}  // namespace foramen
