#include "foramen/core/rng.hpp"

#include <cmath>
#include <numbers>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

// The finaliser of SplitMix64. It makes the streams of neighbouring seeds independent.
std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

}  // namespace

Rng::Rng(std::uint64_t seed) : seed_(seed), engine_(mix(seed)) {}

Rng Rng::fork(std::uint64_t stream) const { return Rng(mix(seed_) ^ mix(~stream)); }

double Rng::uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

int Rng::below(int count) {
  FORAMEN_ASSERT(count > 0);
  const auto n = static_cast<std::uint64_t>(count);
  const std::uint64_t limit = UINT64_MAX - UINT64_MAX % n;
  std::uint64_t x = engine_();
  while (x >= limit) x = engine_();
  return static_cast<int>(x % n);
}

double Rng::normal() {
  const double radius = std::sqrt(-2 * std::log(1.0 - uniform()));  // 1 - u is never 0
  return radius * std::cos(2 * std::numbers::pi * uniform());
}

}  // namespace foramen
