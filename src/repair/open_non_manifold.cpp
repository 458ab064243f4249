#include "repair/open_non_manifold.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "foramen/core/geometry.hpp"
#include "repair/edge_sides.hpp"

namespace foramen::repair_detail {
namespace {

// Largest number of rounds. More than one is needed if flaps are attached to flaps.
constexpr int rounds = 10;

std::size_t face(const Side& side) { return side.halfedge / 3; }

struct Pieces {
  std::vector<std::size_t> of_face;  // smallest face index of the piece of each face
  std::vector<std::size_t> by_area;  // pieces in order of area, smallest first
};

// The pieces of triangles that are connected across edges with exactly two triangles.
Pieces pieces_of(const TriangleSoup& soup, const EdgeSides& edges) {
  DisjointSets sets(soup.triangles.size());
  for (std::size_t e = 0; e < edges.edge_count(); ++e)
    if (const auto sides = edges.sides(e); sides.size() == 2) sets.join(face(sides[0]), face(sides[1]));
  Pieces pieces;
  std::map<std::size_t, double> areas;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const auto& t = soup.triangles[f];
    pieces.of_face.push_back(sets.root(f));
    areas[sets.root(f)] += area({soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]});
  }
  for (const auto& [piece, size] : areas) pieces.by_area.push_back(piece);
  std::stable_sort(pieces.by_area.begin(), pieces.by_area.end(),
                   [&](std::size_t a, std::size_t b) { return areas.at(a) < areas.at(b); });
  return pieces;
}

// For each piece and each non-manifold edge, the number of sides of the piece on the edge.
using Attachments = std::map<std::size_t, std::map<std::size_t, int>>;

Attachments attachments(const EdgeSides& edges, const Pieces& pieces) {
  Attachments found;
  for (std::size_t e = 0; e < edges.edge_count(); ++e)
    if (const auto sides = edges.sides(e); sides.size() > 2)
      for (const Side& side : sides) ++found[pieces.of_face[face(side)]][e];
  return found;
}

// Whether a piece has a border at some non-manifold edge, and each of its non-manifold edges has at least two
// other sides.
bool is_flap(const std::map<std::size_t, int>& hangs_on, const std::map<std::size_t, int>& sides_left) {
  bool ends = false;
  for (const auto& [edge, count] : hangs_on) {
    if (sides_left.at(edge) - count < 2) return false;
    ends = ends || count % 2 == 1;
  }
  return ends;
}

std::vector<Vec3> drop_flaps(RawSurface& surface) {
  const EdgeSides edges(surface.soup.triangles);
  const Pieces pieces = pieces_of(surface.soup, edges);
  Attachments hanging = attachments(edges, pieces);
  std::map<std::size_t, int> sides_left;
  for (const auto& [piece, on] : hanging)
    for (const auto& [edge, count] : on) sides_left[edge] += count;

  std::map<std::size_t, std::pair<Vec3, int>> dropped;  // sum of triangle centres and number of triangles
  for (int round = 0; round < rounds; ++round) {
    const std::size_t before = dropped.size();
    for (std::size_t k = 0; k + 1 < pieces.by_area.size(); ++k) {
      const auto piece = hanging.find(pieces.by_area[k]);
      if (piece == hanging.end() || !is_flap(piece->second, sides_left)) continue;
      for (const auto& [edge, count] : piece->second) sides_left[edge] -= count;
      dropped[piece->first] = {Vec3::Zero(), 0};
      hanging.erase(piece);
    }
    if (dropped.size() == before) break;
  }
  std::vector<char> kept;
  for (std::size_t f = 0; f < pieces.of_face.size(); ++f) {
    const auto piece = dropped.find(pieces.of_face[f]);
    kept.push_back(piece == dropped.end() ? 1 : 0);
    if (piece == dropped.end()) continue;
    piece->second.first += centre(surface.soup, surface.soup.triangles[f]);
    ++piece->second.second;
  }
  keep_triangles(surface, kept);
  std::vector<Vec3> positions;
  for (const auto& [piece, sum] : dropped) positions.emplace_back(sum.first / sum.second);
  return positions;
}

// Sides of one edge that stay connected: two, or one that has no partner.
using Strand = std::vector<Side>;

// Pairs the sides of an edge. Sorted by angle around the edge, each backward side and the forward side that
// follows it have solid between them.
std::vector<Strand> strands(const TriangleSoup& soup, std::span<const Side> sides) {
  if (sides.size() <= 2) return {Strand(sides.begin(), sides.end())};
  const Vec3 &low = soup.points[sides[0].low], &high = soup.points[sides[0].high];
  Vec3 axis = (high - low).normalized();
  if (!(axis.norm() > 0.5)) axis = Vec3::UnitZ();  // the ends coincide up to rounding
  const Vec3 across = axis.unitOrthogonal(), third = axis.cross(across);
  std::vector<std::pair<double, Side>> round;
  for (const Side& side : sides) {
    const auto& t = soup.triangles[face(side)];
    const Vec3 arm = soup.points[t[(side.halfedge + 2) % 3]] - low;
    round.emplace_back(std::atan2(arm.dot(third), arm.dot(across)), side);
  }
  std::sort(round.begin(), round.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.halfedge < b.second.halfedge;
  });
  std::vector<Strand> out;
  std::vector<char> taken(round.size(), 0);
  for (std::size_t i = 0; i < round.size(); ++i) {
    const std::size_t j = (i + 1) % round.size();
    if (round[i].second.forward || !round[j].second.forward) continue;
    taken[i] = taken[j] = 1;
    out.push_back({round[i].second, round[j].second});
  }
  for (std::size_t i = 0; i < round.size(); ++i)
    if (taken[i] == 0) out.push_back({round[i].second});
  return out;
}

