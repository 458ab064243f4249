#include "foramen/core/mesh.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

const Eigen::MatrixX3d points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Eigen::MatrixX3i triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

TEST(EigenMesh, ComesBackAsItWas) {
  const Mesh mesh = mesh_from_matrices(points, triangles);
  EXPECT_TRUE(mesh.is_closed());
  EXPECT_EQ(mesh.position(VertexId(3)), Vec3(0, 0, 1));
  EXPECT_EQ(matrix_of(mesh.positions()), points);
  EXPECT_EQ(matrix_of(mesh.triangles()), triangles);
}

TEST(EigenMesh, AnIndexOutOfRangeIsRefused) {
  Eigen::MatrixX3i wrong = triangles;
  wrong(2, 1) = 4;
  EXPECT_THROW(mesh_from_matrices(points, wrong), InvalidInput);
}

}  // namespace
}  // namespace foramen
