#include "foramen/topology/shortest_loops.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "core/parallel.hpp"
#include "foramen/core/error.hpp"
#include "topology/loop_graph.hpp"

namespace foramen {
namespace {

using topology_detail::LoopGraph;
using topology_detail::LoopScratch;
using topology_detail::position_less;

// Two systems of loops are equally short if their lengths differ by less than this relative amount.
constexpr double tie_tolerance = 1e-12;
// Number of basepoints that are evaluated in parallel. It is fixed, so that the number of threads does not
// change the result or the number of evaluations.
constexpr int batch_size = 8;

// Best-first branch and bound over basepoints.
//
// The greedy loops at b have lengths l_1 <= ... <= l_2g, the successive minima of b: l_k(b) is the least r
// such that the loops through b no longer than r span at least k dimensions of the homology. (Each loop is,
// in homology, a sum of greedy loops that are no longer than it; Erickson and Whittlesey 2005, Section 3.) A
// loop through b' becomes one through b of the same class by walking to b' and back, which adds 2 d(b,b').
// Hence l_k(b') >= l_k(b) - 2 d(b,b') for every k on its own, and
//     L(b') >= sum_k max_b (l_k(b) - 2 d(b,b')),
// which is at least as sharp as max_b (L(b) - 4g d(b,b')), where b is the same for all k. The distances
// d(b,.) are a by-product of the loops of b.
class Search {
 public:
  /// \param counted  number of loops of a basepoint, shortest first, whose total length is minimised; 0: all
  Search(const Mesh& mesh, const EdgeMap<double>& lengths, int counted)
      : mesh_(mesh), graph_(mesh, lengths), loops_(graph_.loop_count()) {
    if (loops_ == 0)
      throw TopologyError("a sphere has no loops to cut it open: needs genus 1 or more, found 0");
    if (counted > 0) loops_ = counted;
    open_.resize(mesh.vertex_count());
    std::iota(open_.begin(), open_.end(), 0);
    std::sort(open_.begin(), open_.end(),
              [&](int a, int b) { return position_less(mesh, VertexId(a), VertexId(b)); });
    bound_.resize(open_.size(), 0);
    bounds_.resize(open_.size() * loops_, 0);
    evaluated_.resize(open_.size(), 0);
    for (int k = 0; k < batch_size; ++k) scratch_.push_back(graph_.scratch());
  }

  bool done() const { return open_.empty(); }
  double fraction_done() const {
    return 1 - static_cast<double>(open_.size()) / static_cast<double>(bound_.size());
  }
  int evaluations() const { return static_cast<int>(found_.size()); }

  void evaluate_batch(const RunContext& ctx) {
    const std::vector<int> batch = choose_batch();
    parallel_for(static_cast<int>(batch.size()), ctx, [&](int k) { graph_.evaluate(batch[k], scratch_[k]); });
    for (std::size_t k = 0; k < batch.size(); ++k) note(batch[k], scratch_[k]);
    tighten(batch.size());
  }

  VertexId best() const {
    std::vector<int> equal;
    for (const Found& f : found_)
      if (f.length <= shortest_ * (1 + tie_tolerance)) equal.push_back(f.basepoint);
    return VertexId(*std::min_element(equal.begin(), equal.end(), [&](int a, int b) {
      return position_less(mesh_, VertexId(a), VertexId(b));
    }));
  }

 private:
  struct Found {
    int basepoint;
    double length;
  };

  // Chooses the open basepoints with the smallest bounds, but none so near to another chosen one that the
  // evaluation of that one will probably exclude it.
  std::vector<int> choose_batch() const {
    std::vector<int> batch;
    std::vector<double> reach;
    while (static_cast<int>(batch.size()) < batch_size) {
      int chosen = -1;
      for (int v : open_) {
        if (chosen >= 0 && bound_[v] >= bound_[chosen]) continue;
        bool clear = true;
        for (std::size_t k = 0; k < batch.size() && clear; ++k)
          clear = (mesh_.position(VertexId(v)) - mesh_.position(VertexId(batch[k]))).norm() > reach[k];
        if (clear) chosen = v;
      }
      if (chosen < 0) break;
      batch.push_back(chosen);
      reach.push_back(found_.empty() ? std::numeric_limits<double>::infinity()
                                     : (shortest_ - bound_[chosen]) / (2 * loops_));
    }
    return batch;
  }

