#pragma once
/// \file
/// The first map of a shape to the torus, in the basis of loops and at the position of the reference's map.

#include "correspond/propagate_loops.hpp"
#include "correspond/transfer_homology.hpp"
#include "foramen/core/options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// A first map with the homology by which its loops were identified.
struct FirstMap {
  TorusMap map;              ///< unit lattice, without flipped triangles
  Eigen::Matrix2i homology;  ///< A, see transfer_homology()
  Eigen::Matrix2i seifert;   ///< Seifert matrix of the shape's own loops
};

/// Transfers the loops of the reference to the shape (propagate_loops()), identifies them by homology
/// (transfer_homology()), and computes the map that they give. Throws TopologyError if the Seifert test fails
/// (seifert_test()).
/// \param carried  the shape in the position in which it is compared with the reference: aligned, or also
/// bent onto the reference
/// \param embedded  the same mesh in a position without self-intersections, for linking numbers
FirstMap first_map(const Mesh& carried, const Mesh& embedded, const ReferenceLoops& reference,
                   InitialMap initial_map, EdgeCost edge_cost);

/// Translates the map on the torus by the area-weighted circular mean of the differences between the torus
/// coordinates of vertices and those of their nearest vertices on the reference, so that these differences
/// are zero on average.
TorusMap translated_onto(TorusMap map, const Mesh& carried, const Mesh& reference,
                         const TorusMap& reference_map);

}  // namespace foramen
