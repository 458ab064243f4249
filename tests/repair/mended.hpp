#pragma once
/// \file
/// Requirements for every repaired surface, and helpers to check the list of changes.

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "foramen/core/geometry.hpp"
#include "foramen/repair/repair_mesh.hpp"
#include "foramen/topology/inspect_mesh.hpp"

namespace foramen::testing {

/// The number of repaired defects of a kind.
inline int count(const RepairedMesh& repaired, RepairKind kind) {
  for (const RepairChange& change : repaired.report.changes)
    if (change.kind == kind) return change.count();
  return 0;
}

/// The repaired surface, after checking that it is usable and that its maps to and from the raw surface
/// agree.
inline RepairedMesh mended(const TriangleSoup& raw, const RepairOptions& options = {}) {
  RepairedMesh repaired = repair_mesh(raw, options);
  EXPECT_FALSE(obstacle_to_model(inspect_mesh(repaired.mesh.soup())));
  EXPECT_GT(signed_volume(repaired.mesh), 0);
  EXPECT_EQ(repaired.origin.size(), repaired.mesh.vertex_count());
  EXPECT_EQ(repaired.repaired.size(), static_cast<int>(raw.points.size()));
  for (VertexId v : repaired.mesh.vertices()) {
    const VertexId was = repaired.origin[v];
    if (!was.valid()) continue;
    const auto now = repaired.from_raw(was);
    EXPECT_TRUE(now.has_value());
    EXPECT_EQ(repaired.origin[now.value_or(v)], was);
    EXPECT_LE((repaired.mesh.position(v) - raw.points[was.index]).norm(), repaired.report.largest_move_mm);
  }
  EXPECT_FALSE(repaired.from_raw(VertexId()));
  EXPECT_FALSE(repaired.from_raw(VertexId(static_cast<int>(raw.points.size()))));
  return repaired;
}

/// Expects that the report lists these changes in this order.
inline void expect_only(const RepairedMesh& repaired, std::vector<std::pair<RepairKind, int>> expected) {
  std::vector<std::pair<RepairKind, int>> found;
  for (const RepairChange& change : repaired.report.changes) found.emplace_back(change.kind, change.count());
  EXPECT_EQ(found, expected) << summary(repaired.report);
}

/// Expects that mesh and soup have exactly the same coordinates and triangles.
inline void expect_same(const Mesh& mesh, const TriangleSoup& soup) {
  EXPECT_EQ(mesh.triangles(), soup.triangles);
  EXPECT_TRUE(
      std::equal(soup.points.begin(), soup.points.end(), mesh.positions().begin(), mesh.positions().end()));
}

}  // namespace foramen::testing
