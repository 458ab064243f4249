#pragma once
/// \file
/// A map of a closed genus-1 surface to the flat torus R^2 / L Z^2, without a cut.

#include "foramen/core/mesh.hpp"

namespace foramen {

/// x - floor(x) in [0, 1), also for -1e-17, whose difference rounds to 1.
double wrap(double turns);

/// Columns: the periods of the two loops in the plane. Upper triangular, det > 0; det = 1 once normalised.
using Lattice = Mat2;

/// The shortest representative of a plane vector modulo the lattice: reduced basis (Lagrange), nine
/// candidates.
class LatticeReducer {
 public:
  explicit LatticeReducer(const Lattice& lattice);
  Vec2 shortest(const Vec2& plane_vector) const;

 private:
  Mat2 reduced_, inverse_;
};

/// Positions in turns, and the integer jump of every halfedge: the edge i -> j is L (p_j + t_ij - p_i) in the
/// plane.
struct TorusMap {
  Lattice lattice = Lattice::Identity();
  VertexMap<Vec2> turns;     ///< one turn = one period
  HalfedgeMap<Vec2i> jumps;  ///< t_ij; jumps[twin(h)] == -jumps[h], and they sum to zero round every face
};

/// The three corners of a face in the plane, the first at L p_i, the others continued across cuts.
std::array<Vec2, 3> plane_triangle(const Mesh& mesh, const TorusMap& map, FaceId f);
/// Signed area in the plane; the domain's is det(lattice).
double signed_area(const Mesh& mesh, const TorusMap& map, FaceId f);
/// The same map with all positions in [0, 1)^2 and jumps to match: points that left the rectangle enter on
/// the opposite side.
TorusMap wrapped(const Mesh& mesh, TorusMap map);
/// Positions of a quantised map are multiples of 2^-quantum_bits turns.
inline constexpr int quantum_bits = 40;
/// The same map with positions rounded to multiples of 2^-40 turns, so that p + t is exact and orientation
/// tests are.
TorusMap quantised(const Mesh& mesh, TorusMap map);
/// jumps -> B jumps, positions -> B p, lattice -> L B^-1 turned until it is upper triangular with det > 0:
/// the same map in another basis of periods. Lengths stay; areas too if det B = 1, and change their sign if
/// det B = -1. InvalidInput for other det.
TorusMap change_basis(TorusMap map, const Eigen::Matrix2i& b);

}  // namespace foramen
