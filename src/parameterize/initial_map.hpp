#pragma once
/// \file
/// First maps to the torus, both provably without flipped triangles.

#include "foramen/parameterize/torus_map.hpp"
#include "topology/periods.hpp"

namespace foramen {

/// Every vertex at the average of its neighbours (uniform weights), with the periods of the cocycle: an
/// embedding for positive weights (Gortler, Gotsman, Thurston 2006). Unit lattice. Its orientation is made
/// positive: if the signed area comes out negative the caller's cocycle is oriented the other way, and
/// TopologyError is thrown. \param form  jumps; need not come from cocycle(): any closed form with the wanted
/// periods will do
TorusMap harmonic_torus_map(const Mesh& mesh, const Cocycle& form);

/// The paper's: each loop is laid on a side of the unit rectangle, by arc length, its copy on the opposite
/// side, and Tutte with uniform weights fills the inside. \cite tutte1963. Its jumps have the periods (1,0)
/// and (0,1) over the two loops; these must be positively oriented (TopologyError). As a constraint on the
/// torus (vertices of the loops fixed, jumps from the cocycle) it needs no copy of anything. Where loops do
/// not make a rectangle: spurs near the basepoint are left off; loops that share a stretch make a hexagon
/// with opposite sides identified; and a side takes the chord where an edge joins two of its vertices, since
/// the triangles between would have no area on a straight side.
TorusMap rectangle_torus_map(const Mesh& mesh, const LoopSystem& loops);

}  // namespace foramen
