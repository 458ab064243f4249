#include "sampling/lloyd.hpp"

#include <numbers>

#include "core/parallel.hpp"

namespace foramen::detail {
namespace {

// Number of times that a move that flips a triangle is halved before it is taken back.
constexpr int halvings = 3;
constexpr int landmarks_per_task = 256;
// Moves are this many times as long as the way to the centroid, which halves the number of rounds for the
// same quality. With factors above 2 the iteration does not converge.
constexpr double over_relaxation = 1.6;

/// The one-ring of a landmark unfolded to the plane: the landmark is at 0, neighbours are at their
/// distances, and the angles between them are scaled to sum to 2 pi.
struct Unfolded {
  std::vector<int> halfedges;   // outgoing halfedges of the landmark, counter-clockwise
  std::vector<Vec2> neighbour;  // end of halfedge k; triangle k is between halfedges k and k + 1
  std::vector<double> weight;   // weights at the neighbours
  double own_weight = 0;
};

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

void unfold(const LandmarkState& s, int v, Unfolded& out) {
  out.halfedges.clear();
  out.neighbour.clear();
  out.weight.clear();
  s.mesh.for_each_outgoing(v, [&](int h) { out.halfedges.push_back(h); });
  out.own_weight = s.density[v] * s.density[v];
  const std::size_t n = out.halfedges.size();
  double total = 0;
  for (int h : out.halfedges)
    total += angle_between(s.point[s.mesh.to(h)] - s.point[v], s.point[s.mesh.apex(h)] - s.point[v]);
  const double scale = total > 0 ? 2 * std::numbers::pi / total : 0.0;
  double angle = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const int h = out.halfedges[k];
    const int w = s.mesh.to(h);
    const Vec3 edge = s.point[w] - s.point[v];
    out.neighbour.push_back(edge.norm() * Vec2(std::cos(angle), std::sin(angle)));
    out.weight.push_back(s.density[w] * s.density[w]);
    angle += scale * angle_between(edge, s.point[s.mesh.apex(h)] - s.point[v]);
  }
}

double cross2(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The corner of the Voronoi cell of the landmark in the triangle (0, a, b): the circumcentre, or the
/// midpoint of the longest side if the circumcentre lies outside.
Vec2 cell_corner(const Vec2& a, const Vec2& b) {
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), cc = (a - b).squaredNorm();
  if (aa >= bb + cc) return a / 2;
  if (bb >= aa + cc) return b / 2;
  if (cc >= aa + bb) return (a + b) / 2;
  const double twice = 2 * cross2(a, b);
  return Vec2(b.y() * aa - a.y() * bb, a.x() * bb - b.x() * aa) / twice;
}

/// Mass and first moment of polygons with linear weight, accumulated over triangles.
struct Moments {
  double mass = 0;
  Vec2 first = Vec2::Zero();
  void add(const Vec2& a, const Vec2& b, double weight_origin, double weight_a, double weight_b) {
    const double area = 0.5 * cross2(a, b), sum = weight_origin + weight_a + weight_b;
    mass += area * sum / 3;
    first += area / 12 * (a * (weight_a + sum) + b * (weight_b + sum));
  }
};

Vec2 cell_centroid(const Unfolded& ring) {
  const std::size_t n = ring.neighbour.size();
  Moments cell;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t l = (k + 1) % n;
    const Vec2 &a = ring.neighbour[k], &b = ring.neighbour[l];
    const double here = ring.own_weight;
    const double weight_corner = (here + ring.weight[k] + ring.weight[l]) / 3;
    const Vec2 corner = cell_corner(a, b);
    cell.add(a / 2, corner, here, (here + ring.weight[k]) / 2, weight_corner);
    cell.add(corner, b / 2, here, weight_corner, (here + ring.weight[l]) / 2);
  }
  return cell.mass > 0 ? Vec2(cell.first / cell.mass) : Vec2(Vec2::Zero());
}

