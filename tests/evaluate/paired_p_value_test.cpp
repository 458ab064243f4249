#include "evaluate/paired_p_value.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"

namespace foramen {
namespace {

double p_of(const std::vector<double>& differences) { return paired_p_value(differences); }

TEST(PairedPValue, OfThreeDifferencesByHand) {
  EXPECT_EQ(p_of({1, 2, 3}), 0.25);   // sums 6, 4, 2, 0 and their opposites: 6 twice of 8
  EXPECT_EQ(p_of({1, 2, -4}), 1);     // |sums| 7, 1, 3, 5: all reach 1
  EXPECT_EQ(p_of({1, -2, 4}), 0.75);  // the same: 7, 3, 5 reach 3
  EXPECT_EQ(p_of({-1, 2, 4}), 0.5);   // 7, 5 reach 5
  EXPECT_EQ(p_of({-1, -2, -4}), 0.25);
  EXPECT_EQ(p_of({1, 1, -1}), 1);  // |sums| 3, 1, 1, 1
}

TEST(PairedPValue, OfVeryFewAndOfZeroDifferences) {
  EXPECT_EQ(p_of({5}), 1);
  EXPECT_EQ(p_of({5, 1}), 0.5);
  EXPECT_EQ(p_of({0, 0, 0, 0}), 1);
  EXPECT_EQ(p_of({7, 0, 0, 0}), 1) << "a difference of zero has no sign";
  const std::vector<double> positive(20, 0.3);
  EXPECT_EQ(paired_p_value(positive), std::ldexp(1.0, -19));
}

// 0.1 + 0.2 - 0.3 is not 0 in floating point, but must count as equal to 0.
TEST(PairedPValue, TiesCountWhateverTheLastDigits) {
  EXPECT_EQ(p_of({0.1, 0.2, -0.3}), 1);
  EXPECT_EQ(p_of({0.1, 0.2, 0.3 + 1e-16, 0.0}), 0.25);
  const double third = 1.0 / 3;
  EXPECT_EQ(p_of({third, third, -third, third * (1 + 1e-15)}), p_of({1, 1, -1, 1}));
  EXPECT_EQ(p_of({1, 1, -1, 1}), 10.0 / 16);  // at most one sign, or all but at most one, against the others
}

// Enumerates all patterns and computes each sum separately.
double brute_force(const std::vector<double>& d) {
  double observed = 0;
  for (const double x : d) observed += x;
  int count = 0;
  for (unsigned pattern = 0; pattern < 1u << d.size(); ++pattern) {
    double sum = 0;
    for (std::size_t i = 0; i < d.size(); ++i) sum += (pattern >> i & 1u) != 0 ? d[i] : -d[i];
    count += std::abs(sum) >= std::abs(observed) - 1e-9;
  }
  return count / std::ldexp(1.0, static_cast<int>(d.size()));
}

TEST(PairedPValue, IsTheShareOfAllPatterns) {
  Rng rng(3);
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<double> d;
    const int n = 1 + rng.below(11);
    for (int i = 0; i < n; ++i) d.push_back(rng.normal() + 0.4);
    EXPECT_DOUBLE_EQ(paired_p_value(d), brute_force(d));
  }
}

TEST(PairedPValue, DependsOnNeitherOrderNorUnitNorTheSignOfAll) {
  const std::vector<double> d{0.5, -0.1, 0.9, 0.3, 0.2, -0.4, 0.8};
  std::vector<double> backwards(d.rbegin(), d.rend()), scaled = d, opposite = d;
  for (double& x : scaled) x *= 1e-6;
  for (double& x : opposite) x = -x;
  EXPECT_EQ(paired_p_value(backwards), paired_p_value(d));
  EXPECT_EQ(paired_p_value(scaled), paired_p_value(d));
  EXPECT_EQ(paired_p_value(opposite), paired_p_value(d));
}

TEST(PairedPValue, RandomPatternsEstimateTheSame) {
  std::vector<double> d{0.5, -0.1, 0.9, 0.3, 0.2, -0.4, 0.8, 0.1, -0.7, 0.6};
  const double exact = paired_p_value(d);
  d.resize(30, 0.0);  // zeros change no sum
  const double deviation = std::sqrt(exact * (1 - exact) / random_sign_patterns);
  EXPECT_NEAR(paired_p_value(d), exact, 4 * deviation);
  EXPECT_EQ(paired_p_value(d), paired_p_value(d));
  const std::vector<double> many(70, 1.0);
  EXPECT_EQ(paired_p_value(many), 1.0 / (1 + random_sign_patterns)) << "never 0";
}

TEST(PairedPValue, RefusesNothingAndNoNumber) {
  EXPECT_THROW(p_of({}), InvalidInput);
  EXPECT_THROW(p_of({1, std::numeric_limits<double>::quiet_NaN()}), InvalidInput);
}

}  // namespace
}  // namespace foramen
