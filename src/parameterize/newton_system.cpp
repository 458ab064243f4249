#include "parameterize/newton_system.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "parameterize/optimise_map.hpp"

namespace foramen {
namespace {

/// A regularisation relative to the diagonal. With an objective no vertex is fixed, and if all its terms
/// vanish the energy does not change under translations, so the Hessian is singular. The shift makes the
/// factorisation possible and is too small to change a step.
constexpr double diagonal_shift = 1e-12;

}  // namespace

LatticeShape::LatticeShape(const Lattice& lattice)
    : size(std::sqrt(lattice.determinant())),
      stretch(std::log(lattice(0, 0) / lattice(1, 1)) / 2),
      shear(lattice(0, 1) / size) {}

Lattice LatticeShape::lattice() const {
  Lattice l;
  l << std::exp(stretch), shear, 0, std::exp(-stretch);
  return size * l;
}

Lattice LatticeShape::along_stretch() const {
  Lattice l;
  l << std::exp(stretch), 0, 0, -std::exp(-stretch);
  return size * l;
}

Lattice LatticeShape::curvature() const {
  Lattice l;
  l << std::exp(stretch), 0, 0, std::exp(-stretch);
  return size * l;
}

Lattice LatticeShape::along_shear() const {
  Lattice l;
  l << 0, 1, 0, 0;
  return size * l;
}

LatticeShape LatticeShape::moved(const Vec2& by) const {
  LatticeShape out = *this;
  out.stretch += by[0];
  out.shear += by[1];
  return out;
}

NewtonSystem::NewtonSystem(const MapEnergy& energy, bool free_lattice)
    : hessian(energy.mesh()), energy_(energy), free_lattice_(free_lattice) {
  const Mesh& mesh = energy.mesh();
  places_.resize(mesh.face_count());
  for (FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = Mesh::halfedge(f, k);
      places_[f.index][k] = {mesh.edge(h), mesh.halfedge(mesh.edge(h)) == h};
    }
}

void NewtonSystem::assemble(const MapState& state, double kept) {
  const int unknowns = 2 * energy_.mesh().vertex_count();
  const LatticeShape shape(state.lattice);
  value = 0;
  gradient.setZero(unknowns);
  hessian.set_zero();
  lattice_gradient.setZero();
  lattice_hessian.setZero();
  lattice_curvature_ = 0;
  lattice_coupling.setZero(free_lattice_ ? unknowns : 0, 2);
  for (std::size_t f = 0; f < places_.size(); ++f) {
    const MapEnergy::Triangle& t = energy_.triangles()[f];
    DistortionTerm term = damped_distortion_term(t.rest, MapEnergy::edges(t, state), kept);
    term.value *= t.weight;
    term.gradient *= t.weight;
    term.hessian *= t.weight;
    add_triangle(f, term);
    if (free_lattice_) add_lattice(f, term, shape);
  }
  lattice_hessian(0, 0) += lattice_curvature_ > 0 ? lattice_curvature_ : kept * lattice_curvature_;
  if (energy_.has_objective())
    add_vertices(state);
  else
    fix_first_vertex();
}

void NewtonSystem::add_triangle(std::size_t f, const DistortionTerm& term) {
  const auto& c = energy_.triangles()[f].corner;
  value += term.value;
  const Vec2 g1 = term.gradient.head<2>(), g2 = term.gradient.tail<2>();
  gradient.segment<2>(2 * c[0]) -= g1 + g2;
  gradient.segment<2>(2 * c[1]) += g1;
  gradient.segment<2>(2 * c[2]) += g2;

  // The blocks of the Hessian for the corners follow from those for q = (x1 - x0, x2 - x0).
  const Mat2 a11 = term.hessian.topLeftCorner<2, 2>(), a12 = term.hessian.topRightCorner<2, 2>(),
             a22 = term.hessian.bottomRightCorner<2, 2>();
  const Mat2 a21 = a12.transpose();
  const Mat2 b01 = -(a11 + a21), b20 = -(a21 + a22);
  hessian.diagonal[VertexId(c[0])] -= b01 + b20.transpose();
  hessian.diagonal[VertexId(c[1])] += a11;
  hessian.diagonal[VertexId(c[2])] += a22;
  const auto add = [&](const EdgePlace& p, const Mat2& block) {
    if (p.forward)
      hessian.coupling[p.edge] += block;
    else
      hessian.coupling[p.edge] += block.transpose();
  };
  add(places_[f][0], b01);
  add(places_[f][1], a12);
  add(places_[f][2], b20);
}

void NewtonSystem::add_lattice(std::size_t f, const DistortionTerm& term, const LatticeShape& shape) {
  const MapEnergy::Triangle& t = energy_.triangles()[f];
  if (t.jump[0].isZero() && t.jump[1].isZero()) return;
  Eigen::Matrix<double, 4, 2> moves;  // dq/d(u,b)
  moves << shape.along_stretch() * t.jump[0], shape.along_shear() * t.jump[0],
      shape.along_stretch() * t.jump[1], shape.along_shear() * t.jump[1];
  Vec4 curved;  // d2q/du2, since L is not linear in u
  curved << shape.curvature() * t.jump[0], shape.curvature() * t.jump[1];
  lattice_curvature_ += curved.dot(term.gradient);
  const Eigen::Matrix<double, 4, 2> coupled = term.hessian * moves;
  lattice_gradient += moves.transpose() * term.gradient;
  lattice_hessian += moves.transpose() * coupled;
  lattice_coupling.middleRows<2>(2 * t.corner[0]) -= coupled.topRows<2>() + coupled.bottomRows<2>();
  lattice_coupling.middleRows<2>(2 * t.corner[1]) += coupled.topRows<2>();
  lattice_coupling.middleRows<2>(2 * t.corner[2]) += coupled.bottomRows<2>();
}

void NewtonSystem::add_vertices(const MapState& state) {
  for (int v = 0; v < static_cast<int>(state.x.cols()); ++v) {
    const CorrespondenceObjective::Term term = energy_.correspondence(v, state.x.col(v));
    value += term.value;
    gradient.segment<2>(2 * v) += term.gradient;
    Mat2& block = hessian.diagonal[VertexId(v)];
    block += term.hessian;
    block.diagonal() *= 1 + diagonal_shift;
  }
}

// Fixes the first vertex, because without an objective the energy does not change under translations.
void NewtonSystem::fix_first_vertex() {
  const Mesh& mesh = energy_.mesh();
  const VertexId fixed(0);
  gradient.segment<2>(2 * fixed.index).setZero();
  hessian.diagonal[fixed].setIdentity();
  for (HalfedgeId h : mesh.fan(fixed)) hessian.coupling[mesh.edge(h)].setZero();
  if (free_lattice_) lattice_coupling.middleRows<2>(2 * fixed.index).setZero();
}

}  // namespace foramen
