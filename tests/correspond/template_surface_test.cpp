#include "correspond/template_surface.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "parameterize/mapped_torus.hpp"

namespace foramen {
namespace {

// A flat torus with these sides, its isometric map, and its metric in the plane.
TemplateSurface flat_template(double length_mm, double width_mm) {
  constexpr int around = 12, tube = 8;
  const Mesh mesh = testing::folded_flat_torus(around, tube, length_mm, width_mm);
  VertexMap<Vec2> turns(mesh.vertex_count(), Vec2::Zero());
  for (VertexId v : mesh.vertices())
    turns[v] = Vec2(double(v.index / tube) / around, double(v.index % tube) / tube);
  return {mesh,
          {Lattice::Identity(), turns, testing::grid_form(mesh, testing::regular_cells(around, tube)).value}};
}

TEST(MetricTensors, OfAFlatTorusAreThoseOfItsSides) {
  const VertexMap<Mat2> tensors = metric_tensors(flat_template(30, 12));
  for (const Mat2& tensor : tensors.values())
    EXPECT_LT((tensor - Mat2(Vec2(30 * 30, 12 * 12).asDiagonal())).norm(), 1e-9);
}

TEST(MetricTensors, FollowALinearChangeOfThePlane) {
  testing::MappedTorus torus = testing::mapped_bumpy_torus(24, 12, 3);
  const VertexMap<Mat2> before = metric_tensors({torus.mesh, torus.map});
  Mat2 change;
  change << 1.5, 0.4, 0, 2.0 / 3;
  torus.map.lattice = change * torus.map.lattice;
  const VertexMap<Mat2> after = metric_tensors({torus.mesh, torus.map});
  for (VertexId v : torus.mesh.vertices())
    EXPECT_LT((change.transpose() * after[v] * change - before[v]).norm(), 1e-9 * before[v].norm());
}

TEST(MetricTensors, AreSymmetricAndGrowWithTheSquareOfTheSize) {
  const testing::MappedTorus torus = testing::mapped_bumpy_torus(24, 12, 4);
  std::vector<Vec3> positions;
  for (const Vec3& p : torus.mesh.positions()) positions.push_back(3 * p + Vec3(5, 6, 7));
  const VertexMap<Mat2> small = metric_tensors({torus.mesh, torus.map});
  const VertexMap<Mat2> large = metric_tensors({torus.mesh.with_positions(positions), torus.map});
  for (VertexId v : torus.mesh.vertices()) {
    EXPECT_LT((large[v] - 9 * small[v]).norm(), 1e-9 * large[v].norm());
    EXPECT_LT((small[v] - small[v].transpose()).norm(), 1e-9 * small[v].norm());
    EXPECT_GT(small[v].determinant(), 0);
  }
}

TEST(Interpolated, IsTheCornersOwnAndTheirMeanBetween) {
  const testing::MappedTorus torus = testing::mapped_bumpy_torus(12, 9, 5);
  const VertexMap<Mat2> tensors = metric_tensors({torus.mesh, torus.map});
  for (FaceId f : torus.mesh.faces()) {
    const auto c = torus.mesh.corners(f);
    EXPECT_EQ(interpolated(torus.mesh, tensors, {f, Vec3::UnitY()}), tensors[c[1]]);
    const Mat2 middle = (tensors[c[0]] + tensors[c[1]] + tensors[c[2]]) / 3;
    EXPECT_LT((interpolated(torus.mesh, tensors, {f, Vec3::Constant(1.0 / 3)}) - middle).norm(),
              1e-12 * middle.norm());
  }
}

TEST(CurvaturesAt, AreInterpolatedBetweenTheVertices) {
  TemplateSurface surface = flat_template(30, 12);
  EXPECT_TRUE(curvatures_at(surface, std::vector<Vec2>{{0.1, 0.2}}).values().empty());
  surface.curvatures = VertexMap<Vec2>(surface.mesh.vertex_count(), Vec2::Zero());
  surface.curvatures[VertexId(9)] = Vec2(0.5, -1);
  const Vec2 place = surface.map.turns[VertexId(9)], next = surface.map.turns[VertexId(10)];
  const std::vector<Vec2> places{place, (3 * place + next) / 4, place + Vec2(0.5, 0)};
  const std::vector<Vec2> found = curvatures_at(surface, places).values();
  EXPECT_LT((found[0] - Vec2(0.5, -1)).norm(), 1e-9);
  EXPECT_LT((found[1] - 0.75 * Vec2(0.5, -1)).norm(), 1e-9);
  EXPECT_EQ(found[2], Vec2::Zero());
}

}  // namespace
}  // namespace foramen
