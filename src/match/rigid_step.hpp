#pragma once
/// \file
/// One step of ICP: from matched points with normals to a rigid motion.

#include <span>
#include <vector>

#include "foramen/core/geometry.hpp"

namespace foramen::detail {

/// A point of the moving shape, where it is now, and its partner on the fixed one.
struct Match {
  Vec3 moving, fixed;
  Vec3 normal;          ///< unit: direction in which their distance counts most
  double distance = 0;  ///< of the search (positions and normals together), mm
};

/// Tukey's biweights of the matches for a scale estimated from the median distance, not below `least_scale`
/// [mm].
std::vector<double> tukey_weights(std::span<const Match> matches, double least_scale);

struct RigidStepOptions {
  double point_share = 0.1;  ///< s below, in [0, 1]
  double length = 1;         ///< the part of the step that is taken, in (0, 1]
};

/// The motion that minimises sum_i w_i ((1 - s) (d_i . n_i)^2 + s |d_i|^2), d_i = moving_i - fixed_i,
/// linearised in the rotation with half of it on either side, so that exchanging the sides inverts the
/// motion. Identity if the weights vanish.
RigidTransform rigid_step(std::span<const Match> matches, std::span<const double> weights,
                          const RigidStepOptions& options = {});

}  // namespace foramen::detail
