#include "foramen/topology/inspect_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace foramen {
namespace {

using Triangle = std::array<int, 3>;

bool has_repeated_corner(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

bool in_range(const Triangle& t, std::size_t points) {
  return std::all_of(t.begin(), t.end(),
                     [&](int c) { return c >= 0 && static_cast<std::size_t>(c) < points; });
}

std::array<Vec3, 3> corners_of(const TriangleSoup& soup, const Triangle& t) {
  return {soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]};
}

bool all_finite(const std::array<Vec3, 3>& t) {
  return t[0].allFinite() && t[1].allFinite() && t[2].allFinite();
}

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }
  bool is_root(std::size_t i) const { return parent_[i] == i; }

 private:
  std::vector<std::size_t> parent_;
};

// One side of a triangle. Corner 3f+k is corner k of triangle f.
struct Side {
  int low, high;
  std::size_t corner_at_low, corner_at_high;
  bool forward;  // runs from low to high
};

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t here = 3 * f + k, there = 3 * f + (k + 1) % 3;
      const int a = triangles[f][k], b = triangles[f][(k + 1) % 3];
      sides.push_back(a < b ? Side{a, b, here, there, true} : Side{b, a, there, here, false});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::tie(x.low, x.high, x.corner_at_low) < std::tie(y.low, y.high, y.corner_at_low);
  });
  return sides;
}

// Counts the edges and their defects. Joins the corners of triangles that share an edge, so that each set of
// joined corners at a vertex is one fan.
void inspect_edges(const TriangleSoup& soup, const std::vector<Triangle>& triangles, DisjointSets& fans,
                   MeshReport& report) {
  const std::vector<Side> sides = sorted_sides(triangles);
  double length_sum = 0;
  int measured = 0;
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    std::size_t forward = 0;
    for (; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high; ++end) {
      fans.join(sides[end].corner_at_low, sides[i].corner_at_low);
      fans.join(sides[end].corner_at_high, sides[i].corner_at_high);
      forward += sides[end].forward ? 1 : 0;
    }
    const std::size_t count = end - i;
    ++report.edges;
    if (count == 1) ++report.boundary_edges;
    if (count == 2 && forward != 1) ++report.misoriented_edges;
    if (count > 2) ++report.non_manifold_edges;
    const double length = (soup.points[sides[i].high] - soup.points[sides[i].low]).norm();
    if (std::isfinite(length)) {
      length_sum += length;
      ++measured;
    }
    i = end;
  }
  if (measured > 0) report.mean_edge = length_sum / measured;
}

void inspect_vertices(const TriangleSoup& soup, const std::vector<Triangle>& triangles,
                      const DisjointSets& fans, MeshReport& report) {
  std::vector<int> fan_count(soup.points.size(), 0);
  DisjointSets pieces(soup.points.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t vertex = triangles[f][k];
      if (fans.is_root(3 * f + k)) ++fan_count[vertex];
      pieces.join(vertex, triangles[f][0]);
    }
  for (std::size_t v = 0; v < fan_count.size(); ++v) {
    if (fan_count[v] == 0) ++report.unused_vertices;
    if (fan_count[v] > 1) ++report.non_manifold_vertices;
    if (fan_count[v] > 0 && pieces.is_root(v)) ++report.components;
    if (!soup.points[v].allFinite()) ++report.non_finite_vertices;
  }
}

int duplicate_vertices(const std::vector<Vec3>& points) {
  std::vector<std::tuple<double, double, double>> finite;
  for (const Vec3& p : points)
    if (p.allFinite()) finite.emplace_back(p.x(), p.y(), p.z());
  std::sort(finite.begin(), finite.end());
  return static_cast<int>(finite.end() - std::unique(finite.begin(), finite.end()));
}

int duplicate_triangles(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) std::sort(t.begin(), t.end());
  std::sort(triangles.begin(), triangles.end());
  return static_cast<int>(triangles.end() - std::unique(triangles.begin(), triangles.end()));
}

// The bounding box of the vertices of triangles. An unused vertex far away must not change which triangles
// count as degenerate.
BoundingBox box_of(const TriangleSoup& soup, const std::vector<Triangle>& triangles) {
  std::vector<Vec3> finite;
  for (const Triangle& t : triangles)
    for (const Vec3& p : corners_of(soup, t))
      if (p.allFinite()) finite.push_back(p);
  if (finite.empty())
    std::copy_if(soup.points.begin(), soup.points.end(), std::back_inserter(finite),
                 [](const Vec3& p) { return p.allFinite(); });
  return finite.empty() ? BoundingBox{Vec3::Zero(), Vec3::Zero()} : bounding_box(finite);
}

void measure(const TriangleSoup& soup, const std::vector<Triangle>& triangles, MeshReport& report) {
  const double smallest_area = degenerate_area(report.box.diagonal());
  const Vec3 origin = report.box.low;  // a point near the surface, so that the volume loses no digits
  for (const Triangle& triangle : triangles) {
    const std::array<Vec3, 3> t = corners_of(soup, triangle);
    if (!all_finite(t)) continue;
    const double a = area(t);
    if (!(a > smallest_area)) ++report.degenerate_triangles;
    report.area += a;
    report.volume += (t[0] - origin).dot((t[1] - origin).cross(t[2] - origin)) / 6;
  }
}

