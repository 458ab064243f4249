#include "apply/part_surface.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

TEST(PartSurface, OfAManifoldIsTheSameSurface) {
  const TriangleSoup torus = testing::torus_soup(12, 9);
  const Mesh part = part_surface(torus);
  EXPECT_TRUE(part.is_closed());
  EXPECT_EQ(part.vertex_count(), static_cast<int>(torus.points.size()));
  EXPECT_DOUBLE_EQ(total_area(part), total_area(build_mesh(torus)));
}

TEST(PartSurface, DropsWhatNoTriangleUses) {
  TriangleSoup torus = testing::torus_soup(12, 9);
  torus.triangles.resize(torus.triangles.size() / 2);
  const Mesh part = part_surface(torus);
  EXPECT_FALSE(part.is_closed());
  EXPECT_LT(part.vertex_count(), static_cast<int>(torus.points.size()));
  EXPECT_EQ(part.face_count(), static_cast<int>(torus.triangles.size()));
}

TEST(PartSurface, TrianglesThatMeetInOnePointOnlyGetAVertexEach) {
  const TriangleSoup bowtie{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                            {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_THROW(build_mesh(bowtie), TopologyError);
  const Mesh part = part_surface(bowtie);
  EXPECT_EQ(part.vertex_count(), 6);
  EXPECT_EQ(part.face_count(), 2);
}

TEST(PartSurface, DropsTrianglesWithoutArea) {
  const TriangleSoup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 3, 1}}};
  EXPECT_EQ(part_surface(soup).face_count(), 1);
}

TEST(PartSurface, OfThreeTrianglesAtAnEdgeTwoStayJoined) {
  const TriangleSoup book{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                          {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  EXPECT_THROW(build_mesh(book), TopologyError);
  const Mesh part = part_surface(book);
  EXPECT_EQ(part.face_count(), 3);
  EXPECT_EQ(part.vertex_count(), 7);
}

TEST(PartSurface, RefusesWhatIsNoSurface) {
  EXPECT_THROW(part_surface({}), InvalidInput);
  EXPECT_THROW(part_surface({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 7}}}), InvalidInput);
}

}  // namespace
}  // namespace foramen
