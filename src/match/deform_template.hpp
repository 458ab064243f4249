#pragma once
/// \file
/// Non-rigid registration: bends a template smoothly onto a shape.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/match/bending_options.hpp"
#include "foramen/match/displacement_prior.hpp"
#include "match/vertex_matches.hpp"

namespace foramen {

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
