#include "match/oriented_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "foramen/core/error.hpp"
#include "spatial/point_index.hpp"
#include "support/lopsided_torus.hpp"

namespace foramen {
namespace {

RigidTransform some_motion() {
  return Eigen::Translation3d(-60, 20, 130) * Eigen::AngleAxisd(1.3, Vec3(2, 1, -1).normalized());
}

// A square in the plane z = 0, seen from above.
Mesh square(int side) {
  TriangleSoup soup;
  for (int i = 0; i <= side; ++i)
    for (int k = 0; k <= side; ++k) soup.points.emplace_back(i, k, 0);
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k) {
      const int a = (side + 1) * i + k, b = a + side + 1;
      soup.triangles.push_back({a, b, b + 1});
      soup.triangles.push_back({a, b + 1, a + 1});
    }
  return build_mesh(std::move(soup));
}

TEST(OrientedSamples, LieOnTheSurfaceWithItsNormals) {
  // On the torus of radii 20 and 8 mm the normal points from the nearest point of its core circle.
  const Mesh torus = build_mesh(testing::torus_soup(120, 60));
  const auto samples = oriented_samples(torus, 500, 3);
  ASSERT_EQ(samples.size(), 500u);
  for (const OrientedPoint& p : samples) {
    const Vec3 core = 20 * Vec3(p.position.x(), p.position.y(), 0).normalized();
    EXPECT_NEAR((p.position - core).norm(), 8, 0.05);
    EXPECT_NEAR(p.normal.norm(), 1, 1e-12);
    EXPECT_GT(p.normal.dot((p.position - core).normalized()), 0.999);
    EXPECT_FALSE(p.at_border);
  }
}

TEST(OrientedSamples, MoveWithTheSurface) {
  const Mesh mesh = build_mesh(testing::lopsided_torus_soup(40, 20));
  const auto here = oriented_samples(mesh, 200, 1);
  const auto there = oriented_samples(transformed(mesh, some_motion()), 200, 1);
  for (std::size_t i = 0; i < here.size(); ++i) {
    const OrientedPoint expected = moved(here[i], some_motion());
    EXPECT_LT((there[i].position - expected.position).norm(), 1e-6);
    EXPECT_LT((there[i].normal - expected.normal).norm(), 1e-6);
  }
}

TEST(OrientedSamples, SayWhereTheSurfaceEnds) {
  const Mesh mesh = square(10);
  int at_border = 0;
  for (const OrientedPoint& p : oriented_samples(mesh, 2000, 1)) {
    const double inside =
        std::min({p.position.x(), p.position.y(), 10 - p.position.x(), 10 - p.position.y()});
    if (inside < 0.999) {
      EXPECT_TRUE(p.at_border) << p.position.transpose();
    } else if (inside > 1.001) {
      EXPECT_FALSE(p.at_border) << p.position.transpose();
    }
    at_border += p.at_border;
  }
  EXPECT_NEAR(at_border / 2000.0, 1 - 0.64, 0.03);
}

TEST(OrientedVertices, AreTheVerticesWithTheirNormals) {
  const Mesh mesh = square(4);
  const auto points = oriented_vertices(mesh);
  ASSERT_EQ(static_cast<int>(points.size()), mesh.vertex_count());
  for (VertexId v : mesh.vertices()) {
    const OrientedPoint& p = points[v.index];
    EXPECT_EQ(p.position, mesh.position(v));
    EXPECT_LT((p.normal - Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_EQ(p.at_border, mesh.is_boundary(v));
  }
}

TEST(MeanNormal, LiesBetweenOrIsTheSecond) {
  EXPECT_LT((mean_normal(Vec3::UnitX(), Vec3::UnitY()) - Vec3(1, 1, 0).normalized()).norm(), 1e-12);
  EXPECT_EQ(mean_normal(Vec3::UnitX(), -Vec3::UnitX()), -Vec3::UnitX());
}

TEST(IndexedPoints, FindWhatSearchingAllFinds) {
  const Mesh mesh = build_mesh(testing::lopsided_torus_soup(30, 16));
  const IndexedPoints points(oriented_vertices(mesh), 5);
  for (const OrientedPoint& query : oriented_samples(mesh, 100, 2)) {
    const auto distance = [&](const OrientedPoint& p) {
      return std::sqrt((p.position - query.position).squaredNorm() +
                       25 * (p.normal - query.normal).squaredNorm());
    };
    const auto nearest =
        std::min_element(points.points().begin(), points.points().end(),
                         [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    const NearPoint found = points.nearest(query);
    EXPECT_NEAR(found.distance(), distance(*nearest), 1e-9);
    EXPECT_NEAR(distance(points[found.index]), distance(*nearest), 1e-9);
    const auto three = points.nearest(query, 3);
    ASSERT_EQ(three.size(), 3u);
    EXPECT_EQ(three.front().index, found.index);
    EXPECT_LE(three[1].squared_distance, three[2].squared_distance);
  }
  EXPECT_THROW(IndexedPoints(oriented_vertices(mesh), -1), InvalidInput);
}

TEST(NearestVertices, StayOnTheirSideOfAThinWall) {
  // The surface is moved by more than the thickness of the wall. Each vertex must still find itself and not
  // the other side of the wall.
  const Mesh wall = build_mesh(testing::walled_torus_soup(120, 60, 1, 0.4, 0.3));
  RigidTransform shift = RigidTransform::Identity();
  shift.translation() = Vec3(0.3, 0.3, 0.9);
  const VertexMap<Vec3> normals = vertex_normals(wall);
  const VertexMap<VertexId> near = nearest_vertices(transformed(wall, shift), wall);
  for (VertexId v : wall.vertices()) EXPECT_GT(normals[near[v]].dot(normals[v]), 0.5);
  const VertexMap<VertexId> own = nearest_vertices(wall, wall);
  for (VertexId v : wall.vertices()) EXPECT_EQ(own[v], v);
}

}  // namespace
}  // namespace foramen
