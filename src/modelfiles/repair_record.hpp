#pragma once
/// \file
/// What a repair changed, as files hold it.

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "foramen/core/options.hpp"
#include "foramen/repair/repair_mesh.hpp"

namespace foramen {

/// Places of one kind [mm]. A long list is counted, but only the first hundred are written out.
struct CountedPlaces {
  int count = 0;
  std::vector<Vec3> positions;
};
template <class Fields>
void list_fields(Fields& fields, MaybeConst<CountedPlaces> auto& places) {
  fields("count", places.count);
  fields("positions", places.positions);
}

struct RecordedChange {
  std::string change;  ///< description() of its kind
  CountedPlaces places;
};
template <class Fields>
void list_fields(Fields& fields, MaybeConst<RecordedChange> auto& c) {
  fields("change", c.change);
  list_fields(fields, c.places);
}

/// The words for handles by the loop that is cut or filled.
template <>
struct EnumWords<LoopKind> {
  static constexpr std::pair<std::string_view, LoopKind> all[] = {
      {"bridge", LoopKind::handle}, {"tunnel", LoopKind::tunnel}, {"undecided", LoopKind::neither}};
};
/// Which way a handle is removed, its loops [mm], its position.
template <class Fields>
void list_fields(Fields& fields, MaybeConst<Handle> auto& handle) {
  fields("kind", handle.kind);
  fields("length_mm", handle.length_mm);
  fields("across_mm", handle.across_mm);
  fields("position", handle.position);
}

struct RepairRecord {
  std::vector<RecordedChange> changes;
  std::vector<Handle> removed_handles;
  Handle canal;  ///< what is left
  double largest_move_mm = 0;
  CountedPlaces remaining_self_intersections;
};
template <class Fields>
void list_fields(Fields& fields, MaybeConst<RepairRecord> auto& r) {
  fields("changes", r.changes);
  fields("removed_handles", r.removed_handles);
  fields("canal", r.canal);
  fields("largest_move_mm", r.largest_move_mm);
  fields("remaining_self_intersections", r.remaining_self_intersections);
}

RepairRecord recorded(const RepairReport& report);
/// The record as JSON.
nlohmann::ordered_json repair_json(const RepairReport& report);
nlohmann::ordered_json handle_json(const Handle& handle);

}  // namespace foramen
