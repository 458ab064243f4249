#pragma once
/// \file
/// A torus map laid out in the plane, cut along edges of the surface.

#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// Whole turns by which the corners of each face stand beside map.turns, so that faces on both sides of an
/// edge that is not cut touch in it.
struct UnfoldedMap {
  HalfedgeMap<Vec2i> shift;  ///< of corner k of face f at halfedge 3f+k
  /// In turns; corner from(h) of face(h).
  Vec2 corner(const Mesh& mesh, const TorusMap& map, HalfedgeId h) const {
    return map.turns[mesh.from(h)] + shift[h].cast<double>();
  }
};

/// Lays face after face beside its neighbour. Where the cut leaves a disk, as two loops that generate do, the
/// result does not depend on the order of faces but for one shift of all: a fundamental domain of the torus
/// whose border is the cut, walked over twice. Otherwise some faces on both sides of an edge stand apart,
/// and each face still stands once. The first face (and the first of every further part) has its first corner
/// at map.turns. \pre closed mesh.
UnfoldedMap unfold(const Mesh& mesh, const TorusMap& map, const EdgeMap<bool>& cut);

}  // namespace foramen
