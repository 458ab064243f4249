#include "parameterize/periodic_laplacian.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/SparseCholesky>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

/// Tolerance of the degree: the sum of signed areas is an integer multiple of the domain's area up to
/// rounding.
constexpr double degree_tolerance = 1e-6;

}  // namespace

VertexMap<Vec2> average_of_neighbours(const Mesh& mesh, const Cocycle& form,
                                      const VertexMap<std::optional<Vec2>>& fixed) {
  VertexMap<int> unknown(mesh.vertex_count(), -1);
  int count = 0;
  for (VertexId v : mesh.vertices())
    if (!fixed[v]) unknown[v] = count++;
  FORAMEN_ASSERT(count < mesh.vertex_count());

  VertexMap<Vec2> p(mesh.vertex_count(), Vec2::Zero());
  for (VertexId v : mesh.vertices())
    if (fixed[v]) p[v] = *fixed[v];
  if (count == 0) return p;

  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> degree(count, 0.0);
  Eigen::MatrixX2d rhs = Eigen::MatrixX2d::Zero(count, 2);
  for (HalfedgeId h : mesh.halfedges()) {
    const int i = unknown[mesh.from(h)], j = unknown[mesh.to(h)];
    if (i < 0) continue;
    degree[i] += 1;
    rhs.row(i) += form.value[h].cast<double>().transpose();
    if (j < 0)
      rhs.row(i) += p[mesh.to(h)].transpose();
    else if (j < i)
      entries.emplace_back(i, j, -1.0);
  }
  for (int i = 0; i < count; ++i) entries.emplace_back(i, i, degree[i]);
  Eigen::SparseMatrix<double> laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky(laplacian);
  if (cholesky.info() != Eigen::Success)
    throw ConvergenceError("the Laplacian of the surface could not be factored; is the surface connected?");
  const Eigen::MatrixX2d solution = cholesky.solve(rhs);
  for (VertexId v : mesh.vertices())
    if (unknown[v] >= 0) p[v] = solution.row(unknown[v]).transpose();
  return p;
}

void check_embedding(const Mesh& mesh, const TorusMap& map) {
  double degree = 0;
  for (FaceId f : mesh.faces()) degree += signed_area(mesh, map, f);
  if (std::abs(degree - 1) > degree_tolerance)
    throw TopologyError("the map covers the torus " + std::to_string(degree) +
                        " times instead of once; for -1 exchange the two loops or reverse one");
  for (FaceId f : mesh.faces())
    if (!(signed_area(mesh, map, f) > 0))
      throw ConvergenceError("triangle " + std::to_string(f.index) +
                             " has no positive area in the first map of the surface");
}

}  // namespace foramen
