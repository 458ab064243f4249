#include "parameterize/newton.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "foramen/core/error.hpp"
#include "parameterize/flip_free_step.hpp"
#include "parameterize/newton_system.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {
namespace {

/// Largest step, relative to that at which the first triangle collapses.
constexpr double share_of_collapse = 0.9;
constexpr double growth = 1.5;  ///< factor by which a full step is lengthened while the energy decreases
/// Armijo condition: least decrease relative to the one that the slope predicts.
constexpr double sufficient_decrease = 1e-4;
constexpr double least_step = 1e-12;  ///< the line search gives up below this share of the Newton step

/// Share of negative eigenvalues that is kept if the true Hessian is not positive definite.
constexpr double partly_kept = 0.7;
/// Shifts of the diagonal, relative to its own entries, that are tried if rounding spoils the clamped
/// Hessian.
constexpr std::array<double, 4> diagonal_shifts = {1e-10, 1e-8, 1e-6, 1e-4};
/// Factor of the tolerance for steps by a Hessian other than the true one.
constexpr double clamped_margin = 0.1;
/// The iteration is near its end after a full step with a predicted decrease below this share of the energy.
constexpr double end_decrease = 1e-2;

struct Direction {
  Eigen::VectorXd x;
  Vec2 lattice = Vec2::Zero();
  double slope = 0;  ///< gradient . direction, <= 0
  double kept = 0;   ///< share of negative eigenvalues in the Hessian; 1: the true Hessian
};

// Positions on the torus and in space. In space the processes of a vertebra are long and thin, so small
// separators cut them off.
Eigen::MatrixXd coordinates_for_dissection(const Mesh& mesh, const MapState& state) {
  const Mat2 inverse = state.lattice.inverse();
  Eigen::MatrixXd c(mesh.vertex_count(), 5);
  for (VertexId v : mesh.vertices()) {
    const Vec2 turns = inverse * state.x.col(v.index);
    c.row(v.index) << wrap(turns.x()), wrap(turns.y()), mesh.position(v).transpose();
  }
  return c;
}

// The step to the minimum of the second-order model; nullopt if its Hessian is not positive definite.
std::optional<Direction> newton_direction(const NewtonSystem& system, BlockCholesky& cholesky,
                                          bool free_lattice) {
  if (!cholesky.factor(system.hessian)) return std::nullopt;
  Eigen::MatrixXd solved(system.gradient.size(), free_lattice ? 3 : 1);
  solved.col(0) = -system.gradient;
  if (free_lattice) solved.rightCols<2>() = system.lattice_coupling;
  cholesky.solve(solved);
  Direction d;
  d.x = solved.col(0);
  if (free_lattice) {  // the lattice is eliminated last, by the Schur complement of the positions
    const Mat2 schur = system.lattice_hessian - system.lattice_coupling.transpose() * solved.rightCols<2>();
    const Vec2 rest = -system.lattice_gradient - system.lattice_coupling.transpose() * d.x;
    const Eigen::LLT<Mat2> in_lattice(schur);
    if (in_lattice.info() != Eigen::Success) return std::nullopt;
    d.lattice = in_lattice.solve(rest);
    d.x -= solved.rightCols<2>() * d.lattice;
  }
  d.slope = system.gradient.dot(d.x) + system.lattice_gradient.dot(d.lattice);
  if (!(d.slope <= 0)) return std::nullopt;
  return d;
}

class DirectionFinder {
 public:
  DirectionFinder(const MapEnergy& energy, const MapState& start, bool free_lattice)
      : cholesky_(energy.mesh(), coordinates_for_dissection(energy.mesh(), start)),
        system_(energy, free_lattice),
        free_lattice_(free_lattice) {}

  // The Newton direction with the Hessians of all triangles clamped. Near the end of the iteration the
  // largest tried share of negative eigenvalues is kept for which the sum is positive definite, so that the
  // last steps converge (nearly) quadratically.
  Direction operator()(const MapState& state, bool near_end) {
    if (near_end)
      for (const double kept : {1.0, partly_kept})
        if (auto d = direction(state, kept)) return *d;
    if (auto d = direction(state, 0)) return *d;
    // The sum of clamped Hessians is positive definite but for rounding, which a triangle next to degenerate
    // makes large. A shift of the diagonal gives a shorter step that decreases the energy as well.
    for (const double shift : diagonal_shifts)
      if (auto d = direction(state, 0, shift)) return *d;
    throw ConvergenceError(
        "the Hessian of the distortion is not positive definite to working precision, because a triangle of "
        "the map is next to degenerate");
  }

 private:
  std::optional<Direction> direction(const MapState& state, double kept, double shift = 0) {
    system_.assemble(state, kept);
    if (shift > 0)
      for (Mat2& block : system_.hessian.diagonal) block += shift * block.trace() * Mat2::Identity();
    std::optional<Direction> d = newton_direction(system_, cholesky_, free_lattice_);
    if (d) d->kept = kept;
    return d;
  }