std::string counted(int count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

const std::vector<Remedy> by_repair = {{RemedyKind::repair}};

Obstacle genus_obstacle(int genus) {
  if (genus == 0)
    return {"no hole passes through the surface (genus 0), but a vertebra has one, the vertebral canal",
            "look at the canal in the segmentation: reopen it if it is filled or capped, and close the arch "
            "behind it if the arch is broken or cut off"};
  return {"genus " + std::to_string(genus) + ": " + std::to_string(genus) +
              " holes pass through the surface where only the vertebral canal should",
          "if this is a cervical vertebra with open foramina transversaria, its kind is not supported; "
          "otherwise repair the surface, which cuts thin bridges and fills tunnels of "
          "noise; larger ones must be mended in the segmentation or in a mesh editor",
          by_repair};
}

// The first defect that makes single vertices or triangles unusable.
std::optional<Obstacle> unusable_elements(const MeshReport& r) {
  if (r.triangles == 0)
    return Obstacle{"it has no triangles", "export the surface of the bone, not points or an empty scene"};
  if (r.non_finite_vertices > 0)
    return Obstacle{counted(r.non_finite_vertices, "vertex has", "vertices have") +
                        " a coordinate that is not a finite number",
                    "delete them in a mesh editor and close the holes, or export the surface again"};
  if (r.invalid_triangles > 0)
    return Obstacle{counted(r.invalid_triangles, "triangle uses", "triangles use") +
                        " a vertex that does not exist, or one vertex twice",
                    "remove invalid faces in a mesh editor, or export the surface again"};
  return std::nullopt;
}

std::optional<Obstacle> not_one_surface(const MeshReport& r) {
  if (r.components > 1)
    return Obstacle{
        "it consists of " + std::to_string(r.components) + " separate pieces",
        "repair the surface, which keeps the largest piece, or delete islands and inner cavities in the "
        "segmentation",
        by_repair};
  if (r.duplicate_triangles > 0)
    return Obstacle{counted(r.duplicate_triangles, "triangle is", "triangles are") + " there twice",
                    "repair the surface", by_repair};
  if (r.non_manifold_edges > 0)
    return Obstacle{counted(r.non_manifold_edges, "edge belongs", "edges belong") +
                        " to more than two triangles (not a manifold surface)",
                    "repair the surface, which drops flaps and inner walls, or remove the "
                    "faces at such edges in a mesh editor and close the holes that this leaves",
                    by_repair};
  if (r.non_manifold_vertices > 0)
    return Obstacle{counted(r.non_manifold_vertices, "vertex joins", "vertices join") +
                        " parts of the surface that touch in that point alone (not a manifold surface)",
                    "repair the surface, which parts them", by_repair};
  if (r.boundary_edges > 0)
    return Obstacle{"it is open: " + counted(r.boundary_edges, "boundary edge", "boundary edges"),
                    "repair the surface, which fills small holes; if the bone is cut off at the edge of the "
                    "scan, this shape cannot be used",
                    by_repair};
  if (r.misoriented_edges > 0)
    return Obstacle{"its triangles are not all wound the same way (" +
                        counted(r.misoriented_edges, "edge", "edges") + " between opposite ones)",
                    "repair the surface, which winds them alike", by_repair};
  return std::nullopt;
}

}  // namespace

MeshReport inspect_mesh(const TriangleSoup& soup) {
  MeshReport report;
  report.vertices = static_cast<int>(soup.points.size());
  report.triangles = static_cast<int>(soup.triangles.size());
  std::vector<Triangle> valid;
  valid.reserve(soup.triangles.size());
  for (const Triangle& t : soup.triangles) {
    if (has_repeated_corner(t)) ++report.degenerate_triangles;
    if (has_repeated_corner(t) || !in_range(t, soup.points.size()))
      ++report.invalid_triangles;
    else
      valid.push_back(t);
  }
  DisjointSets fans(3 * valid.size());
  inspect_edges(soup, valid, fans, report);
  inspect_vertices(soup, valid, fans, report);
  report.duplicate_vertices = duplicate_vertices(soup.points);
  report.duplicate_triangles = duplicate_triangles(valid);
  report.euler_number =
      report.vertices - report.unused_vertices - report.edges + static_cast<int>(valid.size());
  report.box = box_of(soup, valid);
  measure(soup, valid, report);
  if (!valid.empty() && report.closed() && report.manifold() && report.oriented() && report.components == 1)
    report.genus = (2 - report.euler_number) / 2;
  report.inward = report.closed() && report.oriented() && report.volume < 0;
  return report;
}

double degenerate_area(double diagonal) {
  constexpr double degenerate_share = 1e-12;
  return degenerate_share * diagonal * diagonal;
}

std::optional<Obstacle> obstacle_to_model(const MeshReport& report) {
  if (auto found = unusable_elements(report)) return found;
  if (auto found = not_one_surface(report)) return found;
  if (report.genus != 1) return genus_obstacle(report.genus.value_or(0));
  return std::nullopt;
}

}  // namespace foramen
