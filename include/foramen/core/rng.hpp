#pragma once
/// \file
/// Random numbers that are the same on every library and for every number of threads.

#include <cstdint>
#include <random>

namespace foramen {

/// A seeded stream. The distributions are our own: those of std differ between standard libraries.
class Rng {
 public:
  explicit Rng(std::uint64_t seed);
  /// An independent stream for item `stream`; does not change this one, so the order of forks does not
  /// matter.
  Rng fork(std::uint64_t stream) const;
  std::uint64_t bits() { return engine_(); }
  /// Uniform in [0, 1), 53 bits.
  double uniform();
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in 0 .. count-1, without bias. \pre count > 0.
  int below(int count);
  /// Standard normal (Box-Muller).
  double normal();

 private:
  std::uint64_t seed_;
  std::mt19937_64 engine_;
};

}  // namespace foramen
