#include "match/principal_curvatures.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace foramen {
namespace {

// Collects the vertices round one vertex. Kept between vertices, so that marks need not be cleared.
class Neighbourhood {
 public:
  Neighbourhood(const Mesh& mesh, const VertexMap<Vec3>& normals, double radius)
      : mesh_(mesh), normals_(normals), radius_(radius), seen_from_(mesh.vertex_count(), VertexId(-1)) {}

  const std::vector<VertexId>& of(VertexId centre) {
    constexpr double facing_away = -0.3;  // cosine of the normals: beyond the edge of a thin wall
    members_.assign(1, centre);
    seen_from_[centre] = centre;
    for (std::size_t next = 0; next < members_.size(); ++next) {
      const HalfedgeId first = mesh_.outgoing(members_[next]);
      HalfedgeId h = first;
      do {
        const VertexId other = mesh_.to(h);
        if (seen_from_[other] != centre &&
            (mesh_.position(other) - mesh_.position(centre)).squaredNorm() < radius_ * radius_ &&
            normals_[other].dot(normals_[centre]) > facing_away) {
          seen_from_[other] = centre;
          members_.push_back(other);
        }
        h = mesh_.rotated(h);
      } while (h.valid() && h != first);
    }
    return members_;
  }

 private:
  const Mesh& mesh_;
  const VertexMap<Vec3>& normals_;
  double radius_;
  VertexMap<VertexId> seen_from_;
  std::vector<VertexId> members_;
};

// Two unit vectors that are orthogonal to the normal and to each other.
std::pair<Vec3, Vec3> tangents(const Vec3& normal) {
  const Vec3 other = std::abs(normal.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 first = other.cross(normal).normalized();
  return {first, normal.cross(first)};
}

}  // namespace

VertexMap<PrincipalCurvatures> principal_curvatures(const Mesh& mesh, const VertexMap<Vec3>& normals,
                                                    double radius_mm) {
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  constexpr std::size_t fewest = 6;
  constexpr double ridge = 1e-3;  // keeps the fit of a neighbourhood on a line solvable
  // With this factor the ridge is the same for all directions of the tangents.
  constexpr double root_two = std::numbers::sqrt2;
  const VertexMap<double> areas = vertex_areas(mesh);
  VertexMap<PrincipalCurvatures> curvatures(mesh.vertex_count());
  Neighbourhood neighbourhood(mesh, normals, radius_mm);
  for (VertexId v : mesh.vertices()) {
    const auto& members = neighbourhood.of(v);
    if (members.size() < fewest) continue;
    const auto [first, second] = tangents(normals[v]);
    Mat6 left = Mat6::Zero();
    Vec6 right = Vec6::Zero();
    for (VertexId member : members) {
      const Vec3 d = (mesh.position(member) - mesh.position(v)) / radius_mm;
      const double x = d.dot(first), y = d.dot(second);
      const double weight = areas[member] * std::exp(-2 * d.squaredNorm());
      Vec6 row;
      row << x * x, root_two * x * y, y * y, x, y, 1;
      left += weight * row * row.transpose();
      right += weight * d.dot(normals[v]) * row;
    }
    left.diagonal().array() += ridge * left.trace() / 6;
    const Vec6 fit = left.ldlt().solve(right);
    Mat2 form;
    form << -2 * fit[0], -root_two * fit[1], -root_two * fit[1], -2 * fit[2];
    const Vec2 values = Eigen::SelfAdjointEigenSolver<Mat2>(form / radius_mm).eigenvalues();
    curvatures[v] = {values[1], values[0]};
  }
  return curvatures;
}

Vec2 squashed(const PrincipalCurvatures& k) {
  constexpr double half_way = 0.3;  // 1/mm
  return {std::tanh(k.largest / half_way), std::tanh(k.smallest / half_way)};
}

double curvedness(const PrincipalCurvatures& k) { return squashed(k).cwiseAbs().maxCoeff(); }

}  // namespace foramen
