#include "foramen/resample/refine_landmarks.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/parameterize/certificate.hpp"
#include "foramen/spatial/flips.hpp"
#include "foramen/spatial/self_intersections.hpp"
#include "resample/mapped_tori.hpp"

namespace foramen {
namespace {

using testing::MappedSurface;

/// Shapes with what lifting and judging needs; the surfaces must outlive it.
struct Cohort {
  std::vector<MappedSurface> surfaces;
  std::vector<TorusLocator> locators;
  std::vector<TriangleTree> trees;
  explicit Cohort(std::vector<MappedSurface> of) : surfaces(std::move(of)) {
    for (const auto& s : surfaces) {
      locators.emplace_back(s.mesh, s.map);
      trees.emplace_back(s.mesh);
    }
  }
  std::vector<LandmarkShape> shapes() const {
    std::vector<LandmarkShape> out;
    for (std::size_t i = 0; i < surfaces.size(); ++i) out.push_back({&locators[i], &trees[i]});
    return out;
  }
  int guilty(const LandmarkMesh& l) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const auto f =
          sampled_flips(build_mesh({lift_to_surface(locators[i], l.turns), l.triangles}), trees[i]);
      count += f.confirmed.size() + f.degenerate.size();
    }
    return static_cast<int>(count);
  }
  int meetings(const LandmarkMesh& l) const {
    std::size_t count = 0;
    for (const TorusLocator& locator : locators)
      count += self_intersections(TriangleTree(build_mesh({lift_to_surface(locator, l.turns), l.triangles})))
                   .size();
    return static_cast<int>(count);
  }
};

/// A torus whose tube, 16 mm high, is pressed flat in one place: a bent wall of thickness 2 * half_wall_mm.
MappedSurface walled_torus(double half_wall_mm, double middle_turns, double width_turns) {
  return testing::mapped_surface("walled torus", testing::rectangular_lattice(20, 8), 20000,
                                 [=](const Vec2& t) {
                                   const double x = std::remainder(t.x() - middle_turns, 1.0) / width_turns;
                                   const double across = 3 - (3 - half_wall_mm) * std::exp(-x * x / 2);
                                   const Vec2 a = 2 * std::numbers::pi * t;
                                   const double r = 20 + across * std::cos(a.y());
                                   return Vec3(r * std::cos(a.x()), r * std::sin(a.x()), 8 * std::sin(a.y()));
                                 });
}

MappedSurface spikes() { return testing::spiky_torus(20000, 6, 14, 0.02); }

LandmarkMesh landmarks_of(const MappedSurface& m, int count) {
  return remesh(m.mesh, m.map, curvature_density(m.mesh), RunContext(1), {.landmarks = count});
}

/// The spiky torus three times, its maps bent differently: landmarks that suit the unbent map miss the thin
/// tips.
Cohort bent_spikes(double strength) {
  std::vector<MappedSurface> out;
  for (int k = 0; k < 3; ++k) {
    out.push_back(spikes());
    TorusMap& map = out.back().map;
    for (Vec2& t : map.turns) {
      const Vec2 a = 2 * std::numbers::pi * t;
      t += strength * Vec2(std::sin(3 * a.y() + k), std::sin(2 * a.x() + 2 * a.y() + 2 * k));
    }
    map = quantised(out.back().mesh, map);
  }
  return Cohort(std::move(out));
}

TEST(RefineLandmarks, LeavesAGoodTriangulationAlone) {
  const Cohort cohort({testing::torus(6000), testing::wavy_torus(6000)});
  const LandmarkMesh l = landmarks_of(testing::torus(6000), 800);
  const RefinedLandmarks r = refine_landmarks(l, cohort.shapes(), RunContext(1));
  EXPECT_EQ(r.initial, 0);
  EXPECT_EQ(r.remaining, 0);
  EXPECT_EQ(r.inserted + r.flips + r.moved, 0);
  EXPECT_EQ(r.landmarks.turns, l.turns);
  EXPECT_EQ(r.landmarks.triangles, l.triangles);
}

TEST(RefineLandmarks, RepairsThinSpikesOnAllShapes) {
  const Cohort cohort = bent_spikes(0.04);
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
  const Cohort cohort = bent_spikes(0.04);
  const LandmarkMesh l = landmarks_of(spikes(), 800);
  const RefinedLandmarks a = refine_landmarks(l, cohort.shapes(), RunContext(1));
  const RefinedLandmarks b = refine_landmarks(l, cohort.shapes(), RunContext(3));
  EXPECT_GT(a.flips, 0);
  EXPECT_EQ(a.landmarks.turns, b.landmarks.turns);
  EXPECT_EQ(a.landmarks.triangles, b.landmarks.triangles);
  EXPECT_EQ(a.landmarks.jumps, b.landmarks.jumps);
}

TEST(RefineLandmarks, PartsTheSidesOfThinWalls) {
  const Cohort cohort({walled_torus(0.01, 0.0, 0.15), walled_torus(0.01, 0.3, 0.15), testing::torus(6000)});
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
  const Cohort cohort({walled_torus(0.005, 0.0, 0.1)});
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

TEST(RefineLandmarks, LeavesShapesWhoseInputMeetsItselfAsTheyAre) {
  // The wall's sides have changed places.
  const Cohort cohort({walled_torus(-0.5, 0.0, 0.1)});
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
  // One round and no new landmark: not enough here.
  const Cohort cohort = bent_spikes(0.04);
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
