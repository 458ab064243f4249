#include "extract/numbering_fit.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "extract/vertebra_level.hpp"

namespace foramen {
namespace {

struct Fit {
  int named = 0, wrong_order = 0, gaps = 0;
  int score() const { return named - 2 * wrong_order; }
};

Fit fit_of(const LabelHeights& labels, LabelNumbering numbering) {
  std::vector<std::pair<int, double>> levels;  // rank and height
  for (const auto& [label, height] : labels) {
    const auto found = label_names(numbering).find(label);
    if (found == label_names(numbering).end()) continue;
    if (const auto rank = rank_of_level(found->second)) levels.emplace_back(*rank, height);
  }
  std::sort(levels.begin(), levels.end());
  Fit fit{.named = static_cast<int>(levels.size())};
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const int step = levels[i].first - levels[i - 1].first;
    if (step > 0 && levels[i].second > levels[i - 1].second) ++fit.wrong_order;
    if (step > 2) ++fit.gaps;
  }
  return fit;
}

bool better(const Fit& a, const Fit& b) {
  constexpr int enough_to_see_a_gap = 3;
  if (a.score() != b.score()) return a.score() > b.score();
  return a.named >= enough_to_see_a_gap && a.gaps == 0 && b.gaps > 0;
}

std::vector<std::string> named_levels(const LabelHeights& labels, LabelNumbering numbering) {
  std::vector<std::string> levels;
  for (const auto& [label, height] : labels)
    if (label_names(numbering).contains(label)) levels.push_back(name_of(label_names(numbering), label));
  return levels;
}

char region_of(const std::string& level) {
  return level == "sacrum" ? 'S' : level == "coccyx" ? 0 : level.front();
}

}  // namespace

LabelHeights heights_of(const LabelMap& map, const std::map<int, LabelExtent>& present) {
  LabelHeights heights;
  for (const auto& [label, extent] : present) {
    Vec3 middle;
    for (int d = 0; d < 3; ++d) middle[d] = (extent.low[d] + extent.high[d]) / 2.0;
    heights[label] = (map.origin + map.axes * middle).z();
  }
  return heights;
}

std::vector<LabelNumbering> better_numberings(const LabelHeights& labels, LabelNumbering than) {
  const Fit fit = fit_of(labels, than);
  std::vector<LabelNumbering> found;
  Fit best = fit;
  for (const auto& [word, other] : EnumWords<LabelNumbering>::all) {
    const Fit of_other = fit_of(labels, other);
    if (!better(of_other, fit) || better(best, of_other)) continue;
    if (better(of_other, best)) found.clear();
    best = of_other;
    found.push_back(other);
  }
  return found;
}

std::vector<LabelNumbering> numberings_in_region(const LabelHeights& labels, char region,
                                                 LabelNumbering than) {
  std::vector<LabelNumbering> found;
  for (const auto& [word, other] : EnumWords<LabelNumbering>::all) {
    const auto levels = named_levels(labels, other);
    const bool fits = std::all_of(levels.begin(), levels.end(),
                                  [&](const std::string& level) { return region_of(level) == region; });
    if (other != than && !levels.empty() && fits && fit_of(labels, other).wrong_order == 0)
      found.push_back(other);
  }
  return found;
}

bool any_in_region(const LabelHeights& labels, char region, LabelNumbering numbering) {
  const auto levels = named_levels(labels, numbering);
  return std::any_of(levels.begin(), levels.end(),
                     [&](const std::string& level) { return region_of(level) == region; });
}

std::string meaning_of(const LabelHeights& labels, LabelNumbering numbering) {
  constexpr int most = 5;
  std::string text;
  int count = 0;
  for (const auto& [label, height] : labels) {
    if (!label_names(numbering).contains(label)) continue;
    if (++count > most) return text + " ...";
    text +=
        (text.empty() ? "" : ", ") + std::to_string(label) + " is " + name_of(label_names(numbering), label);
  }
  return text;
}

}  // namespace foramen
