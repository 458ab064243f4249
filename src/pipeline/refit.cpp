#include "foramen/pipeline/refit.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/parallel.hpp"
#include "foramen/core/stage_store.hpp"
#include "foramen/correspond/icp_baseline.hpp"
#include "foramen/sampling/lift_to_surface.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "pipeline/model_archive.hpp"

namespace foramen {
namespace {

bool contains(const std::vector<int>& group, int shape) {
  return std::find(group.begin(), group.end(), shape) != group.end();
}

std::vector<Vec3> landmarks_by_icp(const Mesh& shape, const ModelBuild& build, const RunContext& ctx) {
  const std::vector<Vec3>& landmarks = build.shapes[static_cast<std::size_t>(build.reference)].landmarks;
  const auto normals = vertex_normals(build_mesh({landmarks, build.landmarks.triangles}));
  return icp_correspondence(landmarks, normals.values(), TriangleTree(shape),
                            align(shape, build.reference_map.mesh(), ctx).transform)
      .points;
}

/// What a build without a group of shapes says of them.
struct RefittedGroup {
  std::vector<std::optional<std::vector<Vec3>>> landmarks;  // one per shape of the group; unset: failed
  std::vector<RefitGeneralization::Failure> failures;
  std::optional<AlignedModel> model;  // that has not seen them; unset: the build failed
};

template <class Archive>
void transfer(Archive& archive, MaybeConst<RefittedGroup> auto& group) {
  archive(group.landmarks, group.failures, group.model);
}

class Refit {
 public:
  Refit(const ModelBuild& build, const std::vector<std::string>& subjects, const BuildOptions& options,
        const GeneralizationOptions& measure, const RunContext& ctx)
      : build_(build),
        options_(options),
        measure_(measure),
        ctx_(ctx),
        groups_(left_out_together(static_cast<int>(build.shapes.size()), subjects, measure.leave_out)) {
    for (const auto& group : groups_) {
      const auto first = static_cast<std::size_t>(group.front());
      group_names_.push_back(measure.leave_out == LeaveOut::shape ? stem(group.front()) : subjects[first]);
    }
  }

  RefitGeneralization run() {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      ctx_.step("refit", static_cast<double>(g) / static_cast<double>(groups_.size()));
      // The stages of the builds would be told, and kept, as if the whole began anew.
      const RunContext inner = ctx_.without_progress().with_store(nullptr, {});
      const std::string of = measure_.leave_out == LeaveOut::shape ? "shape " : "subject ";
      refitted_.push_back(kept<RefittedGroup>(ctx_, "refit without " + of + std::to_string(g),
                                              [&] { return leave_out(g, inner); }));
      const auto& failures = refitted_.back().failures;
      result_.failures.insert(result_.failures.end(), failures.begin(), failures.end());
    }
    measure_all();
    ctx_.step("refit", 1);
    return std::move(result_);
  }

 private:
  const std::string& stem(int shape) const {
    return build_.shapes[static_cast<std::size_t>(shape)].input.stem;
  }

  RefittedGroup leave_out(std::size_t g, const RunContext& ctx) const {
    const std::vector<int>& group = groups_[g];
    RefittedGroup result;
    result.landmarks.resize(group.size());
    std::vector<std::string> reasons(group.size());
    try {
      ModelBuild without = build_without(build_, group, options_, ctx);
      for (const LeftOut& other : without.left_out)
        result.failures.push_back({other.stem, group_names_[g], other.reason});
      const RunContext single = ctx.with_threads(1);
      parallel_for(static_cast<int>(group.size()), ctx, [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        try {
          result.landmarks[k] = landmarks_on_unseen(input(group[k]), without, options_, single);
        } catch (const Cancelled&) {
          throw;
        } catch (const Error& e) {
          reasons[k] = e.what();
        }
      });
      result.model = {std::move(without.procrustes), std::move(without.model)};
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& e) {
      reasons.assign(group.size(), e.what());
    }
    for (std::size_t k = 0; k < group.size(); ++k)
      if (!reasons[k].empty()) result.failures.push_back({stem(group[k]), group_names_[g], reasons[k]});
    return result;
  }

  const Mesh& input(int shape) const { return build_.shapes[static_cast<std::size_t>(shape)].input.mesh; }

  /// One shape that was left out, and the model that has not seen it.
  struct Entered {
    int shape = 0;
    const std::vector<Vec3>* landmarks = nullptr;
    const AlignedModel* model = nullptr;
  };

  /// In the order of the shapes.
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
    std::size_t fewest_shapes = build_.shapes.size();
    int models = 0;
    for (const RefittedGroup& group : refitted_)
      if (group.model) {
        fewest_shapes = std::min(fewest_shapes, group.model->alignment.aligned.size());
        ++models;
      }
    const std::vector<Entered> shapes = entered();
    for (const Entered& one : shapes) result_.names.push_back(stem(one.shape));
    const std::vector<int> counts = mode_counts(static_cast<int>(fewest_shapes) - 1);
    std::vector<std::vector<ShapeError>> errors(shapes.size());
    parallel_for(static_cast<int>(shapes.size()), ctx_, [&](int k) {
      const Entered& one = shapes[static_cast<std::size_t>(k)];
      errors[static_cast<std::size_t>(k)] =
          unseen_errors(*one.landmarks, input(one.shape), *one.model, counts, measure_);
    });
    result_.generalization = {measure_.leave_out, models, over_shapes(errors, counts)};
  }

  const ModelBuild& build_;
  const BuildOptions& options_;
  const GeneralizationOptions& measure_;
  const RunContext& ctx_;
  std::vector<std::vector<int>> groups_;
  std::vector<std::string> group_names_;
  std::vector<RefittedGroup> refitted_;
  RefitGeneralization result_;
};

}  // namespace

ModelBuild build_without(const ModelBuild& build, const std::vector<int>& left_out,
                         const BuildOptions& options, const RunContext& ctx) {
  Cohort others;
  BuildOptions others_options = options;
  for (int i = 0; i < static_cast<int>(build.shapes.size()); ++i) {
    const InputShape& input = build.shapes[static_cast<std::size_t>(i)].input;
    if (!contains(left_out, i))
      others.shapes.push_back(input);
    else if (input.stem == options.correspondence.reference)
      others_options.correspondence.reference = "auto";
  }
  return build_model(std::move(others), others_options, ctx);
}

std::vector<Vec3> landmarks_on_unseen(const Mesh& shape, const ModelBuild& build, const BuildOptions& options,
                                      const RunContext& ctx) {
  const CorrespondOptions& how = options.correspondence;
  if (how.method == Method::icp) return landmarks_by_icp(shape, build, ctx);
  const RegisteredShape registered =
      how.objective == Objective::surface
          ? register_to_group(shape, build.reference_map, build.group_template, ctx, how.group)
          : register_shape(shape, build.reference_map, ctx, how.registration);
  return lift_to_surface(TorusLocator(shape, registered.shape_map.map), build.landmarks.turns);
}

RefitGeneralization refit_generalization(const ModelBuild& build, const std::vector<std::string>& subjects,
                                         const BuildOptions& options, const GeneralizationOptions& measure,
                                         const RunContext& ctx) {
  return Refit(build, subjects, options, measure, ctx).run();
}

}  // namespace foramen
