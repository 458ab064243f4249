#include "foramen/spatial/triangle_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"
#include "support/heap_in_use.hpp"
#include "support/meshes.hpp"
#include "support/real_meshes.hpp"

namespace foramen {
namespace {

Vec3 random_point(Rng& rng, double size) {
  return {rng.uniform(-size, size), rng.uniform(-size, size), rng.uniform(-size, size)};
}

Vec3 random_direction(Rng& rng) { return Vec3(rng.normal(), rng.normal(), rng.normal()).normalized(); }

// A flat plate on a grid. Coordinates have few digits, so that equal distances are exactly equal.
Mesh plate(int side) {
  TriangleSoup soup;
  for (int i = 0; i <= side; ++i)
    for (int j = 0; j <= side; ++j) soup.points.emplace_back(i, j, 0);
  const auto id = [&](int i, int j) { return i * (side + 1) + j; };
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      soup.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      soup.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return build_mesh(std::move(soup));
}

// A torus whose triangles are up to 1000 times longer than high, some without any area.
Mesh squashed_torus() {
  TriangleSoup soup = testing::bumpy_torus_soup(24, 12, 5);
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    if (v % 3 == 0) soup.points[v].z() *= 1e-3;
    if (v % 17 == 0) soup.points[v] = soup.points[v + 1];
  }
  return build_mesh(std::move(soup));
}

std::vector<std::pair<std::string, Mesh>> meshes() {
  return {{"torus", build_mesh(testing::torus_soup(20, 12))},
          {"bumpy torus", build_mesh(testing::bumpy_torus_soup(31, 17, 2))},
          {"renumbered", build_mesh(testing::renumbered(testing::bumpy_torus_soup(20, 10, 3), 4))},
          {"squashed", squashed_torus()},
          {"plate", plate(12)},
          {"far from the origin", transformed(build_mesh(testing::torus_soup(16, 9)),
                                              RigidTransform(Eigen::Translation3d(1e4, -2e4, 5e3)))}};
}

Vec3 random_query(const Mesh& mesh, Rng& rng) {
  const BoundingBox box = bounding_box(mesh.positions());
  const Vec3 centre = 0.5 * (box.low + box.high);
  const double reach = rng.uniform() < 0.2 ? 20 : 0.7;  // some far away
  return centre + random_point(rng, reach * box.diagonal());
}

// The closest of all faces that `accept` accepts; among equal distances the one with the smallest index.
template <class Accept>
ClosestPoint brute_force(const Mesh& mesh, const Vec3& query, const Accept& accept) {
  ClosestPoint best;
  for (FaceId f : mesh.faces()) {
    if (!accept(f)) continue;
    ClosestPoint candidate = closest_on_triangle(mesh.triangle(f), query);
    candidate.on.face = f;
    if (candidate.squared_distance < best.squared_distance) best = candidate;
  }
  return best;
}

ClosestPoint brute_force(const Mesh& mesh, const Vec3& query) {
  return brute_force(mesh, query, [](FaceId) { return true; });
}

void expect_same(const ClosestPoint& found, const ClosestPoint& expected) {
  EXPECT_EQ(found.on.face, expected.on.face);
  EXPECT_EQ(found.squared_distance, expected.squared_distance);
  EXPECT_EQ(found.point, expected.point);
  EXPECT_EQ(found.on.barycentric, expected.on.barycentric);
}

// The smallest value of a convex function on [0, end], by ternary search.
template <class Function>
double smallest(double end, const Function& function) {
  double low = 0, high = end;
  for (int i = 0; i < 100; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (function(a) < function(b) ? high : low) = function(a) < function(b) ? b : a;
  }
  return std::min({function(low), function(high), function(0), function(end)});
}

// The distance by a search that does not distinguish faces, edges and corners. It uses that the distance is
// convex in the barycentric coordinates.
double distance_by_search(const std::array<Vec3, 3>& t, const Vec3& query) {
  return smallest(1, [&](double v) {
    return smallest(1 - v,
                    [&](double w) { return (t[0] + v * (t[1] - t[0]) + w * (t[2] - t[0]) - query).norm(); });
  });
}

// Memory matters because the trees and the locators (lift_to_surface_test.cpp) of all shapes are in memory
// while landmarks are placed.
TEST(TriangleTree, WithoutNormalsTakesLittleMemoryAndAnswersTheSame) {
  const Mesh mesh = build_mesh(testing::torus_soup(160, 60, 30, 10));
  const double before = testing::heap_in_use();
  const TriangleTree small(mesh, TreeNormals::none);
  EXPECT_LT((testing::heap_in_use() - before) / mesh.face_count(), 64);  // bytes
  const TriangleTree whole(mesh);
  Rng rng(7);
  for (int i = 0; i < 100; ++i) {
    const Vec3 query = random_point(rng, 40);
    EXPECT_EQ(small.closest(query).on.face, whole.closest(query).on.face);
    EXPECT_EQ(small.faces_within(query, 12), whole.faces_within(query, 12));
  }
  EXPECT_THROW(small.closest_compatible({0, 0, 0}, {0, 0, 1}), InternalError);
}

TEST(ClosestOnTriangle, ClosedForms) {
  const std::array<Vec3, 3> t{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  const auto closest = [&](double x, double y, double z) {
    return closest_on_triangle(t, Vec3(x, y, z)).point;
  };
  EXPECT_EQ(closest(1, 1, 5), Vec3(1, 1, 0));    // face
  EXPECT_EQ(closest(-1, -2, 1), Vec3(0, 0, 0));  // corners
  EXPECT_EQ(closest(9, -1, 1), Vec3(4, 0, 0));
  EXPECT_EQ(closest(-1, 9, 1), Vec3(0, 4, 0));
  EXPECT_EQ(closest(2, -3, 1), Vec3(2, 0, 0));  // edges
  EXPECT_EQ(closest(-3, 1, 1), Vec3(0, 1, 0));
  EXPECT_EQ(closest(4, 4, 1), Vec3(2, 2, 0));
  EXPECT_EQ(closest_on_triangle(t, Vec3(1, 1, 5)).squared_distance, 25);
}

TEST(ClosestOnTriangle, AgreesWithASearchForTheSmallestDistance) {
  Rng rng(11);
  for (int i = 0; i < 60; ++i) {
    const double flatness = std::pow(10.0, rng.uniform(-9, 0));
    const Vec3 base = random_point(rng, 1), side = random_direction(rng), up = random_direction(rng);
    const std::array<Vec3, 3> t{base, base + side, base + rng.uniform(-0.5, 1.5) * side + flatness * up};
    const Vec3 query = random_point(rng, 2);
    const ClosestPoint found = closest_on_triangle(t, query);
    EXPECT_NEAR(std::sqrt(found.squared_distance), distance_by_search(t, query), 1e-9)
        << "flatness " << flatness;
    EXPECT_NEAR((found.point - query).squaredNorm(), found.squared_distance, 1e-14);
    EXPECT_NEAR(found.on.barycentric.sum(), 1, 1e-12);
    EXPECT_GE(found.on.barycentric.minCoeff(), -1e-12);
  }
}

TEST(ClosestOnTriangle, TrianglesWithoutAreaAreSegmentsOrPoints) {
  const Vec3 a(0, 0, 0), b(2, 0, 0), c(6, 0, 0), query(3, 4, 0), beyond(9, 4, 0);
  for (const auto& t : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}, std::array{a, c, b},
                        std::array{a, a, c}, std::array{a, c, c}, std::array{c, a, c}}) {
    EXPECT_EQ(closest_on_triangle(t, query).squared_distance, 16);
    EXPECT_EQ(closest_on_triangle(t, beyond).squared_distance, 25);
  }
  EXPECT_EQ(closest_on_triangle({a, a, a}, Vec3(0, 3, 4)).squared_distance, 25);
}

