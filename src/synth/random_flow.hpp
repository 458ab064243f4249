#pragma once
/// \file
/// Smooth random diffeomorphisms of space.

#include <functional>
#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/rng.hpp"

namespace foramen {

struct RandomFieldOptions {
  /// Correlation length: the covariance of a coordinate at distance r is proportional to exp(-r^2 / (2
  /// correlation_mm^2)) [mm]. > 0.
  double correlation_mm = 25.0;
  /// Number of waves of a field; the error of its covariance is about 1 / sqrt(features). > 0.
  int features = 128;
};

/// \f$ v(x) = \sum_j c_j \cos(w_j \cdot x) + s_j \sin(w_j \cdot x) \f$: random Fourier features \cite
/// rahimi2007.
struct VelocityField {
  std::vector<Vec3> wave_vectors;  ///< w_j [1/mm]
  std::vector<Vec3> cosine, sine;  ///< c_j, s_j [mm per unit of time]

  Vec3 operator()(const Vec3& point) const;
};

/// Independent Gaussian random fields with unit variance of every coordinate at every point. They share their
/// wave vectors.
std::vector<VelocityField> random_velocity_fields(int count, const RandomFieldOptions& options, Rng& rng);

/// A field like those of random_velocity_fields() whose value at a point has this correlation with the mirror
/// image of its value at the mirrored point (mirror plane x = 0). It has 2 features waves, in mirrored pairs.
/// \pre |left_right_correlation| <= 1
VelocityField symmetric_velocity_field(double left_right_correlation, const RandomFieldOptions& options,
                                       Rng& rng);

/// sum_k weights[k] fields[k]. \pre as many weights as fields, at least one; all fields share their wave
/// vectors
VelocityField weighted_sum(std::span<const VelocityField> fields, std::span<const double> weights);

/// A velocity at every point of space [mm per unit of time].
using Velocity = std::function<Vec3(const Vec3& point)>;

/// Moves points by the flow dx/dt = v(x) of a stationary field for one unit of time, with `steps` steps of
/// the classical Runge-Kutta method. The flow of a smooth field is a diffeomorphism. \pre steps > 0
std::vector<Vec3> carried_by_flow(std::span<const Vec3> points, const Velocity& velocity, int steps = 8);

}  // namespace foramen
