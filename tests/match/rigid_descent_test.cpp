#include "match/rigid_descent.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "match/oriented_points.hpp"
#include "support/lopsided_torus.hpp"

namespace foramen::detail {
namespace {

const RunContext ctx(1);

RigidTransform turn(double angle) { return RigidTransform(Eigen::AngleAxisd(angle, Vec3::UnitZ())); }

// The samples are vertices of the surface itself, so the identity fits exactly.
class RigidDescent : public ::testing::Test {
 protected:
  const Mesh mesh = build_mesh(testing::lopsided_torus_soup(60, 30));
  const IndexedPoints targets{oriented_vertices(mesh), 8};
  const std::vector<OrientedPoint> samples = oriented_vertices(mesh);
  const Matching matching = [this](const RigidTransform& at) { return matches_of(samples, targets, at); };
  const Pose start{.at = Eigen::Translation3d(0.4, -0.3, 0.2) * turn(0.05)};
};

TEST_F(RigidDescent, EndsWhereMatchesNoLongerMoveIt) {
  const Pose end = descend(start, matching, {.iteration_limit = 100, .tolerance = 1e-6}, ctx);
  EXPECT_TRUE(end.converged);
  EXPECT_LT(end.iterations, 100);
  EXPECT_LT(end.residual, 1e-5);
  EXPECT_LT((end.at.matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-5);
}

TEST_F(RigidDescent, GoesOnFromAPose) {
  const DescentOptions two{.iteration_limit = 2, .tolerance = 0}, four{.iteration_limit = 4, .tolerance = 0};
  const Pose twice = descend(descend(start, matching, two, ctx), matching, two, ctx);
  const Pose once = descend(start, matching, four, ctx);
  EXPECT_EQ(twice.at.matrix(), once.at.matrix());
  EXPECT_EQ(twice.iterations, 4);
  EXPECT_FALSE(twice.converged);
}

TEST_F(RigidDescent, LaterStepsAreShorter) {
  const DescentOptions one{.iteration_limit = 1}, none_full{.iteration_limit = 2, .full_steps = 0};
  const Pose full = descend(start, matching, one, ctx);
  const Pose then_half = descend(start, matching, none_full, ctx);
  const auto moved_by = [](const Pose& a, const Pose& b) {
    return (a.at.translation() - b.at.translation()).norm();
  };
  const Pose then_full = descend(full, matching, one, ctx);
  EXPECT_NEAR(moved_by(full, then_half), 0.5 * moved_by(full, then_full), 0.02 * moved_by(full, then_full));
}

TEST(MeanResidual, FarMatchesCountAsTwelveMillimetres) {
  std::vector<Match> matches(2);
  matches[0].distance = 2;
  matches[1].distance = 1000;
  EXPECT_DOUBLE_EQ(mean_residual(matches), 7);
}

TEST(DistinctAnswers, AreTheBestOfEachRotation) {
  std::vector<Pose> poses{{turn(0), 3}, {turn(1), 1}, {turn(0.1), 2}, {turn(1.15), 4}, {turn(2), 5}};
  sort_best_first(poses);
  const std::vector<Pose> answers = distinct_answers(poses);
  ASSERT_EQ(answers.size(), 3u);
  EXPECT_EQ(answers[0].residual, 1);
  EXPECT_EQ(answers[1].residual, 2);
  EXPECT_EQ(answers[2].residual, 5);
  EXPECT_EQ(distinct_answers(poses, 2).size(), 2u);
}

}  // namespace
}  // namespace foramen::detail
