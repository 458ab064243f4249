#include "correspond/own_loops.hpp"

#include <utility>

#include "correspond/propagate_loops.hpp"
#include "correspond/transfer_homology.hpp"
#include "topology/periods.hpp"

namespace foramen {

OwnLoops with_own_loops(const TemplateSurface& surface, const RunContext& ctx) {
  OwnLoops own{{find_reference_loops(surface.mesh, ctx), {}}, Eigen::Matrix2i::Zero()};
  const Cocycle form{surface.map.jumps};
  for (int k = 0; k < 2; ++k) own.periods.col(k) = integrate(form, own.reference.loops.loops.loops[k]);
  own.reference.shape_map.map = change_basis(surface.map, inverse_unimodular(own.periods));
  return own;
}

TorusMap in_basis_of(TorusMap map, const OwnLoops& own, const TorusMap& given) {
  TorusMap changed = change_basis(std::move(map), own.periods);
  changed.lattice = given.lattice;  // the same but for rounding
  return changed;
}

}  // namespace foramen
