#include "foramen/parameterize/torus_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <Eigen/LU>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen {
namespace {

__extension__ using Wide = __int128;  // products of two edge coordinates in quanta need up to 104 bits

/// Larger positions would overflow the integers below: 2^22 turns are 2^62 quanta, and edges are differences
/// of two positions.
constexpr double largest_turns = 1 << 20;
constexpr double degree_tolerance = 1e-9;

using Quanta = std::array<std::int64_t, 2>;

Quanta quanta(const Vec2& turns) {
  return {static_cast<std::int64_t>(std::ldexp(turns.x(), quantum_bits)),
          static_cast<std::int64_t>(std::ldexp(turns.y(), quantum_bits))};
}

Quanta edge(const Quanta& from, const Quanta& to, const Vec2i& jump) {
  constexpr std::int64_t turn = std::int64_t{1} << quantum_bits;
  return {to[0] - from[0] + jump.x() * turn, to[1] - from[1] + jump.y() * turn};
}

Wide cross(const Quanta& a, const Quanta& b) { return Wide{a[0]} * b[1] - Wide{a[1]} * b[0]; }

bool consistent_periods(const Mesh& mesh, const TorusMap& map) {
  for (HalfedgeId h : mesh.halfedges())
    if (!mesh.twin(h).valid() || map.jumps[mesh.twin(h)] != -map.jumps[h]) return false;
  for (FaceId f : mesh.faces()) {
    const Vec2i round =
        map.jumps[Mesh::halfedge(f, 0)] + map.jumps[Mesh::halfedge(f, 1)] + map.jumps[Mesh::halfedge(f, 2)];
    if (round != Vec2i::Zero()) return false;
  }
  return true;
}

void check_range(const TorusMap& map) {
  for (VertexId v : map.turns.ids())
    if (!(map.turns[v].cwiseAbs().maxCoeff() <= largest_turns))
      throw InvalidInput("the position of vertex " + std::to_string(v.index) +
                         " on the torus is not finite or too many turns away; wrap the map first");
}

}  // namespace

bool MapCertificate::valid() const {
  return flipped == 0 && std::abs(degree - 1) <= degree_tolerance && periods_consistent;
}

MapCertificate certify(const Mesh& mesh, const TorusMap& map) {
  check_range(map);
  const TorusMap exact = quantised(mesh, map);
  VertexMap<Quanta> position(mesh.vertex_count());
  for (VertexId v : mesh.vertices()) position[v] = quanta(exact.turns[v]);

  // Plane areas are det L times areas in turns, so their signs can be computed in turns, where areas are
  // integers.
  const int orientation = map.lattice.determinant() > 0 ? 1 : -1;
  const double domain = std::ldexp(1.0, 2 * quantum_bits + 1);  // twice the unit square, in squared quanta
  const double surface = total_area(mesh);
  MapCertificate c;
  c.triangles = mesh.face_count();
  c.smallest_area_ratio = std::numeric_limits<double>::infinity();
  c.largest_area_ratio = -std::numeric_limits<double>::infinity();
  c.periods_consistent = consistent_periods(mesh, exact);
  Wide sum = 0;
  for (FaceId f : mesh.faces()) {
    const auto v = mesh.corners(f);
    const Quanta a = edge(position[v[0]], position[v[1]], exact.jumps[Mesh::halfedge(f, 0)]);
    const Quanta b = edge(position[v[0]], position[v[2]], -exact.jumps[Mesh::halfedge(f, 2)]);
    const Wide doubled = orientation * cross(a, b);
    sum += doubled;
    if (doubled <= 0) ++c.flipped;
    const double ratio = static_cast<double>(doubled) / domain / (area(mesh.triangle(f)) / surface);
    c.smallest_area_ratio = std::min(c.smallest_area_ratio, ratio);
    c.largest_area_ratio = std::max(c.largest_area_ratio, ratio);
  }
  c.degree = static_cast<double>(sum) / domain;
  return c;
}

}  // namespace foramen