TEST(TriangleTree, ClosestIsWhatBruteForceFinds) {
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    const TriangleTree tree(mesh);
    Rng rng(21);
    for (int i = 0; i < 300; ++i) {
      const Vec3 query = random_query(mesh, rng);
      expect_same(tree.closest(query), brute_force(mesh, query));
    }
  }
}

TEST(TriangleTree, EqualDistancesGoToTheSmallerFace) {
  const Mesh mesh = plate(9);  // above a corner six triangles have equal distances, above an edge two
  const TriangleTree tree(mesh);
  for (const Vec3& p : mesh.positions())
    for (double height : {0.0, 0.25, 3.0}) {
      const Vec3 query = p + Vec3(0, 0, height);
      expect_same(tree.closest(query), brute_force(mesh, query));
      const Vec3 over_an_edge = query + Vec3(0.5, 0, 0);
      expect_same(tree.closest(over_an_edge), brute_force(mesh, over_an_edge));
    }
}

TEST(TriangleTree, WithinIsABoundThatNeverChangesTheAnswer) {
  const Mesh mesh = build_mesh(testing::bumpy_torus_soup(30, 14, 8));
  const TriangleTree tree(mesh);
  Rng rng(31);
  for (int i = 0; i < 200; ++i) {
    const Vec3 query = random_query(mesh, rng);
    const ClosestPoint free = tree.closest(query);
    const double distance = std::sqrt(free.squared_distance);
    expect_same(tree.closest(query, distance * 1.001), free);
    EXPECT_FALSE(tree.closest(query, distance * 0.999).on.face.valid());
    EXPECT_TRUE(tree.any_within(query, distance * 1.001));
    EXPECT_FALSE(tree.any_within(query, distance * 0.999));
  }
  EXPECT_FALSE(tree.closest(mesh.position(VertexId(0)), 0.0).on.face.valid());
  EXPECT_TRUE(tree.any_within(mesh.position(VertexId(0)), 0.0));
  EXPECT_FALSE(tree.any_within(mesh.position(VertexId(0)), -1.0));
}

