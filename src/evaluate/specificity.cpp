#include "foramen/evaluate/specificity.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/kept_results.hpp"
#include "core/parallel.hpp"
#include "evaluate/closest_shape.hpp"
#include "evaluate/error_archive.hpp"
#include "evaluate/measured_surface.hpp"
#include "evaluate/stage_progress.hpp"
#include "foramen/core/error.hpp"

namespace foramen {
namespace {

using detail::MeasuredSurface;

constexpr int block_draws = 5;
constexpr double infinity = std::numeric_limits<double>::infinity();
// Spacing of the distance lattice, relative to the diagonal of the middle surface, for this many surfaces to
// measure. For fewer surfaces the lattice is coarser, because a fine one would cost more time than it saves.
constexpr double finest_lattice = 1.0 / 110;
constexpr double surfaces_worth_the_finest = 5000;
// The least reach of the lattice, relative to the diagonal of the middle surface.
constexpr double least_reach = 1.0 / 90;
// Usual distance of drawn surfaces from the mean, in standard deviations of a landmark.
constexpr double usual_deviations = 2;

/// mm
double diagonal_of_mean(const ShapeModel& model) {
  return bounding_box(unflattened(model.mean())).diagonal();
}

/// mm
double usual_reach(const ShapeModel& model) {
  return least_reach * diagonal_of_mean(model) +
         usual_deviations * std::sqrt(model.variance().sum() / model.total_weight());
}

/// mm
double lattice_spacing(const ShapeModel& model, int surfaces) {
  const double coarser = std::cbrt(surfaces_worth_the_finest / std::max(1, surfaces));
  return diagonal_of_mean(model) * finest_lattice * std::max(1.0, coarser);
}

void lower(std::atomic<double>& smallest, double value) {
  double seen = smallest.load();
  while (value < seen && !smallest.compare_exchange_weak(seen, value)) {
  }
}

/// Compares draws with the training shapes; shared by all threads. The smallest distance of a training shape
/// to any draw so far saves work in later draws. The final minimum does not depend on their order.
class Ensemble {
 public:
  Ensemble(const AlignedCohort& cohort, std::vector<int> counts, const SpecificityOptions& options,
           const RunContext& ctx)
      : model_(cohort.model),
        options_(options),
        counts_(std::move(counts)),
        training_(MeasuredSurface(build_mesh({unflattened(model_.mean()), model_.triangles()}),
                                  options.surface_samples, options.seed),
                  cohort.inputs, options.surface_samples, options.seed, usual_reach(model_),
                  lattice_spacing(model_, options.draws * static_cast<int>(counts_.size())), ctx),
        smallest_(counts_.size() * cohort.inputs.size()) {
    for (const auto& landmarks : cohort.alignment.aligned) landmarks_.push_back(flattened(landmarks));
    for (auto& s : smallest_) s.store(infinity);
  }

  /// The errors of one draw for every number of modes.
  std::vector<ShapeError> measure(Rng rng) {
    const Eigen::VectorXd b = model_.draw(rng);
    Eigen::VectorXd x = model_.mean();
    MeasuredSurface probe = training_.middle;
    detail::ClosestShapeSearch search(training_);
    std::vector<ShapeError> errors;
    int added = 0;
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      const int modes = std::min(counts_[k], model_.modes());
      for (; added < modes; ++added) x += b[added] * model_.basis().col(added);
      probe.move_to(unflattened(x));
      search.look_at(probe);
      ShapeError error;
      error.landmark_rms = smallest_landmark_rms(x);
      if (options_.hausdorff)
        error.hausdorff =
            search.smallest_hausdorff([&](std::size_t i) { return smallest(k, i).load(); },
                                      [&](std::size_t i, double d) { lower(smallest(k, i), d); });
      if (options_.mean_surface) error.mean_surface = search.smallest_mean();
      errors.push_back(error);
    }
    return errors;
  }

