#pragma once
/// \file
/// Random numbers that do not depend on the standard library or on the number of threads.

#include <cstdint>
#include <random>

namespace foramen {

/// A seeded stream of random numbers. The distributions are implemented here, because those of std differ
/// between standard libraries.
class Rng {
 public:
  explicit Rng(std::uint64_t seed);
  /// Returns an independent stream for the item of index `stream`. It depends on the seed and the index only
  /// and does not advance this stream, so the order of forks does not matter.
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
