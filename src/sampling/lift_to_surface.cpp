#include "sampling/lift_to_surface.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <string>

#include "foramen/core/error.hpp"
#include "sampling/fixed_torus.hpp"

namespace foramen {
namespace {

using detail::cross;
using detail::Fixed2;
using detail::fixed_bits;
using detail::fixed_turn;
using detail::Int128;

// A cell with more faces than this is subdivided, to at most this depth.
constexpr std::size_t crowded = 12;
constexpr int deepest = 8;
// A cell is subdivided only if its parts have at most this share of its faces on average. Near a vertex,
// where all parts have the same faces, a subdivision does not help.
constexpr double least_thinning = 0.6;

/// Cells per side, as a power of two, for about two faces per cell.
int side_bits(std::size_t faces) { return static_cast<int>(std::bit_width(faces / 2 + 1)) / 2; }

template <class Place>
Fixed2 fixed(const Place& p) {
  return {p.x, p.y};
}

/// Whether a point with orientation `o` relative to an edge of direction d counts as inside. A point exactly
/// on the edge is shifted by (e, e^2) with e -> 0, which changes the orientation by d.x e^2 - d.y e.
bool inside(Int128 o, Fixed2 d) {
  if (o != 0) return o > 0;
  return d.y != 0 ? d.y < 0 : d.x > 0;
}

/// Whether a positively oriented triangle may touch a closed square that its bounding box touches; false if
/// the square lies outside one of its edges.
bool touches_square(const std::array<Fixed2, 3>& t, Fixed2 low, std::int64_t size) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Fixed2 a = t[k], d = t[(k + 1) % 3] - a;
    const Fixed2 innermost{d.y > 0 ? low.x : low.x + size, d.x > 0 ? low.y + size : low.y};
    if (cross(d, innermost - a) < 0) return false;
  }
  return true;
}

[[noreturn]] void throw_not_positive(int face) {
  throw InvalidInput("torus map: triangle " + std::to_string(face) +
                     " has no positive area on the torus (in steps of 2^-40 turns); "
                     "only maps without flipped triangles can be inverted");
}

}  // namespace

TorusLocator::TorusLocator(const Mesh& mesh, const TorusMap& map) : mesh_(mesh) {
  FORAMEN_ASSERT(map.turns.size() == mesh.vertex_count() && map.jumps.size() == mesh.halfedge_count());
  for (VertexId v : mesh.vertices())
    if (!detail::representable(map.turns[v]))
      throw InvalidInput("torus map: vertex " + std::to_string(v.index) +
                         " is not within 4096 turns of zero");

  places_.reserve(mesh.vertex_count());
  for (VertexId v : mesh.vertices()) {
    const Fixed2 p = detail::to_fixed(map.turns[v]);
    places_.push_back({p.x, p.y});
  }
  turns_.resize(mesh.face_count());
  std::vector<Entry> entries;
  entries.reserve(turns_.size() + turns_.size() / 8);
  Int128 doubled_area = 0;
  for (FaceId f : mesh.faces()) {
    const auto c = mesh.corners(f);
    std::array<Fixed2, 3> p;
    std::array<Vec2i, 3> to_corner;
    Vec2i jump = Vec2i::Zero();
    for (int k = 0; k < 3; ++k) {
      to_corner[k] = jump;
      p[k] = fixed(places_[c[k].index]) + detail::whole_turns(jump);
      jump += map.jumps[Mesh::halfedge(f, k)];
    }
    const Int128 doubled = detail::orientation(p[0], p[1], p[2]);
    if (jump != Vec2i::Zero())
      throw InvalidInput("torus map: the jumps round triangle " + std::to_string(f.index) +
                         " do not sum to zero");
    if (doubled <= 0) throw_not_positive(f.index);
    doubled_area += doubled;

    const Fixed2 low{std::min({p[0].x, p[1].x, p[2].x}), std::min({p[0].y, p[1].y, p[2].y})};
    const Vec2i floor = detail::floor_turns(low);
    for (int k = 0; k < 3; ++k) {
      const Vec2i turns = to_corner[k] - floor;
      turns_[f.index][k] = {static_cast<std::int16_t>(turns.x()), static_cast<std::int16_t>(turns.y())};
    }
    const Fixed2 high = Fixed2{std::max({p[0].x, p[1].x, p[2].x}), std::max({p[0].y, p[1].y, p[2].y})} -
                        detail::whole_turns(floor);
    const Vec2i last = detail::floor_turns(high);
    for (int y = 0; y <= last.y(); ++y)
      for (int x = 0; x <= last.x(); ++x)
        entries.push_back({f.index, static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)});
  }
  // If all triangles are positive and their areas sum to that of the torus, the map has degree 1 and covers
  // every point once.
  if (doubled_area != 2 * Int128{fixed_turn} * fixed_turn)
    throw InvalidInput("torus map: its triangles cover the torus " +
                       std::to_string(static_cast<double>(doubled_area) / 2 /
                                      static_cast<double>(fixed_turn) / static_cast<double>(fixed_turn)) +
                       " times, not once; are its periods right?");
  build_grid(entries, {0, 0}, fixed_bits, 0);
  cells_.shrink_to_fit();
  entries_.shrink_to_fit();
}

