#pragma once
/// \file
/// A template in the place of the reference, with shortest loops of its own.

#include "foramen/core/run_context.hpp"
#include "foramen/correspond/registration_frame.hpp"

namespace foramen {

struct OwnLoops {
  Reference reference;      ///< the template with its loops, and its map expressed in their basis
  Eigen::Matrix2i periods;  ///< column k: the periods of loop k under the template's map as it was given
};

/// Finds the shortest loops of a template. Throws TopologyError if its mesh is not closed and of genus 1.
OwnLoops with_own_loops(const TemplateSurface& surface, const RunContext& ctx);

/// Expresses a map that was made in the basis of the template's own loops in the basis of the map with which
/// the template was given.
/// \param given  a map in that basis, whose lattice the result takes
TorusMap in_basis_of(TorusMap map, const OwnLoops& own, const TorusMap& given);

}  // namespace foramen
