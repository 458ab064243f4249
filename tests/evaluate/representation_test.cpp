#include "foramen/evaluate/representation.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

// A square of four triangles about a movable centre, at a height.
std::vector<Vec3> fan(double height, const Vec2& centre) {
  return {Vec3(centre.x(), centre.y(), height), Vec3(1, -1, height), Vec3(1, 1, height), Vec3(-1, 1, height),
          Vec3(-1, -1, height)};
}
const std::vector<std::array<int, 3>> fan_triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};

// The same square at height 0 in two triangles.
Mesh square() {
  return build_mesh({{{1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
}

// Three squares, each at another height above its input and in another pose.
CorrespondingCohort squares(const std::array<double, 3>& heights, const std::array<Vec2, 3>& centres) {
  CorrespondingCohort cohort;
  cohort.triangles = fan_triangles;
  Rng rng(4);
  for (std::size_t s = 0; s < 3; ++s) {
    const RigidTransform pose = testing::random_pose(rng);
    cohort.names.push_back("square" + std::to_string(s));
    cohort.corresponding.push_back(transformed(fan(heights[s], centres[s]), pose));
    cohort.inputs.push_back(transformed(square(), pose));
  }
  return cohort;
}

Representation representation_of(const CorrespondingCohort& cohort, int threads = 1) {
  return representation(cohort, align_cohort(cohort, ScaleMode::keep), {.samples = 200}, RunContext(threads));
}

const Vec2 middle(0, 0), beyond_the_side(1.5, 0);

TEST(RepresentationOfSquares, ParallelOnesAreAsFarApartAsTheirHeight) {
  const Representation r = representation_of(squares({0.5, 1, 3}, {middle, middle, middle}));
  ASSERT_EQ(r.shapes.size(), 3u);
  for (const auto& [s, height] : {std::pair<std::size_t, double>{0, 0.5}, {1, 1}, {2, 3}}) {
    EXPECT_NEAR(r.shapes[s].distance.mean, height, 1e-12);
    EXPECT_NEAR(r.shapes[s].distance.p95, height, 1e-12);
    EXPECT_NEAR(r.shapes[s].distance.hausdorff, height, 1e-12);
    ASSERT_EQ(r.shapes[s].map.landmark_mm.size(), 5u);
    for (const double d : r.shapes[s].map.landmark_mm) EXPECT_NEAR(d, height, 1e-12);
  }
  // Deviations from the mean of 1.5 are -1, -0.5 and 1.5.
  const double standard_error = std::sqrt((1 + 0.25 + 2.25) / 2) / std::sqrt(3);
  for (const Estimate& e : {r.mean_surface, r.p95, r.hausdorff}) {
    EXPECT_NEAR(e.mean, 1.5, 1e-12);
    EXPECT_NEAR(e.standard_error, standard_error, 1e-12);
  }
  for (const Estimate& e :
       {r.plain_flips, r.confirmed_flips, r.opposing_mean, r.self_intersections, r.input_self_intersections})
    EXPECT_EQ(e.mean, 0);
}

TEST(RepresentationOfSquares, ACentreBeyondItsSideTurnsOneTriangleOver) {
  const Representation r = representation_of(squares({1, 1, 1}, {middle, beyond_the_side, middle}));
  for (std::size_t s = 0; s < 3; ++s) {
    const int expected = s == 1 ? 1 : 0;
    EXPECT_EQ(r.shapes[s].plain_flips, expected);
    EXPECT_EQ(r.shapes[s].confirmed_flips, expected);
    EXPECT_EQ(r.shapes[s].opposing_mean, expected);
    EXPECT_EQ(r.shapes[s].map.plain_flips, std::vector<int>(expected, 0));
    EXPECT_EQ(r.shapes[s].map.confirmed_flips, r.shapes[s].map.plain_flips);
    EXPECT_EQ(r.shapes[s].degenerate, 0);
  }
  EXPECT_NEAR(r.plain_flips.mean, 1.0 / 3, 1e-12);
  EXPECT_NEAR(r.confirmed_flips.standard_error, 1.0 / 3, 1e-12);
  EXPECT_NEAR(r.opposing_mean.mean, 1.0 / 3, 1e-12);
}

TEST(RepresentationOfSquares, ACentreOnItsSideLeavesATriangleWithoutArea) {
  CorrespondingCohort cohort = squares({1, 1, 1}, {middle, middle, middle});
  cohort.corresponding[2][0] = 0.5 * (cohort.corresponding[2][1] + cohort.corresponding[2][2]);
  const Representation r = representation_of(cohort);
  EXPECT_EQ(r.shapes[2].degenerate, 1);
  EXPECT_EQ(r.shapes[2].plain_flips, 0);
  EXPECT_EQ(r.shapes[0].degenerate, 0);
}

// Self-intersections of the input are counted separately, because the correspondence does not cause them.
TEST(RepresentationOfSquares, AnInputThatMeetsItselfIsCountedAsTheInputs) {
  CorrespondingCohort cohort = squares({1, 1, 1}, {middle, middle, middle});
  TriangleSoup crossed = cohort.inputs[1].soup();
  const auto first = static_cast<int>(crossed.points.size());
  const Vec3 centre = 0.5 * (crossed.points[0] + crossed.points[2]);
  const Vec3 across = crossed.points[0] - crossed.points[2];
  const Vec3 up = (crossed.points[1] - crossed.points[0]).cross(across).normalized();
  // A small upright triangle that pierces the first of the two triangles and nothing else.
  const Vec3 inside = centre + 0.2 * (crossed.points[1] - centre);
  crossed.points.insert(crossed.points.end(),
                        {inside + 0.1 * up, inside - 0.1 * up, inside + 0.1 * up + 0.01 * across});
  crossed.triangles.push_back({first, first + 1, first + 2});
  cohort.inputs[1] = build_mesh(crossed);
  const Representation r = representation_of(cohort);
  EXPECT_EQ(r.shapes[1].input_self_intersections, 1);
  EXPECT_EQ(r.shapes[1].self_intersections, 0);
  EXPECT_NEAR(r.input_self_intersections.mean, 1.0 / 3, 1e-12);
}

TEST(RepresentationOfSquares, ThreadsChangeNothingAndAStopRequestEndsIt) {
  const CorrespondingCohort cohort = testing::torus_cohort({.shapes = 4});
  const Representation one = representation_of(cohort, 1), four = representation_of(cohort, 4);
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_EQ(one.shapes[s].distance.mean, four.shapes[s].distance.mean);
    EXPECT_EQ(one.shapes[s].map.landmark_mm, four.shapes[s].map.landmark_mm);
  }
  EXPECT_EQ(one.p95.standard_error, four.p95.standard_error);
  const RunContext stopped(1);
  stopped.request_stop();
  EXPECT_THROW(representation(cohort, align_cohort(cohort, ScaleMode::keep), {.samples = 10}, stopped),
               Cancelled);
}

TEST(RepresentationOfSquares, ACohortThatDoesNotFitIsRefused) {
  CorrespondingCohort cohort = squares({1, 1, 1}, {middle, middle, middle});
  const AlignedCohort aligned = align_cohort(cohort, ScaleMode::keep);
  cohort.inputs.pop_back();
  EXPECT_THROW(representation(cohort, aligned, {.samples = 10}, RunContext(1)), InvalidInput);
}

}  // namespace
}  // namespace foramen
