#pragma once
/// \file
/// Non-rigid alignment: a template bent smoothly onto a shape.

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

/// The template's vertices where the smooth displacement that best explains the shape puts them: the maximum
/// a posteriori of u = phi a, a as the prior says, given matches both ways between the bent template and the
/// shape. Template points and shape points are matched to the other surface's nearest by position and normal;
/// Tukey's weights leave out what has no partner; \f$ \min_a -2 \log p(a) + \sum_m r_m^T P_m r_m \f$ with r
/// the difference of a match's two points and P its precision, match_precision(), is solved anew for every
/// set of matches. Folds are not excluded: what needs a one-to-one map takes the result as a target, not as
/// the map.
///
/// \param functions  of smooth_displacements() at the template's vertices  \param shape  aligned to the
/// template  \param start  where the template's vertices are first; empty: undeformed
std::vector<Vec3> deform_template(const Mesh& surface, const Eigen::MatrixXd& functions, const Mesh& shape,
                                  const RunContext& ctx, const DeformTemplateOptions& options = {},
                                  std::span<const Vec3> start = {}, const DisplacementPrior& prior = {});

}  // namespace foramen
