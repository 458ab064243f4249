#include "modelfiles/repair_record.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace foramen {
namespace {

using nlohmann::ordered_json;

// The positions of further changes are not written; their number is.
constexpr std::size_t most_positions = 100;

ordered_json position_json(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

ordered_json positions_json(const std::vector<Vec3>& positions) {
  ordered_json out = ordered_json::array();
  for (std::size_t k = 0; k < std::min(positions.size(), most_positions); ++k)
    out.push_back(position_json(positions[k]));
  return out;
}

}  // namespace

ordered_json handle_json(const Handle& handle) {
  const char* kind = handle.kind == LoopKind::handle   ? "bridge"
                     : handle.kind == LoopKind::tunnel ? "tunnel"
                                                       : "undecided";
  return {{"kind", kind},
          {"length_mm", handle.length_mm},
          {"across_mm", handle.across_mm},
          {"position", position_json(handle.position)}};
}

ordered_json repair_json(const RepairReport& report) {
  ordered_json changes = ordered_json::array(), handles = ordered_json::array();
  for (const RepairChange& change : report.changes)
    changes.push_back({{"change", description(change.kind)},
                       {"count", change.count()},
                       {"positions", positions_json(change.positions)}});
  for (const Handle& h : report.removed_handles) handles.push_back(handle_json(h));
  return {{"changes", changes},
          {"removed_handles", handles},
          {"canal", handle_json(report.canal)},
          {"largest_move_mm", report.largest_move_mm},
          {"remaining_self_intersections",
           {{"count", report.remaining_self_intersections.size()},
            {"positions", positions_json(report.remaining_self_intersections)}}}};
}

}  // namespace foramen