  void note(int basepoint, const LoopScratch& s) {
    const double length = std::accumulate(s.loop_lengths.begin(), s.loop_lengths.begin() + loops_, 0.0);
    shortest_ = found_.empty() ? length : std::min(shortest_, length);
    found_.push_back({basepoint, length});
    evaluated_[basepoint] = 1;
  }

  // Raises the bounds by the results of the batch and closes basepoints that can neither win nor tie.
  void tighten(std::size_t batch) {
    // Twice the tolerance, because the bounds have rounding errors, too.
    const double cutoff = shortest_ * (1 + 2 * tie_tolerance);
    std::size_t kept = 0;
    for (int v : open_) {
      double* bounds = &bounds_[v * loops_];
      for (std::size_t b = 0; b < batch; ++b)
        for (int k = 0; k < loops_; ++k)
          bounds[k] = std::max(bounds[k], scratch_[b].loop_lengths[k] - 2 * scratch_[b].distance[v]);
      bound_[v] = std::accumulate(bounds, bounds + loops_, 0.0);
      if (evaluated_[v] == 0 && bound_[v] <= cutoff) open_[kept++] = v;
    }
    open_.resize(kept);
  }

  const Mesh& mesh_;
  LoopGraph graph_;
  int loops_;                   // number of loops whose lengths count, at most 2g
  std::vector<int> open_;       // basepoints that may still win, in order of position
  std::vector<double> bound_;   // per vertex
  std::vector<double> bounds_;  // per vertex and loop
  std::vector<std::uint8_t> evaluated_;
  std::vector<Found> found_;
  double shortest_ = 0;
  std::vector<LoopScratch> scratch_;
};

// The best basepoint and the number of evaluations.
std::pair<VertexId, int> best_basepoint(const Mesh& mesh, const EdgeMap<double>& lengths, int counted,
                                        const RunContext& ctx, const ShortestLoopsOptions& options) {
  Search search(mesh, lengths, counted);
  while (!search.done()) {
    if (options.evaluation_limit > 0 && search.evaluations() >= options.evaluation_limit)
      throw ConvergenceError("the shortest loops are not found after " +
                             std::to_string(search.evaluations()) +
                             " basepoints: raise evaluation_limit or use a coarser mesh");
    search.evaluate_batch(ctx);
    ctx.step("shortest loops", search.fraction_done());
  }
  return {search.best(), search.evaluations()};
}

// Removes steps that are immediately reversed, also across the end of the loop. They can occur with edges of
// length zero.
EdgeLoop without_spurs(const Mesh& mesh, const EdgeLoop& loop) {
  EdgeLoop out;
  for (HalfedgeId h : loop) {
    if (!out.empty() && out.back() == mesh.twin(h))
      out.pop_back();
    else
      out.push_back(h);
  }
  std::size_t first = 0, last = out.size();
  while (last - first >= 2 && out[first] == mesh.twin(out[last - 1])) {
    ++first;
    --last;
  }
  return {out.begin() + static_cast<std::ptrdiff_t>(first), out.begin() + static_cast<std::ptrdiff_t>(last)};
}

}  // namespace

ShortestLoopsResult shortest_loops(const Mesh& mesh, const EdgeMap<double>& lengths, const RunContext& ctx,
                                   const ShortestLoopsOptions& options) {
  const auto [basepoint, evaluations] = best_basepoint(mesh, lengths, 0, ctx, options);
  return {greedy_loops(mesh, basepoint, lengths), evaluations};
}

EdgeLoop shortest_loop(const Mesh& mesh, const EdgeMap<double>& lengths, const RunContext& ctx,
                       const ShortestLoopsOptions& options) {
  const VertexId basepoint = best_basepoint(mesh, lengths, 1, ctx, options).first;
  return without_spurs(mesh, greedy_loops(mesh, basepoint, lengths).loops.front());
}

}  // namespace foramen
