#include "sampling/remesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "sampling/curvature_density.hpp"
#include "sampling/lift_to_surface.hpp"
#include "sampling/mapped_tori.hpp"

namespace foramen {
namespace {

using testing::MappedSurface;

const RunContext one_thread(1);

Mesh lifted(const MappedSurface& m, const LandmarkMesh& landmarks) {
  return build_mesh({lift_to_surface(TorusLocator(m.mesh, m.map), landmarks.turns), landmarks.triangles});
}

/// The smallest angles of the triangles in degrees, sorted.
std::vector<double> smallest_angles(const Mesh& mesh) {
  std::vector<double> out;
  for (FaceId f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    double smallest = 180;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = t[(k + 1) % 3] - t[k], b = t[(k + 2) % 3] - t[k];
      smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi);
    }
    out.push_back(smallest);
  }
  std::sort(out.begin(), out.end());
  return out;
}

VertexMap<double> uniform(const MappedSurface& m) { return VertexMap<double>(m.mesh.vertex_count(), 1.0); }

std::vector<MappedSurface> surfaces() {
  return {testing::torus(9000), testing::wavy_torus(9000), testing::spiky_torus(12000, 5, 8, 0.03)};
}

TEST(Remesh, GivesAnEmbeddedTriangulationOfTheTorusWithExactlySoManyLandmarks) {
  for (const auto& m : surfaces())
    for (int count : {16, 300, 1500}) {
      SCOPED_TRACE(m.name + " " + std::to_string(count));
      const LandmarkMesh l =
          remesh(m.mesh, m.map, curvature_density(m.mesh), one_thread, {.landmarks = count});
      ASSERT_EQ(static_cast<int>(l.turns.size()), count);
      EXPECT_EQ(static_cast<int>(l.triangles.size()), 2 * count);
      const Mesh mesh = lifted(m, l);  // throws unless every edge has two triangles and every fan is one disk
      EXPECT_EQ(mesh.euler_characteristic(), 0);
      const MapCertificate c = certify(mesh, {m.map.lattice, VertexMap<Vec2>(l.turns), l.jumps});
      EXPECT_TRUE(c.valid()) << c.flipped << " flipped, degree " << c.degree;
      for (HalfedgeId h : mesh.halfedges()) EXPECT_EQ(mesh.find_halfedge(mesh.from(h), mesh.to(h)), h);
      for (const Vec2& t : l.turns) EXPECT_TRUE(t.minCoeff() >= 0 && t.maxCoeff() < 1);
    }
}

TEST(Remesh, TrianglesAreNearEquilateral) {
  for (const auto& m : surfaces()) {
    SCOPED_TRACE(m.name);
    const LandmarkMesh l = remesh(m.mesh, m.map, curvature_density(m.mesh), one_thread, {.landmarks = 1500});
    const auto angles = smallest_angles(lifted(m, l));
    EXPECT_GE(angles.front(), 25);
    EXPECT_GE(angles[angles.size() / 2], 50);
  }
}

TEST(Remesh, MoreLandmarksThanVerticesAreInserted) {
  const MappedSurface m = testing::wavy_torus(700);
  const LandmarkMesh l = remesh(m.mesh, m.map, uniform(m), one_thread, {.landmarks = 2000});
  EXPECT_EQ(l.turns.size(), 2000u);
  const auto angles = smallest_angles(lifted(m, l));
  EXPECT_GE(angles[angles.size() / 2], 48);
}

TEST(Remesh, TheSameForAnyNumberOfThreadsAndEveryTime) {
  const MappedSurface m = testing::wavy_torus(6000);
  const auto density = curvature_density(m.mesh);
  const LandmarkMesh a = remesh(m.mesh, m.map, density, one_thread, {.landmarks = 700});
  for (int threads : {1, 2, 4}) {
    const LandmarkMesh b = remesh(m.mesh, m.map, density, RunContext(threads), {.landmarks = 700});
    EXPECT_EQ(a.turns, b.turns);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.jumps, b.jumps);
  }
}

TEST(Remesh, UniformDensityGivesEqualCells) {
  const MappedSurface m = testing::torus(20000, 30, 6);
  const LandmarkMesh l =
      remesh(m.mesh, m.map, uniform(m), one_thread, {.landmarks = 1000, .relaxation_rounds = 100});
  const Mesh mesh = lifted(m, l);
  const auto areas = vertex_areas(mesh);
  const double mean = total_area(mesh) / mesh.vertex_count();
  double variance = 0;
  for (double a : areas) variance += (a - mean) * (a - mean) / mesh.vertex_count();
  EXPECT_LT(std::sqrt(variance) / mean, 0.12);
  EXPECT_LT(*std::max_element(areas.begin(), areas.end()), 1.5 * mean);
  EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 0.5 * mean);
}

