#include "foramen/core/mesh.hpp"

#include <utility>

namespace foramen {

Mesh mesh_from_matrices(const Eigen::Ref<const Eigen::MatrixX3d>& points,
                        const Eigen::Ref<const Eigen::MatrixX3i>& triangles) {
  TriangleSoup soup;
  for (Eigen::Index i = 0; i < points.rows(); ++i) soup.points.emplace_back(points.row(i).transpose());
  for (Eigen::Index i = 0; i < triangles.rows(); ++i)
    soup.triangles.push_back({triangles(i, 0), triangles(i, 1), triangles(i, 2)});
  return build_mesh(std::move(soup));
}

Eigen::MatrixX3d matrix_of(std::span<const Vec3> points) {
  Eigen::MatrixX3d matrix(std::ssize(points), 3);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) matrix.row(i) = points[i].transpose();
  return matrix;
}

Eigen::MatrixX3i matrix_of(std::span<const std::array<int, 3>> triangles) {
  Eigen::MatrixX3i matrix(std::ssize(triangles), 3);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index k = 0; k < 3; ++k) matrix(i, k) = triangles[i][k];
  return matrix;
}

}  // namespace foramen
