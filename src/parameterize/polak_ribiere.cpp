#include "parameterize/polak_ribiere.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "parameterize/flip_free_step.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {
namespace {

constexpr int steps_per_node = 3;
constexpr double share_of_kernel =
    0.5;  ///< first trial step, relative to the distance at which the node leaves the kernel of its one-ring
constexpr double sufficient_decrease = 1e-4;
constexpr int trial_limit = 20;
/// A node is not moved if the slope times the distance to the border of the kernel predicts a decrease below
/// this share of its energy.
constexpr double negligible_share = 1e-9;

// A triangle at a node, and which of its corners the node is.
struct RingTriangle {
  int triangle;
  int corner;
};

// The energy terms of one node as a function of its position, with all other nodes fixed.
class NodeEnergy {
 public:
  NodeEnergy(const MapEnergy& energy, MapState& state, std::span<const RingTriangle> ring, int node)
      : energy_(energy), state_(state), ring_(ring), node_(node) {}

  struct Value {
    double energy;
    Vec2 gradient;
  };

  Value at(const Vec2& position) {
    state_.x.col(node_) = position;
    const CorrespondenceObjective::Term own = energy_.correspondence(node_, position);
    Value sum{own.value, own.gradient};
    for (const RingTriangle& r : ring_) {
      const MapEnergy::Triangle& t = energy_.triangles()[r.triangle];
      const DistortionGradient e = distortion_gradient(t.rest, MapEnergy::edges(t, state_));
      if (!std::isfinite(e.value)) return {std::numeric_limits<double>::infinity(), Vec2::Zero()};
      sum.energy += t.weight * e.value;
      const Vec2 g1 = e.gradient.head<2>(), g2 = e.gradient.tail<2>();
      sum.gradient += t.weight * (r.corner == 0 ? Vec2(-g1 - g2) : r.corner == 1 ? g1 : g2);
    }
    return sum;
  }

  // The step in this direction at which the node leaves the kernel of its one-ring.
  double way_to_border(const Vec2& position, const Vec2& direction) {
    state_.x.col(node_) = position;
    double least = std::numeric_limits<double>::infinity();
    for (const RingTriangle& r : ring_) {
      const MapEnergy::Triangle& t = energy_.triangles()[r.triangle];
      Vec4 d = Vec4::Zero();
      if (r.corner != 2) d.head<2>() = r.corner == 0 ? Vec2(-direction) : direction;
      if (r.corner != 1) d.tail<2>() = r.corner == 0 ? Vec2(-direction) : direction;
      least = std::min(least, first_collapse(MapEnergy::edges(t, state_), d));
    }
    return least;
  }

 private:
  const MapEnergy& energy_;
  MapState& state_;
  std::span<const RingTriangle> ring_;
  int node_;
};

struct LinePoint {
  double step = 0;
  NodeEnergy::Value value;
};

// Starts with a trial inside the kernel and follows minima of parabolas to a point with sufficient decrease
// of the energy; step 0 if there is none.
LinePoint search_line(NodeEnergy& node, const Vec2& position, const NodeEnergy::Value& here,
                      const Vec2& direction, double border) {
  const double slope = here.gradient.dot(direction);
  const auto decreases = [&](const LinePoint& p) {
    return p.value.energy <= here.energy + sufficient_decrease * p.step * slope;
  };
  const auto evaluate = [&](double step) { return LinePoint{step, node.at(position + step * direction)}; };
  LinePoint trial = evaluate(share_of_kernel * border);
  for (int k = 0; k < trial_limit; ++k) {
    const double excess = trial.value.energy - here.energy - slope * trial.step;
    const double bottom = std::isfinite(excess) && excess > 0
                              ? -slope * trial.step * trial.step / (2 * excess)
                              : 0.5 * trial.step;
    const bool enough = decreases(trial);
    LinePoint next =
        evaluate(std::clamp(bottom, 0.05 * trial.step, enough ? 0.9 * border : 0.5 * trial.step));
    if (enough) return decreases(next) && next.value.energy < trial.value.energy ? next : trial;
    if (decreases(next)) return next;
    trial = next;
  }
  return {0, here};
}

void relax(NodeEnergy& node, MapState& state, int index) {
  Vec2 position = state.x.col(index);
  NodeEnergy::Value here = node.at(position);
  Vec2 direction = -here.gradient;
  for (int k = 0; k < steps_per_node; ++k) {
    if (!(here.gradient.dot(direction) < 0)) direction = -here.gradient;
    const double border = node.way_to_border(position, direction);
    if (!std::isfinite(border) || -here.gradient.dot(direction) * border <= negligible_share * here.energy)
      break;
    const LinePoint next = search_line(node, position, here, direction, border);
    if (next.step == 0) break;
    position += next.step * direction;
    const Vec2 change = next.value.gradient - here.gradient;
    const double beta = std::max(0.0, next.value.gradient.dot(change) / here.gradient.squaredNorm());
    direction = -next.value.gradient + beta * direction;
    here = next.value;
  }
  state.x.col(index) = position;
}

struct Rings {
  std::vector<std::size_t> begin;
  std::vector<RingTriangle> triangles;

  explicit Rings(const Mesh& mesh) {
    for (VertexId v : mesh.vertices()) {
      begin.push_back(triangles.size());
      for (HalfedgeId h : mesh.fan(v)) triangles.push_back({Mesh::face(h).index, h.index % 3});
    }
    begin.push_back(triangles.size());
  }
  std::span<const RingTriangle> of(int v) const {
    const std::size_t i = v;
    return {triangles.data() + begin[i], begin[i + 1] - begin[i]};
  }
};

}  // namespace

Minimisation minimise_by_sweeps(const MapEnergy& energy, MapState start, const RunContext& ctx,
                                const OptimiseMapOptions& options) {
  const Rings rings(energy.mesh());
  Minimisation result{std::move(start), OptimiseStatus::iteration_limit, {}};
  double value = energy.value(result.state);
  result.energies.push_back(value);
  for (int sweep = 0; sweep < options.iteration_limit && !low_enough(value, options); ++sweep) {
    ctx.check();
    const MapState before = result.state;
    for (int v = 0; v < energy.mesh().vertex_count(); ++v) {
      NodeEnergy node(energy, result.state, rings.of(v), v);
      relax(node, result.state, v);
    }
    const double next = energy.value(result.state);
    if (!(next <= value)) {  // the energy of every node decreased, so only rounding can raise the sum
      result.state = before;
      result.status = OptimiseStatus::line_search_stalled;
      return result;
    }
    const bool last = value - next <= options.relative_tolerance * value;
    value = next;
    result.energies.push_back(value);
    if (last) {
      result.status = OptimiseStatus::converged;
      return result;
    }
  }
  if (low_enough(value, options)) result.status = OptimiseStatus::converged;
  return result;
}

}  // namespace foramen
