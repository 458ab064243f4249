#pragma once
/// \file
/// Non-rigid registration: bends a template smoothly onto a shape.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/match/displacement_prior.hpp"
#include "foramen/match/vertex_matches.hpp"

namespace foramen {

struct DeformTemplateOptions {
  std::vector<double> noise_mm = {4, 2, 1, 0.5, 0.25};  ///< Not empty.
  int iterations = 4;
  MatchOptions match = {};  ///< The number of samples holds for each of the two surfaces.
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<DeformTemplateOptions> auto& o) {
  visit(o.noise_mm, {.name = "noise",
                     .unit = "mm",
                     .range = above(0),
                     .meaning = "standard deviation of a match, from coarse to fine"});
  visit(o.iterations,
        {.name = "iterations", .range = at_least(1), .meaning = "iterations at every level of noise"});
  visit(o.match, {.nesting = Nesting::inlined});
}

/// Returns the positions of the template's vertices on the shape, mm. The displacement is u = phi a with the
/// basis phi of `functions`; the coefficients a are the maximum a posteriori estimate under the prior, given
/// matches between the bent template and the shape.
///
/// In each iteration points of each surface are matched with the nearest points of the other by position and
/// normal, and Tukey's biweight removes points without partner. Then \f$ \min_a -2 \log p(a) + \sum_m r_m^T
/// P_m r_m \f$ is solved, where r_m is the difference of the two points of match m and P_m its precision
/// (match_precision()). The result may have folds, so a caller that needs a one-to-one map uses it as a
/// target and not as the map.
///
/// Throws InvalidInput for sizes that do not agree and for options out of range.
///
/// \param functions  values of smooth_displacements() at the template's vertices
/// \param shape  the shape, aligned to the template
/// \param start  initial positions of the template's vertices; empty: undeformed
std::vector<Vec3> deform_template(const Mesh& surface, const Eigen::MatrixXd& functions, const Mesh& shape,
                                  const RunContext& ctx, const DeformTemplateOptions& options = {},
                                  std::span<const Vec3> start = {}, const DisplacementPrior& prior = {});

}  // namespace foramen
