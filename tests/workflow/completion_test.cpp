#include "workflow/completion.hpp"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "support/meshes.hpp"
#include "support/messages.hpp"

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

// Parts of a torus, and a model whose mean is the whole torus.
class UsablePart : public ::testing::Test {
 protected:
  // The part is scaled so that its bounding box has this diagonal.
  PartOfVertebra taken(double diagonal, const InputUnit& unit = {}) const {
    TriangleSoup scaled = part_;
    for (Vec3& p : scaled.points) p *= diagonal / diagonal_;
    return usable_part(scaled, unit, model_);
  }

  const TriangleSoup torus_ = testing::torus_soup(24, 12);
  const double whole_ = bounding_box(torus_.points).diagonal();
  const ShapeModel model_{flattened(torus_.points), Eigen::MatrixXd(3 * torus_.points.size(), 0),
                          Eigen::VectorXd(0), torus_.triangles};
  const TriangleSoup part_{torus_.points, {torus_.triangles.begin(), torus_.triangles.begin() + 100}};
  const double diagonal_ =
      bounding_box(usable_part(part_, {LengthUnit::millimetre, true}, model_).mesh.positions()).diagonal();
};

TEST_F(UsablePart, IsOpenAndMayBeSmallerThanAVertebra) {
  EXPECT_EQ(taken(diagonal_).mesh.face_count(), 100);
  EXPECT_FALSE(taken(diagonal_).size_note);
  EXPECT_FALSE(taken(16).size_note) << "in cm it would be larger than the whole";
  EXPECT_THROW(usable_part({}, {}, model_), InvalidInput);
}

TEST_F(UsablePart, IsRefusedIfAnotherUnitWouldMakeItTheWhole) {
  const auto refused = [&](double diagonal, const InputUnit& unit = {}) {
    return testing::refusal([&] { taken(diagonal, unit); });
  };
  EXPECT_THAT(refused(whole_ / 10), testing::offers({{RemedyKind::give_unit, "cm"}}));
  EXPECT_THAT(refused(0.6 * whole_ / 1000), testing::offers({{RemedyKind::give_unit, "m"}}));
  EXPECT_THAT(refused(whole_ * 1000), testing::offers({{RemedyKind::give_unit, "um"}}));
  EXPECT_THAT(refused(whole_, LengthUnit::metre), testing::offers({{RemedyKind::leave_unit_out}}));
  EXPECT_THAT(refused(0.001), testing::offers({{RemedyKind::give_unit}}));
  EXPECT_NEAR(bounding_box(taken(whole_ / 1000, LengthUnit::metre).mesh.positions()).diagonal(), whole_,
              1e-9);
}

TEST_F(UsablePart, OfACertainUnitIsTakenWithANote) {
  const PartOfVertebra part = taken(whole_ / 10, {LengthUnit::millimetre, true});
  EXPECT_NEAR(bounding_box(part.mesh.positions()).diagonal(), whole_ / 10, 1e-9);
  ASSERT_TRUE(part.size_note);
  EXPECT_THAT(*part.size_note, testing::says("very little of a vertebra"));
}

}  // namespace
}  // namespace foramen
