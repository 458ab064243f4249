#pragma once
// A torus of revolution with the map by its two angles, and with loops along both of them.

#include "foramen/core/geometry.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "support/meshes.hpp"

namespace foramen::testing {

struct MappedTorus {
  Mesh mesh;
  TorusMap map;
  std::array<std::vector<VertexId>, 2> loops;  // periods (1,0) and (0,1), through vertex 0
};

inline MappedTorus mapped_torus(int around, int tube) {
  MappedTorus torus;
  torus.mesh = build_mesh(torus_soup(around, tube));
  const Mesh& mesh = torus.mesh;
  TorusMap& map = torus.map;
  map.lattice << 0.8, 0.3, 0, 1.25;
  map.turns = VertexMap<Vec2>(mesh.vertex_count(), Vec2::Zero());
  const auto angle_of = [&](VertexId v) { return Vec2i(v.index / tube, v.index % tube); };
  for (VertexId v : mesh.vertices())
    map.turns[v] = Vec2(angle_of(v).x() / double(around), angle_of(v).y() / double(tube));
  map.jumps = HalfedgeMap<Vec2i>(mesh.halfedge_count(), Vec2i::Zero());
  for (HalfedgeId h : mesh.halfedges()) {
    const Vec2i step = angle_of(mesh.to(h)) - angle_of(mesh.from(h));
    // The jump of an edge, which is 0 unless the edge crosses the end of a period.
    const auto jump = [](int s) { return s > 1 ? -1 : s < -1 ? 1 : 0; };
    map.jumps[h] = Vec2i(jump(step.x()), jump(step.y()));
  }
  for (int i = 0; i < around; ++i) torus.loops[0].emplace_back(i * tube);
  for (int j = 0; j < tube; ++j) torus.loops[1].emplace_back(j);
  return torus;
}

}  // namespace foramen::testing
