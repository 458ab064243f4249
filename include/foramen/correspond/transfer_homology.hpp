#pragma once
/// \file
/// Which loop of a shape is which loop of the reference: homology carried over, and its independent checks.

#include <array>
#include <vector>

#include "foramen/correspond/propagate_loops.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "foramen/topology/periods.hpp"

namespace foramen {

/// A loop by points of a surface, in the order in which they are passed, the first after the last.
struct LoopStation {
  Vec3 position, normal;
};
using LoopStations = std::array<std::vector<LoopStation>, 2>;

/// The vertices of the reference's loops.
LoopStations stations_of(const ReferenceLoops& reference);

struct HomologyTransfer {
  Eigen::Matrix2i a;  ///< column k: periods of the transferred loop k under the shape's cocycle
  std::array<EdgeLoop, 2> transferred;  ///< closed loops on the shape
};

/// Moves each of the reference's loops to the nearest normal-compatible vertices of the shape, closes it by
/// shortest paths and integrates the shape's cocycle along it. t' = A^-1 t then has the reference's periods.
/// Throws TopologyError if |det A| is not 1. It proves nothing by itself (a Dehn twist passes): see
/// seifert_test() and map_agreement().
HomologyTransfer transfer_homology(const Mesh& aligned_shape, const Cocycle& form,
                                   const LoopStations& reference);

/// The check of a finished map, which knows of its making nothing: the reference's loops, moved to the shape
/// anew, wind round the torus as (1,0) and (0,1) under the map's own jumps, and their Seifert matrix is the
/// reference's. Throws TopologyError.
/// \param carried  the shape where it is compared with the reference's loops: aligned, or bent back as well
/// \param embedded  the same mesh as it lies in space without intersecting itself, for linking numbers
void require_reference_homology(const Mesh& carried, const Mesh& embedded, const TorusMap& map,
                                const LoopStations& loops, const Eigen::Matrix2i& reference_seifert);

/// A^-1 of an integer matrix. \pre |det A| = 1
Eigen::Matrix2i inverse_unimodular(const Eigen::Matrix2i& a);

/// Mean cosine, over the surface, between the gradients of the shape's map and of the reference's at the
/// nearest normal-compatible vertex, for each of the two coordinates. Both must be positive: the Seifert test
/// leaves the common sign of the two loops open, and this settles it without the transferred loops.
Vec2 map_agreement(const Mesh& aligned_shape, const TorusMap& map, const Mesh& reference,
                   const TorusMap& reference_map);

}  // namespace foramen
