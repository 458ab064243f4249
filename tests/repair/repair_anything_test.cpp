// Random soups and random damage: no surface crashes a repair.
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "foramen/repair/repair_mesh.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

using testing::torus_soup;

// Whatever comes in: a usable surface or a refusal.
void expect_mended_or_refused(const TriangleSoup& soup) {
  try {
    const RepairedMesh repaired = repair_mesh(soup);
    EXPECT_FALSE(obstacle_to_model(inspect_mesh(repaired.mesh.soup())));
  } catch (const InvalidInput& e) {
    EXPECT_GT(std::string(e.what()).size(), 20u);
  }
}

TEST(RepairAnything, AnySoupIsMendedOrRefused) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    TriangleSoup soup;
    const int points = 3 + rng.below(30), triangles = 1 + rng.below(60);
    const bool on_grid = rng.below(2) == 0;  // many coincidences
    for (int v = 0; v < points; ++v) {
      const Vec3 p(rng.uniform(0, 4), rng.uniform(0, 4), rng.uniform(0, 4));
      soup.points.push_back(on_grid ? Vec3(p.array().round()) : Vec3(10 * p));
    }
    for (int f = 0; f < triangles; ++f)
      soup.triangles.push_back({rng.below(points), rng.below(points), rng.below(points)});
    expect_mended_or_refused(soup);
  }
}

TEST(RepairAnything, AnyDamageIsMendedOrRefused) {
  int usable = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    TriangleSoup soup = torus_soup(16, 10);
    const int edits = 1 + rng.below(8);
    for (int e = 0; e < edits; ++e) {
      const auto f = static_cast<std::size_t>(rng.below(static_cast<int>(soup.triangles.size())));
      const auto v = static_cast<std::size_t>(rng.below(static_cast<int>(soup.points.size())));
      switch (rng.below(6)) {
        case 0:
          soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(f));
          break;
        case 1:
          soup.triangles.push_back(soup.triangles[f]);
          break;
        case 2:
          std::swap(soup.triangles[f][0], soup.triangles[f][1]);
          break;
        case 3:
          soup.triangles[f][static_cast<std::size_t>(rng.below(3))] = static_cast<int>(v);
          break;
        case 4:
          soup.points[v] += 6 * Vec3(rng.normal(), rng.normal(), rng.normal());
          break;
        default:
          soup.points[v] = soup.points[static_cast<std::size_t>(soup.triangles[f][0])];
          break;
      }
    }
    expect_mended_or_refused(soup);
    try {
      repair_mesh(soup, {.hole_perimeter_mm = 100});
      ++usable;
    } catch (const InvalidInput&) {
    }
  }
  EXPECT_GT(usable, 100);
}

}  // namespace
}  // namespace foramen
