#pragma once
/// \file
/// Repair of a raw surface: what comes out is one closed, manifold, outward, genus-1 surface.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/repair/remove_handles.hpp"

namespace foramen {

struct RepairOptions {
  /// A hole is filled if its border is no longer than this [mm]. Above: bone may be missing.
  double hole_perimeter_mm = 20;
  /// A separate piece is dropped if its area is at most this share of the largest's. Above: which is meant?
  double stray_share = 0.1;
  RemoveHandlesOptions handles = {};
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<RepairOptions> auto& o) {
  visit(o.hole_perimeter_mm, {.name = "hole_limit",
                              .unit = "mm",
                              .range = above(0),
                              .meaning = "a hole is filled if its border is at most this long"});
  visit(o.stray_share,
        {.name = "stray_share",
         .range = at_least(0).up_to(1),
         .meaning = "a separate piece is dropped if its area is at most this share of the largest's"});
  visit(o.handles, {.nesting = Nesting::inlined});
}

/// In the order in which they are mended.
enum class RepairKind {
  unused_vertices,        ///< dropped: they belong to no triangle
  duplicate_vertices,     ///< joined with an earlier one of the same coordinates
  zero_area_triangles,    ///< dropped, collapsed or flipped
  duplicate_triangles,    ///< dropped: the same corners as an earlier one
  flaps,                  ///< dropped: pieces that hang on an edge with three or more triangles
  non_manifold_edges,     ///< opened: three or more triangles
  non_manifold_vertices,  ///< doubled: parts that touch in one point
  stray_components,       ///< dropped, outside the surface
  inner_shells,           ///< dropped, inside the surface
  reversed_triangles,     ///< wound the other way
  holes,                  ///< filled
  self_intersections,     ///< pairs of triangles, parted
  bridges,                ///< handles cut
  tunnels                 ///< handles filled
};
/// "holes filled" and the like.
std::string_view description(RepairKind kind);

struct RepairChange {
  RepairKind kind = RepairKind::unused_vertices;
  std::vector<Vec3> positions;  ///< of each, mm: a vertex, or the middle of what was changed
  int count() const { return static_cast<int>(positions.size()); }
};

struct RepairReport {
  std::vector<RepairChange> changes;    ///< what was done, one entry a kind; empty: the surface was clean
  std::vector<Handle> removed_handles;  ///< the bridges and tunnels among them, in the order of removal
  Handle canal;                         ///< what is left
  std::vector<Vec3> remaining_self_intersections;  ///< pairs of triangles that could not be parted, mm
  double largest_move_mm = 0;                      ///< of a vertex that was kept
};

/// One line: "holes filled: 1 at (1.0, 2.0, 3.0); cut a bridge, 2.3 mm round ...".
std::string summary(const RepairReport& report);

struct RepairedMesh {
  Mesh mesh;
  RepairReport report;
  VertexMap<VertexId> origin;    ///< per vertex: the vertex in raw; invalid where a patch is new
  VertexMap<VertexId> repaired;  ///< per raw vertex: the vertex it became (the first, if it was doubled)
  /// Where a raw vertex is now; nullopt if it is gone.
  std::optional<VertexId> from_raw(VertexId raw) const;
};

/// One pass over the defects in the order of RepairKind. Points that are kept and not reported stay where
/// they are, to the bit; a surface without defect comes back as it was. Vertices keep their order, new ones
/// come last.
///
/// Throws InvalidInput naming the defect, where it is and what to do: a coordinate that is not finite, an
/// index out of range, holes beyond the limit, pieces of like size, a surface that cannot be oriented
/// (TopologyError), genus other than 1 by more than noise (see remove_handles).
RepairedMesh repair_mesh(const TriangleSoup& raw, const RepairOptions& options = {},
                         const RunContext& ctx = RunContext());

}  // namespace foramen
