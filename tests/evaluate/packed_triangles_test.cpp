#include "evaluate/packed_triangles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "foramen/core/geometry.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "support/meshes.hpp"

namespace foramen::detail {
namespace {

using testing::bumpy_torus_soup;
using testing::renumbered;
using testing::torus_soup;

/// A strip of thin triangles, with heights down to 1e-9 of their length, and of triangles without area.
TriangleSoup needles() {
  TriangleSoup soup = torus_soup(12, 6);
  for (std::size_t i = 0; i < soup.points.size(); i += 3)
    soup.points[i] = soup.points[(i + 1) % soup.points.size()];
  for (std::size_t i = 1; i < soup.points.size(); i += 5) soup.points[i].z() *= 1e-9;
  return soup;
}

TriangleSoup shifted(TriangleSoup soup, const Vec3& by) {
  for (Vec3& p : soup.points) p += by;
  return soup;
}

std::vector<std::pair<std::string, Mesh>> meshes() {
  return {{"smallest torus", build_mesh(torus_soup(3, 3))},
          {"torus", build_mesh(torus_soup(30, 13))},
          {"bumpy torus", build_mesh(bumpy_torus_soup(25, 11, 3))},
          {"renumbered", build_mesh(renumbered(bumpy_torus_soup(20, 10, 4), 5))},
          {"needles", build_mesh(needles())},
          {"far from the origin", build_mesh(shifted(torus_soup(20, 10), Vec3(4000, -900, 300)))}};
}

/// Query points near and far from the mesh, and on vertices, edges and faces.
std::vector<Vec3> queries(const Mesh& mesh, int count) {
  Rng rng(7);
  const BoundingBox box = bounding_box(mesh.positions());
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const auto t = mesh.triangle(FaceId(rng.below(mesh.face_count())));
    const Vec3 on = t[0] + rng.uniform() * (t[1] - t[0]);
    const Vec3 away(rng.normal(), rng.normal(), rng.normal());
    points.push_back(t[0]);
    points.push_back(on);
    points.push_back(on + std::pow(10.0, rng.uniform(-6, 1)) * away);
    points.push_back(box.low +
                     (box.high - box.low).cwiseProduct(Vec3(rng.uniform(), rng.uniform(), rng.uniform())));
    points.push_back(box.low + 10 * box.diagonal() * away);
  }
  return points;
}

double brute_force(const Mesh& mesh, const Vec3& query) {
  double smallest = std::numeric_limits<double>::infinity();
  for (FaceId f : mesh.faces())
    smallest = std::min(smallest, closest_on_triangle(mesh.triangle(f), query).squared_distance);
  return smallest;
}

TEST(PackedTriangles, DistancesAreThoseOfBruteForceToTheBit) {
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    const PackedTriangles packed(mesh);
    for (const Vec3& q : queries(mesh, 60)) EXPECT_EQ(packed.squared_distance(q), brute_force(mesh, q));
  }
}

TEST(PackedTriangles, DistancesAreThoseOfTheTree) {
  const Mesh mesh = build_mesh(bumpy_torus_soup(120, 50, 9));
  const TriangleTree tree(mesh);
  const PackedTriangles packed(mesh);
  for (const Vec3& q : queries(mesh, 2000))
    EXPECT_EQ(packed.squared_distance(q), tree.closest(q).squared_distance);
}

TEST(PackedTriangles, SaysWhetherAnythingIsWithin) {
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    const PackedTriangles packed(mesh);
    for (const Vec3& q : queries(mesh, 60)) {
      const double d = std::sqrt(packed.squared_distance(q));
      EXPECT_TRUE(packed.any_within(q, d * (1 + 1e-14) + 1e-300));
      EXPECT_FALSE(packed.any_within(q, d * (1 - 1e-14) - 1e-300));
      EXPECT_FALSE(packed.any_within(q, -1.0));
    }
  }
}

TEST(PackedTriangles, LowerBoundsAreNeverAbove) {
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    const PackedTriangles packed(mesh);
    for (const Vec3& q : queries(mesh, 60))
      EXPECT_LE(packed.distance_at_least(q), std::sqrt(packed.squared_distance(q)));
  }
}

TEST(PackedTriangles, LowerBoundsAreClose) {
  const Mesh mesh = build_mesh(torus_soup(120, 50));
  const PackedTriangles packed(mesh);
  for (const Vec3& q : queries(mesh, 1000))
    EXPECT_GE(packed.distance_at_least(q), 0.83 * std::sqrt(packed.squared_distance(q)) - 0.05);
}

TEST(PackedTriangles, FollowsItsVertices) {
  const Mesh before = build_mesh(bumpy_torus_soup(25, 11, 3)),
             after = build_mesh(bumpy_torus_soup(25, 11, 8));
  PackedTriangles packed(before);
  packed.move_to({after.positions().begin(), after.positions().end()});
  const PackedTriangles fresh(after);
  for (const Vec3& q : queries(after, 200)) EXPECT_EQ(packed.squared_distance(q), fresh.squared_distance(q));
}

}  // namespace
}  // namespace foramen::detail
