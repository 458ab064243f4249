#include "repair/pieces.hpp"

#include <algorithm>
#include <map>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "repair/edge_sides.hpp"
#include "repair/words.hpp"

namespace foramen::repair_detail {
namespace {

// Number of points of a dropped piece that are kept to test whether it lies inside.
constexpr std::size_t most_samples = 7;

struct Piece {
  std::vector<std::size_t> faces;
  BoundingBox box{Vec3::Zero(), Vec3::Zero()};
  double area = 0;
};

std::map<std::size_t, Piece> pieces_of(const TriangleSoup& soup) {
  const EdgeSides edges(soup.triangles);
  DisjointSets sets(soup.triangles.size());
  for (std::size_t e = 0; e < edges.edge_count(); ++e)
    for (const Side& side : edges.sides(e)) sets.join(side.halfedge / 3, edges.sides(e)[0].halfedge / 3);
  std::map<std::size_t, Piece> pieces;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    Piece& piece = pieces[sets.root(f)];
    const auto& t = soup.triangles[f];
    const std::array<Vec3, 3> corners{soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]};
    BoundingBox box = bounding_box(corners);
    if (!piece.faces.empty()) box = {box.low.cwiseMin(piece.box.low), box.high.cwiseMax(piece.box.high)};
    piece.box = box;
    piece.area += area(corners);
    piece.faces.push_back(f);
  }
  return pieces;
}

}  // namespace

std::vector<DroppedPiece> keep_largest_piece(RawSurface& surface) {
  const auto pieces = pieces_of(surface.soup);
  const auto largest = std::max_element(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
    return a.second.box.diagonal() < b.second.box.diagonal();
  });
  std::vector<DroppedPiece> dropped;
  std::vector<char> kept(surface.soup.triangles.size(), 1);
  for (auto piece = pieces.begin(); piece != pieces.end(); ++piece) {
    if (piece == largest) continue;
    const auto& [first, p] = *piece;
    DroppedPiece out{p.area, (p.box.low + p.box.high) / 2, {}};
    const std::size_t step = std::max<std::size_t>(1, p.faces.size() / most_samples);
    for (std::size_t k = 0; k < p.faces.size() && out.samples.size() < most_samples; k += step)
      out.samples.push_back(centre(surface.soup, surface.soup.triangles[p.faces[k]]));
    for (std::size_t f : p.faces) kept[f] = 0;
    dropped.push_back(std::move(out));
  }
  keep_triangles(surface, kept);
  return dropped;
}

std::vector<char> wind_alike(RawSurface& surface) {
  auto& triangles = surface.soup.triangles;
  struct Neighbour {
    int face;
    bool opposed;  // both triangles run along the common edge in the same direction
    int edge_low, edge_high;
  };
  std::vector<std::vector<Neighbour>> neighbours(triangles.size());
  const EdgeSides edges(triangles);
  for (std::size_t e = 0; e < edges.edge_count(); ++e) {
    const auto sides = edges.sides(e);
    if (sides.size() != 2) continue;
    for (std::size_t k = 0; k < 2; ++k)
      neighbours[sides[k].halfedge / 3].push_back(
          {sides[1 - k].halfedge / 3, sides[0].forward == sides[1].forward, sides[k].low, sides[k].high});
  }
  std::vector<char> turned(triangles.size(), 0), reached(triangles.size(), 0);
  std::vector<std::size_t> stack{0};
  reached[0] = 1;
  while (!stack.empty()) {
    const std::size_t f = stack.back();
    stack.pop_back();
    for (const Neighbour& n : neighbours[f]) {
      const char wanted = n.opposed ? static_cast<char>(1 - turned[f]) : turned[f];
      if (reached[n.face] == 0) {
        reached[n.face] = 1;
        turned[n.face] = wanted;
        stack.push_back(n.face);
      } else if (turned[n.face] != wanted) {
        throw TopologyError(
            "its triangles cannot be wound alike: going round the surface one comes back on its other "
            "side, as on a Moebius band, near " +
            shown((surface.soup.points[n.edge_low] + surface.soup.points[n.edge_high]) / 2) +
            "; export the surface again");
      }
    }
  }
  if (2 * std::count(turned.begin(), turned.end(), 1) > static_cast<std::ptrdiff_t>(turned.size()))
    for (char& t : turned) t = static_cast<char>(1 - t);
  for (std::size_t f = 0; f < triangles.size(); ++f)
    if (turned[f] != 0) std::swap(triangles[f][1], triangles[f][2]);
  return turned;
}

}  // namespace foramen::repair_detail
