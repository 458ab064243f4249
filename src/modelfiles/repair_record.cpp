#include "modelfiles/repair_record.hpp"

#include <algorithm>

#include "modelfiles/json_fields.hpp"

namespace foramen {
namespace {

// More are counted, but not written one by one.
constexpr std::ptrdiff_t most_positions = 100;

CountedPlaces counted_places(const std::vector<Vec3>& positions) {
  const auto end = positions.begin() + std::min(std::ssize(positions), most_positions);
  return {static_cast<int>(positions.size()), {positions.begin(), end}};
}

}  // namespace

RepairRecord recorded(const RepairReport& report) {
  RepairRecord record{.changes = {},
                      .removed_handles = report.removed_handles,
                      .canal = report.canal,
                      .largest_move_mm = report.largest_move_mm,
                      .remaining_self_intersections = counted_places(report.remaining_self_intersections)};
  for (const RepairChange& change : report.changes)
    record.changes.push_back({std::string(description(change.kind)), counted_places(change.positions)});
  return record;
}

nlohmann::ordered_json repair_json(const RepairReport& report) { return json_of(recorded(report)); }
nlohmann::ordered_json handle_json(const Handle& handle) { return json_of(handle); }

}  // namespace foramen
