#pragma once
/// \file
/// Minimisation of the distortion of a torus map, and optionally of a correspondence energy, without flipping
/// a triangle.

#include <optional>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// The correspondence energy: one term E_cor,v per vertex v, a function of its position x = L p in the plane.
/// The term must be periodic, because x is given up to lattice translations.
class CorrespondenceObjective {
 public:
  struct Term {
    double value = 0;
    Vec2 gradient = Vec2::Zero();
    Mat2 hessian = Mat2::Zero();  ///< positive semi-definite (a Gauss-Newton matrix or a majoriser)
  };
  virtual ~CorrespondenceObjective() = default;
  virtual Term term(VertexId v, const Vec2& plane_position) const = 0;
};

/// The metric of a target surface that is mapped to the same torus. With it, E is the distortion of the map
/// surface -> target instead of surface -> plane.
struct TargetMetric {
  /// Per face of the surface: maps plane vectors to mm in a tangent plane of the target; det > 0.
  FaceMap<Mat2> to_target;
  double area = 0;  ///< of the target, mm^2
};

struct OptimiseMapOptions {
  Optimiser optimiser = Optimiser::newton;
  Weighting weighting = Weighting::area;
  /// Factor of the distortion. > 0, because the distortion is also the barrier against flips. Irrelevant
  /// without objective.
  double lambda = 1.0;
  /// Also optimises the shape of L at constant determinant. Only with Newton and without objective.
  bool free_lattice = false;
  /// Newton stops if the predicted decrease <= this * energy; the node-wise method stops if the decrease of a
  /// sweep is.
  double relative_tolerance = 1e-4;
  int iteration_limit = 200;  ///< Largest number of Newton iterations or of sweeps over all nodes.
  std::optional<double> stop_at_energy =
      std::nullopt;  ///< Stops with `converged` once energy <= this (benchmarks).
};

enum class OptimiseStatus { converged, iteration_limit, line_search_stalled };

/// The result of optimise_map().
struct OptimisedMap {
  TorusMap map;
  OptimiseStatus status = OptimiseStatus::converged;
  int iterations = 0;
  double initial_energy = 0, final_energy = 0;
  double distortion = 0;         ///< area-weighted mean of E at the end, >= 4
  std::vector<double> energies;  ///< initial energy, then the energy after each iteration; never increases
};

/// Minimises the energy from `start`. Surface areas are scaled to the area of the domain (det L = 1), or to
/// that of the target if a metric is given. With free_lattice the lattice of the result is scaled to det 1.
/// Every accepted step keeps all signed areas positive, so the result has no flipped triangle. Throws
/// InvalidInput if `start` has a flipped triangle (the message names the first), if the surface has a
/// triangle of zero area, and for options that contradict each other, such as a metric with a free lattice.
OptimisedMap optimise_map(const Mesh& mesh, const TorusMap& start, const RunContext& ctx,
                          const OptimiseMapOptions& options = {},
                          const CorrespondenceObjective* objective = nullptr,
                          const TargetMetric* metric = nullptr);

}  // namespace foramen
