// Random soups and random damage: no surface crashes a repair, and defects that repair promises to fix are
// fixed.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"
#include "repair/mended.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

using testing::expect_only;
using testing::expect_same;
using testing::mended;
using testing::renumbered;
using testing::torus_soup;

// Repairs a soup. The result must be usable, or the soup must be refused with a reason. Returns whether it
// was repaired.
bool mended_or_refused(const TriangleSoup& soup, const RepairOptions& options = {}) {
  try {
    mended(soup, options);
    return true;
  } catch (const InvalidInput& e) {
    EXPECT_GT(std::string(e.what()).size(), 20u);
    return false;
  }
}

TriangleSoup random_soup(Rng& rng) {
  TriangleSoup soup;
  const int points = 3 + rng.below(30), triangles = 1 + rng.below(60);
  const bool on_grid = rng.below(2) == 0;  // a coarse grid gives many coincident points
  for (int v = 0; v < points; ++v) {
    const Vec3 p(rng.uniform(0, 4), rng.uniform(0, 4), rng.uniform(0, 4));
    soup.points.push_back(on_grid ? Vec3(p.array().round()) : Vec3(10 * p));
  }
  for (int f = 0; f < triangles; ++f)
    soup.triangles.push_back({rng.below(points), rng.below(points), rng.below(points)});
  return soup;
}

double area_of(const TriangleSoup& soup) {
  double sum = 0;
  for (const auto& t : soup.triangles) sum += area({soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]});
  return sum;
}

// Adds another soup with its points moved to scale * p + shift.
void add(TriangleSoup& soup, const TriangleSoup& other, double scale, const Vec3& shift) {
  const int n = static_cast<int>(soup.points.size());
  for (const Vec3& p : other.points) soup.points.emplace_back(scale * p + shift);
  for (const auto& t : other.triangles) soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
}

// A soup by itself may be refused. If it stands beside a surface, shares no point with it and is much
// smaller, it is a stray piece, so repair must always return the surface. All its triangles together have a
// twentieth of the surface's area, and a single piece may have a tenth.
TEST(RepairAnything, AnySoupIsMendedOrRefusedAndDroppedBesideASurface) {
  const TriangleSoup torus = torus_soup(16, 10);
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const TriangleSoup strays = random_soup(rng);
    mended_or_refused(strays);
    if (seed % 3 != 0) continue;
    const double scale = std::sqrt(0.05 * area_of(torus) / std::max(1.0, area_of(strays)));
    TriangleSoup soup = torus;
    add(soup, strays, scale, Vec3(40, 0, 0));
    expect_same(mended(soup).mesh, torus);
  }
}

