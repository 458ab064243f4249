#pragma once
/// \file
/// Repair of a raw surface. The result is one closed manifold surface of genus 1, wound outward.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/repair/handles.hpp"

namespace foramen {

struct RepairOptions {
  /// A hole is filled if its border is at most this long [mm]. A surface with a longer border is refused,
  /// because bone may be missing there.
  double hole_perimeter_mm = 20;
  /// A separate piece is dropped if its area is at most this share of the area of the largest piece. A
  /// surface with a larger second piece is refused, because either piece may be the vertebra.
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

/// Kinds of repairs, in the order in which they are made.
enum class RepairKind {
  unused_vertices,        ///< vertices of no triangle, dropped
  duplicate_vertices,     ///< merged with an earlier vertex of the same coordinates
  zero_area_triangles,    ///< triangles of zero area: dropped, collapsed or flipped
  duplicate_triangles,    ///< triangles with the same corners as an earlier one, dropped
  flaps,                  ///< pieces attached to the surface at an edge with three or more triangles, dropped
  non_manifold_edges,     ///< edges with three or more triangles, separated
  non_manifold_vertices,  ///< vertices at which parts of the surface touch, doubled
  stray_components,       ///< separate pieces outside the surface, dropped
  inner_shells,           ///< separate pieces inside the surface, dropped
  reversed_triangles,     ///< triangles with reversed winding
  holes,                  ///< filled
  self_intersections,     ///< pairs of intersecting triangles, separated
  bridges,                ///< bridges cut (see remove_handles())
  tunnels                 ///< tunnels filled (see remove_handles())
};
/// A description such as "holes filled".
std::string_view description(RepairKind kind);

/// All repairs of one kind.
struct RepairChange {
  RepairKind kind = RepairKind::unused_vertices;
  std::vector<Vec3> positions;  ///< one position per change, mm: a vertex or the centre of the changed part
  int count() const { return static_cast<int>(positions.size()); }
};

/// Everything that repair_mesh() changed.
struct RepairReport {
  /// One entry per kind of repair made; empty for a surface without defects.
  std::vector<RepairChange> changes;
  /// The bridges and tunnels among the changes, in the order of removal.
  std::vector<Handle> removed_handles;
  Handle canal;  ///< the tunnel that is left
  /// Positions of pairs of triangles that could not be separated, mm.
  std::vector<Vec3> remaining_self_intersections;
  double largest_move_mm = 0;  ///< largest displacement of a kept vertex
};

/// One line: "holes filled: 1 at (1.0, 2.0, 3.0); cut a bridge, 2.3 mm round ...".
std::string summary(const RepairReport& report);

/// The result of repair_mesh().
struct RepairedMesh {
  Mesh mesh;
  RepairReport report;
  VertexMap<VertexId> origin;  ///< per vertex: its index in the raw surface; invalid for a new vertex
  /// Per raw vertex: the vertex that it became (the first one if it was doubled); invalid if it was dropped.
  VertexMap<VertexId> repaired;
  /// The vertex that a raw vertex became; nullopt if it was dropped.
  std::optional<VertexId> from_raw(VertexId raw) const;
};

/// Repairs the defects in the order of RepairKind. A kept vertex that no repair concerns keeps its exact
/// position, and a surface without defects is returned unchanged. Vertices keep their order; new ones come
/// last.
///
/// Throws InvalidInput with the defect, its position and what to do: a coordinate that is not finite, an
/// index out of range, a hole beyond the limit, or a second piece beyond the limit. Throws TopologyError for
/// a surface that cannot be oriented and for one whose genus remove_handles() cannot reduce to 1.
RepairedMesh repair_mesh(const TriangleSoup& raw, const RepairOptions& options = {},
                         const RunContext& ctx = RunContext());

}  // namespace foramen
