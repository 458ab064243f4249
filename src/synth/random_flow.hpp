#pragma once
/// \file
/// Smooth random diffeomorphisms of space.

#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/rng.hpp"

namespace foramen {

struct RandomFieldOptions {
  double correlation_mm =
      25.0;            ///< The covariance of a coordinate falls as exp(-r^2 / (2 correlation^2)) [mm]. > 0.
  int features = 128;  ///< Waves a field is the sum of; its covariance errs by about 1 / sqrt(features). > 0.
};

/// \f$ v(x) = \sum_j c_j \cos(w_j \cdot x) + s_j \sin(w_j \cdot x) \f$: random Fourier features \cite
/// rahimi2007.
struct VelocityField {
  std::vector<Vec3> wave_vectors;  ///< w_j [1/mm]
  std::vector<Vec3> cosine, sine;  ///< c_j, s_j [mm per unit of time]

  Vec3 operator()(const Vec3& point) const;
};

/// Independent Gaussian fields of unit variance in every coordinate, everywhere. They share their wave
/// vectors.
std::vector<VelocityField> random_velocity_fields(int count, const RandomFieldOptions& options, Rng& rng);

/// sum_k weights[k] fields[k]. \pre as many weights as fields, at least one; all fields share their wave
/// vectors.
VelocityField weighted_sum(std::span<const VelocityField> fields, std::span<const double> weights);

/// The points carried for one unit of time by the flow of a stationary field: dx/dt = v(x), by `steps` steps
/// of the classical Runge-Kutta method. The flow of a smooth field is a diffeomorphism: it neither folds nor
/// tears. \pre steps > 0.
std::vector<Vec3> carried_by_flow(std::span<const Vec3> points, const VelocityField& field, int steps = 8);

}  // namespace foramen
