#include "workflow/completion.hpp"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

// Four landmarks with standard deviations of 1, 2, 3 and 5 mm, of which the first and the last are seen.
CompletedSurface known_completion() {
  CompletedSurface completed;
  completed.shape.mean = Eigen::VectorXd::Zero(12);
  completed.shape.factor = Eigen::MatrixXd::Zero(12, 2);
  completed.shape.factor(0, 0) = 1;
  completed.shape.factor(4, 1) = -2;
  completed.shape.factor(8, 0) = 3;
  completed.shape.factor(9, 0) = 3;  // across two columns and coordinates: 3, 4
  completed.shape.factor(11, 1) = 4;
  completed.seen = {true, false, false, true};
  completed.distance_mm = 0.4;
  completed.matched_share = 0.9;
  completed.second_best_mm = 2;
  return completed;
}

TEST(CompletionJson, GivesMeansOverSeenAndUnseenLandmarks) {
  const auto json = completion_json(known_completion());
  EXPECT_EQ(json.at("distance_mm"), 0.4);
  EXPECT_EQ(json.at("matched_share"), 0.9);
  EXPECT_EQ(json.at("seen_share"), 0.5);
  EXPECT_NEAR(json.at("standard_deviation_seen_mm").get<double>(), 3, 1e-12);
  EXPECT_NEAR(json.at("standard_deviation_unseen_mm").get<double>(), 2.5, 1e-12);
  EXPECT_EQ(json.at("second_best_pose_mm"), 2);
}

TEST(CompletionJson, WhatThereIsNotIsZeroOrNull) {
  CompletedSurface completed = known_completion();
  completed.seen.assign(4, true);
  completed.second_best_mm = std::numeric_limits<double>::infinity();
  const auto json = completion_json(completed);
  EXPECT_EQ(json.at("seen_share"), 1);
  EXPECT_EQ(json.at("standard_deviation_unseen_mm"), 0);
  EXPECT_TRUE(json.at("second_best_pose_mm").is_null());
}

TEST(CompletionNote, IsMadeOnlyOfAnotherPoseThatFitsNearlyAsWell) {
  CompletedSurface completed = known_completion();
  EXPECT_FALSE(completion_note(completed));
  completed.second_best_mm = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(completion_note(completed));
  completed.second_best_mm = 1.05 * completed.distance_mm;
  ASSERT_TRUE(completion_note(completed));
  EXPECT_THAT(*completion_note(completed), ::testing::HasSubstr("0.42"));
  completed.second_best_mm = 1.2 * completed.distance_mm;
  EXPECT_FALSE(completion_note(completed));
}

TEST(UsablePart, TakesAnOpenPartAndRefusesWhatIsNoVertebrasSize) {
  TriangleSoup part = testing::torus_soup(24, 12);
  part.triangles.resize(100);
  EXPECT_EQ(usable_part(part).face_count(), 100);
  for (Vec3& p : part.points) p *= 0.1;
  EXPECT_EQ(usable_part(part).face_count(), 100) << "a part may be small";
  for (Vec3& p : part.points) p *= 1000;
  EXPECT_THROW(usable_part(part), InvalidInput);
  EXPECT_THROW(usable_part({}), InvalidInput);
}

}  // namespace
}  // namespace foramen
