#include "workflow/completion.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "apply/part_surface.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "inputs/surface_size.hpp"

namespace foramen {
namespace {

using nlohmann::ordered_json;

// Another pose fits nearly as well if its distance is at most this factor times the smallest distance.
constexpr double ambiguous_factor = 1.1;

double mean_where(const std::vector<double>& values, const std::vector<bool>& seen, bool wanted) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (seen[i] == wanted) {
      sum += values[i];
      ++count;
    }
  return count > 0 ? sum / count : 0;
}

}  // namespace

PartOfVertebra usable_part(TriangleSoup soup, const InputUnit& unit, const ShapeModel& model) {
  for (Vec3& p : soup.points) p *= millimetres_per(unit.length);
  PartOfVertebra part{part_surface(soup)};
  const double whole = bounding_box(unflattened(model.mean())).diagonal();
  const double diagonal = bounding_box(part.mesh.positions()).diagonal();
  part.size_note = check_size_of_part(diagonal / millimetres_per(unit.length), unit, whole);
  return part;
}

ordered_json completion_json(const CompletedSurface& completed) {
  const std::vector<double> deviations = standard_deviations(completed.shape);
  const auto seen = std::count(completed.seen.begin(), completed.seen.end(), true);
  return {
      {"distance_mm", completed.distance_mm},
      {"matched_share", completed.matched_share},
      {"seen_share", static_cast<double>(seen) / static_cast<double>(completed.seen.size())},
      {"standard_deviation_seen_mm", mean_where(deviations, completed.seen, true)},
      {"standard_deviation_unseen_mm", mean_where(deviations, completed.seen, false)},
      {"second_best_pose_mm", std::isfinite(completed.second_best_mm) ? ordered_json(completed.second_best_mm)
                                                                      : ordered_json(nullptr)}};
}

std::optional<std::string> completion_note(const CompletedSurface& completed) {
  if (completed.second_best_mm >= ambiguous_factor * completed.distance_mm) return std::nullopt;
  return "another pose fits nearly as well (" + std::to_string(completed.second_best_mm) + " mm against " +
         std::to_string(completed.distance_mm) + " mm)";
}

}  // namespace foramen
