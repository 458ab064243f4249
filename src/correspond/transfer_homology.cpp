#include "correspond/transfer_homology.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "correspond/vertex_path.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "match/oriented_points.hpp"
#include "topology/linking.hpp"

namespace foramen {
namespace {

// Points along the loop with normals, from each vertex on, that are no further apart than the spacing [mm]. A
// path between the places of two vertices alone may return on the side from which it came if the edge is
// long.
std::vector<OrientedPoint> points_along(const Mesh& mesh, const VertexMap<Vec3>& normals,
                                        const EdgeLoop& loop, double spacing) {
  std::vector<OrientedPoint> points;
  for (HalfedgeId h : loop) {
    const VertexId from = mesh.from(h), to = mesh.to(h);
    const Vec3 edge = mesh.position(to) - mesh.position(from);
    const int pieces = std::max(1, static_cast<int>(std::ceil(edge.norm() / spacing)));
    for (int k = 0; k < pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      const Vec3 normal = (1 - t) * normals[from] + t * normals[to];
      points.push_back({mesh.position(from) + t * edge, normal.stableNormalized()});
    }
  }
  return points;
}

EdgeLoop transfer_loop(const Mesh& shape, const IndexedPoints& vertices, VertexPaths& paths,
                       const std::vector<OrientedPoint>& points) {
  std::vector<VertexId> stations;
  for (const OrientedPoint& point : points) {
    const VertexId moved(vertices.nearest(point).index);
    if (stations.empty() || stations.back() != moved) stations.push_back(moved);
  }
  EdgeLoop closed;
  for (std::size_t k = 0; k < stations.size(); ++k) {
    const auto walk = paths.between(stations[k], stations[(k + 1) % stations.size()]);
    closed.insert(closed.end(), walk.begin(), walk.end());
  }
  FORAMEN_ASSERT(closed.empty() || shape.to(closed.back()) == shape.from(closed.front()));
  return closed;
}

// Gradients of the two torus coordinates on a face, as vectors in space [turns per mm].
std::array<Vec3, 2> gradients(const Mesh& mesh, const TorusMap& map, FaceId f) {
  const auto t = mesh.triangle(f);
  const Vec3 doubled = 2 * area_vector(t);
  const double squared = doubled.squaredNorm();
  std::array<Vec3, 2> out{Vec3::Zero(), Vec3::Zero()};
  if (squared == 0) return out;
  const HalfedgeId h0 = Mesh::halfedge(f, 0), h2 = Mesh::halfedge(f, 2);
  const auto corners = mesh.corners(f);
  const Vec2 along1 = map.turns[corners[1]] + map.jumps[h0].cast<double>() - map.turns[corners[0]];
  const Vec2 along2 = map.turns[corners[2]] - map.jumps[h2].cast<double>() - map.turns[corners[0]];
  const Vec3 e1 = t[1] - t[0], e2 = t[2] - t[0];
  for (int c = 0; c < 2; ++c)
    out[c] = (along1[c] * e2.cross(doubled) + along2[c] * doubled.cross(e1)) / squared;
  return out;
}

// For each coordinate, the area-weighted average of the gradients of the faces at each vertex, normalised to
// unit length.
std::array<VertexMap<Vec3>, 2> vertex_gradients(const Mesh& mesh, const TorusMap& map) {
  std::array<VertexMap<Vec3>, 2> sum{VertexMap<Vec3>(mesh.vertex_count(), Vec3::Zero()),
                                     VertexMap<Vec3>(mesh.vertex_count(), Vec3::Zero())};
  for (FaceId f : mesh.faces()) {
    const auto g = gradients(mesh, map, f);
    const double weight = area(mesh.triangle(f));
    for (VertexId v : mesh.corners(f))
      for (std::size_t c = 0; c < 2; ++c) sum[c][v] += weight * g[c];
  }
  for (auto& field : sum)
    for (Vec3& g : field)
      if (g.squaredNorm() > 0) g.normalize();
  return sum;
}

}  // namespace

HomologyTransfer transfer_homology(const Mesh& aligned_shape, const Cocycle& form,
                                   const ReferenceLoops& reference) {
  const auto reference_normals = vertex_normals(reference.mesh);
  const IndexedPoints vertices(oriented_vertices(aligned_shape), vertebra_normal_weight_mm);
  const auto lengths = edge_lengths(aligned_shape);
  VertexPaths paths(aligned_shape, lengths);
  double spacing = 0;  // the mean length of the shape's edges
  for (const double length : lengths) spacing += length / lengths.size();
  HomologyTransfer transfer;
  for (int k = 0; k < 2; ++k) {
    const EdgeLoop& loop = reference.loops.loops[k];
    auto& moved = transfer.transferred[k];
    moved = transfer_loop(aligned_shape, vertices, paths,
                          points_along(reference.mesh, reference_normals, loop, spacing));
    transfer.a.col(k) = integrate(form, moved);
  }
  const int det = transfer.a(0, 0) * transfer.a(1, 1) - transfer.a(0, 1) * transfer.a(1, 0);
  if (std::abs(det) != 1)
    throw TopologyError(
        "the reference's loops could not be carried to this shape (their homology matrix has determinant " +
        std::to_string(det) + ", not +-1): the shape is probably misaligned or of another anatomy");
  return transfer;
}

Eigen::Matrix2i inverse_unimodular(const Eigen::Matrix2i& a) {
  const int det = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
  FORAMEN_ASSERT(std::abs(det) == 1);
  Eigen::Matrix2i inverse;
  inverse << det * a(1, 1), -det * a(0, 1), -det * a(1, 0), det * a(0, 0);
  return inverse;
}

void require_reference_homology(const Mesh& mesh, const TorusMap& map, const Vec2& base,
                                const Eigen::Matrix2i& reference_seifert) {
  const auto distance = [&](VertexId v) {
    const Vec2 turns = map.turns[v] - base;
    return (map.lattice * (turns - turns.array().round().matrix())).squaredNorm();
  };
  VertexId nearest(0);
  for (VertexId v : mesh.vertices())
    if (distance(v) < distance(nearest)) nearest = v;
  const LoopSystem loops = oriented(mesh, greedy_loops(mesh, nearest, edge_lengths(mesh)));
  Eigen::Matrix2i periods = Eigen::Matrix2i::Zero();
  for (int k = 0; k < 2; ++k) periods.col(k) = integrate({map.jumps}, loops.loops[k]);
  const int det = periods(0, 0) * periods(1, 1) - periods(0, 1) * periods(1, 0);
  const Eigen::Matrix2i seifert = seifert_matrix(mesh, loops.loops[0], loops.loops[1]);
  if (det == 1 && seifert_test(inverse_unimodular(periods), seifert, reference_seifert)) return;
  throw TopologyError(
      "the finished map winds round the torus otherwise than the reference's (Seifert test of loops found "
      "anew failed): the shape is probably misaligned or of another anatomy");
}

Vec2 map_agreement(const Mesh& aligned_shape, const TorusMap& map, const Mesh& reference,
                   const TorusMap& reference_map) {
  const VertexMap<VertexId> near = nearest_vertices(aligned_shape, reference);
  const auto here = vertex_gradients(aligned_shape, map), there = vertex_gradients(reference, reference_map);
  const auto areas = vertex_areas(aligned_shape);
  Vec2 sum = Vec2::Zero();
  double weight = 0;
  for (VertexId v : aligned_shape.vertices()) {
    for (std::size_t c = 0; c < 2; ++c)
      sum[static_cast<int>(c)] += areas[v] * here[c][v].dot(there[c][near[v]]);
    weight += areas[v];
  }
  return sum / weight;
}

}  // namespace foramen
