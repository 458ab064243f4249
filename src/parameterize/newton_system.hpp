#pragma once
/// \file
/// Gradient and positive semi-definite Hessian of the map energy, assembled triangle by triangle.

#include <vector>

#include "parameterize/block_cholesky.hpp"
#include "parameterize/map_energy.hpp"

namespace foramen {

/// Lattices of one determinant, r^2: L = r [[e^u, b], [0, e^-u]]. The surface is scaled to the domain, so the
/// determinant means nothing and of the three entries two are free.
struct LatticeShape {
  double size = 1, stretch = 0, shear = 0;  ///< r, u, b
  explicit LatticeShape(const Lattice& lattice);
  Lattice lattice() const;
  Lattice along_stretch() const;  ///< dL/du
  Lattice along_shear() const;    ///< dL/db
  Lattice curvature() const;      ///< d2L/du2
  LatticeShape moved(const Vec2& by) const;
};

/// Second-order model of the energy in (x, u, b); the part of the lattice is left zero unless it is free.
class NewtonSystem {
 public:
  NewtonSystem(const MapEnergy& energy, bool free_lattice);

  /// Fills the members below for this state. \param kept  of negative eigenvalues of a triangle: see
  /// damped_distortion_term
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
  double lattice_curvature_ = 0;  // of the energy because L is not linear in u; may be negative
  struct EdgePlace {
    EdgeId edge;
    bool forward;  // the face runs along the edge's own halfedge
  };
  std::vector<std::array<EdgePlace, 3>> places_;  // per face
};

}  // namespace foramen
