#pragma once
// Declarations that the tests of loops, periods, cuts and linking share.

#include <string>
#include <vector>

#include "foramen/core/geometry.hpp"
#include "foramen/topology/shortest_loops.hpp"
#include "support/double_torus.hpp"

namespace foramen::testing {

struct NamedMesh {
  std::string name;
  Mesh mesh;
  int genus;
};

inline std::vector<NamedMesh> surfaces_with_handles() {
  return {{"coarsest torus", build_mesh(torus_soup(3, 3)), 1},
          {"torus", build_mesh(torus_soup(16, 10)), 1},
          {"thin torus", build_mesh(torus_soup(24, 9, 20, 1)), 1},
          {"bumpy torus", build_mesh(bumpy_torus_soup(20, 14, 3)), 1},
          {"renumbered bumpy torus", build_mesh(renumbered(bumpy_torus_soup(20, 14, 3), 5)), 1},
          {"double torus", build_mesh(genus2_soup(12, 8)), 2},
          {"bumpy double torus", build_mesh(bumpy_genus2_soup(16, 10, 2)), 2}};
}

/// About `count` basepoints spread over the numbering.
inline std::vector<VertexId> some_vertices(const Mesh& mesh, int count) {
  std::vector<VertexId> chosen;
  const int step = mesh.vertex_count() / count + 1;
  for (int v = 0; v < mesh.vertex_count(); v += step) chosen.emplace_back(v);
  return chosen;
}

/// The vertex that has exactly this position; invalid if there is none.
inline VertexId vertex_at(const Mesh& mesh, const Vec3& position) {
  for (VertexId v : mesh.vertices())
    if (mesh.position(v) == position) return v;
  return {};
}

inline std::vector<Vec3> positions_of(const Mesh& mesh, const EdgeLoop& loop) {
  std::vector<Vec3> positions;
  for (HalfedgeId h : loop) positions.push_back(mesh.position(mesh.from(h)));
  return positions;
}

inline bool is_closed_walk(const Mesh& mesh, const EdgeLoop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (mesh.to(loop[i]) != mesh.from(loop[(i + 1) % loop.size()])) return false;
  return !loop.empty();
}

/// The closed walk through these vertices, each joined by an edge to the next.
inline EdgeLoop walk_through(const Mesh& mesh, const std::vector<int>& vertices) {
  EdgeLoop loop;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    loop.push_back(mesh.find_halfedge(VertexId(vertices[i]), VertexId(vertices[(i + 1) % vertices.size()])));
  return loop;
}

/// On torus_soup(around, tube): about the tube at position 0 along the axis, from the inner rim.
inline EdgeLoop tube_loop(const Mesh& mesh, int tube) {
  std::vector<int> vertices;
  for (int j = 0; j < tube; ++j) vertices.push_back((tube / 2 + j) % tube);
  return walk_through(mesh, vertices);
}

/// On torus_soup(around, tube): about the axis along the inner rim.
inline EdgeLoop rim_loop(const Mesh& mesh, int around, int tube) {
  std::vector<int> vertices;
  for (int i = 0; i < around; ++i) vertices.push_back(i * tube + tube / 2);
  return walk_through(mesh, vertices);
}

}  // namespace foramen::testing
