#pragma once
/// \file
/// A map of a closed genus-1 surface to the flat torus R^2 / L Z^2, without a cut: its data, the certificate
/// that it is one to one, and how its energy is minimised.

#include <string_view>
#include <utility>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"

namespace foramen {

/// x - floor(x), in [0, 1) for every finite x; for -1e-17, whose difference rounds to 1, it is 0.
double wrap(double turns);

/// A matrix whose columns are the periods of the two loops in the plane. Upper triangular, det > 0; det = 1
/// after normalisation.
using Lattice = Mat2;

/// Finds the shortest representative of a plane vector modulo the lattice, among nine candidates in a
/// Lagrange-reduced basis.
class LatticeReducer {
 public:
  explicit LatticeReducer(const Lattice& lattice);
  Vec2 shortest(const Vec2& plane_vector) const;

 private:
  Mat2 reduced_, inverse_;
};

/// A map to the torus: positions p in turns and an integer jump t_ij for every halfedge. In the plane the
/// halfedge i -> j is the vector L (p_j + t_ij - p_i).
struct TorusMap {
  Lattice lattice = Lattice::Identity();
  VertexMap<Vec2> turns;  ///< one turn = one period
  /// The jumps t_ij; jumps[twin(h)] == -jumps[h], and the jumps around every face sum to zero.
  HalfedgeMap<Vec2i> jumps;
};

/// The three corners of a face in the plane: the first at L p_i, the others displaced by the jumps.
std::array<Vec2, 3> plane_triangle(const Mesh& mesh, const TorusMap& map, FaceId f);
/// Signed area of a face in the plane. The area of the domain is det(lattice).
double signed_area(const Mesh& mesh, const TorusMap& map, FaceId f);
/// The same map with all positions in [0, 1)^2 and the jumps changed accordingly.
TorusMap wrapped(const Mesh& mesh, TorusMap map);
/// Positions of a quantised map are multiples of 2^-quantum_bits turns.
inline constexpr int quantum_bits = 40;
/// The same map with positions rounded to multiples of 2^-40 turns, so that p + t and orientation tests are
/// exact.
TorusMap quantised(const Mesh& mesh, TorusMap map);
/// The same map in another basis of periods: jumps B t, positions B p and the lattice L B^-1, rotated or
/// reflected to be upper triangular with det > 0. Lengths in the plane do not change. Signed areas do not
/// change if det B = 1 and change their sign if det B = -1. Throws InvalidInput for any other determinant.
TorusMap change_basis(TorusMap map, const Eigen::Matrix2i& b);

/// The result of certify().
struct MapCertificate {
  int triangles = 0;
  int flipped = 0;  ///< triangles of non-positive signed area, by exact integer arithmetic; must be 0
  /// Plane area / surface area of a triangle, where the total areas are normalised to 1.
  double smallest_area_ratio = 0;
  double largest_area_ratio = 0;
  double degree = 0;                ///< sum of signed areas / area of the domain; 1 for a map of degree one
  bool periods_consistent = false;  ///< jumps are antisymmetric and sum to zero around every face
  bool valid() const;               ///< no flipped triangle, degree 1 within 1e-9, periods consistent
};

/// Computes the certificate of a map. Positions that are not quantised (see quantised()) are quantised first.
MapCertificate certify(const Mesh& mesh, const TorusMap& map);

/// The method of minimisation.
enum class Optimiser {
  newton,         ///< projected Newton over all vertices at once
  polak_ribiere,  ///< the paper's node-wise conjugate gradients
};
template <>
struct EnumWords<Optimiser> {
  static constexpr std::pair<std::string_view, Optimiser> all[] = {
      {"newton", Optimiser::newton}, {"polak-ribiere", Optimiser::polak_ribiere}};
};

/// Weights of triangles and vertices in the energy. With `area` they are shares of the surface area, so the
/// energy is an area-weighted mean that does not depend on the triangulation. With `each` the energy is sum
/// over vertices of E_cor + lambda sum over triangles of E, the form of the paper (eq. 4).
enum class Weighting { area, each };
template <>
struct EnumWords<Weighting> {
  static constexpr std::pair<std::string_view, Weighting> all[] = {{"area", Weighting::area},
                                                                   {"each", Weighting::each}};
};

}  // namespace foramen
