#include "sampling/refine_landmarks.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "sampling/mapped_cohort.hpp"
#include "spatial/self_intersections.hpp"

namespace foramen {
namespace {

using testing::bent_spikes;
using testing::landmarks_of;
using testing::MappedCohort;
using testing::spikes;
using testing::walled_torus;

TEST(RefineLandmarks, LeavesAGoodTriangulationAlone) {
  const MappedCohort cohort({testing::torus(6000), testing::wavy_torus(6000)});
  const LandmarkMesh l = landmarks_of(testing::torus(6000), 800);
  const RefinedLandmarks r = refine_landmarks(l, cohort.shapes(), RunContext(1));
  EXPECT_EQ(r.initial, 0);
  EXPECT_EQ(r.remaining, 0);
  EXPECT_EQ(r.inserted + r.flips + r.moved, 0);
  EXPECT_EQ(r.landmarks.turns, l.turns);
  EXPECT_EQ(r.landmarks.triangles, l.triangles);
}

TEST(RefineLandmarks, RepairsThinSpikesOnAllShapes) {
  const MappedCohort cohort = bent_spikes(0.04);
  for (int count : {200, 400, 800}) {
    SCOPED_TRACE(count);
    const LandmarkMesh l = landmarks_of(spikes(), count);
    ASSERT_GT(cohort.guilty(l), 10) << "the example needs something to repair";
    const RefinedLandmarks r = refine_landmarks(l, cohort.shapes(), RunContext(2));
    EXPECT_EQ(r.initial, cohort.guilty(l));
    EXPECT_EQ(r.remaining, 0);
    EXPECT_EQ(cohort.guilty(r.landmarks), 0);
    EXPECT_LE(r.inserted, count / 20);
    EXPECT_EQ(r.landmarks.turns.size(), l.turns.size() + static_cast<std::size_t>(r.inserted));

    const auto& first = cohort.surfaces[0];
    const Mesh mesh =
        build_mesh({lift_to_surface(cohort.locators[0], r.landmarks.turns), r.landmarks.triangles});
    EXPECT_EQ(mesh.euler_characteristic(), 0);
    EXPECT_TRUE(
        certify(mesh, {first.map.lattice, VertexMap<Vec2>(r.landmarks.turns), r.landmarks.jumps}).valid());
  }
}

TEST(RefineLandmarks, TheSameForAnyNumberOfThreads) {
  const MappedCohort cohort = bent_spikes(0.04);
  const LandmarkMesh l = landmarks_of(spikes(), 800);
  const RefinedLandmarks a = refine_landmarks(l, cohort.shapes(), RunContext(1));
  const RefinedLandmarks b = refine_landmarks(l, cohort.shapes(), RunContext(3));
  EXPECT_GT(a.flips, 0);
  EXPECT_EQ(a.landmarks.turns, b.landmarks.turns);
  EXPECT_EQ(a.landmarks.triangles, b.landmarks.triangles);
  EXPECT_EQ(a.landmarks.jumps, b.landmarks.jumps);
}

TEST(RefineLandmarks, PartsTheSidesOfThinWalls) {
  const MappedCohort cohort(
      {walled_torus(0.01, 0.0, 0.15), walled_torus(0.01, 0.3, 0.15), testing::torus(6000)});
  for (const TriangleTree& tree : cohort.trees) ASSERT_TRUE(self_intersections(tree).empty());
  for (int count : {200, 800}) {
    SCOPED_TRACE(count);
    const LandmarkMesh l = landmarks_of(testing::torus(20000), count);
    ASSERT_GT(cohort.meetings(l), 20) << "the example needs something to repair";
    const RefinedLandmarks r = refine_landmarks(l, cohort.shapes(), RunContext(2));
    EXPECT_EQ(r.initial_self_intersections, cohort.meetings(l));
    EXPECT_EQ(r.remaining_self_intersections, 0);
    EXPECT_EQ(cohort.meetings(r.landmarks), 0);
    EXPECT_EQ(cohort.guilty(r.landmarks), 0);
    EXPECT_LE(r.inserted, count / 20);
    const Mesh mesh =
        build_mesh({lift_to_surface(cohort.locators[0], r.landmarks.turns), r.landmarks.triangles});
    const Lattice& lattice = cohort.surfaces[0].map.lattice;
    EXPECT_TRUE(certify(mesh, {lattice, VertexMap<Vec2>(r.landmarks.turns), r.landmarks.jumps}).valid());

    const RefinedLandmarks other = refine_landmarks(l, cohort.shapes(), RunContext(4));
    EXPECT_EQ(r.landmarks.turns, other.landmarks.turns);
    EXPECT_EQ(r.landmarks.triangles, other.landmarks.triangles);
    EXPECT_EQ(r.landmarks.jumps, other.landmarks.jumps);
  }
}

TEST(RefineLandmarks, PartsAWallWithNewLandmarksOnlyOrSaysThatItMeets) {
  const MappedCohort cohort({walled_torus(0.005, 0.0, 0.1)});
  const LandmarkMesh l = landmarks_of(testing::torus(20000), 400);
  const RefinedLandmarks without = refine_landmarks(l, cohort.shapes(), RunContext(1), {.budget = 0});
  EXPECT_EQ(without.inserted, 0);
  EXPECT_GT(without.remaining_self_intersections, 0);
  EXPECT_LT(without.remaining_self_intersections, without.initial_self_intersections);
  EXPECT_EQ(without.remaining_self_intersections, cohort.meetings(without.landmarks));
  const RefinedLandmarks with = refine_landmarks(l, cohort.shapes(), RunContext(1));
  EXPECT_GT(with.inserted, 0);
  EXPECT_EQ(cohort.meetings(with.landmarks), 0);
}

TEST(RefineLandmarks, AnotherRoundNeverEndsWithMore) {
  for (const auto& [width, count] : {std::pair(0.1, 400), std::pair(0.15, 400)}) {
    const MappedCohort cohort({walled_torus(0.002, 0.0, width), walled_torus(0.002, 0.3, width)});
    const LandmarkMesh l = landmarks_of(testing::torus(20000), count);
    int former = cohort.meetings(l);
    for (int rounds = 0; rounds <= 5; ++rounds) {
      const RefinedLandmarks r = refine_landmarks(l, cohort.shapes(), RunContext(2), {.round_limit = rounds});
      EXPECT_LE(r.remaining_self_intersections, former) << width << " turns wide, " << rounds << " rounds";
      EXPECT_EQ(r.remaining_self_intersections, cohort.meetings(r.landmarks));
      former = r.remaining_self_intersections;
    }
  }
}

TEST(RefineLandmarks, LeavesShapesWhoseInputMeetsItselfAsTheyAre) {
  // The two sides of the wall are exchanged.
  const MappedCohort cohort({walled_torus(-0.5, 0.0, 0.1)});
  ASSERT_FALSE(self_intersections(cohort.trees[0]).empty());
  const LandmarkMesh l = landmarks_of(testing::torus(20000), 400);
  ASSERT_GT(cohort.meetings(l), 0);
  const RefinedLandmarks r = refine_landmarks(l, cohort.shapes(), RunContext(1));
  EXPECT_EQ(r.initial_self_intersections, 0);
  EXPECT_EQ(r.remaining_self_intersections, 0);
  EXPECT_EQ(r.landmarks.turns, l.turns);
  EXPECT_EQ(r.landmarks.triangles, l.triangles);
}

TEST(RefineLandmarks, NeverLeavesMoreThanItFoundAndSaysWhatIsLeft) {
  // One round without new landmarks is not enough here.
  const MappedCohort cohort = bent_spikes(0.04);
  const LandmarkMesh l = landmarks_of(spikes(), 800);
  const RefinedLandmarks r =
      refine_landmarks(l, cohort.shapes(), RunContext(1), {.budget = 0, .round_limit = 1});
  EXPECT_EQ(r.inserted, 0);
  EXPECT_GT(r.remaining, 0);
  EXPECT_LT(r.remaining, r.initial);
  EXPECT_EQ(r.remaining, cohort.guilty(r.landmarks));
  EXPECT_THROW(refine_landmarks(l, cohort.shapes(), RunContext(1), {.budget = -1}), InvalidInput);
}

}  // namespace
}  // namespace foramen