// The triangles by the positions of their corners, independent of their order and first corner.
std::vector<std::array<double, 9>> surface_of(const TriangleSoup& soup) {
  std::vector<std::array<double, 9>> triangles;
  for (const auto& t : soup.triangles) {
    std::array<std::array<double, 9>, 3> turned{};
    for (std::size_t first = 0; first < 3; ++first)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t c = 0; c < 3; ++c)
          turned[first][3 * k + c] = soup.points[t[(first + k) % 3]][static_cast<int>(c)];
    triangles.push_back(*std::min_element(turned.begin(), turned.end()));
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

// A clean surface with defects of every kind that can be undone without loss, planted at random.
class Planted {
 public:
  explicit Planted(Rng rng)
      : rng_(rng), clean_(testing::bumpy_torus_soup(24 + rng_.below(12), 12 + rng_.below(6), rng_.bits())) {
    soup_ = clean_;
    // Each defect that changes triangles uses a triangle of its own.
    faces_.resize(clean_.triangles.size());
    for (std::size_t f = 0; f < faces_.size(); ++f) faces_[f] = f;
    for (std::size_t f = faces_.size(); f > 1; --f)
      std::swap(faces_[f - 1], faces_[rng_.below(static_cast<int>(f))]);
    plant(RepairKind::unused_vertices, [this] { soup_.points.push_back(anywhere()); });
    plant(RepairKind::duplicate_vertices, [this] {
      const std::size_t f = untouched(), corner = static_cast<std::size_t>(rng_.below(3));
      soup_.points.push_back(Vec3(point(soup_.triangles[f][corner])));
      soup_.triangles[f][corner] = static_cast<int>(soup_.points.size()) - 1;
    });
    plant(RepairKind::zero_area_triangles, [this] {
      const auto t = clean_.triangles[untouched()];
      soup_.triangles.push_back({t[0], t[1], t[1]});
    });
    plant(RepairKind::duplicate_triangles, [this] {
      auto t = clean_.triangles[untouched()];
      std::rotate(t.begin(), t.begin() + rng_.below(3), t.end());
      soup_.triangles.push_back(t);
    });
    const int flaps = plant(RepairKind::flaps, [this] {
      const auto t = clean_.triangles[untouched()];
      soup_.triangles.push_back({t[0], t[1], static_cast<int>(soup_.points.size())});
      soup_.points.push_back(anywhere());
    });
    if (flaps > 0) expected_.emplace_back(RepairKind::non_manifold_edges, flaps);
    plant(RepairKind::stray_components, [this] { add_piece(Vec3(60, 60, 0) + 0.2 * anywhere(), 2); });
    plant(RepairKind::reversed_triangles, [this] {
      auto& t = soup_.triangles[untouched()];
      std::swap(t[0], t[1]);
    });
    soup_ = renumbered(soup_, rng_.bits());
  }
  const TriangleSoup& clean() const { return clean_; }
  const TriangleSoup& soup() const { return soup_; }
  /// The changes that a repair must report.
  const std::vector<std::pair<RepairKind, int>>& expected() const { return expected_; }

 private:
  template <class Once>
  int plant(RepairKind kind, const Once& once) {
    const int count = rng_.below(5);
    for (int i = 0; i < count; ++i) once();
    if (count > 0) expected_.emplace_back(kind, count);
    return count;
  }
  std::size_t untouched() {
    const std::size_t f = faces_.back();
    faces_.pop_back();
    return f;
  }
  Vec3 point(int v) const { return soup_.points[v]; }
  Vec3 anywhere() { return {rng_.uniform(-50, 50), rng_.uniform(-50, 50), rng_.uniform(-50, 50)}; }
  void add_piece(const Vec3& at, double size) {
    add(soup_, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}},
        size, at);
  }

  Rng rng_;
  TriangleSoup clean_, soup_;
  std::vector<std::size_t> faces_;
  std::vector<std::pair<RepairKind, int>> expected_;
};

// No part of the surface is missing. Therefore, repair must return it with the same bits, and must report
// exactly the planted defects.
TEST(RepairAnything, WhatIsPlantedIsTakenAwayAndCounted) {
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    SCOPED_TRACE(seed);
    const Planted planted{Rng(seed)};
    const RepairedMesh repaired = mended(planted.soup());
    expect_only(repaired, planted.expected());
    EXPECT_TRUE(surface_of(repaired.mesh.soup()) == surface_of(planted.clean()));
  }
}

constexpr int all_damage = 6, promised_damage = 3;

// One random change of a surface. Repair promises to fix the first three kinds: a missing triangle, a
// duplicate triangle, and a triangle with the opposite winding.
void damage(TriangleSoup& soup, int kind, Rng& rng) {
  const std::size_t f = rng.below(static_cast<int>(soup.triangles.size()));
  const std::size_t v = rng.below(static_cast<int>(soup.points.size()));
  switch (kind) {
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
      soup.triangles[f][rng.below(3)] = static_cast<int>(v);
      break;
    case 4:
      soup.points[v] += 6 * Vec3(rng.normal(), rng.normal(), rng.normal());
      break;
    default:
      soup.points[v] = soup.points[soup.triangles[f][0]];
      break;
  }
}

// In every second soup, all damage is of the kinds that repair promises to fix. Triangles that are missing
// leave holes in this torus and never cut it through: there are eight at most, and a closed walk that does
// not bound has ten edges or more. The holes' borders together are shorter than 250 mm, since no triangle's
// is longer than 30 mm.
TEST(RepairAnything, AnyDamageIsMendedOrRefused) {
  constexpr RepairOptions any_hole{.hole_perimeter_mm = 250};
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const bool promised = seed % 2 == 0;
    TriangleSoup soup = torus_soup(16, 10);
    const int edits = 1 + rng.below(8);
    for (int e = 0; e < edits; ++e) damage(soup, rng.below(promised ? promised_damage : all_damage), rng);
    mended_or_refused(soup);
    EXPECT_TRUE(mended_or_refused(soup, any_hole) || !promised);
  }
}

}  // namespace
}  // namespace foramen
