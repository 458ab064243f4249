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
  std::vector<FaceId> moved_faces;      ///< the other faces of `removed`, whose corner becomes `kept`, ccw about it
};

struct WorkingMesh {
  Mesh mesh;
  VertexMap<VertexId> vertex_origin;  ///< working vertex -> input vertex
  FaceMap<FaceId> face_origin;        ///< working face -> input face (corner order kept)
  std::vector<Collapse> collapses;    ///< in the order they were done; undone backwards they give the input again
};

struct SimplifyOptions {
  int target_vertices = 10000;  ///< Stops at this many vertices, or when no collapse is allowed any more.
};

/// Halfedge collapses by quadric error (Garland and Heckbert 1997), each checked by the link condition (so the topology
/// never changes), against turned normals and against slivers. Deterministic: ties by vertex index. A mesh that is small enough already is
/// returned unchanged with no collapses. \pre closed mesh.
WorkingMesh simplify(const Mesh& mesh, const RunContext& ctx, const SimplifyOptions& options = {});

}  // namespace foramen
