#include "repair/raw_surface.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <tuple>

#include "foramen/core/error.hpp"
#include "repair/used_points.hpp"

namespace foramen::repair_detail {
namespace {

// Beyond the coordinates of any scanner, and small enough that exact predicates stay within the range of a
// double.
constexpr double largest_coordinate_mm = 1e6;

auto coordinates(const Vec3& p) { return std::tuple(p.x(), p.y(), p.z()); }

std::array<int, 3> sorted(std::array<int, 3> t) {
  std::sort(t.begin(), t.end());
  return t;
}

}  // namespace

RawSurface checked(const TriangleSoup& raw) {
  if (raw.triangles.empty())
    throw InvalidInput("it has no triangles; export the surface of the bone, not points or an empty scene");
  for (std::size_t v = 0; v < raw.points.size(); ++v) {
    if (!raw.points[v].allFinite())
      throw InvalidInput("vertex " + std::to_string(v) +
                         " has a coordinate that is not a finite number; export the surface again");
    if (raw.points[v].lpNorm<Eigen::Infinity>() > largest_coordinate_mm)
      throw InvalidInput(
          "vertex " + std::to_string(v) +
          " is more than a kilometre from the origin; export the surface again, in millimetres");
  }
  for (std::size_t f = 0; f < raw.triangles.size(); ++f)
    for (int corner : raw.triangles[f])
      if (corner < 0 || corner >= std::ssize(raw.points))
        throw InvalidInput("triangle " + std::to_string(f) + " uses vertex " + std::to_string(corner) +
                           ", but there are only " + std::to_string(raw.points.size()) +
                           " vertices; export the surface again");
  RawSurface surface{raw, std::vector<int>(raw.points.size()), {}};
  std::iota(surface.origin.begin(), surface.origin.end(), 0);
  surface.joined = surface.origin;
  return surface;
}

std::vector<Vec3> drop_unused_vertices(RawSurface& surface) {
  const std::vector<Vec3> before = surface.soup.points;
  const std::vector<int> former = keep_used_points(surface.soup);
  std::vector<Vec3> dropped;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    if (kept < former.size() && former[kept] == static_cast<int>(v))
      surface.origin[kept++] = surface.origin[v];
    else
      dropped.push_back(before[v]);
  }
  surface.origin.resize(kept);
  return dropped;
}

std::vector<Vec3> join_duplicate_vertices(RawSurface& surface) {
  TriangleSoup& soup = surface.soup;
  std::vector<int> order(soup.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const auto p = coordinates(soup.points[a]), q = coordinates(soup.points[b]);
    return p != q ? p < q : a < b;
  });
  std::vector<int> first(soup.points.size());
  std::vector<Vec3> joined;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const int v = order[k];
    const bool again = k > 0 && soup.points[v] == soup.points[order[k - 1]];
    first[v] = again ? first[order[k - 1]] : v;
    if (again) joined.push_back(soup.points[v]);
  }
  for (auto& t : soup.triangles)
    for (int& corner : t) corner = first[corner];
  for (std::size_t v = 0; v < first.size(); ++v) surface.joined[surface.origin[v]] = surface.origin[first[v]];
  drop_unused_vertices(surface);
  return joined;
}

void keep_triangles(RawSurface& surface, const std::vector<char>& kept) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < kept.size(); ++f)
    if (kept[f] != 0) surface.soup.triangles[count++] = surface.soup.triangles[f];
  surface.soup.triangles.resize(count);
}

std::vector<Vec3> drop_triangles_with_repeated_corner(RawSurface& surface) {
  std::vector<char> kept;
  std::vector<Vec3> dropped;
  for (const auto& t : surface.soup.triangles) {
    kept.push_back(t[0] != t[1] && t[1] != t[2] && t[2] != t[0] ? 1 : 0);
    if (kept.back() == 0) dropped.push_back(centre(surface.soup, t));
  }
  keep_triangles(surface, kept);
  return dropped;
}

std::vector<Vec3> drop_duplicate_triangles(RawSurface& surface) {
  const auto& triangles = surface.soup.triangles;
  std::vector<std::pair<std::array<int, 3>, std::size_t>> order;
  order.reserve(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f) order.emplace_back(sorted(triangles[f]), f);
  std::sort(order.begin(), order.end());
  std::vector<char> kept(triangles.size(), 1);
  for (std::size_t k = 1; k < order.size(); ++k)
    if (order[k].first == order[k - 1].first) kept[order[k].second] = 0;
  std::vector<Vec3> dropped;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    if (kept[f] == 0) dropped.push_back(centre(surface.soup, triangles[f]));
  keep_triangles(surface, kept);
  return dropped;
}

Vec3 centre(const TriangleSoup& soup, const std::array<int, 3>& triangle) {
  return (soup.points[triangle[0]] + soup.points[triangle[1]] + soup.points[triangle[2]]) / 3;
}

}  // namespace foramen::repair_detail
