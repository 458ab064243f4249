#include "render/torus_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/LU>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/mesh.hpp"
#include "foramen/topology/shortest_loops.hpp"
#include "render/grid_cut.hpp"
#include "render/unfold.hpp"
#include "render/vertebra_scenes.hpp"

namespace foramen {
namespace {

// The torus of revolution in OKLab: mean and amplitude of lightness and chroma. Two per cent of it lie
// slightly outside sRGB and are clipped.
constexpr double lightness = 0.68, lightness_swing = 0.12, chroma = 0.095, chroma_swing = 0.02;
// The share of white in the lighter cells of the checkerboard.
constexpr double lighter = 0.4;
constexpr double border_radius_mm = 0.6;
// Edges and borders are drawn this far in front of the flat torus, so that it does not hide them.
constexpr double before_mm = 1;

unsigned char srgb_byte(double linear) {
  const double in_gamut = std::clamp(linear, 0.0, 1.0);
  const double encoded =
      in_gamut <= 0.0031308 ? 12.92 * in_gamut : 1.055 * std::pow(in_gamut, 1 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::lround(255 * encoded));
}

// Converts Ottosson's OKLab (2020) to sRGB.
Colour srgb(double l, double a, double b) {
  const double x = std::pow(l + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double y = std::pow(l - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double z = std::pow(l - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {srgb_byte(4.0767416621 * x - 3.3077115913 * y + 0.2309699292 * z),
          srgb_byte(-1.2684380046 * x + 2.6097574011 * y - 0.3413193965 * z),
          srgb_byte(-0.0041960863 * x - 0.7034186147 * y + 1.7076147010 * z)};
}

Colour cell_colour(const Vec2i& cell, const Vec2i& cells) {
  const Vec2 middle = (cell.cast<double>() + Vec2(0.5, 0.5)).cwiseQuotient(cells.cast<double>());
  Colour c = torus_colour(middle);
  if ((cell.x() + cell.y()) % 2 != 0)
    for (unsigned char& channel : c)
      channel = static_cast<unsigned char>(std::lround(channel + lighter * (255 - channel)));
  return c;
}

// The pieces of all faces, cut along the borders of the cells. place(surface, face, corner) adds the point of
// a corner to the surface.
template <class Place>
SceneSurface checkered(const Mesh& mesh, const TorusMap& map, const UnfoldedMap& unfolded, const Vec2i& cells,
                       const Place& place) {
  SceneSurface surface;
  for (FaceId f : mesh.faces()) {
    std::array<Vec2, 3> corners;
    for (int k = 0; k < 3; ++k)
      corners[k] = unfolded.corner(mesh, map, Mesh::halfedge(f, k)).cwiseProduct(cells.cast<double>());
    for (const GridPiece& piece : cut_by_grid(corners)) {
      const int first = static_cast<int>(surface.soup.points.size());
      const int count = static_cast<int>(piece.corners.size());
      for (const GridCorner& corner : piece.corners) place(surface, f, corner);
      surface.vertex_colours.insert(surface.vertex_colours.end(), piece.corners.size(),
                                    cell_colour(piece.cell, cells));
      for (int i = 2; i < count; ++i) surface.soup.triangles.push_back({first, first + i - 1, first + i});
    }
  }
  return surface;
}

// The flat torus as a plane y = const of space, scaled so that its area is that of the surface.
struct FlatPlane {
  Mat2 mm_of_turns;
  Vec3 operator()(const Vec2& turns, double before = 0) const {
    const Vec2 p = mm_of_turns * turns;
    return {p.x(), -before, p.y()};
  }
};

EdgeLoop walk(const Mesh& mesh, const std::vector<VertexId>& vertices) {
  EdgeLoop loop;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    loop.push_back(mesh.find_halfedge(vertices[i], vertices[(i + 1) % vertices.size()]));
  return loop;
}

EdgeLoop reversed(const Mesh& mesh, const EdgeLoop& loop) {
  EdgeLoop back;
  for (auto h = loop.rbegin(); h != loop.rend(); ++h) back.push_back(mesh.twin(*h));
  return back;
}

// The border along the faces to the left of a walk: one curve, or several if the walk crosses the cut.
std::vector<SceneCurve> border(const Mesh& mesh, const TorusMap& map, const UnfoldedMap& unfolded,
                               const FlatPlane& plane, const EdgeLoop& loop, const Colour& colour) {
  std::vector<SceneCurve> curves;
  for (HalfedgeId h : loop) {
    const Vec3 from = plane(unfolded.corner(mesh, map, h), before_mm);
    if (curves.empty() || curves.back().points.back() != from)
      curves.push_back({{from}, false, colour, border_radius_mm});
    curves.back().points.push_back(plane(unfolded.corner(mesh, map, Mesh::next(h)), before_mm));
  }
  return curves;
}

SceneSurface triangle_edges(const Mesh& mesh, const TorusMap& map, const UnfoldedMap& unfolded,
                            const FlatPlane& plane) {
  SceneSurface wires;
  for (HalfedgeId h : mesh.halfedges())
    wires.soup.points.push_back(plane(unfolded.corner(mesh, map, h), before_mm / 2));
  for (FaceId f : mesh.faces())
    wires.soup.triangles.push_back({3 * f.index, 3 * f.index + 1, 3 * f.index + 2});
  wires.style = SurfaceStyle::wires;
  return wires;
}

}  // namespace

Colour torus_colour(const Vec2& turns) {
  const double hue = 2 * std::numbers::pi * turns.x(), tube = 2 * std::numbers::pi * turns.y();
  const double c = chroma + chroma_swing * std::cos(tube);
  return srgb(lightness + lightness_swing * std::sin(tube), c * std::cos(hue), c * std::sin(hue));
}

Vec2i checker_cells(const Lattice& lattice, int count) {
  const double ratio = lattice.col(1).norm() / lattice.col(0).norm();
  const auto even = [](double cells) { return std::max(2, 2 * static_cast<int>(std::lround(cells / 2))); };
  return {even(std::sqrt(count / ratio)), even(std::sqrt(count * ratio))};
}

SceneSurface checkered_surface(const Mesh& mesh, const TorusMap& map, const Vec2i& cells) {
  const VertexMap<Vec3> normals = vertex_normals(mesh);
  const UnfoldedMap unfolded = unfold(mesh, map, EdgeMap<bool>(mesh.edge_count(), false));
  return checkered(
      mesh, map, unfolded, cells, [&](SceneSurface& surface, FaceId f, const GridCorner& corner) {
        const auto c = mesh.corners(f);
        const Vec3& w = corner.barycentric;
        surface.soup.points.push_back(position(mesh, SurfacePoint{f, w}));
        surface.vertex_normals.push_back(w[0] * normals[c[0]] + w[1] * normals[c[1]] + w[2] * normals[c[2]]);
        surface.vertex_normals.back().normalize();
      });
}

Scene torus_map_scene(const Mesh& mesh, const TorusMap& map, const Vec2i& cells,
                      const std::array<std::vector<VertexId>, 2>& loops) {
  const std::array<EdgeLoop, 2> walks{walk(mesh, loops[0]), walk(mesh, loops[1])};
  EdgeMap<bool> cut(mesh.edge_count(), false);
  for (const EdgeLoop& loop : walks)
    for (HalfedgeId h : loop) cut[mesh.edge(h)] = true;
  const UnfoldedMap unfolded = unfold(mesh, map, cut);
  const FlatPlane plane{std::sqrt(total_area(mesh) / map.lattice.determinant()) * map.lattice};

  Scene scene;
  scene.surfaces.push_back(
      checkered(mesh, map, unfolded, cells, [&](SceneSurface& surface, FaceId, const GridCorner& corner) {
        surface.soup.points.push_back(plane(corner.at.cwiseQuotient(cells.cast<double>())));
      }));
  scene.surfaces.back().style = SurfaceStyle::flat_map;
  scene.surfaces.push_back(triangle_edges(mesh, map, unfolded, plane));
  for (std::size_t k = 0; k < 2; ++k)
    for (const EdgeLoop& side : {walks[k], reversed(mesh, walks[k])})
      for (SceneCurve& curve : border(mesh, map, unfolded, plane, side, loop_colours[k]))
        scene.curves.push_back(std::move(curve));

  const Vec2 first = plane.mm_of_turns.col(0), second = plane.mm_of_turns.col(1);
  const Vec2 across = (first.norm() > second.norm() ? first : second).normalized();
  scene.camera = frame(scene.surfaces.front().soup.points, {0, 1, 0}, {-across.y(), 0, across.x()});
  return scene;
}

}  // namespace foramen
