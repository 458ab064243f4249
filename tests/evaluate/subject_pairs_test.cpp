#include "evaluate/subject_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace foramen::detail {
namespace {

TEST(SubjectPairs, EveryShapeIsASubjectOfItsOwnIfNoneIsKnown) {
  const PairSubjects unknown(3, {}), known(3, {"a", "b", "a"});
  EXPECT_TRUE(unknown.differ(0, 2));
  EXPECT_FALSE(unknown.differ(1, 1));
  EXPECT_FALSE(known.differ(0, 2));
  EXPECT_TRUE(known.differ(0, 1));
}

TEST(MeanOverPairs, TheJackknifeLeavesOutAllPairsOfASubject) {
  // Without subject 0 the pair of 3 remains, without 1 that of 2, without 2 that of 1.
  const TransferEstimate e = mean_over_pairs({{0, 1, 1.0}, {0, 2, 2.0}, {1, 2, 3.0}}, {3, {}});
  EXPECT_DOUBLE_EQ(e.mean, 2);
  ASSERT_TRUE(e.standard_error);
  EXPECT_DOUBLE_EQ(*e.standard_error, std::sqrt(2.0 / 3 * (1 + 0 + 1)));
  EXPECT_EQ(e.pairs, 3);
}

TEST(MeanOverPairs, ShapesOfASubjectLeaveTogether) {
  const PairSubjects subjects(4, {"a", "a", "b", "c"});
  const TransferEstimate e = mean_over_pairs({{0, 2, 1.0}, {1, 3, 5.0}, {2, 3, 3.0}}, subjects);
  // Without a: 3; without b: 5; without c: 1.
  EXPECT_DOUBLE_EQ(*e.standard_error, std::sqrt(2.0 / 3 * (0 + 4 + 4)));
}

TEST(MeanOverPairs, TwoSubjectsHaveNoStandardError) {
  EXPECT_FALSE(mean_over_pairs({{0, 2, 1.0}, {1, 2, 2.0}}, {3, {"a", "a", "b"}}).standard_error);
}

TEST(MeanOverGroups, EveryGroupCountsAlikeHoweverManyPairsItHas) {
  const TransferEstimate e =
      mean_over_groups({{{0, 1, 1.0}, {1, 0, 2.0}, {1, 2, 3.0}}, {{0, 2, 8.0}}, {}}, {3, {}});
  EXPECT_DOUBLE_EQ(e.mean, 5);
  EXPECT_EQ(e.pairs, 4);
  // Without 0: 3; without 1: 8; without 2: 1.5.
  const double m = (3 + 8 + 1.5) / 3;
  EXPECT_NEAR(*e.standard_error,
              std::sqrt(2.0 / 3 * ((3 - m) * (3 - m) + (8 - m) * (8 - m) + (1.5 - m) * (1.5 - m))), 1e-14);
}

}  // namespace
}  // namespace foramen::detail
