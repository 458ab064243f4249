#pragma once
/// \file
/// Tori whose closed 1-form follows from their grid, and checks of their maps.

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "parameterize/initial_map.hpp"
#include "support/meshes.hpp"
#include "topology/periods.hpp"

namespace foramen::testing {

/// The grid cell (i, j) of every vertex of a torus of `around` x `tube` vertices.
struct TorusGrid {
  int around = 0, tube = 0;
  std::vector<std::array<int, 2>> cell;
};

inline TorusGrid regular_cells(int around, int tube) {
  TorusGrid grid{around, tube, {}};
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < tube; ++j) grid.cell.push_back({i, j});
  return grid;
}

/// The cells of the same points in another order.
inline TorusGrid matching_cells(const TorusGrid& grid, const TriangleSoup& original,
                                const TriangleSoup& shuffled) {
  std::map<std::array<double, 3>, std::array<int, 2>> cell_at;
  const auto key = [](const Vec3& p) { return std::array{p.x(), p.y(), p.z()}; };
  for (std::size_t v = 0; v < original.points.size(); ++v) cell_at[key(original.points[v])] = grid.cell[v];
  TorusGrid out{grid.around, grid.tube, {}};
  for (const Vec3& p : shuffled.points) out.cell.push_back(cell_at.at(key(p)));
  return out;
}

/// The closed form in which the jump of an edge counts its passages from the last row (column) to the first.
inline Cocycle grid_form(const Mesh& mesh, const TorusGrid& grid) {
  const auto jump = [](int from, int to, int count) {
    return to - from > count / 2 ? -1 : from - to > count / 2 ? 1 : 0;
  };
  Cocycle form{HalfedgeMap<Vec2i>(mesh.halfedge_count(), Vec2i::Zero())};
  for (HalfedgeId h : mesh.halfedges()) {
    const auto& a = grid.cell[mesh.from(h).index];
    const auto& b = grid.cell[mesh.to(h).index];
    form.value[h] = Vec2i(jump(a[0], b[0], grid.around), jump(a[1], b[1], grid.tube));
  }
  return form;
}

struct MappedTorus {
  Mesh mesh;
  TorusMap map;
};

inline MappedTorus mapped_bumpy_torus(int around, int tube, std::uint64_t seed) {
  const Mesh mesh = build_mesh(bumpy_torus_soup(around, tube, seed));
  return {mesh, harmonic_torus_map(mesh, grid_form(mesh, regular_cells(around, tube)))};
}

/// A flat torus with these sides, folded along lines of its grid so that it lies in space and every triangle
/// keeps its shape.
/// \pre even counts
inline Mesh folded_flat_torus(int around, int tube, double length_mm, double width_mm) {
  TriangleSoup soup = torus_soup(around, tube);
  const auto folded = [](int i, int count) { return std::abs(2.0 * i / count - 1.0) / 2; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < tube; ++j)
      soup.points[i * tube + j] = Vec3(length_mm * folded(i, around), width_mm * folded(j, tube), 0);
  return build_mesh(std::move(soup));
}

inline std::vector<std::pair<std::string, MappedTorus>> genus1_maps() {
  std::vector<std::pair<std::string, MappedTorus>> out;
  for (const auto& [around, tube, seed] :
       {std::array{7, 5, 1}, {12, 9, 2}, {24, 10, 3}, {40, 22, 4}, {9, 31, 5}})
    out.emplace_back(std::to_string(around) + "x" + std::to_string(tube),
                     mapped_bumpy_torus(around, tube, static_cast<std::uint64_t>(seed)));
  return out;
}

inline int flipped_triangles(const Mesh& mesh, const TorusMap& map) {
  int count = 0;
  for (FaceId f : mesh.faces())
    if (!(signed_area(mesh, map, f) > 0)) ++count;
  return count;
}

/// The first triangle without positive area; invalid if all have positive area.
inline FaceId first_flipped(const Mesh& mesh, const TorusMap& map) {
  for (FaceId f : mesh.faces())
    if (!(signed_area(mesh, map, f) > 0)) return f;
  return {};
}

}  // namespace foramen::testing
