#include "match/vertex_matches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/match/bending_options.hpp"
#include "match/robust_weight.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;

std::vector<VertexMatch> matches_at(const std::vector<double>& distances) {
  std::vector<VertexMatch> matches;
  for (const double d : distances) matches.push_back({0, {Vec3::Zero(), Vec3::UnitZ()}, d, 1});
  return matches;
}

TEST(MatchCut, IsSoManyMediansAndNeverLessThanOfTheLeast) {
  EXPECT_DOUBLE_EQ(match_cut(matches_at({9, 1, 2}), {}), 4 * 2);
  EXPECT_DOUBLE_EQ(match_cut(matches_at({9, 1, 2, 3}), {.rejection = 3}), 3 * 3);  // the upper median
  EXPECT_DOUBLE_EQ(match_cut(matches_at({0.1, 0.2, 7}), {}), 4 * 0.5);
  EXPECT_DOUBLE_EQ(match_cut(matches_at({0.1, 0.2, 7}), {.least_median_mm = 1}), 4 * 1);
}

TEST(MatchPrecision, HoldsAcrossTheSurfaceAndLessAlongIt) {
  const VertexMatch match{7, {Vec3(1, 2, 3), Vec3::UnitX()}, 3, 10};
  const MatchOptions options{.tangential_share = 0.2, .independent_area_mm2 = 40};
  const MatchScale scale{.noise_mm = 0.5, .cut_mm = 6};
  const Mat3 p = match_precision(match, {Vec3::Zero(), Vec3::UnitY()}, scale, options);
  const double weight = (1 - 0.25) * (1 - 0.25) * (10.0 / 40) / (2 * 0.25);
  const Vec3 across = Vec3(1, 1, 0).normalized(), along = Vec3(1, -1, 0).normalized();
  EXPECT_LT((p * across - weight * across).norm(), 1e-12);
  EXPECT_LT((p * along - 0.2 * weight * along).norm(), 1e-12);
  EXPECT_LT((p * Vec3::UnitZ() - 0.2 * weight * Vec3::UnitZ()).norm(), 1e-12);
}

TEST(MatchPrecision, HoldsMoreAlongTheSurfaceWhereBothAreCurved) {
  const MatchScale scale{.noise_mm = 0.5, .cut_mm = 6};
  const MatchOptions options{.tangential_share = 0.2, .curved_share = 0.9};
  const auto share_with = [&](double of_vertex, double of_partner) {
    const VertexMatch match{7, {Vec3::Zero(), Vec3::UnitX(), false, of_partner}, 3, 10};
    const Mat3 p = match_precision(match, {Vec3::Zero(), Vec3::UnitX(), false, of_vertex}, scale, options);
    return p(1, 1) / p(0, 0);
  };
  EXPECT_NEAR(share_with(0.5, 0.8), 0.2 + 0.9 * 0.5 * 0.8, 1e-12);
  EXPECT_NEAR(share_with(0, 0.8), 0.2, 1e-12);
  EXPECT_NEAR(share_with(1, 1), 1, 1e-12);
}

TEST(MatchPrecision, EndsAtTheCut) {
  const MatchScale scale{.noise_mm = 1, .cut_mm = 2};
  for (const double distance : {2.0, 3.0}) {
    const VertexMatch match{0, {Vec3::Zero(), Vec3::UnitX()}, distance, 10};
    EXPECT_TRUE(match_precision(match, {Vec3::Zero(), Vec3::UnitX()}, scale, {}).isZero(0));
  }
}

TEST(MatchOptions, AreRefusedOutOfTheirRangesInTheCallersName) {
  EXPECT_NO_THROW(check_options("somebody", MatchOptions{}));
  const auto refused = [](const MatchOptions& options) {
    try {
      check_options("somebody", options);
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refused({.samples = 0}), HasSubstr("somebody: samples"));
  EXPECT_THAT(refused({.normal_weight = -1}), HasSubstr("somebody: normal_weight"));
  EXPECT_THAT(refused({.tangential_share = 0}), HasSubstr("somebody: tangential_share"));
  EXPECT_THAT(refused({.tangential_share = 1.1}), HasSubstr("somebody: tangential_share"));
  EXPECT_THAT(refused({.independent_area_mm2 = 0}), HasSubstr("somebody: independent_area"));
  EXPECT_THAT(refused({.rejection = 0}), HasSubstr("rejection"));
  EXPECT_THAT(refused({.least_median_mm = 0}), HasSubstr("least_median"));
}

TEST(TukeyWeight, FallsFromOneToNone) {
  EXPECT_EQ(tukey_weight(0), 1);
  EXPECT_DOUBLE_EQ(tukey_weight(0.5), 0.25);
  EXPECT_EQ(tukey_weight(1), 0);
  EXPECT_EQ(tukey_weight(4), 0);
}

TEST(UpperMedian, IsAValueInTheMiddle) {
  EXPECT_EQ(upper_median({5}), 5);
  EXPECT_EQ(upper_median({3, 1, 2}), 2);
  EXPECT_EQ(upper_median({4, 1, 3, 2}), 3);
}

}  // namespace
}  // namespace foramen
