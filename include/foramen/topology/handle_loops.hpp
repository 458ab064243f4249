#pragma once
/// \file
/// Handle loops and tunnel loops: on which side of a closed surface in space a loop bounds.

#include "foramen/topology/shortest_loops.hpp"

namespace foramen {

/// Every handle of a surface has both: a bridge of the solid has a handle loop round it and a tunnel loop
/// along it, a tunnel through the solid a tunnel loop round its wall and a handle loop through it. \cite
/// dey2008
enum class LoopKind {
  handle,  ///< homologous to zero in the inside: a disk across the solid closes it
  tunnel,  ///< homologous to zero in the outside: a disk across the opening closes it
  neither
};

/// By linking numbers with a system of loops: a loop bounds outside if no loop of the surface links with the
/// loop pushed outward, inside if the loop links with none pushed outward. \pre outward winding; a loop that
/// is not homologous to zero. ConvergenceError if the numbers do not settle (see seifert_matrix).
LoopKind loop_kind(const Mesh& mesh, const EdgeLoop& loop);

/// The shortest closed walk that crosses the loop an odd number of times: how far it is round what the loop
/// encloses. TopologyError if there is none (the loop is homologous to zero).
EdgeLoop shortest_crossing_loop(const Mesh& mesh, const EdgeLoop& loop, const EdgeMap<double>& lengths);

}  // namespace foramen
