#include "correspond/subdivide.hpp"

#include <gtest/gtest.h>

#include "correspond/knobbly_family.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {
namespace {

TemplateSurface coarse_torus() {
  const testing::MappedSurface member = testing::member_surface(1, 300);
  return {member.mesh, member.map};
}

TEST(Subdivided, DividesEveryTriangleAndItsImageIntoFourEqualParts) {
  const TemplateSurface coarse = coarse_torus(), fine = subdivided(coarse);
  ASSERT_EQ(fine.mesh.face_count(), 4 * coarse.mesh.face_count());
  EXPECT_EQ(fine.mesh.vertex_count(), coarse.mesh.vertex_count() + coarse.mesh.edge_count());
  for (FaceId f : fine.mesh.faces()) {
    const FaceId whole(f.index / 4);
    EXPECT_NEAR(4 * area(fine.mesh.triangle(f)), area(coarse.mesh.triangle(whole)), 1e-9);
    EXPECT_NEAR(4 * signed_area(fine.mesh, fine.map, f), signed_area(coarse.mesh, coarse.map, whole), 1e-9);
  }
}

TEST(Subdivided, IsAOneToOneMapWithTheVerticesInTheirPlaces) {
  const TemplateSurface coarse = coarse_torus(), fine = subdivided(coarse);
  EXPECT_TRUE(certify(fine.mesh, fine.map).valid());
  for (VertexId v : coarse.mesh.vertices()) {
    EXPECT_EQ(fine.mesh.position(v), coarse.mesh.position(v));
    EXPECT_LT((fine.map.turns[v] - coarse.map.turns[v]).norm(), 1e-11);
  }
}

// Points between the vertices have the same torus positions on both.
TEST(Subdivided, IsTheSameMap) {
  const TemplateSurface coarse = coarse_torus(), fine = subdivided(coarse);
  const std::vector<Vec2> places{{0.1, 0.2}, {0.37, 0.81}, {0.99, 0.5}, {0.5, 0.003}};
  const std::vector<Vec3> on_coarse = lift_to_surface(TorusLocator(coarse.mesh, coarse.map), places),
                          on_fine = lift_to_surface(TorusLocator(fine.mesh, fine.map), places);
  for (std::size_t k = 0; k < places.size(); ++k) EXPECT_LT((on_coarse[k] - on_fine[k]).norm(), 1e-6);
}

TEST(Subdivided, TakesItsCurvaturesFromTheCoarseVertices) {
  TemplateSurface coarse = coarse_torus();
  EXPECT_TRUE(subdivided(coarse).curvatures.values().empty());
  coarse.curvatures = VertexMap<Vec2>(coarse.mesh.vertex_count(), Vec2(1, 2));
  const EdgeId edge = *coarse.mesh.edges().begin();
  const VertexId from = coarse.mesh.from(coarse.mesh.halfedge(edge));
  coarse.curvatures[from] = Vec2(3, -2);
  const TemplateSurface fine = subdivided(coarse);
  ASSERT_EQ(std::ssize(fine.curvatures.values()), fine.mesh.vertex_count());
  EXPECT_EQ(fine.curvatures[from], Vec2(3, -2));
  EXPECT_EQ(fine.curvatures[VertexId(coarse.mesh.vertex_count() + edge.index)], Vec2(2, 0));
}

TEST(WithEdgeMidpoints, AreThePositionsOfTheSubdividedMesh) {
  const TemplateSurface coarse = coarse_torus(), fine = subdivided(coarse);
  const std::vector<Vec3> points = with_edge_midpoints(coarse.mesh, coarse.mesh.positions());
  ASSERT_EQ(std::ssize(points), fine.mesh.vertex_count());
  for (VertexId v : fine.mesh.vertices()) EXPECT_EQ(points[v.index], fine.mesh.position(v));
}

}  // namespace
}  // namespace foramen