std::array<TorusLocator::Place, 3> TorusLocator::corners(int face) const {
  const auto& vertices = mesh_.triangles()[face];
  const auto& turns = turns_[face];
  std::array<Place, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Place& p = places_[vertices[k]];
    corners[k] = {p.x + turns[k][0] * fixed_turn, p.y + turns[k][1] * fixed_turn};
  }
  return corners;
}

int TorusLocator::build_grid(const std::vector<Entry>& entries, Place corner, int size_bits, int depth) {
  const int bits = std::min(side_bits(entries.size()), size_bits);
  const int shift = size_bits - bits;
  const int side = 1 << bits;
  const std::size_t cell_count = std::size_t{1} << (2 * bits);
  std::vector<std::vector<Entry>> cells(cell_count);
  std::size_t stored = 0;
  for (const Entry& e : entries) {
    const std::array<Place, 3> t = corners(e.face);
    const Fixed2 origin = Fixed2{corner.x + e.x * fixed_turn, corner.y + e.y * fixed_turn};
    const std::array p{fixed(t[0]) - origin, fixed(t[1]) - origin, fixed(t[2]) - origin};
    const auto cell_of = [&](std::int64_t x) {
      return static_cast<int>(std::clamp<std::int64_t>(x >> shift, 0, side - 1));
    };
    const int last_x = cell_of(std::max({p[0].x, p[1].x, p[2].x}));
    const int last_y = cell_of(std::max({p[0].y, p[1].y, p[2].y}));
    for (int y = cell_of(std::min({p[0].y, p[1].y, p[2].y})); y <= last_y; ++y)
      for (int x = cell_of(std::min({p[0].x, p[1].x, p[2].x})); x <= last_x; ++x)
        if (touches_square(p, {std::int64_t{x} << shift, std::int64_t{y} << shift},
                           std::int64_t{1} << shift)) {
          cells[y * side + x].push_back(e);
          ++stored;
        }
  }
  if (depth > 0 && static_cast<double>(stored) >
                       least_thinning * static_cast<double>(entries.size()) * static_cast<double>(cell_count))
    return -1;

  const int id = static_cast<int>(grids_.size());
  const int first_cell = static_cast<int>(cells_.size());
  grids_.push_back({shift, bits, first_cell});
  cells_.resize(cells_.size() + cell_count);
  for (int i = 0; i < static_cast<int>(cell_count); ++i) {
    const auto& own = cells[i];
    const Place own_corner{corner.x + (std::int64_t{i % side} << shift),
                           corner.y + (std::int64_t{i / side} << shift)};
    const bool divide = own.size() > crowded && shift > 0 && depth < deepest;
    const int finer = divide ? build_grid(own, own_corner, shift, depth + 1) : -1;
    Cell& cell = cells_[first_cell + i];
    cell.grid = finer;
    if (finer >= 0) continue;
    cell.first = static_cast<int>(entries_.size());
    entries_.insert(entries_.end(), own.begin(), own.end());
    cell.last = static_cast<int>(entries_.size());
  }
  return id;
}

SurfacePoint TorusLocator::locate(const Vec2& turns) const {
  if (!detail::representable(turns)) throw InvalidInput("a torus position is not within 4096 turns of zero");
  constexpr std::int64_t fraction = fixed_turn - 1;
  Fixed2 q = detail::to_fixed(turns);
  q = {q.x & fraction, q.y & fraction};

  const Cell* cell = nullptr;
  for (int g = 0; g >= 0; g = cell->grid) {
    const Grid& grid = grids_[g];
    const std::int64_t mask = (std::int64_t{1} << grid.bits) - 1;
    const auto x = (q.x >> grid.shift) & mask, y = (q.y >> grid.shift) & mask;
    cell = &cells_[grid.first_cell + (y << grid.bits) + x];
  }
  for (int i = cell->first; i < cell->last; ++i) {
    const Entry& entry = entries_[i];
    const std::array<Place, 3> t = corners(entry.face);
    const Fixed2 p = q + Fixed2{entry.x * fixed_turn, entry.y * fixed_turn};
    const Fixed2 a = fixed(t[0]), b = fixed(t[1]), c = fixed(t[2]);
    const Int128 against_a = cross(c - b, p - b);
    if (!inside(against_a, c - b)) continue;
    const Int128 against_b = cross(a - c, p - c);
    if (!inside(against_b, a - c)) continue;
    const Int128 against_c = cross(b - a, p - a);
    if (!inside(against_c, b - a)) continue;
    const double whole = static_cast<double>(against_a + against_b + against_c);
    return {FaceId(entry.face), Vec3(static_cast<double>(against_a), static_cast<double>(against_b),
                                     static_cast<double>(against_c)) /
                                    whole};
  }
  throw InternalError("no triangle of the torus map contains a point of the torus");
}

std::vector<SurfacePoint> TorusLocator::locate(std::span<const Vec2> turns) const {
  std::vector<SurfacePoint> found;
  found.reserve(turns.size());
  for (const Vec2& t : turns) found.push_back(locate(t));
  return found;
}

std::vector<Vec3> lift_to_surface(const TorusLocator& locator, std::span<const Vec2> turns) {
  std::vector<Vec3> points;
  points.reserve(turns.size());
  for (const Vec2& t : turns) points.push_back(position(locator.mesh(), locator.locate(t)));
  return points;
}

}  // namespace foramen
