#include "foramen/evaluate/region_transfer.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "core/parallel.hpp"
#include "evaluate/subject_pairs.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "spatial/point_index.hpp"

namespace foramen {
namespace {

constexpr int no_region = -1;

/// The regions of one shape in the numbering of all shapes.
struct LabelledShape {
  std::vector<bool> has;     // whether the input has each region
  std::vector<int> regions;  // of each vertex of the corresponding mesh
  std::vector<double> areas;
};

void check_regions(const CorrespondingCohort& cohort, const std::vector<RegionsOfShape>& regions) {
  if (regions.size() != cohort.corresponding.size())
    throw InvalidInput("found regions of " + std::to_string(regions.size()) + " shapes for " +
                       std::to_string(cohort.size()) +
                       " corresponding shapes: there must be an entry for each");
  for (std::size_t s = 0; s < regions.size(); ++s) {
    const RegionsOfShape& of_shape = regions[s];
    if (of_shape.names.empty()) continue;
    if (static_cast<int>(of_shape.of_vertex.size()) != cohort.inputs[s].vertex_count())
      throw InvalidInput("the regions of " + cohort.names[s] + " label " +
                         std::to_string(of_shape.of_vertex.size()) + " vertices, but its surface has " +
                         std::to_string(cohort.inputs[s].vertex_count()) +
                         ": give the surfaces that were labelled");
    for (const int label : of_shape.of_vertex)
      FORAMEN_ASSERT(label >= no_region && label < static_cast<int>(of_shape.names.size()));
  }
}

/// Every name once. Whole numbers come in their order, then other names in theirs.
std::vector<std::string> all_names(const std::vector<RegionsOfShape>& regions) {
  const auto key = [](const std::string& name) {
    const bool number = !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
    return std::tuple(!number, number ? name.size() : 0, name);
  };
  std::vector<std::string> names;
  for (const RegionsOfShape& of_shape : regions)
    names.insert(names.end(), of_shape.names.begin(), of_shape.names.end());
  std::sort(names.begin(), names.end(),
            [&](const std::string& a, const std::string& b) { return key(a) < key(b); });
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

LabelledShape labelled(const CorrespondingCohort& cohort, int shape, const RegionsOfShape& regions,
                       const std::vector<std::string>& names) {
  std::vector<int> number_of;  // of each region of this shape
  for (const std::string& name : regions.names)
    number_of.push_back(static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin()));
  LabelledShape result;
  result.has.resize(names.size());
  for (const int label : regions.of_vertex)
    if (label != no_region) result.has[number_of[label]] = true;
  const PointIndex input(cohort.inputs[shape].positions());
  for (const Vec3& p : cohort.corresponding[shape]) {
    const int label = regions.of_vertex[input.nearest(p).index];
    result.regions.push_back(label == no_region ? no_region : number_of[label]);
  }
  const VertexMap<double> areas = vertex_areas(corresponding_mesh(cohort, shape));
  result.areas.assign(areas.begin(), areas.end());
  return result;
}

double dice(const LabelledShape& a, const LabelledShape& b, int region) {
  double common = 0, sum = 0;
  for (std::size_t v = 0; v < a.regions.size(); ++v) {
    const double weight = (a.areas[v] + b.areas[v]) / 2;
    const bool in_a = a.regions[v] == region, in_b = b.regions[v] == region;
    if (in_a && in_b) common += weight;
    sum += weight * (int{in_a} + int{in_b});
  }
  return sum > 0 ? 2 * common / sum : 0;
}

}  // namespace

RegionTransfer region_transfer(const CorrespondingCohort& cohort, const std::vector<RegionsOfShape>& regions,
                               const RunContext& ctx) {
  check_cohort(cohort);
  check_regions(cohort, regions);
  const std::vector<std::string> names = all_names(regions);
  const int shapes = cohort.size(), count = static_cast<int>(names.size());
  std::vector<LabelledShape> of_shape(shapes);
  parallel_for(shapes, ctx, [&](int s) {
    if (!regions[s].names.empty()) of_shape[s] = labelled(cohort, s, regions[s], names);
  });

  const detail::PairSubjects subjects(shapes, cohort.subjects);
  const auto both_have = [&](int a, int b, int region) {
    return !of_shape[a].has.empty() && !of_shape[b].has.empty() && of_shape[a].has[region] &&
           of_shape[b].has[region];
  };
  std::vector<std::vector<std::vector<detail::PairValue>>> found(shapes);  // by `from`, then by region
  parallel_for(shapes, ctx, [&](int from) {
    found[from].resize(count);
    for (int to = 0; to < shapes; ++to)
      for (int r = 0; r < count && subjects.differ(from, to); ++r)
        if (both_have(from, to, r))
          found[from][r].push_back({from, to, dice(of_shape[from], of_shape[to], r)});
  });

  RegionTransfer transfer;
  std::vector<std::vector<detail::PairValue>> by_region(count);
  std::map<std::pair<int, int>, std::pair<double, int>> of_pair;  // sum and number of regions
  for (const auto& from : found)
    for (int r = 0; r < count; ++r)
      for (const detail::PairValue& pair : from[r]) {
        by_region[r].push_back(pair);
        auto& [sum, regions_of_pair] = of_pair[{pair.from, pair.to}];
        sum += pair.value;
        ++regions_of_pair;
      }
  if (of_pair.empty())
    throw InvalidInput(
        "no two shapes of different subjects have a region in common: give regions of the same names on at "
        "least two shapes, and check their subjects");
  for (const auto& [pair, sum] : of_pair)
    transfer.pairs.push_back({pair.first, pair.second, sum.first / sum.second});
  for (int r = 0; r < count; ++r)
    if (!by_region[r].empty())
      transfer.by_region.push_back({names[r], detail::mean_over_pairs(by_region[r], subjects)});
  transfer.dice = detail::mean_over_groups(by_region, subjects);
  transfer.labelled_shapes = static_cast<int>(std::count_if(
      regions.begin(), regions.end(), [](const RegionsOfShape& r) { return !r.names.empty(); }));
  return transfer;
}

}  // namespace foramen
