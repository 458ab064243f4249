#include "topology/linking.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "support/real_meshes.hpp"
#include "topology/loop_fixtures.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

using namespace foramen::testing;
using Matrix = Eigen::Matrix2i;
using std::numbers::pi;

template <class Curve>
std::vector<Vec3> polygon(int sides, const Curve& curve) {
  std::vector<Vec3> points;
  for (int i = 0; i < sides; ++i) points.push_back(curve(2 * pi * i / sides));
  return points;
}

std::vector<Vec3> reverse(std::vector<Vec3> points) { return {points.rbegin(), points.rend()}; }

const auto flat_circle = [](double t) { return Vec3(std::cos(t), std::sin(t), 0); };
// Passes upward through the flat circle.
const auto upright_circle = [](double t) { return Vec3(1 - std::cos(t), 0, std::sin(t)); };

// The (2,3) torus knot about z, right-handed, and the normal of its torus.
Vec3 trefoil(double t) {
  const double r = 20 + 8 * std::cos(3 * t);
  return {r * std::cos(2 * t), r * std::sin(2 * t), -8 * std::sin(3 * t)};
}
Vec3 trefoil_normal(double t) {
  return {std::cos(3 * t) * std::cos(2 * t), std::cos(3 * t) * std::sin(2 * t), -std::sin(3 * t)};
}

RigidTransform some_motion() {
  RigidTransform motion = RigidTransform::Identity();
  motion.linear() = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  motion.translation() = Vec3(130, -40, 900);
  return motion;
}

Matrix matrix(int a, int b, int c, int d) { return Matrix{{a, b}, {c, d}}; }

Matrix seifert_of(const Mesh& mesh, const LoopSystem& loops) {
  return seifert_matrix(mesh, loops.loops[0], loops.loops[1]);
}

Matrix basis_change(const Cocycle& form, const LoopSystem& loops) {
  Matrix a;
  for (int k = 0; k < 2; ++k) a.col(k) = integrate(form, loops.loops[k]);
  return a;
}

TEST(LinkingNumber, OfHopfLinks) {
  const auto a = polygon(40, flat_circle), b = polygon(33, upright_circle);
  EXPECT_EQ(linking_number(a, b), 1);
  EXPECT_EQ(linking_number(b, a), 1);
  EXPECT_EQ(linking_number(a, reverse(b)), -1);
  EXPECT_EQ(linking_number(reverse(a), reverse(b)), 1);
  EXPECT_EQ(linking_number(polygon(3, flat_circle), polygon(4, upright_circle)), 1);
  EXPECT_EQ(linking_number(a, polygon(33, [](double t) { return Vec3(upright_circle(t) + Vec3(3, 0, 0)); })),
            0);
}

TEST(LinkingNumber, CountsTurns) {
  // The trefoil winds twice round the axis and three times round the core of its torus.
  const auto knot = polygon(200, trefoil);
  const auto core = polygon(50, [](double t) { return Vec3(20 * flat_circle(t)); });
  const auto axis = polygon(50, [](double t) { return Vec3(60 * upright_circle(t)); });
  EXPECT_EQ(linking_number(core, knot),
            3 * linking_number(polygon(9, flat_circle), polygon(9, upright_circle)));
  EXPECT_EQ(linking_number(knot, axis), 2);
}

TEST(LinkingNumber, IgnoresRigidMotionAndScaleAndFlipsInAMirror) {
  const auto a = polygon(60, trefoil),
             b = polygon(60, [](double t) { return Vec3(trefoil(t) + 0.5 * trefoil_normal(t)); });
  const int number = linking_number(a, b);
  EXPECT_EQ(std::abs(number), 6);
  EXPECT_EQ(linking_number(transformed(a, some_motion()), transformed(b, some_motion())), number);
  auto small_a = a, small_b = b, mirror_a = a, mirror_b = b;
  for (auto* points : {&small_a, &small_b})
    for (Vec3& p : *points) p *= 1e-5;
  for (auto* points : {&mirror_a, &mirror_b})
    for (Vec3& p : *points) p.y() = -p.y();
  EXPECT_EQ(linking_number(small_a, small_b), number);
  EXPECT_EQ(linking_number(mirror_a, mirror_b), -number);
}

TEST(LinkingNumber, IsExactWhenThePolygonsNearlyTouch) {
  const auto a = polygon(40, flat_circle);
  for (double gap : {1e-2, 1e-5, 1e-8}) {
    // Two curves near the corner a[0] = (1, 0, 0): one passes through the circle just inside the corner, one
    // just outside.
    const std::vector<Vec3> inside{{1 - gap, 0, -1}, {1 - gap, 0, 1}, {3, 0, 1}, {3, 0, -1}};
    const std::vector<Vec3> outside{{1 + gap, 0, -1}, {1 + gap, 0, 1}, {3, 0, 1}, {3, 0, -1}};
    EXPECT_EQ(linking_number(a, inside), 1);
    EXPECT_EQ(linking_number(a, outside), 0);
  }
}

