#include "sampling/torus_grid.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "sampling/mapped_tori.hpp"

namespace foramen {
namespace {

using testing::rectangular_lattice;

Lattice sheared(double shear) {
  Lattice l = rectangular_lattice(3, 1);
  l(0, 1) = shear;
  return l;
}

const std::vector<std::pair<Lattice, int>> grids{
    {Lattice::Identity(), 9},        {Lattice::Identity(), 100}, {rectangular_lattice(1, 7), 5000},
    {rectangular_lattice(9, 1), 64}, {sheared(0.4), 3000},       {sheared(-0.4), 3000}};

TEST(TorusGrid, IsATriangulationOfTheTorus) {
  for (const auto& [lattice, points] : grids) {
    SCOPED_TRACE(points);
    const auto m = testing::mapped_surface("grid", lattice, points,
                                           [](const Vec2& t) { return testing::on_torus(t, 20, 8); });
    EXPECT_EQ(m.mesh.euler_characteristic(), 0);
    EXPECT_TRUE(m.mesh.is_closed());
    const MapCertificate c = certify(m.mesh, m.map);
    EXPECT_TRUE(c.valid()) << c.flipped << " flipped, degree " << c.degree;
  }
}

TEST(TorusGrid, AllTrianglesAreTheSame) {
  for (const auto& [lattice, points] : grids) {
    SCOPED_TRACE(points);
    const auto m = testing::mapped_surface("grid", lattice, points,
                                           [](const Vec2& t) { return testing::on_torus(t, 20, 8); });
    for (FaceId f : m.mesh.faces())
      EXPECT_NEAR(signed_area(m.mesh, m.map, f) * m.mesh.face_count(), lattice.determinant(), 1e-9);
  }
}

TEST(TorusGrid, VerticesStandWherePromised) {
  const TorusGrid grid = make_torus_grid(sheared(0.2), 1000);
  ASSERT_EQ(static_cast<int>(grid.turns.size()), grid.rows * grid.columns);
  EXPECT_NEAR(static_cast<double>(grid.turns.size()), 1000, 40);
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c)
      EXPECT_EQ(grid.turns[r * grid.columns + c], Vec2(double(c) / grid.columns, double(r) / grid.rows));
}

TEST(TorusGrid, CellsAreNearSquareAndCutByTheirShorterDiagonal) {
  for (double shear : {0.4, -0.4, 0.0}) {
    const Lattice lattice = sheared(shear);
    const TorusGrid grid = make_torus_grid(lattice, 4000);
    const Vec2 across = lattice.col(0) / grid.columns, up = lattice.col(1) / grid.rows;
    EXPECT_NEAR(across.norm() / up.norm(), 1, 0.05);
    const auto& t = grid.triangles[0];
    const bool rising = t[2] == grid.columns + 1;
    EXPECT_EQ(rising, (across + up).norm() <= (across - up).norm());
  }
}

TEST(TorusGrid, RefusesWhatIsNoTorus) {
  EXPECT_THROW(make_torus_grid(Lattice::Identity(), 8), InvalidInput);
  EXPECT_THROW(make_torus_grid(rectangular_lattice(3, 1) * Vec2(1, -1).asDiagonal(), 100), InvalidInput);
}

}  // namespace
}  // namespace foramen
