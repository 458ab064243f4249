#include "foramen/evaluate/specificity.hpp"

#include "foramen/core/error.hpp"

namespace foramen {

std::vector<EnsembleAtModes> ensemble_form(const Specificity& specificity) {
  FORAMEN_ASSERT(specificity.nearest_draw.size() == specificity.by_modes.size());
  std::vector<EnsembleAtModes> result;
  for (std::size_t k = 0; k < specificity.by_modes.size(); ++k)
    result.push_back({specificity.by_modes[k].modes, estimate(specificity.nearest_draw[k]),
                      specificity.by_modes[k].hausdorff});
  return result;
}

}  // namespace foramen
