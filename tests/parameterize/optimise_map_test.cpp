#include "parameterize/optimise_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "parameterize/distortion.hpp"
#include "parameterize/mapped_torus.hpp"
#include "support/real_meshes.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

using testing::mapped_bumpy_torus;
using testing::MappedTorus;

const RunContext quiet(1);

MATCHER(NeverIncreases, "") {
  for (std::size_t k = 1; k < arg.size(); ++k)
    if (arg[k] > arg[k - 1]) return false;
  return true;
}

// Half the squared distance of each vertex to the nearest translate of its target.
class Pull : public CorrespondenceObjective {
 public:
  Pull(const Mesh& mesh, const TorusMap& target)
      : reducer_(target.lattice), target_(mesh.vertex_count(), Vec2::Zero()) {
    for (VertexId v : mesh.vertices()) target_[v] = target.lattice * target.turns[v];
  }
  Term term(VertexId v, const Vec2& x) const override {
    const Vec2 d = reducer_.shortest(x - target_[v]);
    return {d.squaredNorm() / 2, d, Mat2::Identity()};
  }
  double distance(VertexId v, const Vec2& x) const { return reducer_.shortest(x - target_[v]).norm(); }

 private:
  LatticeReducer reducer_;
  VertexMap<Vec2> target_;
};

// An objective that is zero everywhere.
class NoPull : public CorrespondenceObjective {
 public:
  Term term(VertexId, const Vec2&) const override { return {}; }
};

// Moves the first corner of the first face towards the middle of the opposite edge until the triangle has
// only this share of its area in the map.
TorusMap with_thin_triangle(const Mesh& mesh, TorusMap map, double share) {
  const auto corners = mesh.corners(FaceId(0));
  const Vec2 jump0 = map.jumps[Mesh::halfedge(FaceId(0), 0)].cast<double>(),
             jump2 = map.jumps[Mesh::halfedge(FaceId(0), 2)].cast<double>();
  const Vec2 middle = (map.turns[corners[1]] + jump0 + map.turns[corners[2]] - jump2) / 2;
  map.turns[corners[0]] += (1 - share) * (middle - map.turns[corners[0]]);
  return map;
}

OptimiseMapOptions tight() {
  OptimiseMapOptions o;
  o.relative_tolerance = 1e-11;
  return o;
}

TEST(OptimiseMap, IsAFixedPointOnAnIsometricMap) {
  const Mesh mesh = testing::folded_flat_torus(16, 10, 40, 40);
  const TorusMap start = harmonic_torus_map(mesh, testing::grid_form(mesh, testing::regular_cells(16, 10)));
  const OptimisedMap out = optimise_map(mesh, start, quiet);
  EXPECT_EQ(out.status, OptimiseStatus::converged);
  EXPECT_NEAR(out.initial_energy, 4, 1e-12);
  EXPECT_NEAR(out.final_energy, 4, 1e-12);
  EXPECT_NEAR(out.distortion, 4, 1e-12);
}

TEST(OptimiseMap, FindsTheIsometryOfAFlatTorusAgain) {
  const Mesh mesh = testing::folded_flat_torus(16, 10, 40, 40);
  TorusMap start = harmonic_torus_map(mesh, testing::grid_form(mesh, testing::regular_cells(16, 10)));
  Rng rng(1);
  for (Vec2& p : start.turns) p += 0.015 * Vec2(rng.uniform(-1, 1), rng.uniform(-1, 1));
  ASSERT_EQ(testing::flipped_triangles(mesh, start), 0);
  const OptimisedMap out = optimise_map(mesh, start, quiet, tight());
  EXPECT_GT(out.initial_energy, 4.1);
  EXPECT_NEAR(out.final_energy, 4, 1e-9);
}

// A flat torus of 80 x 20 mm, mapped to the square torus, has the singular values 1/2 and 2 everywhere. If
// the lattice is free, the result is the lattice 2 x 1/2, without distortion.
TEST(OptimiseMap, FindsTheLatticeOfAFlatTorus) {
  const Mesh mesh = testing::folded_flat_torus(24, 10, 80, 20);
  const TorusMap start = harmonic_torus_map(mesh, testing::grid_form(mesh, testing::regular_cells(24, 10)));
  EXPECT_NEAR(optimise_map(mesh, start, quiet).final_energy, 2 * (4 + 0.25), 1e-9);
  OptimiseMapOptions options = tight();
  options.free_lattice = true;
  const OptimisedMap out = optimise_map(mesh, start, quiet, options);
  EXPECT_NEAR(out.final_energy, 4, 1e-9);
  EXPECT_NEAR(out.map.lattice(0, 0), 2, 1e-4);
  EXPECT_NEAR(out.map.lattice(0, 1), 0, 1e-4);
  EXPECT_NEAR(out.map.lattice.determinant(), 1, 1e-12);
}

