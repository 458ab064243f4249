#include "synth/random_flow.hpp"

#include <cmath>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

// The components are drawn in a loop, because the result depends on the order of draws and C++ does not
// define the order in which arguments are evaluated.
Vec3 normal_vector(Rng& rng) {
  Vec3 v;
  for (int k = 0; k < 3; ++k) v[k] = rng.normal();
  return v;
}

// The spectrum of exp(-r^2 / (2 l^2)) is normal with standard deviation 1 / l.
std::vector<Vec3> random_waves(const RandomFieldOptions& options, Rng& rng) {
  std::vector<Vec3> waves;
  waves.reserve(options.features);
  for (int j = 0; j < options.features; ++j) waves.push_back(normal_vector(rng) / options.correlation_mm);
  return waves;
}

Vec3 mirrored(const Vec3& v) { return {-v.x(), v.y(), v.z()}; }

Vec3 runge_kutta_step(const Velocity& v, const Vec3& x, double h) {
  const Vec3 k1 = v(x), k2 = v(x + 0.5 * h * k1), k3 = v(x + 0.5 * h * k2), k4 = v(x + h * k3);
  return x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

}  // namespace

Vec3 VelocityField::operator()(const Vec3& point) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t j = 0; j < wave_vectors.size(); ++j) {
    const double phase = wave_vectors[j].dot(point);
    sum += std::cos(phase) * cosine[j] + std::sin(phase) * sine[j];
  }
  return sum;
}

std::vector<VelocityField> random_velocity_fields(int count, const RandomFieldOptions& options, Rng& rng) {
  FORAMEN_ASSERT(count >= 0 && options.correlation_mm > 0 && options.features > 0);
  const std::vector<Vec3> waves = random_waves(options, rng);
  // Each wave has a cosine and a sine, and cos^2 + sin^2 = 1, so the variance is 1 for any set of waves.
  const double scale = 1 / std::sqrt(static_cast<double>(options.features));
  std::vector<VelocityField> fields(count);
  for (VelocityField& field : fields) {
    field.wave_vectors = waves;
    for (int j = 0; j < options.features; ++j) {
      field.cosine.push_back(scale * normal_vector(rng));
      field.sine.push_back(scale * normal_vector(rng));
    }
  }
  return fields;
}

VelocityField symmetric_velocity_field(double left_right_correlation, const RandomFieldOptions& options,
                                       Rng& rng) {
  FORAMEN_ASSERT(std::abs(left_right_correlation) <= 1 && options.correlation_mm > 0 && options.features > 0);
  const double common = left_right_correlation, own = std::sqrt(1 - common * common);
  const double scale = 1 / std::sqrt(2.0 * options.features);  // two waves for every feature
  VelocityField field;
  const auto add = [&](const Vec3& wave, const Vec3& cosine, const Vec3& sine) {
    field.wave_vectors.push_back(wave);
    field.cosine.push_back(scale * cosine);
    field.sine.push_back(scale * sine);
  };
  for (const Vec3& wave : random_waves(options, rng)) {
    const Vec3 cosine = normal_vector(rng), sine = normal_vector(rng);
    const Vec3 own_cosine = normal_vector(rng), own_sine = normal_vector(rng);
    add(wave, cosine, sine);
    add(mirrored(wave), common * mirrored(cosine) + own * own_cosine,
        common * mirrored(sine) + own * own_sine);
  }
  return field;
}

VelocityField weighted_sum(std::span<const VelocityField> fields, std::span<const double> weights) {
  FORAMEN_ASSERT(!fields.empty() && fields.size() == weights.size());
  VelocityField sum{fields[0].wave_vectors, std::vector<Vec3>(fields[0].cosine.size(), Vec3::Zero()),
                    std::vector<Vec3>(fields[0].sine.size(), Vec3::Zero())};
  for (std::size_t k = 0; k < fields.size(); ++k) {
    FORAMEN_ASSERT(fields[k].wave_vectors == sum.wave_vectors);
    for (std::size_t j = 0; j < sum.cosine.size(); ++j) {
      sum.cosine[j] += weights[k] * fields[k].cosine[j];
      sum.sine[j] += weights[k] * fields[k].sine[j];
    }
  }
  return sum;
}

std::vector<Vec3> carried_by_flow(std::span<const Vec3> points, const Velocity& velocity, int steps) {
  FORAMEN_ASSERT(steps > 0);
  std::vector<Vec3> carried(points.begin(), points.end());
  for (Vec3& x : carried)
    for (int s = 0; s < steps; ++s) x = runge_kutta_step(velocity, x, 1.0 / steps);
  return carried;
}

}  // namespace foramen
