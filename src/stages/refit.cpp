#include "foramen/stages/refit.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/kept_results.hpp"
#include "core/parallel.hpp"
#include "foramen/core/error.hpp"
#include "model/model_archive.hpp"
#include "stages/refit_archive.hpp"

namespace foramen {
namespace {

bool contains(const std::vector<int>& group, int shape) {
  return std::find(group.begin(), group.end(), shape) != group.end();
}

/// The results of a build without a group of shapes.
struct RefittedGroup {
  std::vector<std::optional<std::vector<Vec3>>> landmarks;  // one per shape of the group; unset: failed
  std::vector<RefitGeneralization::Failure> failures;
  std::optional<AlignedModel> model;  // the model without these shapes; unset: the build failed
};

template <class Archive>
void transfer(Archive& archive, MaybeConst<RefittedGroup> auto& group) {
  archive(group.landmarks, group.failures, group.model);
}

class Refit {
 public:
  Refit(std::span<const Shape> shapes, const std::vector<std::string>& subjects, const BuildOptions& options,
        const GeneralizationOptions& measure, const RunContext& ctx)
      : shapes_(shapes),
        options_(options),
        measure_(measure),
        ctx_(ctx),
        groups_(left_out_together(static_cast<int>(shapes.size()), subjects, measure.leave_out)) {
    for (const auto& group : groups_) {
      const std::size_t first = group.front();
      group_names_.push_back(measure.leave_out == LeaveOut::shape ? name(group.front()) : subjects[first]);
    }
  }

  RefitGeneralization run() {
    std::vector<StageKey> of_shapes;
    for (const Shape& shape : shapes_) of_shapes.emplace_back(ctx_, "shape", shape.name, shape.mesh);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      ctx_.step("refit", static_cast<double>(g) / static_cast<double>(groups_.size()));
      // The stages of these builds neither report progress nor use the store, because they would appear as a
      // new run of the whole.
      const RunContext inner = ctx_.without_progress().with_store(nullptr);
      const StageKey key(ctx_, "refit", of_shapes, groups_[g], group_names_[g], options_, measure_);
      refitted_.push_back(kept<RefittedGroup>(ctx_, key, [&] { return leave_out(g, inner); }));
      const auto& failures = refitted_.back().failures;
      result_.failures.insert(result_.failures.end(), failures.begin(), failures.end());
    }
    measure_all();
    ctx_.step("refit", 1);
    return std::move(result_);
  }

 private:
  const std::string& name(int shape) const { return shapes_[shape].name; }

  RefittedGroup leave_out(std::size_t g, const RunContext& ctx) const {
    const std::vector<int>& group = groups_[g];
    RefittedGroup result;
    result.landmarks.resize(group.size());
    std::vector<std::string> reasons(group.size());
    try {
      BuiltModel without = build_without(shapes_, group, options_, ctx);
      for (const FailedShape& other : without.registration.failed)
        result.failures.push_back({other.name, group_names_[g], other.reason.text});
      const RunContext single = ctx.with_threads(1);
      parallel_for(static_cast<int>(group.size()), ctx, [&](int i) {
        const std::size_t k = i;
        try {
          result.landmarks[k] = landmarks_on_newcomer(surface(group[k]), without.registration,
                                                      without.landmarks, options_.correspondence, single);
        } catch (const Cancelled&) {
          throw;
        } catch (const Error& e) {
          reasons[k] = e.what();
        }
      });
      result.model = std::move(without.aligned);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& e) {
      reasons.assign(group.size(), e.what());
    }
    for (std::size_t k = 0; k < group.size(); ++k)
      if (!reasons[k].empty()) result.failures.push_back({name(group[k]), group_names_[g], reasons[k]});
    return result;
  }

  const Mesh& surface(int shape) const { return shapes_[shape].mesh; }

  /// A shape that was left out, and the model without it.
  struct Entered {
    int shape = 0;
    const std::vector<Vec3>* landmarks = nullptr;
    const AlignedModel* model = nullptr;
  };

  /// All shapes that were registered, in the order of the shapes.
  std::vector<Entered> entered() const {
    std::vector<Entered> all;
    for (std::size_t g = 0; g < groups_.size(); ++g)
      for (std::size_t k = 0; k < groups_[g].size(); ++k)
        if (const auto& landmarks = refitted_[g].landmarks[k])
          all.push_back({groups_[g][k], &*landmarks, &*refitted_[g].model});
    std::sort(all.begin(), all.end(), [](const Entered& a, const Entered& b) { return a.shape < b.shape; });
    return all;
  }

  void measure_all() {
    std::size_t fewest_shapes = shapes_.size();
    int models = 0;
    for (const RefittedGroup& group : refitted_)
      if (group.model) {
        fewest_shapes = std::min(fewest_shapes, group.model->alignment.aligned.size());
        ++models;
      }
    const std::vector<Entered> shapes = entered();
    for (const Entered& one : shapes) result_.names.push_back(name(one.shape));
    const std::vector<int> counts = mode_counts(static_cast<int>(fewest_shapes) - 1);
    std::vector<std::vector<ShapeError>> errors(shapes.size());
    parallel_for(static_cast<int>(shapes.size()), ctx_, [&](int k) {
      const Entered& one = shapes[k];
      errors[k] = unseen_errors(*one.landmarks, surface(one.shape), *one.model, counts, measure_);
    });
    result_.generalization = {measure_.leave_out, models, over_shapes(errors, counts)};
  }

  std::span<const Shape> shapes_;
  const BuildOptions& options_;
  const GeneralizationOptions& measure_;
  const RunContext& ctx_;
  std::vector<std::vector<int>> groups_;
  std::vector<std::string> group_names_;
  std::vector<RefittedGroup> refitted_;
  RefitGeneralization result_;
};

}  // namespace

BuiltModel build_without(std::span<const Shape> shapes, const std::vector<int>& left_out,
                         const BuildOptions& options, const RunContext& ctx) {
  std::vector<Shape> others;
  BuildOptions others_options = options;
  std::string& reference = others_options.correspondence.reference;
  for (int i = 0; i < static_cast<int>(shapes.size()); ++i) {
    const Shape& shape = shapes[i];
    if (!contains(left_out, i))
      others.push_back(shape);
    else if (shape.name == reference)
      reference = "auto";
  }
  return build_model(others, others_options, ctx);
}

RefitGeneralization refit_generalization(std::span<const Shape> shapes,
                                         const std::vector<std::string>& subjects,
                                         const BuildOptions& options, const GeneralizationOptions& measure,
                                         const RunContext& ctx) {
  return Refit(shapes, subjects, options, measure, ctx).run();
}

}  // namespace foramen