TEST(OptimiseMap, DecreasesWithoutFlipsToWithinTheTolerance) {
  for (const auto& [name, torus] : testing::genus1_maps()) {
    SCOPED_TRACE(name);
    const OptimisedMap out = optimise_map(torus.mesh, torus.map, quiet);
    EXPECT_EQ(out.status, OptimiseStatus::converged);
    EXPECT_LE(out.iterations, 30);
    EXPECT_EQ(out.iterations + 1, static_cast<int>(out.energies.size()));
    EXPECT_THAT(out.energies, NeverIncreases());
    EXPECT_LT(out.final_energy, out.initial_energy);
    EXPECT_NEAR(out.distortion, out.final_energy, 1e-12);
    EXPECT_TRUE(certify(torus.mesh, out.map).valid());
    const double best = optimise_map(torus.mesh, torus.map, quiet, tight()).final_energy;
    EXPECT_LE(out.final_energy, best * (1 + 1e-4));
  }
}

// A vertex that lies almost on an opposite edge makes a triangle of the map so thin that rounding in its
// Hessian exceeds the Hessians of all others, and the sum has negative eigenvalues. The isometry is the known
// result.
TEST(OptimiseMap, OpensATriangleWhoseHessianIsSpoiltByRounding) {
  const Mesh mesh = testing::folded_flat_torus(16, 10, 40, 40);
  const TorusMap flat = harmonic_torus_map(mesh, testing::grid_form(mesh, testing::regular_cells(16, 10)));
  for (const double share : {1e-3, 1e-5, 1e-6, 1e-7}) {
    SCOPED_TRACE(share);
    const OptimisedMap out = optimise_map(mesh, with_thin_triangle(mesh, flat, share), quiet, tight());
    EXPECT_GT(out.initial_energy, 1 / share);
    EXPECT_THAT(out.energies, NeverIncreases());
    EXPECT_NEAR(out.final_energy, 4, 1e-8);
  }
}

TEST(OptimiseMap, EveryIterateIsWithoutFlips) {
  const MappedTorus torus = mapped_bumpy_torus(40, 22, 4);
  for (const Optimiser method : {Optimiser::newton, Optimiser::polak_ribiere})
    for (int limit = 0; limit < 6; ++limit) {
      OptimiseMapOptions options = tight();  // so that Newton's method also reaches the limit
      options.optimiser = method;
      options.iteration_limit = limit;
      const OptimisedMap out = optimise_map(torus.mesh, torus.map, quiet, options);
      EXPECT_EQ(testing::flipped_triangles(torus.mesh, out.map), 0);
      EXPECT_EQ(out.iterations, limit);
      EXPECT_EQ(out.status, OptimiseStatus::iteration_limit);
    }
}

TEST(OptimiseMap, FreeingTheLatticeNeverCostsEnergy) {
  for (const auto& [name, torus] : testing::genus1_maps()) {
    SCOPED_TRACE(name);
    OptimiseMapOptions options = tight();
    const double fixed = optimise_map(torus.mesh, torus.map, quiet, options).final_energy;
    options.free_lattice = true;
    const OptimisedMap out = optimise_map(torus.mesh, torus.map, quiet, options);
    EXPECT_LT(out.final_energy, fixed);
    EXPECT_THAT(out.energies, NeverIncreases());
    EXPECT_NEAR(out.map.lattice.determinant(), 1, 1e-12);
    EXPECT_EQ(out.map.lattice(1, 0), 0);
    EXPECT_TRUE(certify(torus.mesh, out.map).valid());
    // The energy is computed again for the same positions and lattice.
    OptimiseMapOptions none;
    none.iteration_limit = 0;
    EXPECT_NEAR(optimise_map(torus.mesh, out.map, quiet, none).final_energy, out.final_energy, 1e-9);
  }
}

TEST(OptimiseMap, EnergyIgnoresRigidMotionsAndScale) {
  const MappedTorus torus = mapped_bumpy_torus(24, 10, 3);
  RigidTransform motion = RigidTransform::Identity();
  motion.rotate(Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized())).pretranslate(Vec3(100, -20, 3));
  std::vector<Vec3> larger;
  for (const Vec3& p : torus.mesh.positions()) larger.push_back(3 * p);
  const double energy = optimise_map(torus.mesh, torus.map, quiet, tight()).final_energy;
  EXPECT_NEAR(optimise_map(transformed(torus.mesh, motion), torus.map, quiet, tight()).final_energy / energy,
              1, 1e-9);
  EXPECT_NEAR(
      optimise_map(torus.mesh.with_positions(larger), torus.map, quiet, tight()).final_energy / energy, 1,
      1e-9);
}

