#pragma once
/// \file
/// A smaller mesh of the same topology whose vertices are a subset of the input's, with the way back.

#include <array>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

/// One halfedge collapse: `removed` went into `kept`. Face ids are those of the input mesh throughout.
struct Collapse {
  VertexId removed, kept;               ///< input vertex ids
  std::array<FaceId, 2> dropped_faces;  ///< the two faces at the edge removed-kept (input face ids)
  std::array<std::array<VertexId, 3>, 2> dropped_corners;  ///< their corners at that moment
  std::vector<FaceId>
      moved_faces;  ///< the other faces of `removed`, whose corner becomes `kept`, ccw about it
};

struct WorkingMesh {
  Mesh mesh;
  VertexMap<VertexId> vertex_origin;  ///< working vertex -> input vertex
  FaceMap<FaceId> face_origin;        ///< working face -> input face (corner order kept)
  std::vector<Collapse>
      collapses;  ///< in the order they were done; undone backwards they give the input again
};

struct SimplifyOptions {
  int target_vertices = 10000;  ///< Stops at this many vertices, or when no collapse is allowed any more.
};

/// Halfedge collapses by quadric error \cite garland1997. A vertex v that stands for a part of the surface
/// costs, when it goes into u, the growth of \f$ Q_v = \sum A (d_{plane}^2 + 0.03\, d_{point}^2) \f$ from v
/// to u (A: a third of the area of each input triangle at each vertex it stands for), plus \f$ (1/s - 1)\,
/// Q_v(u) \f$ with s the shape \f$ 4\sqrt3\,area / \sum side^2 \f$ of the worst new triangle. Refused: a
/// broken link condition (so the topology never changes and no two edges join the same two vertices), a
/// triangle that turns by more than 60 degrees, s below 0.4 unless v has a worse triangle already, a valence
/// above 9 or a neighbour's below 4. Deterministic: ties by vertex index; O(n log n). A mesh that is small
/// enough already is returned unchanged with no collapses. Throws TopologyError if the mesh is not closed,
/// InvalidInput for a target below 4, Cancelled. \pre closed mesh.
WorkingMesh simplify(const Mesh& mesh, const RunContext& ctx, const SimplifyOptions& options = {});

}  // namespace foramen
