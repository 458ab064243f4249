#include "spatial/self_intersections.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

using ::testing::IsEmpty;
using ::testing::Not;
using Pairs = std::vector<std::pair<FaceId, FaceId>>;

Pairs pairs_of(const TriangleSoup& soup) { return self_intersections(TriangleTree(build_mesh(soup))); }

// The reference: integer arithmetic, all pairs, and other criteria than those of the library.
using Int3 = Eigen::Matrix<std::int64_t, 3, 1>;
using IntTriangle = std::array<Int3, 3>;

bool separates(const Int3& axis, const IntTriangle& a, const IntTriangle& b) {
  const auto range = [&](const IntTriangle& t) {
    return std::minmax({axis.dot(t[0]), axis.dot(t[1]), axis.dot(t[2])});
  };
  const auto in_a = range(a), in_b = range(b);
  return in_a.second < in_b.first || in_b.second < in_a.first;
}

Int3 normal(const IntTriangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

// Two triangles are disjoint if and only if one of these axes separates them.
bool strangers_meet(const IntTriangle& a, const IntTriangle& b) {
  const Int3 na = normal(a), nb = normal(b);
  std::vector<Int3> candidates{na, nb};
  for (std::size_t i = 0; i < 3; ++i) {
    const Int3 side_a = a[(i + 1) % 3] - a[i], side_b = b[(i + 1) % 3] - b[i];
    candidates.emplace_back(na.cross(side_a));
    candidates.emplace_back(nb.cross(side_b));
    for (std::size_t j = 0; j < 3; ++j) candidates.emplace_back(side_a.cross(b[(j + 1) % 3] - b[j]));
  }
  return std::none_of(candidates.begin(), candidates.end(),
                      [&](const Int3& axis) { return separates(axis, a, b); });
}

bool in_cone(const Int3& x, const Int3& p, const Int3& q) {
  const Int3 n = p.cross(q);
  return x.cross(q).dot(n) >= 0 && p.cross(x).dot(n) >= 0;
}

// Whether the cones of p, q and of r, s have a common ray, by the signs of the coefficients in a linear
// combination of p, q, -r, -s that is zero.
bool cones_meet(const Int3& p, const Int3& q, const Int3& r, const Int3& s) {
  const auto det = [](const Int3& x, const Int3& y, const Int3& z) { return x.dot(y.cross(z)); };
  const std::array<std::int64_t, 4> combination{det(q, r, s), -det(p, r, s), -det(p, q, s), det(p, q, r)};
  const auto [least, largest] = std::minmax_element(combination.begin(), combination.end());
  if (*least == 0 && *largest == 0)  // all in one plane
    return in_cone(p, r, s) || in_cone(q, r, s) || in_cone(r, p, q) || in_cone(s, p, q);
  return *least >= 0 || *largest <= 0;
}

struct Oracle {
  Pairs pairs;
  std::array<int, 3> by_shared{};  // number of pairs that share 0, 1, 2 vertices
};

Oracle brute_force(const Mesh& mesh) {
  const auto triangle = [&](FaceId f) {
    const auto t = mesh.triangle(f);
    return IntTriangle{t[0].cast<std::int64_t>(), t[1].cast<std::int64_t>(), t[2].cast<std::int64_t>()};
  };
  Oracle oracle;
  for (FaceId f : mesh.faces())
    for (FaceId g : mesh.faces()) {
      const IntTriangle a = triangle(f), b = triangle(g);
      if (!(f < g) || normal(a).isZero() || normal(b).isZero()) continue;
      std::vector<std::size_t> only_a{0, 1, 2}, only_b{0, 1, 2}, shared_a;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          if (mesh.corners(f)[i] == mesh.corners(g)[j]) {
            std::erase(only_a, i);
            std::erase(only_b, j);
            shared_a.push_back(i);
          }
      bool counts = true;
      if (shared_a.empty()) {
        counts = strangers_meet(a, b);
      } else if (shared_a.size() == 1) {
        const Int3& o = a[shared_a[0]];
        counts = cones_meet(a[only_a[0]] - o, a[only_a[1]] - o, b[only_b[0]] - o, b[only_b[1]] - o);
      } else if (shared_a.size() == 2) {
        const Int3 &o = a[shared_a[0]], edge = a[shared_a[1]] - o;
        const Int3 na = edge.cross(a[only_a[0]] - o), nb = edge.cross(b[only_b[0]] - o);
        counts = na.cross(nb).isZero() && na.dot(nb) > 0;
      }
      if (!counts) continue;
      oracle.pairs.emplace_back(f, g);
      if (shared_a.size() < 3) ++oracle.by_shared[shared_a.size()];
    }
  return oracle;
}

// A torus on a coarse integer grid with randomly moved vertices. All kinds of intersections occur, most often
// touching and coplanar triangles.
Mesh crumpled_torus(std::uint64_t seed) {
  Rng rng(seed);
  const double size = rng.uniform(1, 8), jitter = rng.uniform(0, 3);
  TriangleSoup soup = testing::torus_soup(5 + rng.below(4), 3 + rng.below(4), size, size / 2);
  for (Vec3& p : soup.points)
    for (double& x : p) x = std::round(x + rng.uniform(-jitter, jitter));
  return build_mesh(std::move(soup));
}

// Two triangles that share no vertex: a large one in the plane z = 0, and any other.
TriangleSoup with_floor(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {{Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 9, 0), a, b, c}, {{0, 1, 2}, {3, 4, 5}}};
}

