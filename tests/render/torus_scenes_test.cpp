#include "render/torus_scenes.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "render/mapped_torus.hpp"

namespace foramen {
namespace {

using testing::mapped_torus;
using testing::MappedTorus;

std::array<Vec3, 3> triangle(const SceneSurface& surface, const std::array<int, 3>& t) {
  const auto point = [&](int v) { return surface.soup.points[v]; };
  return {point(t[0]), point(t[1]), point(t[2])};
}

double area_of(const SceneSurface& surface) {
  double sum = 0;
  for (const auto& t : surface.soup.triangles) sum += area(triangle(surface, t));
  return sum;
}

TEST(TorusColour, IsPeriodicAndTellsCellsApart) {
  EXPECT_EQ(torus_colour({0.3, 0.6}), torus_colour({1.3, -1.4}));
  std::set<Colour> colours;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 28; ++j) colours.insert(torus_colour({(i + 0.5) / 12, (j + 0.5) / 28}));
  EXPECT_EQ(colours.size(), 12u * 28u);
}

TEST(CheckerCells, AreEvenAndNearlySquare) {
  Lattice lattice;
  lattice << 0.6, 0.4, 0, 1.0 / 0.6;
  const Vec2i cells = checker_cells(lattice, 300);
  EXPECT_EQ(cells.x() % 2, 0);
  EXPECT_EQ(cells.y() % 2, 0);
  EXPECT_NEAR(cells.x() * cells.y(), 300, 60);
  EXPECT_NEAR(lattice.col(0).norm() / cells.x(), lattice.col(1).norm() / cells.y(), 0.02);
  EXPECT_EQ(checker_cells(lattice, 1), Vec2i(2, 2));
}

// The pieces form a closed surface with the same area and the same volume.
TEST(CheckeredSurface, IsTheSurface) {
  const MappedTorus torus = mapped_torus(17, 11);
  const SceneSurface surface = checkered_surface(torus.mesh, torus.map, {6, 10});
  EXPECT_NEAR(area_of(surface), total_area(torus.mesh), 1e-9 * total_area(torus.mesh));
  Vec3 closing = Vec3::Zero();
  double volume = 0;
  for (const auto& t : surface.soup.triangles) {
    const auto corners = triangle(surface, t);
    closing += area_vector(corners);
    volume += area_vector(corners).dot(corners[0]) / 3;
  }
  EXPECT_NEAR(closing.norm(), 0, 1e-9);
  EXPECT_NEAR(volume, signed_volume(torus.mesh), 1e-9 * volume);
}

// There are 8 cells round the axis and 4 round the tube. The angles of a point determine its colour.
TEST(CheckeredSurface, EveryPieceHasTheColourOfItsCell) {
  const MappedTorus torus = mapped_torus(64, 32);  // borders of cells are exactly along edges
  const SceneSurface surface = checkered_surface(torus.mesh, torus.map, {8, 4});
  ASSERT_EQ(surface.vertex_colours.size(), surface.soup.points.size());
  EXPECT_EQ(surface.soup.triangles.size(), torus.mesh.triangles().size());
  std::map<std::pair<int, int>, std::set<Colour>> colours;
  for (const auto& t : surface.soup.triangles) {
    const auto corners = triangle(surface, t);
    const Vec3 p = (corners[0] + corners[1] + corners[2]) / 3;
    const double u = std::atan2(p.y(), p.x()), v = std::atan2(p.z(), std::hypot(p.x(), p.y()) - 20);
    const auto cell = [](double angle, int cells) {
      return static_cast<int>(cells * wrap(angle / (2 * std::numbers::pi)));
    };
    for (int corner : t) colours[{cell(u, 8), cell(v, 4)}].insert(surface.vertex_colours[corner]);
  }
  EXPECT_EQ(colours.size(), 32u);
  std::set<Colour> all;
  for (const auto& [cell, found] : colours) {
    EXPECT_EQ(found.size(), 1u);
    all.insert(found.begin(), found.end());
  }
  EXPECT_EQ(all.size(), 32u);
}

// On a fine torus the normal is known everywhere, also in the middle of triangles.
TEST(CheckeredSurface, NormalsAreInterpolatedFromTheVertices) {
  const MappedTorus torus = mapped_torus(90, 60);
  const SceneSurface surface = checkered_surface(torus.mesh, torus.map, {14, 22});
  ASSERT_EQ(surface.vertex_normals.size(), surface.soup.points.size());
  for (std::size_t i = 0; i < surface.soup.points.size(); ++i) {
    const Vec3& p = surface.soup.points[i];
    const Vec3 ring = 20 * Vec3(p.x(), p.y(), 0).normalized();
    EXPECT_NEAR(surface.vertex_normals[i].norm(), 1, 1e-12);
    EXPECT_LT((surface.vertex_normals[i] - (p - ring).normalized()).norm(), 0.02);
  }
}

TEST(TorusMapScene, HasTheSurfacesAreaAndFourBorders) {
  const MappedTorus torus = mapped_torus(17, 11);
  const Scene scene = torus_map_scene(torus.mesh, torus.map, {6, 10}, torus.loops);
  EXPECT_NEAR(area_of(scene.surfaces.front()), total_area(torus.mesh), 1e-9 * total_area(torus.mesh));
  ASSERT_EQ(scene.curves.size(), 4u);
  // Both copies of a loop are as long as its period, and the borders close round the domain.
  const double mm = std::sqrt(total_area(torus.mesh) / torus.map.lattice.determinant());
  Vec3 round = Vec3::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& points = scene.curves[k].points;
    EXPECT_EQ(scene.curves[k].colour, loop_colours[k / 2]);
    EXPECT_NEAR((points.back() - points.front()).norm(),
                mm * torus.map.lattice.col(static_cast<int>(k / 2)).norm(), 1e-9);
    round += points.back() - points.front();
  }
  EXPECT_NEAR(round.norm(), 0, 1e-9);
  EXPECT_GT(scene.camera.width_mm, scene.camera.height_mm);
}

}  // namespace
}  // namespace foramen