TEST(OptimiseMap, EnergyIgnoresTheNumbering) {
  const TriangleSoup soup = testing::bumpy_torus_soup(24, 10, 3), shuffled = testing::renumbered(soup, 9);
  const auto cells = testing::regular_cells(24, 10);
  const Mesh mesh = build_mesh(soup), other = build_mesh(shuffled);
  const TorusMap map = harmonic_torus_map(mesh, testing::grid_form(mesh, cells));
  const TorusMap renumbered_map =
      harmonic_torus_map(other, testing::grid_form(other, testing::matching_cells(cells, soup, shuffled)));
  const double energy = optimise_map(mesh, map, quiet, tight()).final_energy;
  EXPECT_NEAR(optimise_map(other, renumbered_map, quiet, tight()).final_energy / energy, 1, 1e-9);
}

TEST(OptimiseMap, SameBytesInEveryRunAndForAnyNumberOfThreads) {
  const MappedTorus torus = mapped_bumpy_torus(24, 10, 3);
  const Pull pull(torus.mesh, torus.map);
  for (const Optimiser method : {Optimiser::newton, Optimiser::polak_ribiere}) {
    OptimiseMapOptions options;
    options.optimiser = method;
    const OptimisedMap first = optimise_map(torus.mesh, torus.map, quiet, options, &pull);
    for (const int threads : {1, 2, 8}) {
      const OptimisedMap again = optimise_map(torus.mesh, torus.map, RunContext(threads), options, &pull);
      EXPECT_EQ(again.map.turns, first.map.turns);
      EXPECT_EQ(again.energies, first.energies);
    }
  }
}

TEST(OptimiseMap, RefusesAFlippedStartAndNamesTheTriangle) {
  auto [mesh, map] = mapped_bumpy_torus(12, 9, 1);
  map.turns[VertexId(60)] += Vec2(0.3, 0.1);
  const std::string name = "triangle " + std::to_string(testing::first_flipped(mesh, map).index) + " ";
  try {
    optimise_map(mesh, map, quiet);
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr(name));
  }
}

TEST(OptimiseMap, RefusesASurfaceTriangleWithoutArea) {
  const auto [mesh, map] = mapped_bumpy_torus(12, 9, 1);
  std::vector<Vec3> points(mesh.positions().begin(), mesh.positions().end());
  const auto c = mesh.corners(FaceId(33));
  points[c[2].index] = points[c[1].index];
  try {
    optimise_map(mesh.with_positions(points), map, quiet);
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("has no area on the surface"));
  }
}

TEST(OptimiseMap, RefusesOptionsThatContradict) {
  const auto [mesh, map] = mapped_bumpy_torus(12, 9, 1);
  const Pull pull(mesh, map);
  OptimiseMapOptions no_barrier, free_with_target, free_sweeps;
  no_barrier.lambda = 0;
  EXPECT_THROW(optimise_map(mesh, map, quiet, no_barrier, &pull), InvalidInput);
  EXPECT_NO_THROW(optimise_map(mesh, map, quiet, no_barrier));
  free_with_target.free_lattice = true;
  EXPECT_THROW(optimise_map(mesh, map, quiet, free_with_target, &pull), InvalidInput);
  free_sweeps.free_lattice = true;
  free_sweeps.optimiser = Optimiser::polak_ribiere;
  EXPECT_THROW(optimise_map(mesh, map, quiet, free_sweeps), InvalidInput);
}

TEST(OptimiseMap, FollowsAPullAcrossTheCut) {
  const auto [mesh, map] = mapped_bumpy_torus(24, 10, 3);
  TorusMap target = optimise_map(mesh, map, quiet).map;
  for (Vec2& p : target.turns)
    p = Vec2(wrap(p.x() + 0.2), wrap(p.y() - 0.25));  // the objective does not depend on jumps
  const Pull pull(mesh, target);
  for (const Optimiser method : {Optimiser::newton, Optimiser::polak_ribiere})
    for (const Weighting weighting : {Weighting::area, Weighting::each}) {
      OptimiseMapOptions options;
      options.optimiser = method;
      options.weighting = weighting;
      options.lambda = 1e-4;
      options.relative_tolerance = 1e-7;
      options.iteration_limit = 2000;
      const OptimisedMap out = optimise_map(mesh, map, quiet, options, &pull);
      EXPECT_EQ(out.status, OptimiseStatus::converged);
      EXPECT_THAT(out.energies, NeverIncreases());
      EXPECT_TRUE(certify(mesh, out.map).valid());
      double sum = 0;
      for (VertexId v : mesh.vertices()) sum += pull.distance(v, out.map.lattice * out.map.turns[v]);
      EXPECT_LT(sum / mesh.vertex_count(), 0.01);
    }
}

