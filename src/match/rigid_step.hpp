#pragma once
/// \file
/// One step of ICP: the rigid motion that fits matched points with normals.

#include <span>
#include <vector>

#include "foramen/core/geometry.hpp"

namespace foramen::detail {

/// A point of the moving shape in its present position, and its partner on the fixed shape.
struct Match {
  Vec3 moving, fixed;
  Vec3 normal;          ///< unit vector: the direction in which their distance counts most
  double distance = 0;  ///< distance in the search by position and normal, mm
};

/// Tukey's biweights of the matches. The scale is estimated from the median distance and is at least
/// `least_scale` [mm].
std::vector<double> tukey_weights(std::span<const Match> matches, double least_scale);

struct RigidStepOptions {
  double point_share = 0.1;  ///< s below, in [0, 1]
  double length = 1;         ///< factor of the step, in (0, 1]
};

/// The motion that minimises sum_i w_i ((1 - s) (d_i . n_i)^2 + s |d_i|^2) with d_i = moving_i - fixed_i. The
/// problem is linearised with half of the rotation applied to either side, so exchanging the sides gives the
/// inverse motion. Identity if all weights are zero.
RigidTransform rigid_step(std::span<const Match> matches, std::span<const double> weights,
                          const RigidStepOptions& options = {});

}  // namespace foramen::detail