/// The displacement of a landmark, in multiples of 2^-40 turns.
struct Move {
  Vec2 turns = Vec2::Zero();
};

/// The displacement on the torus that corresponds to a target in the unfolded one-ring, by linear
/// interpolation in the triangle that contains the target.
Move to_torus(const LandmarkState& s, const Unfolded& ring, const Vec2& target) {
  const std::size_t n = ring.neighbour.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 &a = ring.neighbour[k], &b = ring.neighbour[(k + 1) % n];
    const double whole = cross2(a, b), to_a = cross2(target, b), to_b = cross2(a, target);
    if (!(whole > 0) || to_a < 0 || to_b < 0) continue;
    const double share_a = to_a / whole, share_b = to_b / whole;
    if (share_a + share_b >= 1) return {};  // the target is outside the one-ring: no displacement
    const Fixed2 pa = s.mesh.along(ring.halfedges[k]),
                 pb = -s.mesh.along(TorusTriangulation::prev(ring.halfedges[k]));
    const Vec2 fa(static_cast<double>(pa.x), static_cast<double>(pa.y)),
        fb(static_cast<double>(pb.x), static_cast<double>(pb.y));
    return {share_a * fa + share_b * fb};
  }
  return {};
}

Fixed2 rounded(const Vec2& fixed) { return {std::llround(fixed.x()), std::llround(fixed.y())}; }

/// Makes all moves. If a triangle flips or nearly vanishes, the moves of its corners are halved and finally
/// taken back. Without moves no triangle does, so this terminates.
void make_moves(TorusTriangulation& mesh, const std::vector<Move>& moves) {
  std::vector<Fixed2> old(moves.size());
  std::vector<int> taken_back(moves.size(), 0);
  const auto place = [&](int v) {
    const int k = taken_back[v];
    mesh.set_place(v, k > halvings ? old[v] : old[v] + rounded(moves[v].turns * std::ldexp(1.0, -k)));
  };
  std::vector<Int128> area_before(mesh.face_slots(), 0);
  for (int f = 0; f < mesh.face_slots(); ++f)
    if (mesh.face_alive(f)) area_before[f] = mesh.doubled_area(f);
  for (int v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.alive(v)) {
      old[v] = mesh.place(v);
      place(v);
    }
  std::vector<int> suspects;
  for (int f = 0; f < mesh.face_slots(); ++f)
    if (mesh.face_alive(f)) suspects.push_back(f);
  while (!suspects.empty()) {
    std::vector<int> changed;
    for (int f : suspects)
      if (!TorusTriangulation::keeps_area(mesh.doubled_area(f), area_before[f]))
        for (int v : mesh.corners(f)) changed.push_back(v);
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    suspects.clear();
    for (int v : changed) {
      ++taken_back[v];
      place(v);
      mesh.for_each_outgoing(v, [&](int h) { suspects.push_back(h / 3); });
    }
    std::sort(suspects.begin(), suspects.end());
    suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
  }
}

}  // namespace

void lloyd_round(LandmarkState& s, const DenseSurface& surface, const RunContext& ctx) {
  const int slots = s.mesh.vertex_slots();
  const int tasks = (slots + landmarks_per_task - 1) / landmarks_per_task;
  const auto for_each_landmark = [&](auto&& body) {
    parallel_for(tasks, ctx, [&](int task) {
      Unfolded ring;
      for (int v = task * landmarks_per_task; v < std::min(slots, (task + 1) * landmarks_per_task); ++v)
        if (s.mesh.alive(v)) body(v, ring);
    });
  };
  std::vector<Move> moves(slots);
  for_each_landmark([&](int v, Unfolded& ring) {
    unfold(s, v, ring);
    moves[v] = to_torus(s, ring, over_relaxation * cell_centroid(ring));
  });
  make_moves(s.mesh, moves);
  for_each_landmark([&](int v, Unfolded&) { s.update(v, surface); });
}

}  // namespace foramen::detail
