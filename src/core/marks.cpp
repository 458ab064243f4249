#include "foramen/core/marks.hpp"

#include <map>

namespace foramen {

RegionsOfShape regions_of_labels(std::span<const int> labels) {
  RegionsOfShape regions;
  std::map<int, int> number_of;  // of each label
  for (const int label : labels) {
    if (label <= 0) {
      regions.of_vertex.push_back(-1);
      continue;
    }
    const auto [number, is_new] = number_of.try_emplace(label, static_cast<int>(regions.names.size()));
    if (is_new) regions.names.push_back(std::to_string(label));
    regions.of_vertex.push_back(number->second);
  }
  return regions;
}

}  // namespace foramen
