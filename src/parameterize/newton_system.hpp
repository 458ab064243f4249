#pragma once
/// \file
/// Gradient and positive semi-definite Hessian of the map energy, assembled from its triangles.

#include <vector>

#include "parameterize/block_cholesky.hpp"
#include "parameterize/map_energy.hpp"

namespace foramen {

/// The lattices of determinant r^2: L = r [[e^u, b], [0, e^-u]]. The surface is scaled to the domain, so the
/// energy does not depend on the determinant, and two of the three entries are free.
struct LatticeShape {
  double size = 1, stretch = 0, shear = 0;  ///< r, u, b
  explicit LatticeShape(const Lattice& lattice);
  Lattice lattice() const;
  Lattice along_stretch() const;  ///< dL/du
  Lattice along_shear() const;    ///< dL/db
  Lattice curvature() const;      ///< d2L/du2
  LatticeShape moved(const Vec2& by) const;
};

/// The second-order model of the energy in (x, u, b). The part of the lattice is zero unless the lattice is
/// free.
class NewtonSystem {
 public:
  NewtonSystem(const MapEnergy& energy, bool free_lattice);

  /// Computes the members below for this state.
  /// \param kept  share of negative eigenvalues of a triangle that is kept, see damped_distortion_term()
  void assemble(const MapState& state, double kept = 0);

  double value = 0;
  Eigen::VectorXd gradient;  ///< 2 per vertex
  BlockMatrix hessian;
  Vec2 lattice_gradient = Vec2::Zero();
  Eigen::MatrixX2d lattice_coupling;  ///< d2E/dx d(u,b)
  Mat2 lattice_hessian = Mat2::Zero();

 private:
  void add_triangle(std::size_t f, const DistortionTerm& term);
  void add_lattice(std::size_t f, const DistortionTerm& term, const LatticeShape& shape);
  void add_vertices(const MapState& state);
  void fix_first_vertex();

  const MapEnergy& energy_;
  bool free_lattice_;
  double lattice_curvature_ = 0;  // second derivative of the energy from that of L in u; may be negative
  struct EdgePlace {
    EdgeId edge;
    bool forward;  // the halfedge of the face is halfedge(edge)
  };
  std::vector<std::array<EdgePlace, 3>> places_;  // per face
};

}  // namespace foramen
