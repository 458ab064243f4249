#include "evaluate/paired_p_value.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"

namespace foramen {
namespace {

constexpr double quanta_of_largest = 0x1p40;
constexpr std::uint64_t seed = 1;
constexpr int bits_a_word = 64;

using Quanta = std::vector<std::int64_t>;

Quanta quanta(std::span<const double> differences) {
  double largest = 0;
  for (const double d : differences) {
    if (!std::isfinite(d)) throw InvalidInput("paired test: a difference is not finite; check the figures");
    largest = std::max(largest, std::abs(d));
  }
  Quanta q;
  q.reserve(differences.size());
  for (const double d : differences)
    q.push_back(largest > 0 ? std::llround(d / largest * quanta_of_largest) : 0);
  return q;
}

/// Enumerates the sign patterns in the order of a Gray code, in which one sign changes at a time. The last
/// sign is fixed, because a pattern and its opposite have the same result.
double enumerated(Quanta q, std::int64_t observed) {
  const std::uint64_t patterns = std::uint64_t{1} << (q.size() - 1);
  std::int64_t sum = observed;
  std::uint64_t as_extreme = 1;
  for (std::uint64_t i = 1; i < patterns; ++i) {
    std::int64_t& flipped = q[std::countr_zero(i)];
    sum -= 2 * flipped;
    flipped = -flipped;
    if (std::abs(sum) >= std::abs(observed)) ++as_extreme;
  }
  return static_cast<double>(as_extreme) / static_cast<double>(patterns);
}

double sampled(const Quanta& q, std::int64_t observed) {
  Rng rng(seed);
  int as_extreme = 0;
  for (int pattern = 0; pattern < random_sign_patterns; ++pattern) {
    std::int64_t sum = 0;
    std::uint64_t signs = 0;
    for (std::size_t i = 0; i < q.size(); ++i, signs >>= 1) {
      if (i % bits_a_word == 0) signs = rng.bits();
      sum += (signs & 1) != 0 ? q[i] : -q[i];
    }
    if (std::abs(sum) >= std::abs(observed)) ++as_extreme;
  }
  return (1.0 + as_extreme) / (1.0 + random_sign_patterns);
}

}  // namespace

double paired_p_value(std::span<const double> differences) {
  if (differences.empty()) throw InvalidInput("paired test: there are no differences; it needs 1 or more");
  const Quanta q = quanta(differences);
  const std::int64_t observed = std::accumulate(q.begin(), q.end(), std::int64_t{0});
  return static_cast<int>(q.size()) <= most_enumerated_differences ? enumerated(q, observed)
                                                                   : sampled(q, observed);
}

}  // namespace foramen
