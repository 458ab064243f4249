#pragma once
/// \file
/// Identification of the loops of a shape with those of the reference by homology, and independent checks of
/// the result.

#include <array>

#include "correspond/propagate_loops.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "topology/periods.hpp"

namespace foramen {

/// The loops of the reference transferred to a shape, and their periods.
struct HomologyTransfer {
  Eigen::Matrix2i a;  ///< column k: periods of the transferred reference loop k under the shape's cocycle
  std::array<EdgeLoop, 2> transferred;  ///< closed loops on the shape
};

/// Transfers each reference loop to the nearest vertices of the shape with compatible normals, connects them
/// by shortest paths and integrates the cocycle of the shape along the closed loop. The jumps t' = A^-1 t
/// then have the periods of the reference. Throws TopologyError if |det A| is not 1. This does not prove that
/// the identification is correct (a Dehn twist is not detected), see seifert_test() and map_agreement().
HomologyTransfer transfer_homology(const Mesh& aligned_shape, const Cocycle& form,
                                   const ReferenceLoops& reference);

/// The inverse of an integer matrix. \pre |det A| = 1
Eigen::Matrix2i inverse_unimodular(const Eigen::Matrix2i& a);

/// Checks the homology of a finished map independently of how the map was made. Loops of the shape are
/// computed again and identified by the jumps of the map; they must pass seifert_test() with the Seifert
/// matrix of the reference. The loops of shape and reference need not be close to each other. Throws
/// TopologyError if the test fails.
/// \param mesh  the shape, without self-intersections
/// \param map  its map
/// \param base  torus position of the basepoint of the loops, in turns (that of the reference)
void require_reference_homology(const Mesh& mesh, const TorusMap& map, const Vec2& base,
                                const Eigen::Matrix2i& reference_seifert);

/// For each of the two torus coordinates, the mean cosine over the surface between the gradient of the
/// shape's map and that of the reference's map at the nearest vertex with compatible normal. Both must be
/// positive. The Seifert test does not determine the common sign of the two loops; this check does,
/// independently of the transferred loops.
Vec2 map_agreement(const Mesh& aligned_shape, const TorusMap& map, const Mesh& reference,
                   const TorusMap& reference_map);

}  // namespace foramen
