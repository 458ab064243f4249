#pragma once
/// \file
/// Integer cohomology of a genus-1 surface: the closed 1-form dual to two loops.

#include <span>

#include "foramen/topology/shortest_loops.hpp"

namespace foramen {

/// A closed integer 1-form with values in Z^2: value(twin(h)) = -value(h), and the three values around every
/// face sum to zero. The arithmetic is exact.
struct Cocycle {
  HalfedgeMap<Vec2i> value;
};

/// The cocycle whose integral over loop k of the system is the k-th unit vector. It is 0 on the edges of the
/// tree and (1,0) and (0,1) on the two generators. The other edges form a spanning tree of the dual graph;
/// their values follow from the faces, leaf by leaf. \pre genus 1 (two loops)
Cocycle cocycle(const Mesh& mesh, const LoopSystem& loops);

/// Sum of the values over the halfedges of a walk.
Vec2i integrate(const Cocycle& form, std::span<const HalfedgeId> walk);

/// Whether value(twin) = -value and all faces sum to zero.
bool is_closed_form(const Mesh& mesh, const Cocycle& form);

}  // namespace foramen
