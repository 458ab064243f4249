#include "foramen/evaluate/compactness.hpp"

#include <algorithm>

#include "foramen/evaluate/cohort.hpp"

namespace foramen {

std::vector<CompactnessAtModes> compactness(const ShapeModel& model, int last_mode) {
  const double total = model.variance().sum(), weight = model.total_weight();
  std::vector<CompactnessAtModes> result;
  for (const int modes : mode_counts(last_mode)) {
    const double held = model.variance().head(std::min(modes, model.modes())).sum();
    result.push_back({modes, held / weight, total > 0 ? held / total : 1.0});
  }
  return result;
}

}  // namespace foramen
