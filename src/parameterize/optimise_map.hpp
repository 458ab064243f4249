#pragma once
/// \file
/// Minimises distortion, and optionally correspondence, over a torus map without ever flipping a triangle.

#include <optional>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/parameterize/optimiser.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// A term per vertex that pulls the map: E_cor,v as a function of the vertex's position x = L p in the plane
/// (any lattice translate of it: the term must be periodic).
class CorrespondenceObjective {
 public:
  struct Term {
    double value = 0;
    Vec2 gradient = Vec2::Zero();
    Mat2 hessian = Mat2::Zero();  ///< positive semi-definite (Gauss-Newton or majoriser)
  };
  virtual ~CorrespondenceObjective() = default;
  virtual Term term(VertexId v, const Vec2& plane_position) const = 0;
};

/// Where distortion is measured if not in the flat plane: on a target surface that the same torus is mapped
/// to, so that E is that of the map surface -> target.
struct TargetMetric {
  FaceMap<Mat2> to_target;  ///< per face of the surface: plane vector -> mm in a tangent plane; det > 0
  double area = 0;          ///< of the target, mm^2
};

struct OptimiseMapOptions {
  Optimiser optimiser = Optimiser::newton;
  Weighting weighting = Weighting::area;
  double lambda =
      1.0;  ///< factor of the distortion. > 0 (the barrier stays on). Irrelevant without objective.
  bool free_lattice =
      false;  ///< Also optimise the shape of L at its determinant. Newton only, and without objective.
  double relative_tolerance = 1e-4;  ///< Newton: stops when the predicted decrease <= this * energy; sweeps:
                                     ///< when a sweep's decrease is.
  int iteration_limit = 200;         ///< Newton iterations, or sweeps over all nodes.
  std::optional<double> stop_at_energy =
      std::nullopt;  ///< Stops with `converged` once energy <= this (benchmarks).
};

enum class OptimiseStatus { converged, iteration_limit, line_search_stalled };

struct OptimisedMap {
  TorusMap map;
  OptimiseStatus status = OptimiseStatus::converged;
  int iterations = 0;
  double initial_energy = 0, final_energy = 0;
  double distortion = 0;         ///< area-weighted mean of E at the end, >= 4
  std::vector<double> energies;  ///< after each iteration, first the initial one; never increases
};

/// Surface areas are scaled to the domain's (det L = 1), or to the target's if a metric is given (which
/// excludes a free lattice: InvalidInput). With free_lattice the result's lattice is scaled to
/// det 1 at the end. \pre start has no flipped triangle (InvalidInput names the first otherwise). Never
/// returns a map with one: every accepted step keeps all signed areas positive.
OptimisedMap optimise_map(const Mesh& mesh, const TorusMap& start, const RunContext& ctx,
                          const OptimiseMapOptions& options = {},
                          const CorrespondenceObjective* objective = nullptr,
                          const TargetMetric* metric = nullptr);

}  // namespace foramen