TEST(LinkingNumber, RefusesPolygonsThatTouch) {
  const std::vector<Vec3> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const std::vector<Vec3> through_a_side{{1, 0, -1}, {1, 0, 1.5}, {1, -3, 1}, {1, -3, -1}};
  EXPECT_THROW(linking_number(square, through_a_side), ConvergenceError);
}

TEST(IntersectionNumber, OfTheLoopsOfATorus) {
  const int around = 14, tube = 8;
  const Mesh mesh = build_mesh(torus_soup(around, tube));
  const EdgeLoop m = tube_loop(mesh, tube), e = rim_loop(mesh, around, tube);
  // Where they meet, (12, 0, 0), m runs along -z, e along +y, outside is towards the axis: (-z) x (+y) = +x
  // is inward.
  EXPECT_EQ(intersection_number(mesh, m, e), -1);
  EXPECT_EQ(intersection_number(mesh, e, m), 1);
  EXPECT_EQ(intersection_number(mesh, m, m), 0);
  EdgeLoop twice = m;
  twice.insert(twice.end(), m.begin(), m.end());
  EXPECT_EQ(intersection_number(mesh, twice, e), -2);
}

TEST(SeifertMatrix, OfATorusOfRevolution) {
  for (const auto& [around, tube] : {std::pair{14, 8}, {3, 4}, {60, 20}}) {
    const Mesh mesh = build_mesh(torus_soup(around, tube));
    const EdgeLoop m = tube_loop(mesh, tube), e = rim_loop(mesh, around, tube);
    // After it is pushed outward, m goes round the rim and passes downward through its disk. The rim itself
    // moves towards the axis, away from m.
    EXPECT_EQ(seifert_matrix(mesh, m, e), matrix(0, 0, -1, 0));
    EXPECT_EQ(seifert_matrix(mesh, e, m), matrix(0, -1, 0, 0));
  }
}

TEST(SeifertMatrix, OfAKnottedTorusHoldsItsFraming) {
  const int around = 160, tube = 8;
  TriangleSoup soup = torus_soup(around, tube);
  for (int i = 0; i < around; ++i) {
    const double t = 2 * pi * i / around;
    const Vec3 normal = trefoil_normal(t), tangent = (trefoil(t + 1e-5) - trefoil(t - 1e-5)).normalized();
    for (int j = 0; j < tube; ++j) {
      const double v = 2 * pi * j / tube;
      soup.points[i * tube + j] =
          trefoil(t) + 1.5 * (std::cos(v) * normal + std::sin(v) * normal.cross(tangent));
    }
  }
  Mesh mesh = build_mesh(soup);
  if (signed_volume(mesh) < 0) mesh = reversed(mesh);
  std::vector<int> outer;
  for (int i = 0; i < around; ++i) outer.push_back(i * tube);
  const EdgeLoop longitude = walk_through(mesh, outer), meridian = tube_loop(mesh, tube);
  const Matrix s = seifert_matrix(mesh, longitude, meridian);
  // Pushed along the normal of the torus it lies on, a (p,q) knot links itself p q times.
  EXPECT_EQ(s(0, 0), linking_number(polygon(200, trefoil), polygon(200, [](double t) {
                                      return Vec3(trefoil(t) + trefoil_normal(t));
                                    })));
  EXPECT_EQ(std::abs(s(0, 0)), 6);
  EXPECT_EQ(s(1, 1), 0);
  EXPECT_EQ(std::abs(s(0, 1) + s(1, 0)), 1);
}

// The Seifert matrix is a bilinear form on homology, so it must be the same form for all basepoints, also if
// loops share edges or retrace themselves.
void expect_one_bilinear_form(const Mesh& mesh, int basepoints) {
  const auto lengths = edge_lengths(mesh);
  const LoopSystem here = greedy_loops(mesh, VertexId(0), lengths);
  const Cocycle form = cocycle(mesh, here);
  const Matrix s = seifert_of(mesh, here);
  for (VertexId v : some_vertices(mesh, basepoints)) {
    const LoopSystem there = greedy_loops(mesh, v, lengths);
    const Matrix a = basis_change(form, there);
    EXPECT_EQ(seifert_of(mesh, there), Matrix(a.transpose() * s * a));
  }
}

TEST(SeifertMatrix, IsABilinearFormOnHomology) {
  for (const TriangleSoup& soup :
       {torus_soup(20, 12), bumpy_torus_soup(20, 14, 3), bumpy_torus_soup(30, 24, 8)})
    expect_one_bilinear_form(build_mesh(soup), 20);
}

TEST(SeifertMatrix, IsABilinearFormOnRealData) {
  FORAMEN_NEEDS_REAL_DATA();
  for (const char* stem : {"verse005_L1", "verse561_L4", "verse631_L5"}) {
    SCOPED_TRACE(stem);
    const Mesh mesh = real_mesh(std::string("lumbar/") + stem);
    expect_one_bilinear_form(mesh, 6);
    // For an unknotted torus, there is a basis in which one pair is linked and no loop is linked with itself.
    const Matrix s = seifert_of(mesh, greedy_loops(mesh, VertexId(0), edge_lengths(mesh)));
    EXPECT_EQ(s(0, 0) * s(1, 1) - s(0, 1) * s(1, 0), 0);
  }
}

