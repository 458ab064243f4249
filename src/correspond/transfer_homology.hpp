#pragma once
/// \file
/// Which loop of a shape is which loop of the reference: homology carried over, and its independent checks.

#include <array>

#include "correspond/propagate_loops.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "topology/periods.hpp"

namespace foramen {

struct HomologyTransfer {
  Eigen::Matrix2i a;  ///< column k: periods of the transferred reference loop k under the shape's cocycle
  std::array<EdgeLoop, 2> transferred;  ///< closed loops on the shape
};

/// Moves each reference loop to the nearest normal-compatible vertices of the shape, closes it by shortest
/// paths and integrates the shape's cocycle along it. t' = A^-1 t then has the reference's periods. Throws
/// TopologyError if |det A| is not 1. It proves nothing by itself (a Dehn twist passes): see seifert_test()
/// and map_agreement().
HomologyTransfer transfer_homology(const Mesh& aligned_shape, const Cocycle& form,
                                   const ReferenceLoops& reference);

/// A^-1 of an integer matrix. \pre |det A| = 1
Eigen::Matrix2i inverse_unimodular(const Eigen::Matrix2i& a);

/// The check of a finished map, which relies on nothing of its making: loops of the shape found anew, named
/// by the map's own jumps, must pass seifert_test() with the reference's Seifert matrix; that the shape's and
/// the reference's loops lie near each other is not asked. Throws TopologyError. \param base  on the torus,
/// in turns: where the loops shall pass (the reference's basepoint) \param mesh  as it lies in space without
/// intersecting itself  \param map  of it
void require_reference_homology(const Mesh& mesh, const TorusMap& map, const Vec2& base,
                                const Eigen::Matrix2i& reference_seifert);

/// Mean cosine, over the surface, between the gradients of the shape's map and of the reference's at the
/// nearest normal-compatible vertex, for each of the two coordinates. Both must be positive: the Seifert test
/// leaves the common sign of the two loops open, and this settles it without the transferred loops.
Vec2 map_agreement(const Mesh& aligned_shape, const TorusMap& map, const Mesh& reference,
                   const TorusMap& reference_map);

}  // namespace foramen
