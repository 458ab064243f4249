#pragma once
/// \file
/// The handles of a closed surface, including the vertebral canal.

#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/topology/handle_loops.hpp"

namespace foramen {

/// A handle, described by two loops: the shortest loop that does not separate the surface, and the shortest
/// loop that crosses it.
struct Handle {
  /// Kind of the first loop; handle: a bridge to cut, tunnel: a tunnel to fill.
  LoopKind kind = LoopKind::neither;
  double length_mm = 0;  ///< length of the first loop
  double across_mm = 0;  ///< length of the second loop, which runs along the bridge or through the tunnel
  Vec3 position = Vec3::Zero();  ///< centre of the first loop, mm
};

/// All handles of a surface.
struct SurfaceHandles {
  /// The genus - 1 other handles; each is the shortest one of the surface without the handles before it.
  std::vector<Handle> extra;
  /// The tunnel that is left; length_mm is its circumference, across_mm the length of the loop around the
  /// arch.
  Handle canal;
};

/// Throws TopologyError if the surface is not closed or not connected, or if its genus is 0. \pre wound
/// outward
SurfaceHandles find_handles(const Mesh& mesh, const RunContext& ctx);

/// The one tunnel of a surface of genus 1. Throws TopologyError for any other genus.
Handle find_canal(const Mesh& mesh);

}  // namespace foramen