  /// The smallest distances to all draws so far, by number of modes and training shape.
  std::vector<double> found() const { return {smallest_.begin(), smallest_.end()}; }
  void found_before(const std::vector<double>& found) {
    for (std::size_t i = 0; i < found.size(); ++i) lower(smallest_[i], found[i]);
  }

  std::vector<double> nearest_draw(std::size_t k) {
    std::vector<double> nearest;
    for (std::size_t i = 0; i < landmarks_.size(); ++i) nearest.push_back(smallest(k, i).load());
    return nearest;
  }

 private:
  std::atomic<double>& smallest(std::size_t k, std::size_t shape) {
    return smallest_[k * landmarks_.size() + shape];
  }

  double smallest_landmark_rms(const Eigen::VectorXd& x) const {
    double closest = infinity;
    for (const Eigen::VectorXd& shape : landmarks_)
      closest = std::min(closest, model_.landmark_rms(shape, x));
    return closest;
  }

  const ShapeModel& model_;
  const SpecificityOptions& options_;
  std::vector<int> counts_;
  detail::TrainingSurfaces training_;
  std::vector<Eigen::VectorXd> landmarks_;
  std::vector<std::atomic<double>> smallest_;  // one per number of modes and training shape
};

/// The results of a block of successive draws, which are stored together.
struct DrawBlock {
  std::vector<std::vector<ShapeError>> errors;  // errors of each draw for every number of modes
  std::vector<double> found;                    // Ensemble::found() after these draws
};

template <class Archive>
void transfer(Archive& archive, MaybeConst<DrawBlock> auto& block) {
  archive(block.errors, block.found);
}

void check_options(const SpecificityOptions& options) {
  if (options.draws <= 0)
    throw InvalidInput("specificity: " + std::to_string(options.draws) + " draws asked for; give 1 or more");
  if (options.surface_samples <= 0)
    throw InvalidInput("specificity: " + std::to_string(options.surface_samples) +
                       " samples a surface asked for; give 1 or more");
}

}  // namespace

Specificity specificity(const AlignedCohort& cohort, int last_mode, const SpecificityOptions& options,
                        const RunContext& ctx) {
  check_options(options);
  const std::vector<int> counts = mode_counts(last_mode);
  Ensemble ensemble(cohort, counts, options, ctx);
  const StageKey of_cohort(ctx, "aligned cohort", cohort.alignment.aligned, cohort.inputs,
                           cohort.model.triangles(), cohort.model.weights(), counts);
  const Rng root(options.seed);
  std::vector<DrawBlock> blocks((options.draws + block_draws - 1) / block_draws);
  detail::StageProgress progress(ctx, "specificity", options.draws);
  parallel_for(static_cast<int>(blocks.size()), ctx, [&](int b) {
    DrawBlock& block = blocks[b];
    const int first = b * block_draws, last = std::min(options.draws, first + block_draws);
    const StageKey key(ctx, "specificity", of_cohort, options.seed, options.surface_samples,
                       options.hausdorff, options.mean_surface, first, last);
    block = kept<DrawBlock>(ctx, key, [&] {
      DrawBlock measured;
      for (int draw = first; draw < last; ++draw) {
        ctx.check();
        measured.errors.push_back(ensemble.measure(root.fork(static_cast<std::uint64_t>(draw))));
      }
      measured.found = ensemble.found();
      return measured;
    });
    ensemble.found_before(block.found);
    for (std::size_t i = 0; i < block.errors.size(); ++i) progress.finished_one();
  });

  Specificity result;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    std::vector<ShapeError> items;
    for (const DrawBlock& block : blocks)
      for (const auto& of_draw : block.errors) items.push_back(of_draw[k]);
    result.by_modes.push_back(errors_at_modes(counts[k], std::move(items)));
    if (options.hausdorff) result.nearest_draw.push_back(ensemble.nearest_draw(k));
  }
  return result;
}

}  // namespace foramen
