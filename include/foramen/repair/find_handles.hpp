#pragma once
/// \file
/// The handles of a closed surface, the canal among them.

#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/topology/handle_loops.hpp"

namespace foramen {

/// A handle by its two loops: the shortest one that does not separate the surface, and the shortest that
/// crosses it.
struct Handle {
  LoopKind kind = LoopKind::neither;  ///< of the first: handle = a bridge to cut, tunnel = a tunnel to fill
  double length_mm = 0;               ///< of the first
  double across_mm = 0;               ///< of the second: round what the bridge spans, or through the tunnel
  Vec3 position = Vec3::Zero();       ///< centre of the first, mm
};

struct SurfaceHandles {
  std::vector<Handle>
      extra;     ///< genus - 1, the shortest first: each is the shortest when those before are gone
  Handle canal;  ///< what is left: a tunnel; length_mm round it, across_mm round the arch
};

/// \pre closed, connected, genus at least 1, wound outward. TopologyError otherwise.
SurfaceHandles find_handles(const Mesh& mesh, const RunContext& ctx);

/// The one tunnel of a genus-1 surface.
Handle find_canal(const Mesh& mesh);

}  // namespace foramen
