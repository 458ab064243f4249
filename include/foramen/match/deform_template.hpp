#pragma once
/// \file
/// Non-rigid alignment: a template bent smoothly onto a shape.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/match/displacement_prior.hpp"

namespace foramen {

struct DeformTemplateOptions {
  /// Standard deviation of a match, from coarse to fine [mm]; each level is iterated. Not empty, > 0.
  std::vector<double> noise_mm = {4, 2, 1, 0.5, 0.25};
  int iterations = 4;          ///< of every level, > 0
  int samples = 3000;          ///< matches sought from each of the two surfaces, > 0
  double normal_weight = 8.0;  ///< mm per unit of normal difference in the searches, >= 0
  /// Part of a match that is point to point; the rest is along the mean normal. In (0, 1]. Small: what lies
  /// along the surface is left to the smoothness of the displacement.
  double tangential_share = 0.05;
  /// A patch of this area counts as one independent match, however many samples it holds [mm^2]. > 0.
  double independent_area_mm2 = 20;
  /// Matches farther than this many medians are left out (Tukey's biweight). > 0.
  double rejection = 4;
  double least_median_mm = 0.5;  ///< The median counts as no less than this. > 0.
};

/// The template's vertices where the smooth displacement that best explains the shape puts them: the maximum
/// a posteriori of u = phi a, a as the prior says, given matches both ways between the bent template and the
/// shape. Template points and shape points are matched to the other surface's nearest by position and normal;
/// Tukey's weights leave out what has no partner; \f$ \min_a -2 \log p(a) + \sum_m w_m (r_m^T P_m r_m) /
/// \sigma^2 \f$ with r the distance of a match and P = (1 - s) n n^T + s I is solved anew for every set of
/// matches. Folds are not excluded: what needs a one-to-one map takes the result as a target, not as the map.
///
/// \param functions  of smooth_displacements() at the template's vertices  \param shape  aligned to the
/// template  \param start  where the template's vertices are first; empty: undeformed
std::vector<Vec3> deform_template(const Mesh& surface, const Eigen::MatrixXd& functions, const Mesh& shape,
                                  const RunContext& ctx, const DeformTemplateOptions& options = {},
                                  std::span<const Vec3> start = {}, const DisplacementPrior& prior = {});

}  // namespace foramen
