#pragma once
/// \file
/// Cutting a closed surface open along a system of loops.

#include <vector>

#include "foramen/topology/shortest_loops.hpp"

namespace foramen {

/// The disk that is left when the edges of the loops are cut. Edges walked by several loops are cut once;
/// loops that share a stretch (theta graphs) or retrace a spur are handled.
struct CutMesh {
  Mesh disk;                   ///< same faces in the same order, vertices doubled along the cut
  VertexMap<VertexId> origin;  ///< per disk vertex: the vertex of the closed mesh
  std::vector<HalfedgeId>
      boundary;  ///< disk halfedges along the boundary, in order, starting at a copy of the basepoint
};

/// \pre the loops generate: the complement is one disk (throws TopologyError otherwise).
CutMesh cut_open(const Mesh& mesh, const LoopSystem& loops);

}  // namespace foramen
