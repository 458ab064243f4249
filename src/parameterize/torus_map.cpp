#include "foramen/parameterize/torus_map.hpp"

#include <cmath>
#include <cstdlib>
#include <string>

#include <Eigen/LU>

#include "foramen/core/error.hpp"
#include "parameterize/distortion.hpp"

namespace foramen {
namespace {

// One coordinate split into whole turns and a fraction in [0, 1).
struct SplitTurns {
  int whole;
  double fraction;
};

SplitTurns split(double turns) {
  const double floor = std::floor(turns), rest = turns - floor;
  if (rest < 1.0) return {static_cast<int>(floor), rest};
  return {static_cast<int>(floor) + 1, 0.0};  // -1e-17 - (-1) rounds to 1
}

// Lagrange reduction. The result satisfies |a| <= |b| and |a.b| <= |a|^2 / 2.
Mat2 reduced_basis(const Lattice& lattice) {
  Vec2 a = lattice.col(0), b = lattice.col(1);
  for (;;) {
    if (b.squaredNorm() < a.squaredNorm()) std::swap(a, b);
    const double steps = std::round(a.dot(b) / a.squaredNorm());
    const Vec2 shorter = b - steps * a;
    // A vector is replaced only by a strictly shorter one, so the reduction terminates in spite of rounding.
    if (steps == 0 || !(shorter.squaredNorm() < b.squaredNorm())) break;
    b = shorter;
  }
  Mat2 basis;
  basis << a, b;
  return basis;
}

// The upper triangular matrix with positive diagonal that differs from m by a rotation or a reflection.
Lattice upper_triangular(const Mat2& m) {
  const double length = m.col(0).norm();
  const Vec2 along = m.col(0) / length;
  Lattice out;
  out << length, along.dot(m.col(1)), 0, std::abs(m.determinant()) / length;
  return out;
}

// The two edge vectors from the first corner, in turns.
std::array<Vec2, 2> edges_in_turns(const Mesh& mesh, const TorusMap& map, FaceId f) {
  const auto c = mesh.corners(f);
  const Vec2i first = map.jumps[Mesh::halfedge(f, 0)], last = map.jumps[Mesh::halfedge(f, 2)];
  return {map.turns[c[1]] - map.turns[c[0]] + first.cast<double>(),
          map.turns[c[2]] - map.turns[c[0]] - last.cast<double>()};
}

}  // namespace

double wrap(double turns) { return split(turns).fraction; }

LatticeReducer::LatticeReducer(const Lattice& lattice)
    : reduced_(reduced_basis(lattice)), inverse_(reduced_.inverse()) {}

Vec2 LatticeReducer::shortest(const Vec2& plane_vector) const {
  const Vec2 turns = inverse_ * plane_vector;
  const Vec2 near = plane_vector - reduced_ * Vec2(std::round(turns.x()), std::round(turns.y()));
  Vec2 best = near;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) {
      const Vec2 candidate = near + reduced_ * Vec2(i, j);
      if (candidate.squaredNorm() < best.squaredNorm()) best = candidate;
    }
  return best;
}

std::array<Vec2, 3> plane_triangle(const Mesh& mesh, const TorusMap& map, FaceId f) {
  const Vec2 origin = map.lattice * map.turns[mesh.corners(f)[0]];
  const auto edges = edges_in_turns(mesh, map, f);
  return {origin, origin + map.lattice * edges[0], origin + map.lattice * edges[1]};
}

double signed_area(const Mesh& mesh, const TorusMap& map, FaceId f) {
  const auto turns = edges_in_turns(mesh, map, f);
  Vec4 edges;
  edges << map.lattice * turns[0], map.lattice * turns[1];
  return doubled_area(edges) / 2;
}

TorusMap wrapped(const Mesh& mesh, TorusMap map) {
  VertexMap<Vec2i> whole(mesh.vertex_count(), Vec2i::Zero());
  for (VertexId v : mesh.vertices()) {
    const SplitTurns u = split(map.turns[v].x()), w = split(map.turns[v].y());
    whole[v] = Vec2i(u.whole, w.whole);
    map.turns[v] = Vec2(u.fraction, w.fraction);
  }
  for (HalfedgeId h : mesh.halfedges()) map.jumps[h] += whole[mesh.to(h)] - whole[mesh.from(h)];
  return map;
}

TorusMap quantised(const Mesh& mesh, TorusMap map) {
  FORAMEN_ASSERT(map.turns.size() == mesh.vertex_count());
  const auto rounded = [](double turns) { return std::round(std::ldexp(turns, quantum_bits)); };
  for (Vec2& p : map.turns)
    p = Vec2(std::ldexp(rounded(p.x()), -quantum_bits), std::ldexp(rounded(p.y()), -quantum_bits));
  return map;
}

TorusMap change_basis(TorusMap map, const Eigen::Matrix2i& b) {
  const int det = b(0, 0) * b(1, 1) - b(0, 1) * b(1, 0);
  if (std::abs(det) != 1)
    throw InvalidInput("a change of the basis of periods needs determinant 1 or -1, found " +
                       std::to_string(det));
  const Mat2 real = b.cast<double>();
  for (Vec2& p : map.turns) p = real * p;
  for (Vec2i& t : map.jumps) t = b * t;
  map.lattice = upper_triangular(map.lattice * real.inverse());
  return map;
}

}  // namespace foramen