TEST(Remesh, SamplesFollowTheDensity) {
  // The density on one half of the torus is ten times that on the other half, with a smooth transition.
  const MappedSurface m = testing::torus(20000, 30, 6);
  VertexMap<double> density(m.mesh.vertex_count(), 1.0);
  for (VertexId v : m.mesh.vertices()) {
    const double s = std::sin(2 * std::numbers::pi * m.map.turns[v].x());
    density[v] = std::exp(std::log(10.0) * std::clamp(0.5 + 2 * s, 0.0, 1.0));
  }
  const LandmarkMesh l = remesh(m.mesh, m.map, density, one_thread, {.landmarks = 2000});
  const auto within = [&](double low, double high) {
    return std::count_if(l.turns.begin(), l.turns.end(),
                         [&](const Vec2& t) { return t.x() >= low && t.x() < high; });
  };
  const double ratio = static_cast<double>(within(0.1, 0.4)) / static_cast<double>(within(0.6, 0.9));
  EXPECT_NEAR(ratio, 10, 1.5);
}

TEST(CurvatureDensity, FollowsTheCurvatureOfATorus) {
  // On a thin torus curvature is nearly (1/minor)^2 (|K| + H^2) / 2 with H = 1/(2 minor): constant; fins
  // change that.
  const MappedSurface m = testing::torus(20000, 100, 5);
  const auto flat = curvature_density(m.mesh, {.contrast = 1});
  const auto [low, high] = std::minmax_element(flat.begin(), flat.end());
  EXPECT_GT(*low / *high, 0.8);

  // (|K| + H^2) / 2 in closed form: k1 = 1 / r, k2 = cos v / (R + r cos v).
  const MappedSurface fat = testing::torus(20000, 20, 10);
  const auto density = curvature_density(
      fat.mesh, {.contrast = 1, .floor = 1e-6, .smoothing_rounds = 0, .curvature_radius = 0.004});
  const auto exact = [&](VertexId v) {
    const double c = std::cos(2 * std::numbers::pi * fat.map.turns[v].y()), k1 = 0.1, k2 = c / (20 + 10 * c);
    return (std::abs(k1 * k2) + std::pow((k1 + k2) / 2, 2)) / 2;
  };
  double largest = 0;
  for (VertexId v : fat.mesh.vertices()) largest = std::max(largest, exact(v));
  for (VertexId v : fat.mesh.vertices()) EXPECT_NEAR(density[v], exact(v) / largest, 0.03) << v.index;
}

TEST(CurvatureDensity, KeepsItsFloorAndDoesNotDependOnSizeOrPlace) {
  const MappedSurface m = testing::spiky_torus(8000, 5, 8, 0.03);
  const CurvatureDensityOptions options{.floor = 0.2};
  const auto density = curvature_density(m.mesh, options);
  EXPECT_GE(*std::min_element(density.begin(), density.end()), 0.2 - 1e-12);
  EXPECT_LE(*std::max_element(density.begin(), density.end()), 1.0 + 1e-12);
  std::vector<Vec3> moved;
  for (const Vec3& p : m.mesh.positions()) moved.emplace_back(3 * p.y() + 100, -3 * p.x(), 3 * p.z() - 7);
  const auto again = curvature_density(m.mesh.with_positions(moved), options);
  for (VertexId v : m.mesh.vertices()) EXPECT_NEAR(density[v], again[v], 1e-9);
}

TEST(CurvatureDensity, SpikesGetMoreThanTheRest) {
  const MappedSurface m = testing::spiky_torus(12000, 5, 8, 0.03);
  const auto density = curvature_density(m.mesh);
  const VertexId tip(static_cast<int>(
      std::max_element(m.mesh.positions().begin(), m.mesh.positions().end(),
                       [](const Vec3& a, const Vec3& b) { return a.head<2>().norm() < b.head<2>().norm(); }) -
      m.mesh.positions().begin()));
  std::vector<double> sorted = density.values();
  std::nth_element(sorted.begin(), sorted.begin() + 6000, sorted.end());
  EXPECT_GT(density[tip], 2 * sorted[6000]);
}

TEST(Remesh, NamesWhatIsWrong) {
  const MappedSurface m = testing::torus(400);
  EXPECT_THROW(remesh(m.mesh, m.map, uniform(m), one_thread, {.landmarks = 5}), InvalidInput);
  auto density = uniform(m);
  density[VertexId(3)] = 0;
  EXPECT_THROW(remesh(m.mesh, m.map, density, one_thread, {.landmarks = 100}), InvalidInput);
  EXPECT_THROW(curvature_density(m.mesh, {.floor = 0}), InvalidInput);
  EXPECT_THROW(curvature_density(m.mesh, {.contrast = -1}), InvalidInput);
  EXPECT_THROW(curvature_density(m.mesh, {.curvature_radius = 0}), InvalidInput);
}

TEST(Remesh, StopsWhenAsked) {
  const MappedSurface m = testing::torus(2000);
  const RunContext ctx(1);
  ctx.request_stop();
  EXPECT_THROW(remesh(m.mesh, m.map, uniform(m), ctx, {.landmarks = 100}), Cancelled);
}

}  // namespace
}  // namespace foramen