// A tetrahedron standing on its tip above that triangle.
TriangleSoup tetrahedron_over_floor(double tip) {
  return {{Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 9, 0), Vec3(0, 0, tip), Vec3(1, 0, 5), Vec3(-1, 1, 5),
           Vec3(-1, -1, 5)},
          {{0, 1, 2}, {3, 4, 6}, {3, 5, 4}, {3, 6, 5}, {4, 5, 6}}};
}

TEST(SelfIntersections, NoneInAnEmbeddedSurface) {
  EXPECT_THAT(self_intersections(TriangleTree{Mesh()}), IsEmpty());
  EXPECT_THAT(pairs_of(testing::torus_soup(3, 3)), IsEmpty());
  EXPECT_THAT(pairs_of(testing::torus_soup(60, 30)), IsEmpty());
  EXPECT_THAT(pairs_of(testing::bumpy_torus_soup(40, 20, 1)), IsEmpty());
}

TEST(SelfIntersections, ATipThroughATriangleCrossesItThreeTimes) {
  const Pairs three{{FaceId(0), FaceId(1)}, {FaceId(0), FaceId(2)}, {FaceId(0), FaceId(3)}};
  EXPECT_EQ(pairs_of(tetrahedron_over_floor(-1)), three);
  EXPECT_EQ(pairs_of(tetrahedron_over_floor(0)), three) << "touching counts";
  const double least = std::numeric_limits<double>::epsilon();
  EXPECT_EQ(pairs_of(tetrahedron_over_floor(-least)), three);
  EXPECT_THAT(pairs_of(tetrahedron_over_floor(least)), IsEmpty());
}

TEST(SelfIntersections, StrangersThatTouch) {
  const auto count = [](const Vec3& a, const Vec3& b, const Vec3& c) {
    return pairs_of(with_floor(a, b, c)).size();
  };
  const Vec3 up(0, 0, 4), up_too(1, 0, 4);
  EXPECT_EQ(count(Vec3(0, 0, 0), up, up_too), 1u) << "a corner in the face";
  EXPECT_EQ(count(Vec3(0, -9, 0), up, up_too), 1u) << "a corner on an edge";
  EXPECT_EQ(count(Vec3(9, -9, 0), up, up_too), 1u) << "a corner on a corner";
  EXPECT_EQ(count(Vec3(0, -9.5, 0), up, up_too), 0u) << "a corner in the plane, outside";
  EXPECT_EQ(count(Vec3(0, -9, -1), Vec3(0, -9, 1), Vec3(0, -20, 0)), 1u) << "an edge on an edge, crosswise";
  EXPECT_EQ(count(Vec3(-20, -9, 0), Vec3(20, -9, 0), Vec3(0, -20, 3)), 1u) << "an edge along an edge";
  EXPECT_EQ(count(Vec3(9, -9, 0), Vec3(20, -9, 0), Vec3(0, -20, 3)), 1u) << "edges of one line, a point";
  EXPECT_EQ(count(Vec3(10, -9, 0), Vec3(20, -9, 0), Vec3(0, -20, 3)), 0u) << "edges of one line, apart";
  EXPECT_EQ(count(Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)), 1u) << "in one plane, inside";
  EXPECT_EQ(count(Vec3(-90, -90, 0), Vec3(90, -90, 0), Vec3(0, 90, 0)), 1u) << "in one plane, around";
  EXPECT_EQ(count(Vec3(-1, -10, 0), Vec3(1, -10, 0), Vec3(0, -20, 0)), 0u) << "in one plane, apart";
  EXPECT_EQ(count(Vec3(-1, -1, 1), Vec3(1, -1, 1), Vec3(0, 1, 1)), 0u) << "in parallel planes";
}

