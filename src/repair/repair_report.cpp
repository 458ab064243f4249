#include <algorithm>
#include <array>

#include "foramen/repair/repair_mesh.hpp"
#include "repair/words.hpp"

namespace foramen {
namespace {

using repair_detail::shown;

// At most this many positions are listed; the rest is counted.
constexpr std::size_t most_named = 3;

std::string counted(const std::vector<Vec3>& positions) {
  std::string text = std::to_string(positions.size());
  for (std::size_t k = 0; k < std::min(positions.size(), most_named); ++k)
    text += (k == 0 ? " at " : ", ") + shown(positions[k]);
  return text + (positions.size() > most_named ? " ..." : "");
}

}  // namespace

std::string_view description(RepairKind kind) {
  constexpr std::array texts{"unused vertices dropped",
                             "duplicate vertices joined",
                             "triangles without area removed",
                             "duplicate triangles dropped",
                             "flaps and inner walls dropped",
                             "non-manifold edges opened",
                             "non-manifold vertices doubled",
                             "stray components dropped",
                             "inner shells dropped",
                             "triangles wound the other way",
                             "holes filled",
                             "self-intersections parted",
                             "bridges cut",
                             "tunnels filled"};
  return texts.at(static_cast<std::size_t>(kind));
}

std::string summary(const RepairReport& report) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  for (const RepairChange& change : report.changes)
    if (change.kind != RepairKind::bridges && change.kind != RepairKind::tunnels)
      add(std::string(description(change.kind)) + ": " + counted(change.positions));
  for (const Handle& h : report.removed_handles)
    add((h.kind == LoopKind::handle ? "cut a " : "filled a ") + description(h));
  if (!report.remaining_self_intersections.empty())
    add("pairs of triangles that meet still: " + counted(report.remaining_self_intersections));
  return text.empty() ? "nothing to mend" : text;
}

}  // namespace foramen
