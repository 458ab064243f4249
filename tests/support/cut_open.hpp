#pragma once
/// \file
/// The paper's cut of a surface along its loops, with which tests check rectangle maps and pairs of loops.

#include <string>
#include <vector>

#include "foramen/core/error.hpp"
#include "foramen/topology/shortest_loops.hpp"

namespace foramen::testing {

/// The disk that is left when the edges of the loops are cut. Edges walked by several loops are cut once;
/// loops that share a stretch (theta graphs) or retrace a spur are handled.
struct CutMesh {
  Mesh disk;                   ///< same faces in the same order, vertices doubled along the cut
  VertexMap<VertexId> origin;  ///< per disk vertex: the vertex of the closed mesh
  std::vector<HalfedgeId>
      boundary;  ///< disk halfedges along the boundary, in order, starting at a copy of the basepoint
};

namespace detail {

inline EdgeMap<bool> walked_edges(const Mesh& mesh, const LoopSystem& loops) {
  EdgeMap<bool> cut(mesh.edge_count(), false);
  for (const EdgeLoop& loop : loops.loops)
    for (HalfedgeId h : loop) cut[mesh.edge(h)] = true;
  return cut;
}

inline int piece_count(const Mesh& mesh, const EdgeMap<bool>& cut) {
  FaceMap<bool> reached(mesh.face_count(), false);
  std::vector<FaceId> stack;
  int pieces = 0;
  for (FaceId seed : mesh.faces()) {
    if (reached[seed]) continue;
    ++pieces;
    reached[seed] = true;
    stack.push_back(seed);
    while (!stack.empty()) {
      const FaceId f = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = Mesh::halfedge(f, k);
        if (cut[mesh.edge(h)]) continue;
        const FaceId g = Mesh::face(mesh.twin(h));
        if (reached[g]) continue;
        reached[g] = true;
        stack.push_back(g);
      }
    }
  }
  return pieces;
}

// Every vertex has one copy for each sector between cut edges. The first copy keeps the vertex's index, the
// others come after all vertices.
struct Sectors {
  TriangleSoup soup;
  std::vector<VertexId> origin;
};

inline Sectors split_at(const Mesh& mesh, const EdgeMap<bool>& cut) {
  Sectors out{mesh.soup(), {}};
  for (VertexId v : mesh.vertices()) out.origin.push_back(v);
  for (VertexId v : mesh.vertices()) {
    const auto fan = mesh.fan(v);
    std::size_t start = 0;
    while (start < fan.size() && !cut[mesh.edge(fan[start])]) ++start;
    if (start == fan.size()) continue;  // an interior vertex
    int copy = v.index;
    for (std::size_t k = 0; k < fan.size(); ++k) {  // the sector of fan[k] is the corner at v of its face
      const HalfedgeId h = fan[(start + k) % fan.size()];
      if (k > 0 && cut[mesh.edge(h)]) {
        copy = static_cast<int>(out.soup.points.size());
        out.soup.points.push_back(mesh.position(v));
        out.origin.push_back(v);
      }
      out.soup.triangles[h.index / 3][h.index % 3] = copy;
    }
  }
  return out;
}

// A boundary vertex has one boundary halfedge that leaves it, so the boundary is followed from vertex to
// vertex.
inline std::vector<HalfedgeId> boundary_from(const Mesh& disk, VertexId start) {
  std::vector<HalfedgeId> boundary;
  HalfedgeId h = disk.outgoing(start);
  do {
    FORAMEN_ASSERT(!disk.twin(h).valid());
    boundary.push_back(h);
    h = disk.outgoing(disk.to(h));
  } while (h != boundary.front());
  return boundary;
}

}  // namespace detail

/// \pre the loops generate: the complement is one disk (throws TopologyError otherwise).
inline CutMesh cut_open(const Mesh& mesh, const LoopSystem& loops) {
  if (!mesh.is_closed())
    throw TopologyError("only a closed surface can be cut open, found one with boundary");
  const EdgeMap<bool> cut = detail::walked_edges(mesh, loops);
  const int pieces = detail::piece_count(mesh, cut);
  detail::Sectors sectors = detail::split_at(mesh, cut);
  CutMesh result{build_mesh(std::move(sectors.soup)), VertexMap<VertexId>(std::move(sectors.origin)), {}};
  // A connected surface whose Euler number is 1 is a disk.
  if (pieces != 1 || result.disk.euler_characteristic() != 1)
    throw TopologyError("the loops do not cut the surface open to one disk, but to " +
                        std::to_string(pieces) + (pieces == 1 ? " piece" : " pieces") + " of Euler number " +
                        std::to_string(result.disk.euler_characteristic()) +
                        " in all (needs 1 and 1): use a full system of loops");
  if (!loops.basepoint.valid() || loops.basepoint.index >= mesh.vertex_count() ||
      !result.disk.is_boundary(loops.basepoint))
    throw TopologyError("the basepoint of the loops is not on them");
  result.boundary = detail::boundary_from(result.disk, loops.basepoint);
  return result;
}

}  // namespace foramen::testing
