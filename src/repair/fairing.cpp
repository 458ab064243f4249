#include "repair/fairing.hpp"

#include <map>

#include <Eigen/SparseCholesky>

namespace foramen::repair_detail {
namespace {

std::vector<VertexId> neighbours(const Mesh& mesh, VertexId v) {
  std::vector<VertexId> out;
  for (HalfedgeId h : mesh.fan(v)) out.push_back(mesh.to(h));
  return out;
}

}  // namespace

std::vector<Vec3> faired(const Mesh& mesh, const std::vector<VertexId>& free, Fairness fairness) {
  std::vector<Vec3> positions(mesh.positions().begin(), mesh.positions().end());
  std::map<VertexId, int> unknown;
  for (VertexId v : free) unknown.emplace(v, static_cast<int>(unknown.size()));
  // One equation per vertex that should be the mean of its neighbours.
  std::map<VertexId, int> rows = unknown;
  if (fairness == Fairness::thin_plate)
    for (VertexId v : free)
      for (VertexId n : neighbours(mesh, v)) rows.emplace(n, static_cast<int>(rows.size()));

  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(static_cast<Eigen::Index>(rows.size()), 3);
  const auto add = [&](int row, VertexId v, double weight) {
    if (const auto u = unknown.find(v); u != unknown.end())
      entries.emplace_back(row, u->second, weight);
    else
      right.row(row) -= weight * mesh.position(v).transpose();
  };
  for (const auto& [v, row] : rows) {
    const auto around = neighbours(mesh, v);
    add(row, v, 1);
    for (VertexId n : around) add(row, n, -1 / static_cast<double>(around.size()));
  }
  Eigen::SparseMatrix<double> system(static_cast<Eigen::Index>(rows.size()),
                                     static_cast<Eigen::Index>(unknown.size()));
  system.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> normal = system.transpose() * system;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal);
  if (solver.info() != Eigen::Success) return positions;
  const Eigen::MatrixX3d solution = solver.solve(system.transpose() * right);
  if (!solution.allFinite()) return positions;
  for (const auto& [v, u] : unknown) positions[v.index] = solution.row(u).transpose();
  return positions;
}

}  // namespace foramen::repair_detail
