#pragma once
/// \file
/// Surfaces that cannot be used for a model, and the text that the error must contain.

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "io/malformed_meshes.hpp"
#include "support/double_torus.hpp"
#include "support/meshes.hpp"

namespace foramen::testing {

/// A shape file with one defect.
struct BadShape {
  std::string file_name, bytes, message;
};

inline void PrintTo(const BadShape& shape, std::ostream* out) { *out << shape.file_name; }

/// The soup as OFF, a format that can hold any soup. Reading the text gives the same numbers.
inline std::string off_text(const TriangleSoup& soup) {
  std::string text =
      "OFF\n" + std::to_string(soup.points.size()) + " " + std::to_string(soup.triangles.size()) + " 0\n";
  char line[128];
  for (const Vec3& p : soup.points) {
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", p.x(), p.y(), p.z());
    text += line;
  }
  for (const auto& t : soup.triangles) {
    std::snprintf(line, sizeof line, "3 %d %d %d\n", t[0], t[1], t[2]);
    text += line;
  }
  return text;
}

inline TriangleSoup ring() { return torus_soup(16, 10, 40, 12); }

inline TriangleSoup scaled(TriangleSoup soup, double factor) {
  for (Vec3& p : soup.points) p *= factor;
  return soup;
}

inline TriangleSoup beside(TriangleSoup a, const TriangleSoup& b, const Vec3& shift) {
  const int first = static_cast<int>(a.points.size());
  for (const Vec3& p : b.points) a.points.push_back(p + shift);
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

/// The boundary of a plate of cubes, 10 mm each, with a row of holes: genus = holes.
inline TriangleSoup plate(int holes) {
  const auto solid = [&](int x, int y, int z) {
    return x >= 0 && x < 2 * holes + 1 && y >= 0 && y < 3 && z == 0 && !(y == 1 && x % 2 == 1);
  };
  TriangleSoup soup;
  std::map<std::array<int, 3>, int> corners;
  const auto corner = [&](const std::array<int, 3>& at) {
    const auto [found, fresh] = corners.try_emplace(at, static_cast<int>(soup.points.size()));
    if (fresh) soup.points.push_back(10 * Vec3(at[0], at[1], at[2]));
    return found->second;
  };
  for (int x = 0; x < 2 * holes + 1; ++x)
    for (int y = 0; y < 3; ++y)
      for (int axis = 0; axis < 3; ++axis)
        for (int side : {0, 1}) {
          if (!solid(x, y, 0)) continue;
          std::array<int, 3> beyond{x, y, 0};
          beyond[axis] += 2 * side - 1;
          if (solid(beyond[0], beyond[1], beyond[2])) continue;
          std::array<int, 4> quad{};
          for (std::size_t k = 0; k < 4; ++k) {
            std::array<int, 3> at{x, y, 0};
            at[axis] += side;
            at[(axis + 1) % 3] += k == 1 || k == 2 ? 1 : 0;
            at[(axis + 2) % 3] += k >= 2 ? 1 : 0;
            quad[side == 1 ? k : 3 - k] = corner(at);
          }
          soup.triangles.push_back({quad[0], quad[1], quad[2]});
          soup.triangles.push_back({quad[0], quad[2], quad[3]});
        }
  return soup;
}

/// A closed surface that is not orientable: a torus glued to itself with the wrong orientation.
inline TriangleSoup klein_bottle() {
  constexpr int tube = 10;
  TriangleSoup soup = ring();
  for (auto& t : soup.triangles) {
    const bool across = std::abs(t[0] / tube - t[1] / tube) > 1 || std::abs(t[1] / tube - t[2] / tube) > 1;
    if (!across) continue;
    for (int& corner : t)
      if (corner / tube == 0) corner = (tube - corner % tube) % tube;
  }
  return soup;
}

inline TriangleSoup moebius_strip() {
  constexpr int around = 24;
  TriangleSoup soup;
  for (int i = 0; i < around; ++i) {
    const double u = 2 * std::numbers::pi * i / around;
    for (int side : {-1, 1}) {
      const double r = 40 + side * 10 * std::cos(u / 2);
      soup.points.emplace_back(r * std::cos(u), r * std::sin(u), side * 10 * std::sin(u / 2));
    }
  }
  for (int i = 0; i < around; ++i) {
    const bool last = i + 1 == around;
    const int a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    soup.triangles.push_back({a, c, d});
    soup.triangles.push_back({a, d, b});
  }
  return soup;
}

inline TriangleSoup octahedron() {
  TriangleSoup soup;
  for (int axis = 0; axis < 3; ++axis)
    for (int sign : {-1, 1}) soup.points.push_back(30 * sign * Vec3::Unit(axis));
  for (int x : {0, 1})
    for (int y : {2, 3})
      for (int z : {4, 5}) {
        std::array<int, 3> t{x, y, z};
        if ((x + y + z) % 2 == 0) std::swap(t[1], t[2]);
        soup.triangles.push_back(t);
      }
  return soup;
}

/// The ring after one change.
template <class Change>
TriangleSoup changed_ring(const Change& change) {
  TriangleSoup soup = ring();
  change(soup);
  return soup;
}

inline std::vector<std::pair<std::string, std::pair<TriangleSoup, std::string>>> unusable_surfaces() {
  using Soup = TriangleSoup;
  const auto far_spike = changed_ring([](Soup& s) { s.points[7] *= 1e4; });
  return {
      {"two_pieces", {beside(ring(), ring(), Vec3(120, 0, 0)), "it consists of 2 separate pieces"}},
      {"inner_shell", {beside(ring(), torus_soup(16, 10, 40, 6), Vec3::Zero()), "2 separate pieces"}},
      {"stray_triangle",
       {beside(ring(), {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, Vec3(0, 0, 40)),
        "2 separate pieces"}},
      {"not_welded",
       {[] {
          Soup apart;
          for (const auto& t : ring().triangles)
            apart = beside(std::move(apart),
                           {{ring().points[t[0]], ring().points[t[1]], ring().points[t[2]]}, {{0, 1, 2}}},
                           Vec3::Zero());
          return apart;
        }(),
        "320 separate pieces"}},
      {"one_hole", {changed_ring([](Soup& s) { s.triangles.pop_back(); }), "it is open: 3 boundary edges"}},
      {"many_holes",
       {changed_ring([](Soup& s) {
          for (std::size_t k : {200u, 100u, 50u, 3u})
            s.triangles.erase(s.triangles.begin() + static_cast<std::ptrdiff_t>(k));
        }),
        "it is open: 12 boundary edges"}},
      {"cut_at_the_scans_edge",
       {changed_ring([](Soup& s) { s.triangles.resize(200); }), "it is open: 20 boundary"}},
      {"one_triangle", {{{{0, 0, 0}, {60, 0, 0}, {0, 60, 0}}, {{0, 1, 2}}}, "it is open: 3 boundary edges"}},
      {"moebius_strip", {moebius_strip(), "it is open: 48 boundary edges"}},
      {"genus_0", {octahedron(), "no hole passes through the surface (genus 0)"}},
      {"genus_0_plate", {plate(0), "no hole passes through the surface (genus 0)"}},
      {"genus_2", {genus2_soup(16, 10), "genus 2: 2 holes pass through the surface"}},
      {"genus_2_plate", {plate(2), "genus 2: 2 holes"}},
      {"genus_3", {plate(3), "genus 3: 3 holes"}},
      {"genus_9", {plate(9), "genus 9: 9 holes"}},
      {"one_triangle_reversed",
       {changed_ring([](Soup& s) { std::swap(s.triangles[9][0], s.triangles[9][1]); }),
        "not all wound the same way (3 edges between opposite ones)"}},
      {"half_reversed",
       {changed_ring([](Soup& s) {
          for (std::size_t f = 0; f < 160; ++f) std::swap(s.triangles[f][0], s.triangles[f][1]);
        }),
        "not all wound the same way (20 edges between opposite ones)"}},
      {"klein_bottle", {klein_bottle(), "not all wound the same way"}},
      {"fin",
       {changed_ring([](Soup& s) {
          s.points.emplace_back(0, 0, 30);
          s.triangles.push_back({0, 1, 160});
        }),
        "1 edge belongs to more than two triangles (not a manifold surface)"}},
      {"inner_wall",
       {changed_ring([](Soup& s) {
          for (int j = 1; j + 1 < 10; ++j) s.triangles.push_back({0, j, j + 1});
        }),
        "belong to more than two triangles (not a manifold surface)"}},
      {"touching_in_a_point",
       {changed_ring([](Soup& s) {
          for (auto& t : s.triangles)
            for (int& corner : t)
              if (corner == 80) corner = 0;
          s.points.erase(s.points.begin() + 80);
          for (auto& t : s.triangles)
            for (int& corner : t)
              if (corner > 80) --corner;
        }),
        "1 vertex joins parts of the surface that touch in that point alone"}},
      {"triangle_twice",
       {changed_ring([](Soup& s) { s.triangles.push_back(s.triangles[5]); }), "1 triangle is there twice"}},
      {"triangle_twice_reversed",
       {changed_ring([](Soup& s) {
          s.triangles.push_back({s.triangles[5][1], s.triangles[5][0], s.triangles[5][2]});
        }),
        "1 triangle is there twice"}},
      {"corner_twice",
       {changed_ring([](Soup& s) { s.triangles[5][1] = s.triangles[5][0]; }),
        "1 triangle uses a vertex that does not exist, or one vertex twice"}},
      {"metres", {scaled(ring(), 1e-3), "probably in m, give this unit (--units m)"}},
      {"centimetres", {scaled(ring(), 0.1), "probably in cm, give this unit (--units cm)"}},
      {"micrometres", {scaled(ring(), 1e3), "probably in um, give this unit (--units um)"}},
      {"unknown_unit", {scaled(ring(), 1e7), "a vertebra has 20 to 250 mm"}},
      {"one_place", {scaled(ring(), 0), "the bounding box has a diagonal of 0 mm"}},
      {"huge_numbers", {scaled(ring(), 1e300), "the bounding box has a diagonal of inf mm"}},
      {"tiny_numbers", {scaled(ring(), 1e-300), "a vertebra has 20 to 250 mm"}},
      {"spike", {far_spike, "the bounding box has a diagonal of"}},
  };
}

/// Files that violate their format, and valid files of unusable surfaces.
inline std::vector<BadShape> bad_shapes() {
  std::vector<BadShape> all;
  for (const auto& file : malformed::all_files())
    all.push_back({file.extension + "_" + file.name + "." + file.extension, file.bytes, file.message});
  for (const auto& [name, surface] : unusable_surfaces())
    all.push_back({name + ".off", off_text(surface.first), surface.second});
  return all;
}

}  // namespace foramen::testing
