#pragma once
/// \file
/// Simplification to a mesh of the same topology whose vertices are a subset of the input vertices. The
/// collapses are recorded so that they can be undone.

#include <array>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

/// One halfedge collapse that merged the vertex `removed` into `kept`. Face ids are those of the input mesh.
struct Collapse {
  VertexId removed, kept;               ///< input vertex ids
  std::array<FaceId, 2> dropped_faces;  ///< the two faces at the edge removed-kept (input face ids)
  std::array<std::array<VertexId, 3>, 2> dropped_corners;  ///< their corners before the collapse
  std::vector<FaceId>
      moved_faces;  ///< the other faces of `removed`, in which `kept` replaces it, counter-clockwise
};

struct WorkingMesh {
  Mesh mesh;
  VertexMap<VertexId> vertex_origin;  ///< working vertex -> input vertex
  FaceMap<FaceId> face_origin;        ///< working face -> input face (corner order kept)
  std::vector<Collapse> collapses;    ///< in order; undoing them in reverse order restores the input
};

struct SimplifyOptions {
  int target_vertices = 10000;  ///< Stops at this many vertices, or when no further collapse is allowed.
};

/// Halfedge collapses by quadric error \cite garland1997. Each vertex v represents the input vertices that
/// were merged into it, with the quadric \f$ Q_v = \sum A (d_{plane}^2 + 0.03\, d_{point}^2) \f$, where the
/// sum is over the input triangles at these vertices and A is a third of the area of a triangle. The cost of
/// the collapse of v into u is \f$ Q_v(u) - Q_v(v) + (1/s - 1)\, Q_v(u) \f$, where s is the shape \f$
/// 4\sqrt3\,area / \sum side^2 \f$ of the worst new triangle.
///
/// A collapse is refused if it violates the link condition (so the topology does not change and no two edges
/// join the same vertices), turns a triangle by more than 60 degrees, has s below 0.4 unless v already has a
/// worse triangle, makes a valence larger than 9 or makes the valence of a neighbour smaller than 4.
///
/// The result is deterministic, with ties broken by vertex index; the run time is O(n log n). A mesh that is
/// small enough is returned unchanged. Throws TopologyError if the mesh is not closed, InvalidInput for a
/// target below 4, and Cancelled.
WorkingMesh simplify(const Mesh& mesh, const RunContext& ctx, const SimplifyOptions& options = {});

}  // namespace foramen
