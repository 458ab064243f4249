#pragma once
/// \file
/// A shape's first map to the torus, in the reference's basis of loops and in its place.

#include "correspond/propagate_loops.hpp"
#include "correspond/transfer_homology.hpp"
#include "foramen/core/options.hpp"
#include "foramen/correspond/register_options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

struct FirstMap {
  TorusMap map;              ///< unit lattice, without flipped triangles
  Eigen::Matrix2i homology;  ///< A, see transfer_homology()
  Eigen::Matrix2i seifert;   ///< of the shape's own loops
};

/// Loops carried over, named by homology, checked by the Seifert test (TopologyError), and the map they give.
/// \param carried  the shape where it is compared with the reference: aligned, or bent onto it as well
/// \param embedded  the same mesh as it lies in space without intersecting itself, for linking numbers
FirstMap first_map(const Mesh& carried, const Mesh& embedded, const ReferenceLoops& reference,
                   InitialMap initial_map, EdgeCost edge_cost);

/// The whole map moved so that, on average, nearest neighbours have the same torus coordinates: by the
/// area-weighted circular mean of their differences.
TorusMap translated_onto(TorusMap map, const Mesh& carried, const Mesh& reference,
                         const TorusMap& reference_map);

}  // namespace foramen
