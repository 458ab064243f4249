#pragma once
/// \file
/// Initial maps to the torus, both provably without flipped triangles.

#include "foramen/parameterize/torus_map.hpp"
#include "topology/periods.hpp"

namespace foramen {

/// The map in which every vertex is the average of its neighbours (uniform weights), with the periods of the
/// cocycle and the unit lattice. It is an embedding because all weights are positive (Gortler, Gotsman,
/// Thurston 2006). Throws TopologyError if the cocycle is oriented negatively, so that signed areas are
/// negative.
/// \param form  the jumps: any closed form with the wanted periods, not necessarily from cocycle()
TorusMap harmonic_torus_map(const Mesh& mesh, const Cocycle& form);

/// The initial map of the paper: each loop is mapped by arc length to a side of the unit rectangle, its copy
/// to the opposite side, and the interior is a Tutte embedding with uniform weights \cite tutte1963. Here it
/// is computed on the torus without copies: the vertices of the loops are fixed and the jumps come from the
/// cocycle. The jumps have the periods (1,0) and (0,1) over the two loops, which must be positively oriented
/// (TopologyError otherwise).
///
/// Some loops do not cut the surface into a rectangle. Spurs of the loops near the basepoint are ignored.
/// Loops that share a path give a hexagon with opposite sides identified. If an edge of the mesh joins two
/// vertices of a side, the side follows this edge instead, because the triangles between would have zero area
/// on a straight side.
TorusMap rectangle_torus_map(const Mesh& mesh, const LoopSystem& loops);

}  // namespace foramen