TEST(OptimiseMap, EnergyWithAPullIsTheDocumentedSum) {
  const auto [mesh, map] = mapped_bumpy_torus(12, 9, 3);
  TorusMap target = map;
  for (Vec2& p : target.turns) p += Vec2(0.1, 0.2);
  const Pull pull(mesh, target);
  const double total = total_area(mesh);
  const VertexMap<double> areas = vertex_areas(mesh);
  double by_area = 0, each = 0;
  for (VertexId v : mesh.vertices()) {
    by_area += areas[v] / total * 0.025;
    each += 0.025;
  }
  for (FaceId f : mesh.faces()) {
    const auto plane = plane_triangle(mesh, map, f);
    std::array<Vec3, 3> surface = mesh.triangle(f);
    const double share = area(surface) / total;
    for (Vec3& p : surface) p /= std::sqrt(total);
    const double e = angle_distortion(surface, plane) * area_distortion(surface, plane);
    by_area += 0.3 * share * e;
    each += 0.3 * e;
  }
  OptimiseMapOptions options;
  options.lambda = 0.3;
  options.iteration_limit = 0;
  EXPECT_NEAR(optimise_map(mesh, map, quiet, options, &pull).initial_energy / by_area, 1, 1e-10);
  options.weighting = Weighting::each;
  EXPECT_NEAR(optimise_map(mesh, map, quiet, options, &pull).initial_energy / each, 1, 1e-10);
}

TEST(OptimiseMap, AnObjectiveWithoutPullLeavesTheDistortionAlone) {
  const auto [mesh, map] = mapped_bumpy_torus(24, 10, 3);
  const NoPull nothing;
  EXPECT_NEAR(optimise_map(mesh, map, quiet, tight(), &nothing).final_energy /
                  optimise_map(mesh, map, quiet, tight()).final_energy,
              1, 1e-8);
}

TEST(OptimiseMap, SweepsReachTheSameMinimum) {
  const auto [mesh, map] = mapped_bumpy_torus(24, 10, 3);
  const double best = optimise_map(mesh, map, quiet, tight()).final_energy;
  OptimiseMapOptions options;
  options.optimiser = Optimiser::polak_ribiere;
  options.relative_tolerance = 1e-8;
  options.iteration_limit = 5000;
  const OptimisedMap out = optimise_map(mesh, map, quiet, options);
  EXPECT_EQ(out.status, OptimiseStatus::converged);
  EXPECT_THAT(out.energies, NeverIncreases());
  EXPECT_NEAR(out.final_energy / best, 1, 1e-3);
}

TEST(OptimiseMap, StopsAtTheEnergyAskedFor) {
  const auto [mesh, map] = mapped_bumpy_torus(24, 10, 3);
  const OptimisedMap full = optimise_map(mesh, map, quiet);
  for (const Optimiser method : {Optimiser::newton, Optimiser::polak_ribiere}) {
    OptimiseMapOptions options;
    options.optimiser = method;
    options.stop_at_energy = 1.05 * full.final_energy;
    const OptimisedMap out = optimise_map(mesh, map, quiet, options);
    EXPECT_EQ(out.status, OptimiseStatus::converged);
    EXPECT_LE(out.final_energy, *options.stop_at_energy);
    EXPECT_GT(out.energies[out.energies.size() - 2], *options.stop_at_energy);
  }
}

TEST(OptimiseMap, StopsWhenAsked) {
  const auto [mesh, map] = mapped_bumpy_torus(12, 9, 3);
  const RunContext stopped(1);
  stopped.request_stop();
  EXPECT_THROW(optimise_map(mesh, map, stopped), Cancelled);
}

TEST(OptimiseMapRealData, ConvergesWithoutFlips) {
  FORAMEN_NEEDS_REAL_DATA();
  const Mesh mesh = testing::real_mesh("lumbar/verse005_L1");
  Cocycle form = cocycle(mesh, greedy_loops(mesh, VertexId(0), edge_lengths(mesh)));
  TorusMap start;
  try {
    start = harmonic_torus_map(mesh, form);
  } catch (const TopologyError&) {
    for (Vec2i& t : form.value) std::swap(t[0], t[1]);
    start = harmonic_torus_map(mesh, form);
  }
  const OptimisedMap fixed = optimise_map(mesh, start, quiet);
  OptimiseMapOptions options;
  options.free_lattice = true;
  const OptimisedMap free = optimise_map(mesh, start, quiet, options);
  for (const OptimisedMap& out : {fixed, free}) {
    EXPECT_EQ(out.status, OptimiseStatus::converged);
    EXPECT_LE(out.iterations, 30);
    EXPECT_THAT(out.energies, NeverIncreases());
    EXPECT_TRUE(certify(mesh, out.map).valid());
  }
  EXPECT_LT(free.final_energy, fixed.final_energy);
}

}  // namespace
}  // namespace foramen