TEST(SelfIntersections, NeighboursAboutAVertex) {
  // Faces 0 and 2 share vertex 0 alone. Face 1 joins them, so that the mesh is manifold.
  const auto count = [](const Vec3& c, const Vec3& d) {
    const TriangleSoup fan{{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0), c, d},
                           {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}};
    int pairs = 0;
    for (const auto& [f, g] : pairs_of(fan)) pairs += f == FaceId(0) && g == FaceId(2);
    return pairs;
  };
  EXPECT_EQ(count(Vec3(-4, 0, 0), Vec3(0, -4, 0)), 0) << "side by side in one plane";
  EXPECT_EQ(count(Vec3(-4, 0, 3), Vec3(0, -4, 3)), 0);
  EXPECT_EQ(count(Vec3(1, 1, -3), Vec3(1, 1, 3)), 1) << "through the face";
  EXPECT_EQ(count(Vec3(9, 9, -3), Vec3(9, 9, 3)), 1) << "through the face, which ends first";
  EXPECT_EQ(count(Vec3(1, 1, 0), Vec3(1, 1, 3)), 1) << "an edge in the face";
  EXPECT_EQ(count(Vec3(-1, 1, 3), Vec3(5, 0, 0)), 1) << "an edge along an edge";
  EXPECT_EQ(count(Vec3(-1, 1, 3), Vec3(5, -1, 0)), 0) << "an edge in the plane, outside";
  EXPECT_EQ(count(Vec3(2, 1, 0), Vec3(1, 2, 0)), 1) << "in one plane, on the face";
}

TEST(SelfIntersections, NeighboursAlongAnEdgeFold) {
  const auto count = [](const Vec3& other) {
    return pairs_of({{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 3, 0), other}, {{0, 1, 2}, {1, 0, 3}}}).size();
  };
  EXPECT_EQ(count(Vec3(1, -3, 0)), 0u);
  EXPECT_EQ(count(Vec3(1, 2, 0)), 1u);
  EXPECT_EQ(count(Vec3(1, 2, 1e-80)), 0u) << "sharply folded, not flat";
  EXPECT_EQ(count(Vec3(1, 3, 0)), 1u) << "another vertex at the same place";
}

TEST(SelfIntersections, TwoTrianglesOfTheSameVerticesCount) {
  EXPECT_EQ(pairs_of({{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 3, 0)}, {{0, 1, 2}, {0, 2, 1}}}).size(), 1u);
}

TEST(SelfIntersections, TrianglesWithoutAreaArePassedOver) {
  EXPECT_THAT(pairs_of(with_floor(Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(0, 0, 3))), IsEmpty());
  EXPECT_THAT(pairs_of(with_floor(Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0))), IsEmpty());
}

TEST(SelfIntersections, AgreeWithIntegersOnEveryPair) {
  std::array<int, 3> by_shared{};
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = crumpled_torus(seed);
    const Oracle expected = brute_force(mesh);
    ASSERT_EQ(self_intersections(TriangleTree(mesh)), expected.pairs);
    for (std::size_t k = 0; k < 3; ++k) by_shared[k] += expected.by_shared[k];
  }
  for (const int pairs : by_shared) EXPECT_GT(pairs, 100);
}

// Shears with large integer factors change no incidence, but cause cancellation in every determinant.
TEST(SelfIntersections, UnchangedByShears) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = crumpled_torus(seed);
    std::vector<Vec3> sheared(mesh.positions().begin(), mesh.positions().end());
    for (Vec3& p : sheared) {
      p.x() += 1048573 * p.y() - 977711 * p.z();
      p.y() += 1048343 * p.x();
      p.z() += 3 * p.x() - 5 * p.y();
      p *= std::ldexp(1.0, -70);
    }
    EXPECT_EQ(self_intersections(TriangleTree(mesh.with_positions(sheared))),
              self_intersections(TriangleTree(mesh)));
  }
}

TEST(SelfIntersections, DoNotDependOnTheNumbering) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const TriangleSoup soup = crumpled_torus(seed).soup();
    EXPECT_EQ(pairs_of(testing::renumbered(soup, seed + 1)).size(), pairs_of(soup).size()) << seed;
  }
}

// One vertex of the tube is moved out through the other side of the tube.
TEST(SelfIntersections, DoNotDependOnThePoseNorOnARefit) {
  const Mesh torus = build_mesh(testing::torus_soup(40, 20));
  std::vector<Vec3> points(torus.positions().begin(), torus.positions().end());
  points[0] = Vec3(3, 0.7, 0.4);
  const Mesh pierced = torus.with_positions(points);
  const Pairs here = self_intersections(TriangleTree(pierced));
  EXPECT_THAT(here, Not(IsEmpty()));
  const RigidTransform motion =
      Eigen::Translation3d(90, 10, -40) * Eigen::AngleAxisd(2, Vec3(0, 1, 3).normalized());
  EXPECT_EQ(self_intersections(TriangleTree(transformed(pierced, motion))), here);
  TriangleTree tree(torus);
  tree.refit(pierced);
  EXPECT_EQ(self_intersections(tree), here);
}

TEST(SelfIntersections, AreNotListedBeyondTheLimit) {
  TriangleSoup knot = testing::torus_soup(12, 10);
  Rng rng(1);
  for (Vec3& p : knot.points) p = Vec3(rng.uniform(), rng.uniform(), rng.uniform());
  const TriangleTree tree(build_mesh(knot));
  EXPECT_THROW(self_intersections(tree, {.most_overlaps_per_triangle = 30}), ConvergenceError);
  EXPECT_FALSE(self_intersections(tree, {.most_overlaps_per_triangle = 240}).empty());
}

}  // namespace
}  // namespace foramen
