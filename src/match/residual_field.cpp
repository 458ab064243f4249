#include "match/residual_field.hpp"

#include <algorithm>
#include <numbers>

#include <Eigen/LU>

#include "foramen/core/geometry.hpp"

namespace foramen {

ResidualField::ResidualField(const Mesh& surface, double length_mm, double amplitude_mm)
    : factor_(1 / (4 * std::numbers::pi * length_mm * length_mm * amplitude_mm * amplitude_mm)) {
  const int n = surface.vertex_count();
  constexpr double least_area = 1e-3;  // mm^2
  area_.resize(n);
  const VertexMap<double> areas = vertex_areas(surface);
  for (VertexId v : surface.vertices()) area_[v.index] = std::max(least_area, areas[v]);

  // Slivers have cotangents beyond any bound, and negative ones would couple vertices that repel each other.
  constexpr double least_cotangent = 0, largest_cotangent = 5;
  std::vector<Eigen::Triplet<double>> entries;
  for (FaceId f : surface.faces()) {
    const auto corners = surface.corners(f);
    const auto triangle = surface.triangle(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = triangle[(k + 1) % 3] - triangle[k], b = triangle[(k + 2) % 3] - triangle[k];
      const double twice_area = std::max(1e-12, a.cross(b).norm());
      const double cotangent = std::clamp(a.dot(b) / twice_area, least_cotangent, largest_cotangent);
      const double weight = length_mm * length_mm * cotangent / 2;
      const int i = corners[(k + 1) % 3].index, j = corners[(k + 2) % 3].index;
      entries.insert(entries.end(), {{i, i, weight}, {j, j, weight}, {i, j, -weight}, {j, i, -weight}});
    }
  }
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, area_[i]);
  operator_.resize(n, n);
  operator_.setFromTriplets(entries.begin(), entries.end());

  diagonal_ = Eigen::VectorXd::Zero(n);
  for (int i = 0; i < n; ++i)
    for (Sparse::InnerIterator entry(operator_, i); entry; ++entry)
      diagonal_[i] += factor_ * entry.value() * entry.value() / area_[entry.col()];
}

Eigen::MatrixX3d ResidualField::most_probable(const std::vector<VertexPull>& pulls,
                                              const Eigen::MatrixX3d& start) const {
  const Eigen::Index n = area_.size();
  std::vector<Mat3> inverse(n);
  for (Eigen::Index i = 0; i < n; ++i) inverse[i] = Mat3::Identity() / diagonal_[i];
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n, 3);
  for (const VertexPull& pull : pulls) {
    right.row(pull.vertex) = pull.weighted_shift.transpose();
    inverse[pull.vertex] = (pull.weight + diagonal_[pull.vertex] * Mat3::Identity()).inverse();
  }
  const auto applied = [&](const Eigen::MatrixX3d& x) {
    const Eigen::MatrixX3d y = area_.cwiseInverse().asDiagonal() * (operator_ * x);
    Eigen::MatrixX3d z = factor_ * (operator_ * y);
    for (const VertexPull& pull : pulls) z.row(pull.vertex) += x.row(pull.vertex) * pull.weight;
    return z;
  };
  const auto preconditioned = [&](const Eigen::MatrixX3d& x) {
    Eigen::MatrixX3d z(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) z.row(i) = x.row(i) * inverse[i];
    return z;
  };

  constexpr double relative = 1e-6;  // of the squared residual
  constexpr int most_iterations = 150;
  Eigen::MatrixX3d solution = start, residual = right - applied(solution), z = preconditioned(residual),
                   direction = z;
  const double stop = relative * right.cwiseProduct(preconditioned(right)).sum();
  double product = residual.cwiseProduct(z).sum();
  for (int iteration = 0; iteration < most_iterations && product > stop; ++iteration) {
    const Eigen::MatrixX3d along = applied(direction);
    const double step = product / direction.cwiseProduct(along).sum();
    solution += step * direction;
    residual -= step * along;
    z = preconditioned(residual);
    const double next = residual.cwiseProduct(z).sum();
    direction = z + next / product * direction;
    product = next;
  }
  return solution;
}

}  // namespace foramen
