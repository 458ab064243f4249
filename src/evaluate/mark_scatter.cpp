#include "evaluate/mark_scatter.hpp"

#include <algorithm>
#include <cmath>

#include "evaluate/polyline.hpp"
#include "foramen/core/error.hpp"

namespace foramen {
namespace {

void measure(const Mesh& mean, MarkScatter& scatter) {
  const std::size_t points = scatter.placed[0].places.size();
  const double shapes = static_cast<double>(scatter.placed.size());
  scatter.centre.assign(points, Vec3::Zero());
  for (const PlacedMark& mark : scatter.placed) {
    FORAMEN_ASSERT(mark.kind == scatter.kind && mark.places.size() == points);
    for (std::size_t i = 0; i < points; ++i) scatter.centre[i] += position(mean, mark.places[i]) / shapes;
  }
  // The polyline of a single point is that point.
  const detail::Polyline centre(scatter.centre, scatter.kind == MarkKind::closed_curve);
  for (std::size_t i = 0; i < points; ++i) {
    double squared = 0;
    for (const PlacedMark& mark : scatter.placed)
      squared += std::pow(centre.distance(position(mean, mark.places[i])), 2);
    scatter.rms += std::sqrt(squared / shapes) / static_cast<double>(points);
  }
}

}  // namespace

std::vector<MarkScatter> mark_scatter(const Mesh& mean, std::span<const PlacedMark> placed) {
  std::vector<MarkScatter> all;
  for (const PlacedMark& mark : placed) {
    auto of_name = std::find_if(all.begin(), all.end(),
                                [&](const MarkScatter& scatter) { return scatter.mark == mark.mark; });
    if (of_name == all.end()) of_name = all.insert(all.end(), {mark.mark, mark.kind, {}, {}, 0});
    of_name->placed.push_back(mark);
  }
  for (MarkScatter& scatter : all) measure(mean, scatter);
  return all;
}

}  // namespace foramen
