#include "io/soup_builder.hpp"

#include <limits>
#include <utility>

#include "io/triangulate_polygon.hpp"

namespace foramen::io_detail {
namespace {

// Halfedges have int indices and there are three per triangle.
constexpr std::uint64_t most_triangles = std::numeric_limits<int>::max() / 3;

std::string counted(std::uint64_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

}  // namespace

void SoupBuilder::expect(std::uint64_t points, std::uint64_t triangles, std::uint64_t bytes_left,
                         std::uint64_t point_bytes, std::uint64_t triangle_bytes) {
  if (points > most_triangles || triangles > most_triangles)
    source_.refuse("its header announces " + std::to_string(points) + " vertices and " +
                       std::to_string(triangles) + " faces",
                   "that is more than foramen can hold: the header is damaged, or simplify the surface");
  if (points * point_bytes + triangles * triangle_bytes > bytes_left)
    source_.refuse("its header announces " + std::to_string(points) + " vertices and " +
                       std::to_string(triangles) + " faces, which need at least " +
                       std::to_string(points * point_bytes + triangles * triangle_bytes) +
                       " bytes, but only " + std::to_string(bytes_left) + " follow",
                   remedy_export_again);
  soup_.points.reserve(points);
  soup_.triangles.reserve(triangles);
}

void SoupBuilder::refuse_point(const std::string& place) const {
  source_.refuse(place + ": a coordinate is not a finite number",
                 "remove that vertex in a mesh editor or export the surface again");
}

void SoupBuilder::refuse_corner(std::int64_t written, std::uint64_t point_count,
                                const std::string& place) const {
  source_.refuse(place + ": uses vertex " + std::to_string(written) + ", but there are " +
                     std::to_string(point_count) + " vertices",
                 "the file is damaged or was edited by hand: export it again");
}

void SoupBuilder::add_polygon(std::span<const std::int64_t> corners, const std::string& place) {
  if (corners.size() > most_corners)
    source_.refuse(place + ": a face with " + std::to_string(corners.size()) + " corners, more than " +
                       std::to_string(most_corners),
                   remedy_triangulate);
  polygons_.push_back({soup_.triangles.size(), polygon_corners_.size(), corners.size()});
  for (const std::int64_t corner : corners) polygon_corners_.push_back(static_cast<int>(corner));
}

// The triangles of a polygon take its place among the others.
void SoupBuilder::triangulate() {
  const auto triangles = std::exchange(soup_.triangles, {});
  auto next = triangles.begin();
  for (const Polygon& polygon : polygons_) {
    const auto before = triangles.begin() + static_cast<std::ptrdiff_t>(polygon.triangles_before);
    soup_.triangles.insert(soup_.triangles.end(), next, before);
    next = before;
    const std::span corners(polygon_corners_.data() + polygon.first_corner, polygon.corners);
    for (const auto& triangle : triangulate_polygon(corners, soup_.points))
      soup_.triangles.push_back(triangle);
  }
  soup_.triangles.insert(soup_.triangles.end(), next, triangles.end());
}

void SoupBuilder::remove_unused_points() {
  std::vector<int> renumbered(soup_.points.size(), -1);
  for (const auto& triangle : soup_.triangles)
    for (const int corner : triangle) renumbered[static_cast<std::size_t>(corner)] = 0;
  std::vector<Vec3> kept;
  for (std::size_t v = 0; v < renumbered.size(); ++v) {
    if (renumbered[v] < 0) continue;
    renumbered[v] = static_cast<int>(kept.size());
    kept.push_back(soup_.points[v]);
  }
  if (kept.size() == soup_.points.size()) return;
  unused_ = soup_.points.size() - kept.size();
  soup_.points = std::move(kept);
  for (auto& triangle : soup_.triangles)
    for (int& corner : triangle) corner = renumbered[static_cast<std::size_t>(corner)];
}

std::string SoupBuilder::note() const {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  if (!polygons_.empty()) add(counted(polygons_.size(), "polygon") + " cut into triangles");
  if (strips_ > 0) add(counted(strips_, "triangle strip") + " taken apart");
  if (loose_ > 0)
    add(counted(loose_, "loose cell") + " (points, lines) passed over");
  else if (unused_ > 0)
    add(counted(unused_, "point") + " that no face uses passed over");
  if (trailing_ > 0) add(counted(trailing_, "byte") + " after the surface passed over");
  return text;
}

MeshFile SoupBuilder::finish(std::optional<AnatomicalSpace> space) {
  if (!polygons_.empty()) triangulate();
  if (soup_.triangles.empty())
    source_.refuse("holds no triangles (" + std::to_string(soup_.points.size()) + " vertices)",
                   "export the surface, not a point cloud or an empty scene");
  if (soup_.triangles.size() > most_triangles)
    source_.refuse("has " + std::to_string(soup_.triangles.size()) + " triangles",
                   "that is more than foramen can hold: simplify the surface");
  if (loose_ > 0 || passes_over_unused_) remove_unused_points();
  MeshFile file{std::move(soup_), space, {}};
  if (const std::string said = note(); !said.empty()) file.notes.emplace_back(said);
  return file;
}

}  // namespace foramen::io_detail
