#include "match/residual_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "foramen/core/geometry.hpp"
#include "support/lopsided_torus.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

// The precision E of the field by its definition, as a dense matrix.
Eigen::MatrixXd dense_precision(const Mesh& mesh, double length, double amplitude) {
  const int n = mesh.vertex_count();
  Eigen::MatrixXd laplace = Eigen::MatrixXd::Zero(n, n);
  for (FaceId f : mesh.faces()) {
    const auto c = mesh.corners(f);
    const auto t = mesh.triangle(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = t[(k + 1) % 3] - t[k], b = t[(k + 2) % 3] - t[k];
      const double half = std::clamp(a.dot(b) / a.cross(b).norm(), 0.0, 5.0) / 2;
      const int i = c[(k + 1) % 3].index, j = c[(k + 2) % 3].index;
      laplace(i, j) -= half, laplace(j, i) -= half, laplace(i, i) += half, laplace(j, j) += half;
    }
  }
  const VertexMap<double> areas = vertex_areas(mesh);
  const Eigen::Map<const Eigen::VectorXd> area(areas.values().data(), n);
  const Eigen::MatrixXd whole = length * length * laplace + area.asDiagonal().toDenseMatrix();
  return whole.transpose() * area.cwiseInverse().asDiagonal() * whole /
         (4 * std::numbers::pi * length * length * amplitude * amplitude);
}

// Three pulls that hold in different directions.
std::vector<VertexPull> some_pulls() {
  Mat3 along_x = Mat3::Zero(), tilted = 0.5 * Mat3::Identity();
  along_x(0, 0) = 30;
  tilted += Vec3(1, 2, 2) * Vec3(1, 2, 2).transpose();
  return {{3, along_x, along_x * Vec3(0.4, 9, 9)},
          {40, tilted, tilted * Vec3(0.1, -0.3, 0.2)},
          {77, 5 * Mat3::Identity(), 5 * Vec3(0, 0, -0.5)}};
}

TEST(ResidualField, SolvesTheDenseSystem) {
  const Mesh mesh = build_mesh(testing::torus_soup(24, 10, 20, 8));
  for (const double length : {3.0, 10.0}) {
    const Eigen::Index n = mesh.vertex_count();
    const Eigen::MatrixXd precision = dense_precision(mesh, length, 0.3);
    Eigen::MatrixXd left = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(3 * n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j)
        left.block<3, 3>(3 * i, 3 * j) = precision(i, j) * Mat3::Identity();
    for (const VertexPull& pull : some_pulls()) {
      left.block<3, 3>(3 * pull.vertex, 3 * pull.vertex) += pull.weight;
      right.segment<3>(3 * pull.vertex) += pull.weighted_shift;
    }
    const Eigen::VectorXd expected = left.ldlt().solve(right);
    const auto found =
        ResidualField(mesh, length, 0.3).most_probable(some_pulls(), Eigen::MatrixX3d::Zero(n, 3));
    const double largest = expected.cwiseAbs().maxCoeff();
    ASSERT_GT(largest, 0.05);
    for (Eigen::Index i = 0; i < n; ++i)
      EXPECT_LT((found.row(i).transpose() - expected.segment<3>(3 * i)).norm(), 5e-3 * largest) << i;
  }
}

TEST(ResidualField, StaysWhereItIsIfNothingPulls) {
  const Mesh mesh = build_mesh(testing::torus_soup(24, 10));
  const auto found =
      ResidualField(mesh, 5, 0.3).most_probable({}, Eigen::MatrixX3d::Zero(mesh.vertex_count(), 3));
  EXPECT_TRUE(found.isZero(0));
}

// On a fine surface the variance of a coordinate is the amplitude's square, whatever the triangles are.
TEST(ResidualField, HasTheAmplitudeThatItIsGiven) {
  const Mesh mesh = build_mesh(testing::torus_soup(72, 30, 20, 8));
  const double length = 4, amplitude = 0.3;
  const ResidualField field(mesh, length, amplitude);
  // With one pull of precision p at goal g the vertex moves by g v / (v + 1 / p), where v is its variance.
  const double p = 10;
  for (const int vertex : {0, 500, 1200}) {
    const std::vector<VertexPull> pull{{vertex, p * Mat3::Identity(), p * Vec3(1, 0, 0)}};
    const double moved = field.most_probable(pull, Eigen::MatrixX3d::Zero(mesh.vertex_count(), 3))(vertex, 0);
    EXPECT_NEAR(std::sqrt(moved / (p * (1 - moved))), amplitude, 0.1 * amplitude) << vertex;
  }
}

TEST(ResidualField, TheFirstGuessDoesNotMatter) {
  const Mesh mesh = build_mesh(testing::torus_soup(24, 10));
  const ResidualField field(mesh, 5, 0.3);
  const auto a = field.most_probable(some_pulls(), Eigen::MatrixX3d::Zero(mesh.vertex_count(), 3)),
             b = field.most_probable(some_pulls(), Eigen::MatrixX3d::Constant(mesh.vertex_count(), 3, 0.2));
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 2e-3 * a.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace foramen
