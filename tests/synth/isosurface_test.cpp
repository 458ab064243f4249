#include "synth/isosurface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "synth/marching_tetrahedra.hpp"

namespace foramen {
namespace {

constexpr double major_mm = 20, minor_mm = 7;

ImplicitValue ball(const Vec3& p) { return {p.norm() - 20, p.normalized()}; }
ImplicitValue torus(const Vec3& p) {
  const double r = std::hypot(p.x(), p.y());
  const Vec3 on_circle = major_mm / r * Vec3(p.x(), p.y(), 0);
  return {(p - on_circle).norm() - minor_mm, (p - on_circle).normalized()};
}
// Two balls that do not touch.
ImplicitValue two_balls(const Vec3& p) {
  const Vec3 a = p - Vec3(-12, 0, 0), b = p - Vec3(12, 0, 0);
  return a.norm() < b.norm() ? ImplicitValue{a.norm() - 8, a.normalized()}
                             : ImplicitValue{b.norm() - 8, b.normalized()};
}

IsosurfaceOptions options(int vertices) {
  IsosurfaceOptions o;
  o.bounds = {Vec3::Constant(-32), Vec3::Constant(32)};
  o.vertices = vertices;
  return o;
}

RigidTransform some_pose() {
  RigidTransform pose(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  pose.translation() = Vec3(0.3, -0.2, 0.6);
  return pose;
}

double smallest_angle_degrees(const Mesh& mesh) {
  double smallest = 180;
  for (FaceId f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 u = t[(k + 1) % 3] - t[k], v = t[(k + 2) % 3] - t[k];
      smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi);
    }
  }
  return smallest;
}

TEST(Isosurface, HasTheTopologyOfTheSolid) {
  const struct {
    const char* name;
    ImplicitFunction function;
    int euler;
  } cases[] = {{"ball", ball, 2}, {"torus", torus, 0}, {"two balls", two_balls, 4}};
  for (const auto& c : cases)
    for (int rounds : {0, 5}) {
      SCOPED_TRACE(c.name + std::to_string(rounds));
      IsosurfaceOptions o = options(2000);
      o.rounds = rounds;
      o.lattice = some_pose();
      const Mesh mesh = build_mesh(isosurface(c.function, o));
      EXPECT_TRUE(mesh.is_closed());
      EXPECT_EQ(mesh.euler_characteristic(), c.euler);
      EXPECT_GT(signed_volume(mesh), 0);
    }
}

TEST(Isosurface, VerticesLieOnTheSurfaceAndAreaAndVolumeAreRight) {
  const Mesh mesh = build_mesh(isosurface(torus, options(8000)));
  for (const Vec3& p : mesh.positions()) EXPECT_LT(std::abs(torus(p).value), 1e-8);
  constexpr double pi = std::numbers::pi;
  EXPECT_NEAR(total_area(mesh) / (4 * pi * pi * major_mm * minor_mm), 1, 0.005);
  EXPECT_NEAR(signed_volume(mesh) / (2 * pi * pi * major_mm * minor_mm * minor_mm), 1, 0.01);
}

TEST(Isosurface, ReachesTheNumberOfVerticesFromBothSides) {
  for (int vertices : {300, 1000, 5000, 20000}) {  // the lattice gives about 6000
    const Mesh mesh = build_mesh(isosurface(torus, options(vertices)));
    EXPECT_NEAR(mesh.vertex_count(), vertices, 0.05 * vertices);
    EXPECT_EQ(mesh.euler_characteristic(), 0);
  }
}

TEST(Isosurface, TrianglesAreNearlyEquilateralAndFaceOutward) {
  const Mesh mesh = build_mesh(isosurface(torus, options(5000)));
  EXPECT_GT(smallest_angle_degrees(mesh), 20);
  for (FaceId f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    EXPECT_GT(unit_normal(t).dot(torus((t[0] + t[1] + t[2]) / 3).gradient), 0.9);
  }
}

TEST(Isosurface, AnotherLatticeAnotherTriangulationOfTheSameSurface) {
  IsosurfaceOptions a = options(3000), b = a;
  b.lattice = some_pose();
  const TriangleSoup first = isosurface(torus, a), second = isosurface(torus, b);
  EXPECT_NE(first.triangles, second.triangles);
  EXPECT_NEAR(total_area(build_mesh(first)), total_area(build_mesh(second)),
              0.002 * total_area(build_mesh(first)));
}

TEST(Isosurface, IsTheSameInEveryRun) {
  const TriangleSoup a = isosurface(torus, options(2000)), b = isosurface(torus, options(2000));
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
}

// Whatever the signs at the lattice points, the surface between them is closed and manifold.
TEST(MarchingTetrahedra, IsClosedAndManifoldForNoise) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Rng rng(seed);
    const ImplicitFunction noise = [&](const Vec3& p) {
      const double rim = p.cwiseAbs().maxCoeff() - 4.6;
      // a fixed pseudo-random sign per place, asked for twice by the marcher
      const double s = std::sin(p.dot(Vec3(127.1, 311.7, 74.7)) + static_cast<double>(seed)) * 43758.5453;
      return ImplicitValue{rim > 0 ? rim : s - std::floor(s) - 0.5, Vec3::UnitX()};
    };
    const TriangleSoup soup = synth::march_tetrahedra(noise, {Vec3::Constant(-5), Vec3::Constant(5)}, 1.0,
                                                      RigidTransform::Identity());
    ASSERT_FALSE(soup.triangles.empty());
    const Mesh mesh = build_mesh(soup);
    EXPECT_TRUE(mesh.is_closed());
  }
}

TEST(Isosurface, RefusesWhatItCannotDo) {
  IsosurfaceOptions o = options(2000);
  o.spacing_mm = 0;
  EXPECT_THROW(isosurface(ball, o), InvalidInput);
  EXPECT_THROW(isosurface(ball, options(10)), InvalidInput);
  o = options(2000);
  o.rounds = -1;
  EXPECT_THROW(isosurface(ball, o), InvalidInput);
  EXPECT_THROW(isosurface(
                   [](const Vec3& p) {
                     return ImplicitValue{1 + p.squaredNorm(), 2 * p};
                   },
                   options(2000)),
               InvalidInput);
}

}  // namespace
}  // namespace foramen
