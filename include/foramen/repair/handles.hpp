#pragma once
/// \file
/// The handles of a closed surface, including the vertebral canal, and the removal of those that are noise of
/// the segmentation.

#include <string>
#include <vector>

#include "foramen/core/options.hpp"
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

struct RemoveHandlesOptions {
  /// A handle other than the canal is noise if both its loops are at most this long [mm].
  double noise_mm = 12;
  /// A bridge is noise, too, if its circumference is at most this long [mm]. All other handles are anatomy.
  double thin_bridge_mm = 4;
  int most_handles = 16;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<RemoveHandlesOptions> auto& o) {
  visit(o.noise_mm, {.name = "handle_limit",
                     .unit = "mm",
                     .range = above(0),
                     .meaning = "an extra handle is noise if both its loops are at most this long"});
  visit(o.thin_bridge_mm, {.name = "thin_bridge",
                           .unit = "mm",
                           .range = at_least(0),
                           .meaning = "a bridge is noise if it is at most this long round it"});
  visit(o.most_handles, {.name = "most_handles",
                         .range = at_least(1),
                         .meaning = "genus above which a surface is refused without a search for handles"});
}

/// Whether a handle is noise of the segmentation, by the rule of the options.
bool is_noise(const Handle& handle, const RemoveHandlesOptions& options);

/// The result of remove_handles().
struct HandleRemoval {
  Mesh mesh;  ///< genus 1
  /// Per vertex: its index in the input, invalid for a new vertex; kept vertices keep their order.
  VertexMap<VertexId> origin;
  std::vector<Handle> removed;  ///< in the order of removal
  Handle canal;                 ///< the tunnel that is left
};

/// Removes all handles but the canal, one by one and the shortest first. A band of triangles along the loop
/// of a handle is removed, and each border of the band is closed by a smooth disk. The narrowest band whose
/// disks do not intersect the surface is taken. No other triangles change, and a surface of genus 1 is
/// returned unchanged.
///
/// Throws TopologyError with the reason: genus 0 (the canal is closed or the arch is open), a handle that is
/// not noise (such as a foramen transversarium), a noise bridge whose loop across it is at least as long as
/// the circumference of the canal (either of the two holes may be the canal), or a remaining tunnel that is
/// no larger than noise. Throws InvalidInput for a handle that no disk closes without intersecting the
/// surface.
HandleRemoval remove_handles(const Mesh& mesh, const RemoveHandlesOptions& options = {},
                             const RunContext& ctx = RunContext());

/// "bridge, 2.3 mm round and 11.5 mm across, at (-27.3, -80.2, -617.2)".
std::string description(const Handle& handle);

}  // namespace foramen
