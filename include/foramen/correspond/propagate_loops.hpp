#pragma once
/// \file
/// The reference's basepoint and loops carried to an aligned shape (the paper's way), and homology transfer.

#include "foramen/topology/linking.hpp"
#include "foramen/topology/periods.hpp"

namespace foramen {

/// The reference as every other shape sees it.
struct ReferenceLoops {
  Mesh mesh;              ///< in the reference's own coordinates
  LoopSystem loops;
  Eigen::Matrix2i seifert;
};

enum class EdgeCost {
  paper,            ///< eq. 3 as printed: mean distance of the two ends to the reference loops, mm
  length_weighted,  ///< (eq. 3 + small) * edge length: keeps its meaning on uneven meshes
};

/// [becker2011 Eq. 3] for every edge of an aligned shape.
EdgeMap<double> loop_edge_costs(const Mesh& aligned_shape, const ReferenceLoops& reference, EdgeCost cost);

/// Basepoint: the vertex of the shape nearest to the reference's; loops: Erickson-Whittlesey from it with the edge cost.
LoopSystem propagate_loops(const Mesh& aligned_shape, const ReferenceLoops& reference, EdgeCost cost);

struct HomologyTransfer {
  Eigen::Matrix2i a;                    ///< column k: the transferred reference loop k in the basis dual to the shape's cocycle
  std::array<EdgeLoop, 2> transferred;  ///< closed loops on the shape
};
/// Moves each reference loop to nearest normal-compatible vertices of the shape, closes it by Dijkstra paths and integrates
/// the shape's cocycle. Throws TopologyError if |det A| != 1.
HomologyTransfer transfer_homology(const Mesh& aligned_shape, const Cocycle& form, const ReferenceLoops& reference);

}  // namespace foramen
