#pragma once
/// \file
/// Handle loops and tunnel loops of a closed surface in space, that is, loops that bound on the inside or on
/// the outside of the surface.

#include "foramen/topology/shortest_loops.hpp"

namespace foramen {

/// Every handle of a surface has a loop of both kinds. A bridge of the solid has a handle loop around it and
/// a tunnel loop along it; a tunnel through the solid has a tunnel loop around its wall and a handle loop
/// through it. \cite dey2008
enum class LoopKind {
  handle,  ///< homologous to zero in the interior: a disk in the solid spans the loop
  /// Homologous to zero in the exterior: a disk outside the solid, across the opening, spans the loop.
  tunnel,
  neither
};

/// Classifies a loop by its linking numbers with a basis of loops on the surface. A loop is a tunnel loop if,
/// pushed outward off the surface, it has linking number 0 with every loop of the basis. It is a handle loop
/// if it has linking number 0 with every loop of the basis pushed outward. Throws ConvergenceError if the
/// linking numbers for two successive distances of the push never agree (see seifert_matrix()).
/// \pre outward winding; the loop is not homologous to zero on the surface
LoopKind loop_kind(const Mesh& mesh, const EdgeLoop& loop);

/// The shortest closed walk that crosses the loop an odd number of times. For a handle loop around a bridge,
/// for example, it runs along the bridge. Throws TopologyError if there is none because the loop is
/// homologous to zero.
EdgeLoop shortest_crossing_loop(const Mesh& mesh, const EdgeLoop& loop, const EdgeMap<double>& lengths);

}  // namespace foramen
