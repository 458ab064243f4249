#pragma once
/// \file
/// The torus map of the reference, and maps of single shapes in correspondence with it.

#include "correspond/first_map.hpp"
#include "correspond/shape_map.hpp"
#include "correspond/soft_neighbours.hpp"
#include "foramen/core/options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/match/align.hpp"

namespace foramen {

/// Finds the shortest loops of the reference over all basepoints, computes its first map, and minimises the
/// distortion with free lattice. All shapes use the resulting lattice. With Optimiser::polak_ribiere the
/// lattice stays the unit square.
Reference map_reference(const Mesh& mesh, const RunContext& ctx, const RegisterOptions& options = {});

/// A shape in correspondence with the reference.
struct RegisteredShape {
  Alignment alignment;  ///< shape -> reference
  ShapeMap shape_map;
  Eigen::Matrix2i homology = Eigen::Matrix2i::Zero();  ///< A, see transfer_homology()
  Eigen::Matrix2i seifert = Eigen::Matrix2i::Zero();   ///< of the shape's own loops
  Vec2 agreement = Vec2::Zero();                       ///< see map_agreement()
};

/// Aligns the shape with the reference, transfers the reference's loops to it, maps it to the reference's
/// torus and minimises E_cor + lambda E_deg. Throws TopologyError or ConvergenceError with the reason if a
/// check fails: the Seifert test of the first map, the certificate of the finished map, its homology or its
/// direction.
RegisteredShape register_shape(const Mesh& shape, const Reference& reference, const RunContext& ctx,
                               const RegisterOptions& options = {});

}  // namespace foramen