  BlockCholesky cholesky_;
  NewtonSystem system_;
  bool free_lattice_;
};

// The motion of plane positions at a fixed lattice. A step first moves the positions by it and then maps all
// of them by the change of the lattice, so positions in turns move linearly. Since the determinant of the
// lattice is constant, areas are quadratic in the step, as first_collapse() needs, and the nonlinear change
// of the lattice affects edges across the cut no more than other edges.
Eigen::Matrix2Xd at_fixed_lattice(const MapState& state, const Direction& d) {
  Eigen::Matrix2Xd x = Eigen::Map<const Eigen::Matrix2Xd>(d.x.data(), 2, state.x.cols());
  if (d.lattice.isZero(0)) return x;
  const LatticeShape shape(state.lattice);
  const Mat2 rate =
      (d.lattice[0] * shape.along_stretch() + d.lattice[1] * shape.along_shear()) * state.lattice.inverse();
  x -= rate * state.x;
  return x;
}

MapState moved(const MapState& state, const Eigen::Matrix2Xd& direction, const Vec2& lattice, double step) {
  MapState out{state.x + step * direction, state.lattice};
  if (lattice.isZero(0)) return out;
  out.lattice = LatticeShape(state.lattice).moved(step * lattice).lattice();
  const Mat2 carry = out.lattice * state.lattice.inverse();
  out.x = carry * out.x;
  return out;
}

struct Step {
  MapState state;
  double energy;
  double length;
};

class Line {
 public:
  Line(const MapEnergy& energy, const MapState& state, const Direction& d)
      : energy_(energy),
        state_(state),
        lattice_(d.lattice),
        motion_(at_fixed_lattice(state, d)),
        longest_(share_of_collapse * first_collapse(energy, state, {motion_, Lattice::Zero()})) {}

  double longest() const { return longest_; }
  Step at(double length) const {
    Step step{moved(state_, motion_, lattice_, length), 0, length};
    step.energy = energy_.value(step.state);
    return step;
  }

 private:
  const MapEnergy& energy_;
  const MapState& state_;
  Vec2 lattice_;
  Eigen::Matrix2Xd motion_;
  double longest_;  // no longer step is tried, so that no triangle flips
};

// Lengthens a full Newton step while the energy decreases. Where a barrier term 1/x^2 dominates, the Newton
// step is too short: it increases x by a third only.
Step lengthened(const Line& line, Step step) {
  while (step.length < line.longest()) {
    Step next = line.at(std::min(growth * step.length, line.longest()));
    if (!(next.energy < step.energy)) break;
    step = std::move(next);
  }
  return step;
}

// Armijo backtracking from the longest step that flips no triangle; nullopt if no step decreases the energy.
std::optional<Step> line_search(const MapEnergy& energy, const MapState& state, double value,
                                const Direction& d) {
  const Line line(energy, state, d);
  double length = std::min(1.0, line.longest());
  while (length >= least_step) {
    Step next = line.at(length);
    if (next.energy <= value + sufficient_decrease * length * d.slope)
      return length == 1.0 ? lengthened(line, std::move(next)) : next;
    // The next length is the minimum of the parabola through the value and slope at 0 and the value at the
    // tried step, limited to [0.1, 0.5] of that step.
    const double parabola = -d.slope * length * length / (2 * (next.energy - value - d.slope * length));
    length = std::isfinite(parabola) ? std::clamp(parabola, 0.1 * length, 0.5 * length) : 0.5 * length;
  }
  return std::nullopt;
}

}  // namespace

Minimisation minimise_by_newton(const MapEnergy& energy, MapState start, const RunContext& ctx,
                                const OptimiseMapOptions& options) {
  DirectionFinder find_direction(energy, start, options.free_lattice);
  Minimisation result{std::move(start), OptimiseStatus::iteration_limit, {}};
  double value = energy.value(result.state);
  result.energies.push_back(value);
  bool near_end = false;
  for (int k = 0; k < options.iteration_limit && !low_enough(value, options); ++k) {
    ctx.check();
    const Direction d = find_direction(result.state, near_end);
    const double predicted = -d.slope / 2;  // half the squared Newton decrement
    const bool small = predicted <= options.relative_tolerance * value;
    // A clamped Hessian is too large and so predicts too small a decrease. It may stop the iteration only
    // near the end and with a margin.
    const double margin = d.kept == 1 ? 1.0 : clamped_margin;
    const bool last = (near_end || d.kept == 1) && predicted <= margin * options.relative_tolerance * value;
    std::optional<Step> step = line_search(energy, result.state, value, d);
    if (step) {
      near_end = small || (step->length >= 1.0 && predicted <= end_decrease * value);
      result.state = std::move(step->state);
      value = step->energy;
      result.energies.push_back(value);
    }
    if (last || !step) {
      result.status = small ? OptimiseStatus::converged : OptimiseStatus::line_search_stalled;
      return result;
    }
  }
  if (low_enough(value, options)) result.status = OptimiseStatus::converged;
  return result;
}

}  // namespace foramen
