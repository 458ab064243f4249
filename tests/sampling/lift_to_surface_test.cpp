#include "sampling/lift_to_surface.hpp"

#include <Eigen/LU>

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "sampling/fixed_torus.hpp"
#include "sampling/mapped_tori.hpp"
#include "support/heap_in_use.hpp"

namespace foramen {
namespace {

using detail::Fixed2;
using testing::MappedSurface;

/// A torus with a deformed map, whose vertices are translated by random whole turns.
MappedSurface bent(int points, double strength, std::uint64_t seed) {
  MappedSurface m = testing::torus(points);
  Rng rng(seed);
  VertexMap<Vec2i> shift(m.mesh.vertex_count(), Vec2i::Zero());
  for (VertexId v : m.mesh.vertices()) {
    Vec2& t = m.map.turns[v];
    const double a = 2 * std::numbers::pi * t.x(), b = 2 * std::numbers::pi * t.y();
    t += strength / (2 * std::numbers::pi) * Vec2(std::sin(a) + 0.2 * std::sin(b), 0.5 * std::sin(b + 1));
    shift[v] = Vec2i(rng.below(5) - 2, rng.below(5) - 2);
    t += shift[v].cast<double>();
  }
  for (HalfedgeId h : m.mesh.halfedges()) m.map.jumps[h] += shift[m.mesh.from(h)] - shift[m.mesh.to(h)];
  m.map = quantised(m.mesh, m.map);
  return m;
}

/// The closed faces that contain a point, found by testing all faces in all neighbouring translates.
std::vector<int> faces_containing(const MappedSurface& m, const Vec2& turns) {
  std::vector<int> found;
  const Fixed2 q = detail::to_fixed(turns);
  for (FaceId f : m.mesh.faces()) {
    const auto c = m.mesh.corners(f);
    std::array<Fixed2, 3> p;
    Vec2i jump = Vec2i::Zero();
    for (int k = 0; k < 3; ++k) {
      p[k] = detail::to_fixed(m.map.turns[c[k]]) + detail::whole_turns(jump);
      jump += m.map.jumps[Mesh::halfedge(f, k)];
    }
    bool inside = false;
    const Vec2i near = detail::floor_turns(p[0] - q);
    for (int x = near.x() - 1; x <= near.x() + 2; ++x)
      for (int y = near.y() - 1; y <= near.y() + 2; ++y) {
        const Fixed2 s = q + detail::whole_turns({x, y});
        inside |= detail::orientation(p[0], p[1], s) >= 0 && detail::orientation(p[1], p[2], s) >= 0 &&
                  detail::orientation(p[2], p[0], s) >= 0;
      }
    if (inside) found.push_back(f.index);
  }
  return found;
}

Vec2 place_of(const MappedSurface& m, const SurfacePoint& p) {
  const auto t = plane_triangle(m.mesh, m.map, p.face);
  return m.map.lattice.inverse() *
         (p.barycentric[0] * t[0] + p.barycentric[1] * t[1] + p.barycentric[2] * t[2]);
}

double torus_distance(const Vec2& a, const Vec2& b) {
  return std::hypot(std::remainder(a.x() - b.x(), 1.0), std::remainder(a.y() - b.y(), 1.0));
}

TEST(TorusLocator, TakesLittleMemory) {
  const MappedSurface m = bent(20000, 0.5, 3);
  const double before = testing::heap_in_use();
  const TorusLocator locator(m.mesh, m.map);
  EXPECT_LT((testing::heap_in_use() - before) / m.mesh.face_count(), 96);  // bytes
}

TEST(TorusLocator, AgreesWithLookingAtAllTriangles) {
  for (double strength : {0.0, 0.5, 0.95}) {
    SCOPED_TRACE(strength);
    const MappedSurface m = bent(600, strength, 3);
    const TorusLocator locator(m.mesh, m.map);
    Rng rng(1);
    for (int i = 0; i < 300; ++i) {
      const Vec2 q(rng.uniform(), rng.uniform());
      const auto expected = faces_containing(m, q);
      const SurfacePoint p = locator.locate(q);
      EXPECT_TRUE(std::count(expected.begin(), expected.end(), p.face.index)) << i;
      EXPECT_GE(p.barycentric.minCoeff(), 0.0);
      EXPECT_NEAR(p.barycentric.sum(), 1.0, 1e-14);
      EXPECT_LT(torus_distance(place_of(m, p), q), 1e-11);
    }
  }
}

TEST(TorusLocator, AnyTranslateGivesTheSameAnswer) {
  const MappedSurface m = bent(2000, 0.8, 5);
  const TorusLocator locator(m.mesh, m.map);
  Rng rng(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 q = detail::to_turns(detail::to_fixed(Vec2(rng.uniform(), rng.uniform())));
    const SurfacePoint p = locator.locate(q);
    for (const Vec2& shift : {Vec2(1, 0), Vec2(-3, 2), Vec2(17, -40)}) {
      const SurfacePoint r = locator.locate(Vec2(q + shift));
      EXPECT_EQ(r.face, p.face);
      EXPECT_EQ(r.barycentric, p.barycentric);
    }
  }
  // A position that wrapping rounds to 1 must become 0.
  EXPECT_EQ(locator.locate(Vec2(-1e-17, 0.5)).face, locator.locate(Vec2(0, 0.5)).face);
}

/// A point on an edge belongs to the triangle that contains it after a motion by (e, e^2) with infinitesimal
/// e. The test moves it by the smallest possible steps, which are infinitesimal for a map with coarse
/// coordinates.
TEST(TorusLocator, PointsOnEdgesAndVerticesBelongToTheTriangleBesideThem) {
  MappedSurface m = testing::torus(200);
  const double coarse = 64;  // positions are multiples of 1/64 turn: edges have no slope below 2^-12
  for (Vec2& t : m.map.turns) t = (t * coarse).array().round() / coarse;
  const TorusLocator locator(m.mesh, m.map);
  const double unit = std::ldexp(1.0, -40);
  const Vec2 step(unit * 4096 * 16, unit);
  int on_vertex = 0;
  for (int i = 0; i < 128; ++i)
    for (int j = 0; j < 128; ++j) {
      const Vec2 q(i / 128.0, j / 128.0);
      const auto touching = faces_containing(m, q);
      on_vertex += touching.size() > 2;
      const auto beside = faces_containing(m, q + step);
      ASSERT_EQ(beside.size(), 1u);
      EXPECT_EQ(locator.locate(q).face.index, beside[0]) << i << " " << j;
    }
  EXPECT_GE(on_vertex, m.mesh.vertex_count());
}

TEST(TorusLocator, VerticesComeBackToThemselves) {
  const MappedSurface m = bent(3000, 0.9, 7);
  const TorusLocator locator(m.mesh, m.map);
  const auto lifted = lift_to_surface(locator, m.map.turns.values());
  for (VertexId v : m.mesh.vertices()) EXPECT_EQ((lifted[v.index] - m.mesh.position(v)).norm(), 0.0);
}

TEST(TorusLocator, StaysExactWhereTheMapIsStronglyCompressed) {
  // A quarter of the vertices in a thousandth of the domain.
  MappedSurface m = testing::torus(2000);
  for (Vec2& t : m.map.turns)
    for (int k = 0; k < 2; ++k) t[k] = std::pow(t[k], 5.0);
  m.map = quantised(m.mesh, m.map);
  const TorusLocator locator(m.mesh, m.map);
  Rng rng(4);
  for (int i = 0; i < 200; ++i) {
    const Vec2 q(std::pow(rng.uniform(), 5.0), std::pow(rng.uniform(), 5.0));
    const auto expected = faces_containing(m, q);
    EXPECT_TRUE(std::count(expected.begin(), expected.end(), locator.locate(q).face.index));
  }
}

TEST(TorusLocator, RefusesMapsThatCannotBeInverted) {
  const MappedSurface good = testing::torus(400);
  EXPECT_NO_THROW(TorusLocator(good.mesh, good.map));
  auto flipped = good.map;
  flipped.turns[VertexId(7)] += Vec2(0.4, 0);
  EXPECT_THROW(TorusLocator(good.mesh, flipped), InvalidInput);
  auto far = good.map;
  far.turns[VertexId(7)].x() = std::nan("");
  EXPECT_THROW(TorusLocator(good.mesh, far), InvalidInput);
  // A map that covers the torus twice: all triangles are positive, but every point is covered twice.
  auto twice = good.map;
  for (Vec2& t : twice.turns) t.x() *= 2;
  for (Vec2i& j : twice.jumps) j.x() *= 2;
  EXPECT_THROW(TorusLocator(good.mesh, twice), InvalidInput);
  auto open = good.map;
  open.jumps[HalfedgeId(10)] += Vec2i(1, 0);
  EXPECT_THROW(TorusLocator(good.mesh, open), InvalidInput);
  EXPECT_THROW(TorusLocator(good.mesh, good.map).locate(Vec2(std::nan(""), 0)), InvalidInput);
}

}  // namespace
}  // namespace foramen
