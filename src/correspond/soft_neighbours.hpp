#pragma once
/// \file
/// The correspondence energy of the paper: it attracts every vertex to the torus positions of its nearest
/// neighbours on the reference.

#include "foramen/core/options.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {

/// E_cor,j = sum over the q nearest reference vertices k of w_jk |p_j - p_k| [becker2011 Eq. 4]. The distance
/// r is that to the nearest lattice translate, smoothed as sqrt(r^2 + eps^2). Positions are in the plane of
/// the reference's lattice (area 1). The Hessian is exact, and positive semi-definite because the term is
/// convex.
class SoftNeighbours : public CorrespondenceObjective {
 public:
  SoftNeighbours(const Mesh& aligned_shape, const Mesh& reference, const TorusMap& reference_map,
                 const SoftNeighboursOptions& options = {});
  Term term(VertexId v, const Vec2& plane_position) const override;

 private:
  int count_;
  double squared_smoothing_;
  LatticeReducer reducer_;
  std::vector<Vec2> targets_;    // count_ positions per vertex, in the plane
  std::vector<double> weights_;  // count_ per vertex
};

}  // namespace foramen
