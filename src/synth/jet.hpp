#pragma once
/// \file
/// Forward-mode automatic differentiation: a number together with its gradient in space.

#include <cmath>

#include "foramen/core/mesh.hpp"

namespace foramen::synth {

struct Jet {
  double value = 0;
  Vec3 gradient = Vec3::Zero();
};

inline Jet operator+(const Jet& a, const Jet& b) { return {a.value + b.value, a.gradient + b.gradient}; }
inline Jet operator-(const Jet& a, const Jet& b) { return {a.value - b.value, a.gradient - b.gradient}; }
inline Jet operator-(const Jet& a) { return {-a.value, -a.gradient}; }
inline Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, b.value * a.gradient + a.value * b.gradient};
}
inline Jet operator/(const Jet& a, const Jet& b) {
  const double q = a.value / b.value;
  return {q, (a.gradient - q * b.gradient) / b.value};
}
inline Jet operator+(const Jet& a, double b) { return {a.value + b, a.gradient}; }
inline Jet operator+(double a, const Jet& b) { return b + a; }
inline Jet operator-(const Jet& a, double b) { return {a.value - b, a.gradient}; }
inline Jet operator-(double a, const Jet& b) { return {a - b.value, -b.gradient}; }
inline Jet operator*(double a, const Jet& b) { return {a * b.value, a * b.gradient}; }
inline Jet operator/(const Jet& a, double b) { return (1 / b) * a; }

/// The chain rule: g(a) for a function g with value `value` and derivative `slope` at a.value.
inline Jet chain(double value, double slope, const Jet& a) { return {value, slope * a.gradient}; }
inline Jet exp(const Jet& a) {
  const double e = std::exp(a.value);
  return chain(e, e, a);
}
inline Jet abs(const Jet& a) { return a.value < 0 ? -a : a; }
/// \pre a > 0
inline Jet pow(const Jet& a, double exponent) {
  const double p = std::pow(a.value, exponent);
  return chain(p, exponent * p / a.value, a);
}
/// \pre a > 0
inline Jet sqrt(const Jet& a) {
  const double r = std::sqrt(a.value);
  return chain(r, 0.5 / r, a);
}

/// Cubic polynomial smooth minimum: min(a, b) - k h^3 / 6 with h = max(0, 1 - |a - b| / k). Equal to the
/// minimum where the arguments differ by k or more. Twice continuously differentiable.
inline Jet smooth_min(const Jet& a, const Jet& b, double k) {
  const Jet& low = a.value < b.value ? a : b;
  const Jet& high = a.value < b.value ? b : a;
  const double h = 1 - (high.value - low.value) / k;
  if (h <= 0) return low;
  const double share = 0.5 * h * h;
  return {low.value - k * h * h * h / 6, (1 - share) * low.gradient + share * high.gradient};
}
inline Jet smooth_max(const Jet& a, const Jet& b, double k) { return -smooth_min(-a, -b, k); }

}  // namespace foramen::synth