TEST(TriangleTree, CompatibleIsWhatBruteForceFinds) {
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    const TriangleTree tree(mesh);
    Rng rng(41);
    for (int i = 0; i < 200; ++i) {
      const Vec3 query = random_query(mesh, rng), normal = random_direction(rng);
      for (double min_cosine : {-0.5, 0.0, 0.8, 0.999}) {
        const ClosestPoint expected = brute_force(mesh, query, [&](FaceId f) {
          const Vec3 n = unit_normal(mesh.triangle(f));
          return !n.isZero(0) && n.dot(normal) > min_cosine;
        });
        const auto found = tree.closest_compatible(query, normal, min_cosine);
        ASSERT_EQ(found.has_value(), expected.on.face.valid());
        if (!found) continue;
        expect_same(*found, expected);
        const double distance = std::sqrt(expected.squared_distance);
        EXPECT_FALSE(tree.closest_compatible(query, normal, min_cosine, 0.999 * distance).has_value());
        expect_same(*tree.closest_compatible(query, normal, min_cosine, 1.001 * distance + 1e-9), expected);
      }
    }
  }
}

TEST(TriangleTree, NoFaceIsCompatibleWithTheUndersideOfAPlate) {
  const TriangleTree tree(plate(4));
  EXPECT_TRUE(tree.closest_compatible(Vec3(1, 1, 1), Vec3::UnitZ()).has_value());
  EXPECT_FALSE(tree.closest_compatible(Vec3(1, 1, 1), -Vec3::UnitZ()).has_value());
  EXPECT_FALSE(
      tree.closest_compatible(Vec3(1, 1, 1), Vec3::UnitX()).has_value());  // must be above, not equal
}

TEST(TriangleTree, FacesWithinAreThoseOfBruteForce) {
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    const TriangleTree tree(mesh);
    Rng rng(51);
    for (int i = 0; i < 100; ++i) {
      const Vec3 query = random_query(mesh, rng);
      const double radius = rng.uniform(0, 30);
      std::vector<FaceId> expected;
      for (FaceId f : mesh.faces())
        if (closest_on_triangle(mesh.triangle(f), query).squared_distance <= radius * radius)
          expected.push_back(f);
      EXPECT_EQ(tree.faces_within(query, radius), expected);
    }
  }
}

TEST(TriangleTree, FacesWithinIncludesTheRadiusItself) {
  const TriangleTree tree(plate(3));
  EXPECT_EQ(tree.faces_within(Vec3(1, 1, 2), 2.0).size(), 6u);
  EXPECT_TRUE(tree.faces_within(Vec3(1, 1, 2), 1.999).empty());
}

TEST(TriangleTree, OverlapsAreAllPairsOfBoxesThatMeet) {
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    const auto box = [&surface = mesh](FaceId f) { return bounding_box(surface.triangle(f)); };
    std::vector<std::pair<FaceId, FaceId>> found, expected;
    TriangleTree(mesh).for_each_overlap([&](FaceId f, FaceId g) { found.emplace_back(f, g); });
    for (FaceId f : mesh.faces())
      for (FaceId g : mesh.faces())
        if (f < g && (box(f).low.array() <= box(g).high.array()).all() &&
            (box(g).low.array() <= box(f).high.array()).all())
          expected.emplace_back(f, g);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
  TriangleTree{Mesh()}.for_each_overlap([](FaceId, FaceId) { FAIL(); });
}