TEST(SeifertMatrix, IgnoresRigidMotionAndRenumbering) {
  const TriangleSoup soup = bumpy_torus_soup(24, 14, 5);
  const Mesh mesh = build_mesh(soup);
  const LoopSystem loops = greedy_loops(mesh, VertexId(17), edge_lengths(mesh));
  const Matrix s = seifert_of(mesh, loops);
  EXPECT_EQ(seifert_matrix(transformed(mesh, some_motion()), loops.loops[0], loops.loops[1]), s);
  const Mesh other = build_mesh(renumbered(soup, 4));
  const VertexId same = vertex_at(other, mesh.position(VertexId(17)));
  EXPECT_EQ(seifert_of(other, greedy_loops(other, same, edge_lengths(other))), s);
}

TEST(SeifertMatrix, ChangesSignInAMirror) {
  const Mesh mesh = build_mesh(bumpy_torus_soup(24, 14, 5));
  std::vector<Vec3> positions(mesh.positions().begin(), mesh.positions().end());
  for (Vec3& p : positions) p.x() = -p.x();
  const Mesh mirror = reversed(mesh.with_positions(positions));
  const LoopSystem loops = greedy_loops(mesh, VertexId(17), edge_lengths(mesh));
  std::vector<EdgeLoop> mirrored;
  for (const EdgeLoop& loop : loops.loops) {
    std::vector<int> vertices;
    for (HalfedgeId h : loop) vertices.push_back(mesh.from(h).index);
    mirrored.push_back(walk_through(mirror, vertices));
  }
  EXPECT_EQ(seifert_matrix(mirror, mirrored[0], mirrored[1]), Matrix(-seifert_of(mesh, loops)));
}

TEST(SeifertMatrix, RefusesLoopsThatAreNoBasis) {
  const Mesh mesh = build_mesh(torus_soup(14, 8));
  const EdgeLoop m = tube_loop(mesh, 8), e = rim_loop(mesh, 14, 8);
  EXPECT_THROW(seifert_matrix(mesh, m, m), TopologyError);
  EdgeLoop torn = e;
  torn.erase(torn.begin() + 4);
  EXPECT_THROW(seifert_matrix(mesh, m, torn), InvalidInput);
}

// The direction of the push depends on the winding. On a surface that is wound inward, loops are pushed
// inside, and the intersection number only changes its sign.
TEST(SeifertMatrix, OfAnInwardSurfaceIsTransposed) {
  const Mesh mesh = build_mesh(torus_soup(14, 8)), inward = reversed(mesh);
  const EdgeLoop m = tube_loop(inward, 8), e = rim_loop(inward, 14, 8);
  EXPECT_EQ(seifert_matrix(inward, m, e), matrix(0, -1, 0, 0));
}

TEST(SeifertTest, LeavesOnlyTheIdentityUpToSign) {
  const Mesh mesh = build_mesh(torus_soup(14, 8));
  const Matrix s = seifert_matrix(mesh, tube_loop(mesh, 8), rim_loop(mesh, 14, 8));
  constexpr int reach = 4;
  int passed = 0;
  for (int a = -reach; a <= reach; ++a)
    for (int b = -reach; b <= reach; ++b)
      for (int c = -reach; c <= reach; ++c)
        for (int d = -reach; d <= reach; ++d) {
          if (!seifert_test(matrix(a, b, c, d), s, s)) continue;
          ++passed;
          EXPECT_EQ(matrix(a, b, c, d), Matrix(a * Matrix::Identity()));
        }
  EXPECT_EQ(passed, 2);
}

// The errors are made in loops and not in matrices, so the test must detect them from the surface itself.
TEST(SeifertTest, RefusesAPlantedTwistSwapAndSign) {
  const Mesh mesh = build_mesh(bumpy_torus_soup(24, 14, 5));
  const auto lengths = edge_lengths(mesh);
  const LoopSystem reference = greedy_loops(mesh, VertexId(17), lengths),
                   shape = greedy_loops(mesh, VertexId(200), lengths);
  const Matrix s_reference = seifert_of(mesh, reference), s_shape = seifert_of(mesh, shape);
  const Matrix a = basis_change(cocycle(mesh, shape), reference);
  EXPECT_TRUE(seifert_test(a, s_shape, s_reference));
  EXPECT_TRUE(seifert_test(-a, s_shape, s_reference));
  for (int turns : {-2, -1, 1, 2}) {
    EXPECT_FALSE(seifert_test(a * matrix(1, turns, 0, 1), s_shape, s_reference));
    EXPECT_FALSE(seifert_test(a * matrix(1, 0, turns, 1), s_shape, s_reference));
  }
  for (const Matrix& wrong : {matrix(0, 1, 1, 0), matrix(0, -1, 1, 0), matrix(1, 0, 0, -1),
                              matrix(-1, 0, 0, 1), matrix(2, 0, 0, 1)}) {
    EXPECT_FALSE(seifert_test(a * wrong, s_shape, s_reference));
    // The determinant alone does not detect the error.
    EXPECT_NE(Matrix(wrong.transpose() * s_reference * wrong), s_reference);
  }
}

}  // namespace
}  // namespace foramen