std::size_t corner_at_low(const Side& s) {
  const int f = s.halfedge / 3, k = s.halfedge % 3;
  return 3 * f + (s.forward ? k : (k + 1) % 3);
}
std::size_t corner_at_high(const Side& s) {
  const int f = s.halfedge / 3, k = s.halfedge % 3;
  return 3 * f + (s.forward ? (k + 1) % 3 : k);
}

// Gives each fan of triangles at a point a point of its own; the first fan keeps the old one. Returns the
// number of fans of each point.
std::vector<int> double_points(RawSurface& surface, DisjointSets& fans) {
  TriangleSoup& soup = surface.soup;
  std::vector<int> count(soup.points.size(), 0);
  std::map<std::size_t, int> point_of_fan;
  for (std::size_t c = 0; c < 3 * soup.triangles.size(); ++c) {
    int& corner = soup.triangles[c / 3][c % 3];
    const std::size_t fan = fans.root(c);
    auto [entry, is_new] = point_of_fan.emplace(fan, corner);
    if (is_new && ++count[corner] > 1) {
      entry->second = static_cast<int>(soup.points.size());
      const Vec3 position = soup.points[corner];
      soup.points.push_back(position);
      surface.origin.push_back(surface.origin[corner]);
    }
    corner = entry->second;
  }
  return count;
}

// Splits the edge of a strand at its midpoint. False if a triangle of the strand was split before.
bool divide(RawSurface& surface, const Strand& strand, std::vector<char>& divided) {
  TriangleSoup& soup = surface.soup;
  for (const Side& side : strand)
    if (divided[face(side)] != 0) return false;
  const int middle = static_cast<int>(soup.points.size());
  for (const Side& side : strand) {
    const std::size_t from = side.halfedge % 3, to = (from + 1) % 3;
    std::array<int, 3> first = soup.triangles[face(side)], second = first;
    if (std::ssize(soup.points) == middle) {
      const Vec3 position = (soup.points[first[from]] + soup.points[first[to]]) / 2;
      soup.points.push_back(position);
      surface.origin.push_back(-1);
    }
    first[to] = second[from] = middle;
    soup.triangles[face(side)] = first;
    soup.triangles.push_back(second);
    divided[face(side)] = 1;
  }
  return true;
}

std::vector<Vec3> non_manifold_edges(const TriangleSoup& soup) {
  const EdgeSides edges(soup.triangles);
  std::vector<Vec3> middles;
  for (std::size_t e = 0; e < edges.edge_count(); ++e)
    if (const auto sides = edges.sides(e); sides.size() > 2)
      middles.emplace_back((soup.points[sides[0].low] + soup.points[sides[0].high]) / 2);
  return middles;
}

// Separates strands and fans. Returns the doubled points that are not on non-manifold edges.
std::vector<Vec3> take_apart(RawSurface& surface) {
  TriangleSoup& soup = surface.soup;
  const EdgeSides edges(soup.triangles);
  DisjointSets fans(3 * soup.triangles.size());
  std::vector<std::vector<Strand>> opened;
  std::vector<char> on_opened(soup.points.size(), 0);
  for (std::size_t e = 0; e < edges.edge_count(); ++e) {
    auto here = strands(soup, edges.sides(e));
    for (const Strand& strand : here)
      for (const Side& side : strand) {
        fans.join(corner_at_low(side), corner_at_low(strand[0]));
        fans.join(corner_at_high(side), corner_at_high(strand[0]));
      }
    if (here.size() < 2) continue;
    on_opened[here[0][0].low] = on_opened[here[0][0].high] = 1;
    opened.push_back(std::move(here));
  }
  const std::vector<int> fan_count = double_points(surface, fans);
  std::vector<Vec3> doubled;
  for (std::size_t v = 0; v < on_opened.size(); ++v)
    if (fan_count[v] > 1 && on_opened[v] == 0) doubled.push_back(soup.points[v]);

  // If two strands of an edge still share both ends, one of them gets a new point at the middle of the edge.
  std::vector<char> divided(soup.triangles.size(), 0);
  for (const auto& here : opened) {
    std::vector<std::pair<std::size_t, std::size_t>> ends;
    for (const Strand& strand : here) {
      const std::pair of_strand(fans.root(corner_at_low(strand[0])), fans.root(corner_at_high(strand[0])));
      if (std::find(ends.begin(), ends.end(), of_strand) != ends.end()) divide(surface, strand, divided);
      ends.push_back(of_strand);
    }
  }
  return doubled;
}

}  // namespace

OpenedPlaces open_non_manifold(RawSurface& surface) {
  OpenedPlaces places;
  places.edges = non_manifold_edges(surface.soup);
  if (!places.edges.empty()) places.flaps = drop_flaps(surface);
  places.vertices = take_apart(surface);
  // A triangle is split at most once per round, so several rounds may be needed.
  for (int round = 1; round < rounds && !non_manifold_edges(surface.soup).empty(); ++round)
    take_apart(surface);
  return places;
}

}  // namespace foramen::repair_detail
