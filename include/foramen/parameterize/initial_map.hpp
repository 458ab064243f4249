#pragma once
/// \file
/// First maps to the torus, both provably without flipped triangles.

#include "foramen/parameterize/torus_map.hpp"
#include "foramen/topology/periods.hpp"

namespace foramen {

/// Every vertex at the average of its neighbours (uniform weights), with the periods of the cocycle: an embedding for
/// positive weights (Gortler, Gotsman, Thurston 2006). Unit lattice. Its orientation is made positive: if the signed area comes
/// out negative the caller's cocycle is oriented the other way, and TopologyError is thrown.
/// \param form  jumps; need not come from cocycle(): any closed form with the wanted periods will do
TorusMap harmonic_torus_map(const Mesh& mesh, const Cocycle& form);

/// The paper's: cut open along the loops, each loop to a side of the unit rectangle, its copy to the opposite side, Tutte with uniform
/// weights inside, then glued again. Interior edges with both ends on one side are split for the solve and joined again.
/// \cite tutte1963. Its jumps have the periods (1,0) and (0,1) over the two loops.
TorusMap rectangle_torus_map(const Mesh& mesh, const LoopSystem& loops);

}  // namespace foramen
