#include "foramen/correspond/transfer_homology.hpp"

#include <string>

#include "correspond/vertex_path.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/spatial/point_index.hpp"
#include "foramen/topology/linking.hpp"

namespace foramen {
namespace {

EdgeLoop transfer_loop(const Mesh& shape, const OrientedPointIndex& index, VertexPaths& paths,
                       const std::vector<LoopStation>& stations) {
  std::vector<VertexId> passed;
  for (const LoopStation& station : stations) {
    const VertexId moved(index.nearest(station.position, station.normal).index);
    if (passed.empty() || passed.back() != moved) passed.push_back(moved);
  }
  EdgeLoop closed;
  for (std::size_t k = 0; k < passed.size(); ++k) {
    const auto walk = paths.between(passed[k], passed[(k + 1) % passed.size()]);
    closed.insert(closed.end(), walk.begin(), walk.end());
  }
  FORAMEN_ASSERT(closed.empty() || shape.to(closed.back()) == shape.from(closed.front()));
  return closed;
}

// Gradients of the two coordinates (in turns) on a face, as vectors in space [turns per mm].
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

// Area-weighted average of the gradients of the faces at each vertex, by coordinate; unit length.
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

LoopStations stations_of(const ReferenceLoops& reference) {
  const auto normals = vertex_normals(reference.mesh);
  LoopStations stations;
  for (std::size_t k = 0; k < 2; ++k)
    for (HalfedgeId h : reference.loops.loops[k]) {
      const VertexId v = reference.mesh.from(h);
      stations[k].push_back({reference.mesh.position(v), normals[v]});
    }
  return stations;
}

HomologyTransfer transfer_homology(const Mesh& aligned_shape, const Cocycle& form,
                                   const LoopStations& reference) {
  const auto normals = vertex_normals(aligned_shape);
  const OrientedPointIndex index(aligned_shape.positions(), normals.values(), vertebra_normal_weight_mm);
  const auto lengths = edge_lengths(aligned_shape);
  VertexPaths paths(aligned_shape, lengths);
  HomologyTransfer transfer;
  for (int k = 0; k < 2; ++k) {
    auto& moved = transfer.transferred[static_cast<std::size_t>(k)];
    moved = transfer_loop(aligned_shape, index, paths, reference[static_cast<std::size_t>(k)]);
    transfer.a.col(k) = integrate(form, moved);
  }
  const int det = transfer.a(0, 0) * transfer.a(1, 1) - transfer.a(0, 1) * transfer.a(1, 0);
  if (std::abs(det) != 1)
    throw TopologyError(
        "the reference's loops could not be carried to this shape (their homology matrix has determinant " +
        std::to_string(det) + ", not +-1): the shape is probably misaligned or of another anatomy");
  return transfer;
}

void require_reference_homology(const Mesh& carried, const Mesh& embedded, const TorusMap& map,
                                const LoopStations& loops, const Eigen::Matrix2i& reference_seifert) {
  const HomologyTransfer moved = transfer_homology(carried, {map.jumps}, loops);
  const Eigen::Matrix2i seifert = seifert_matrix(embedded, moved.transferred[0], moved.transferred[1]);
  if (moved.a == Eigen::Matrix2i::Identity() && seifert == reference_seifert) return;
  throw TopologyError(
      "the finished map winds the reference's loops round the torus otherwise than the reference does (or "
      "they "
      "link otherwise in space): the shape is probably misaligned or of another anatomy");
}

Eigen::Matrix2i inverse_unimodular(const Eigen::Matrix2i& a) {
  const int det = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
  FORAMEN_ASSERT(std::abs(det) == 1);
  Eigen::Matrix2i inverse;
  inverse << det * a(1, 1), -det * a(0, 1), -det * a(1, 0), det * a(0, 0);
  return inverse;
}

Vec2 map_agreement(const Mesh& aligned_shape, const TorusMap& map, const Mesh& reference,
                   const TorusMap& reference_map) {
  const auto normals = vertex_normals(aligned_shape), reference_normals = vertex_normals(reference);
  const OrientedPointIndex index(reference.positions(), reference_normals.values(),
                                 vertebra_normal_weight_mm);
  const auto here = vertex_gradients(aligned_shape, map), there = vertex_gradients(reference, reference_map);
  const auto areas = vertex_areas(aligned_shape);
  Vec2 sum = Vec2::Zero();
  double weight = 0;
  for (VertexId v : aligned_shape.vertices()) {
    const VertexId near(index.nearest(aligned_shape.position(v), normals[v]).index);
    for (std::size_t c = 0; c < 2; ++c) sum[static_cast<int>(c)] += areas[v] * here[c][v].dot(there[c][near]);
    weight += areas[v];
  }
  return sum / weight;
}

}  // namespace foramen
