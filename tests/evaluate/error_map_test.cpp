#include "evaluate/error_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "foramen/evaluate/representation.hpp"
#include "foramen/spatial/surface_distance.hpp"
#include "spatial/flips.hpp"
#include "support/meshes.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

using ::testing::ElementsAreArray;

struct Pair {
  Mesh corresponding, input;
};

Pair deformed_pair() {
  const CorrespondingCohort cohort =
      testing::torus_cohort({.shapes = 3, .landmark_around = 14, .landmark_tube = 7});
  return {corresponding_mesh(cohort, 0), cohort.inputs[0]};
}

ErrorMap map_of(const Pair& pair) {
  const TriangleTree corresponding(pair.corresponding), input(pair.input);
  return error_map(corresponding, input, sampled_flips(pair.corresponding, input));
}

ClosestPoint closest_of_all(const Mesh& mesh, const Vec3& query) {
  ClosestPoint best;
  for (FaceId f : mesh.faces()) {
    ClosestPoint closest = closest_on_triangle(mesh.triangle(f), query);
    if (closest.squared_distance >= best.squared_distance) continue;
    best = closest;
    best.on.face = f;
  }
  return best;
}

// The expected values are computed by comparing all triangles with all points.
TEST(ErrorMap, IsTheLargestDistanceAroundEachLandmark) {
  const Pair pair = deformed_pair();
  const Mesh& mesh = pair.corresponding;
  std::vector<double> expected(mesh.vertex_count(), 0.0);
  const auto raise = [&](int landmark, double squared) {
    double& e = expected[landmark];
    e = std::max(e, std::sqrt(squared));
  };
  for (const Vec3& p : pair.input.positions()) {
    const ClosestPoint c = closest_of_all(mesh, p);
    const auto t = mesh.corners(c.on.face);
    const auto& b = c.on.barycentric;
    const std::size_t corner = b[0] >= b[1] && b[0] >= b[2] ? 0 : b[1] >= b[2] ? 1 : 2;
    raise(t[corner].index, c.squared_distance);
  }
  for (const auto& t : mesh.triangles()) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.position(VertexId(t[k]));
    const double middle = closest_of_all(pair.input, (p[0] + p[1] + p[2]) / 3).squared_distance;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      raise(t[k], middle);
      raise(t[k], closest_of_all(pair.input, p[k]).squared_distance);
      const double edge = closest_of_all(pair.input, (p[k] + p[next]) / 2).squared_distance;
      raise(t[k], edge);
      raise(t[next], edge);
    }
  }
  const ErrorMap map = map_of(pair);
  ASSERT_EQ(map.landmark_mm.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(map.landmark_mm[i], expected[i], 1e-9) << i;
}

TEST(ErrorMap, ALandmarkOffItsSurfaceShowsAroundItAlone) {
  Pair pair = deformed_pair();
  const ErrorMap before = map_of(pair);
  std::vector<Vec3> moved(pair.corresponding.positions().begin(), pair.corresponding.positions().end());
  const VertexId v(30);
  moved[30] += 4.0 * vertex_normals(pair.corresponding)[v];
  pair.corresponding = pair.corresponding.with_positions(moved);
  const ErrorMap after = map_of(pair);
  EXPECT_NEAR(after.landmark_mm[30], 4.0, 0.3);
  std::set<int> around{30};
  for (HalfedgeId h : pair.corresponding.fan(v)) around.insert(pair.corresponding.to(h).index);
  for (std::size_t i = 0; i < after.landmark_mm.size(); ++i) {
    if (around.contains(static_cast<int>(i))) continue;
    EXPECT_LT(after.landmark_mm[i], before.landmark_mm[i] + 1.0) << i;
  }
}

TEST(ErrorMap, NamesTheFlippedTriangles) {
  Pair pair = deformed_pair();
  std::vector<Vec3> moved(pair.corresponding.positions().begin(), pair.corresponding.positions().end());
  moved[30] += 1.6 * (moved[37] - moved[30]);
  pair.corresponding = pair.corresponding.with_positions(moved);
  const SampledFlips flips = sampled_flips(pair.corresponding, TriangleTree(pair.input));
  std::vector<int> plain;
  for (FaceId f : flips.plain) plain.push_back(f.index);
  std::sort(plain.begin(), plain.end());
  ASSERT_FALSE(plain.empty());
  EXPECT_THAT(map_of(pair).plain_flips, ElementsAreArray(plain));
}

}  // namespace
}  // namespace foramen
