#pragma once
/// \file
/// Cutting noise bridges and filling noise tunnels until only the vertebral canal is left.

#include <string>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/repair/find_handles.hpp"

namespace foramen {

struct RemoveHandlesOptions {
  /// An extra handle is noise if both its loops are at most this long [mm] ...
  double noise_mm = 12;
  /// ... or if it is a bridge at most this thick, measured round it [mm]. All else is anatomy.
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

struct HandleRemoval {
  Mesh mesh;  ///< genus 1
  VertexMap<VertexId>
      origin;  ///< per vertex: the vertex before; invalid: new. Kept vertices keep their order.
  std::vector<Handle> removed;  ///< in the order of removal
  Handle canal;                 ///< the tunnel that is left, the largest
};

/// Removes extra handles one by one, the shortest first: a band of triangles along the loop is taken out and
/// each of its borders closed by a smooth disk, as narrow a band as gives disks that meet nothing. Only these
/// triangles change. A surface of genus 1 comes back as it is.
///
/// Throws TopologyError with the genus and the reason: genus 0 (the canal is closed or the arch open), a
/// handle that is not noise (foramina transversaria), a bridge that spans more than the canal is round
/// (either may be the canal), a hole no larger than noise as the only one; InvalidInput for a handle that
/// cannot be closed without running into the surface.
HandleRemoval remove_handles(const Mesh& mesh, const RemoveHandlesOptions& options = {},
                             const RunContext& ctx = RunContext());

/// "bridge, 2.3 mm round and 11.5 mm across, at (-27.3, -80.2, -617.2)".
std::string description(const Handle& handle);

}  // namespace foramen