TEST(TriangleTree, RefitAnswersLikeANewTree) {
  const Mesh before = build_mesh(testing::bumpy_torus_soup(24, 12, 6));
  std::vector<Vec3> moved(before.positions().begin(), before.positions().end());
  Rng rng(61);
  for (Vec3& p : moved) p = Vec3(100 - p.y(), 2 * p.x(), p.z()) + random_point(rng, 1);
  const Mesh after = before.with_positions(moved);
  TriangleTree tree(before);
  tree.refit(after);
  for (int i = 0; i < 200; ++i) {
    const Vec3 query = random_query(after, rng), normal = random_direction(rng);
    expect_same(tree.closest(query), brute_force(after, query));
    expect_same(tree.closest_compatible(query, normal).value(),
                TriangleTree(after).closest_compatible(query, normal).value());
  }
  EXPECT_THROW(tree.refit(plate(3)), InvalidInput);
}

TEST(TriangleTree, DistanceToATorusOfRevolution) {
  const double major = 20, minor = 8;
  const Mesh mesh = build_mesh(testing::torus_soup(256, 128, major, minor));
  const TriangleTree tree(mesh);
  // A chord of the tube circle or of the outermost circle leaves the surface by at most its sagitta.
  const double sagitta = minor * (1 - std::cos(std::numbers::pi / 128)) +
                         (major + minor) * (1 - std::cos(std::numbers::pi / 256));
  Rng rng(71);
  for (int i = 0; i < 500; ++i) {
    const Vec3 q = random_point(rng, 30);
    const double exact = std::abs(std::hypot(std::hypot(q.x(), q.y()) - major, q.z()) - minor);
    EXPECT_NEAR(std::sqrt(tree.closest(q).squared_distance), exact, sagitta);
  }
}

TEST(TriangleTree, MovesWithTheMesh) {
  const Mesh mesh = build_mesh(testing::bumpy_torus_soup(20, 11, 9));
  const RigidTransform motion =
      Eigen::Translation3d(300, -40, 7) * Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized());
  const TriangleTree here(mesh), there(transformed(mesh, motion));
  Rng rng(81);
  for (int i = 0; i < 200; ++i) {
    const Vec3 query = random_query(mesh, rng);
    const ClosestPoint a = here.closest(query), b = there.closest(motion * query);
    EXPECT_NEAR(std::sqrt(a.squared_distance), std::sqrt(b.squared_distance), 1e-10);
    EXPECT_LT((motion * a.point - b.point).norm(), 1e-8);
  }
}

TEST(TriangleTree, TheSameFromManyThreads) {
  const Mesh mesh = build_mesh(testing::bumpy_torus_soup(40, 20, 10));
  const TriangleTree tree(mesh);
  std::vector<Vec3> queries;
  Rng rng(91);
  for (int i = 0; i < 500; ++i) queries.push_back(random_query(mesh, rng));
  const auto answers = [&](int threads) {
    std::vector<ClosestPoint> found(queries.size());
    parallel_for(static_cast<int>(queries.size()), RunContext(threads),
                 [&](int i) { found[i] = tree.closest(queries[i]); });
    return found;
  };
  const auto one = answers(1), four = answers(4);
  for (std::size_t i = 0; i < one.size(); ++i) expect_same(one[i], four[i]);
}

TEST(TriangleTree, AllTrianglesInOnePlace) {
  TriangleSoup soup = testing::torus_soup(30, 20);
  for (Vec3& p : soup.points) p = Vec3(1, 2, 2);
  const TriangleTree tree(build_mesh(std::move(soup)));
  const ClosestPoint found = tree.closest(Vec3::Zero());
  EXPECT_EQ(found.on.face, FaceId(0));
  EXPECT_EQ(found.squared_distance, 9);
  EXPECT_FALSE(tree.closest_compatible(Vec3::Zero(), Vec3::UnitX(), -1).has_value());  // no face has a normal
}

TEST(TriangleTree, WithoutTriangles) {
  const TriangleTree tree{Mesh()};
  EXPECT_FALSE(tree.closest(Vec3::Zero()).on.face.valid());
  EXPECT_TRUE(tree.faces_within(Vec3::Zero(), 1).empty());
}

TEST(TriangleTree, RealVertebraAgainstBruteForce) {
  FORAMEN_NEEDS_REAL_DATA();
  const Mesh mesh = testing::real_mesh("lumbar/verse005_L2");
  const TriangleTree tree(mesh);
  Rng rng(101);
  for (int i = 0; i < 60; ++i) {
    const Vec3 query = random_query(mesh, rng), normal = random_direction(rng);
    expect_same(tree.closest(query), brute_force(mesh, query));
    expect_same(tree.closest_compatible(query, normal, 0.3).value(), brute_force(mesh, query, [&](FaceId f) {
                  return unit_normal(mesh.triangle(f)).dot(normal) > 0.3;
                }));
  }
}

}  // namespace
}  // namespace foramen
