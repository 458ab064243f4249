#pragma once
/// \file
/// A torus map laid out in the plane, cut along edges of the surface.

#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// Whole turns that are added to map.turns at each corner of each face, so that the two faces at an edge that
/// is not cut share this edge in the plane.
struct UnfoldedMap {
  HalfedgeMap<Vec2i> shift;  ///< entry 3f+k belongs to corner k of face f
  /// The place [turns] of the corner from(h) of face(h).
  Vec2 corner(const Mesh& mesh, const TorusMap& map, HalfedgeId h) const {
    return map.turns[mesh.from(h)] + shift[h].cast<double>();
  }
};

/// Places one face after the other beside its neighbour. If the cut leaves a disk, as two generating loops
/// do, the result is a fundamental domain of the torus whose border passes along the cut twice. It does not
/// depend on the order of the faces, except for a common shift. If the cut leaves no disk, some pairs of
/// neighbouring faces do not touch, but each face is still placed once. The first face of each connected part
/// has its first corner at map.turns. \pre closed mesh.
UnfoldedMap unfold(const Mesh& mesh, const TorusMap& map, const EdgeMap<bool>& cut);

}  // namespace foramen
