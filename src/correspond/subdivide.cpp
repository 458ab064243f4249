#include "correspond/subdivide.hpp"

#include <array>

namespace foramen {
namespace {

VertexId midpoint(const Mesh& mesh, HalfedgeId h) {
  return VertexId(mesh.vertex_count() + mesh.edge(h).index);
}

// A vertex of a face as the map places it next to the face's first corner: its own position, displaced by a
// lattice translation in turns.
struct Placed {
  VertexId vertex;
  Vec2 turns;
};

// The corners of a face, and the midpoints of its edges 01, 12 and 20.
std::array<Placed, 6> placed(const Mesh& mesh, const TorusMap& map, FaceId f) {
  const auto corners = mesh.corners(f);
  const HalfedgeId h0 = Mesh::halfedge(f, 0), h1 = Mesh::halfedge(f, 1), h2 = Mesh::halfedge(f, 2);
  const Vec2 p0 = map.turns[corners[0]], p1 = map.turns[corners[1]] + map.jumps[h0].cast<double>(),
             p2 = map.turns[corners[2]] - map.jumps[h2].cast<double>();
  return {{{corners[0], p0},
           {corners[1], p1},
           {corners[2], p2},
           {midpoint(mesh, h0), (p0 + p1) / 2},
           {midpoint(mesh, h1), (p1 + p2) / 2},
           {midpoint(mesh, h2), (p2 + p0) / 2}}};
}

constexpr std::array<std::array<std::size_t, 3>, 4> quarters{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};

}  // namespace

TemplateSurface subdivided(const TemplateSurface& surface) {
  const Mesh& mesh = surface.mesh;
  TorusMap map{surface.map.lattice, VertexMap<Vec2>(mesh.vertex_count() + mesh.edge_count(), Vec2::Zero()),
               HalfedgeMap<Vec2i>(4 * mesh.halfedge_count(), Vec2i::Zero())};
  TriangleSoup soup{with_edge_midpoints(mesh, mesh.positions()), {}};
  for (VertexId v : mesh.vertices()) map.turns[v] = surface.map.turns[v];
  for (FaceId f : mesh.faces())
    for (const Placed& p : placed(mesh, surface.map, f))
      if (p.vertex.index >= mesh.vertex_count()) map.turns[p.vertex] = p.turns;
  for (FaceId f : mesh.faces()) {
    const auto six = placed(mesh, surface.map, f);
    const auto translation = [&](const Placed& p) -> Vec2i {
      return (p.turns - map.turns[p.vertex]).array().round().matrix().cast<int>();
    };
    for (const auto& corners : quarters) {
      const FaceId quarter(static_cast<int>(soup.triangles.size()));
      std::array<int, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Placed &from = six[corners[k]], &to = six[corners[(k + 1) % 3]];
        triangle[k] = from.vertex.index;
        map.jumps[Mesh::halfedge(quarter, static_cast<int>(k))] = translation(to) - translation(from);
      }
      soup.triangles.push_back(triangle);
    }
  }
  Mesh fine = build_mesh(soup);
  map = quantised(fine, std::move(map));
  const std::vector<Vec2>& curvatures = surface.curvatures.values();
  return {std::move(fine), std::move(map),
          curvatures.empty() ? VertexMap<Vec2>() : VertexMap<Vec2>(with_edge_midpoints(mesh, curvatures))};
}

}  // namespace foramen
