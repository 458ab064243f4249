#include "apply/part_surface.hpp"

#include <array>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen {
namespace {

/// Sets of triangle corners that form one vertex.
class CornerSets {
 public:
  explicit CornerSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

void check(const TriangleSoup& soup) {
  const int count = static_cast<int>(soup.points.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (const int v : soup.triangles[f])
      if (v < 0 || v >= count)
        throw InvalidInput("triangle " + std::to_string(f) + " uses vertex " + std::to_string(v) +
                           ", but there are " + std::to_string(count) + "; export the surface again");
}

std::vector<std::array<int, 3>> with_area(const TriangleSoup& soup) {
  std::vector<std::array<int, 3>> triangles;
  for (const auto& t : soup.triangles) {
    const auto at = [&](std::size_t k) { return soup.points[t[k]]; };
    if (area({at(0), at(1), at(2)}) > 0) triangles.push_back(t);
  }
  return triangles;
}

}  // namespace

Mesh part_surface(const TriangleSoup& soup) {
  check(soup);
  std::vector<std::array<int, 3>> triangles = with_area(soup);
  if (triangles.empty()) throw InvalidInput("it has no triangle with an area; give a surface");
  // Two corners at a vertex are joined if their triangles share an edge at it.
  CornerSets sets(3 * triangles.size());
  std::map<std::pair<int, int>, std::array<std::size_t, 2>> edges;  // from, to -> corners at from, to
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      edges[{triangles[f][k], triangles[f][next]}] = {3 * f + k, 3 * f + next};
    }
  for (const auto& [ends, corners] : edges)
    if (const auto twin = edges.find({ends.second, ends.first}); twin != edges.end()) {
      sets.join(corners[0], twin->second[1]);
      sets.join(corners[1], twin->second[0]);
    }
  TriangleSoup part;
  std::map<std::size_t, int> vertex;  // vertex of each set
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [at, is_new] =
          vertex.try_emplace(sets.root(3 * f + k), static_cast<int>(part.points.size()));
      if (is_new) part.points.push_back(soup.points[triangles[f][k]]);
      corners[k] = at->second;
    }
    part.triangles.push_back(corners);
  }
  return build_mesh(std::move(part));
}

}  // namespace foramen
