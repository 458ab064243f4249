#include "foramen/pipeline/refit.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/parallel.hpp"
#include "foramen/correspond/icp_baseline.hpp"
#include "foramen/resample/lift_to_surface.hpp"
#include "foramen/spatial/triangle_tree.hpp"

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

/// One shape that was left out, and the model that has not seen it.
struct Refitted {
  std::vector<Vec3> landmarks;
  std::size_t model = 0;
};

class Refit {
 public:
  Refit(const ModelBuild& build, const std::vector<std::string>& subjects, const BuildOptions& options,
        const GeneralizationOptions& measure, const RunContext& ctx)
      : build_(build),
        options_(options),
        measure_(measure),
        ctx_(ctx),
        groups_(left_out_together(static_cast<int>(build.shapes.size()), subjects, measure.leave_out)),
        refitted_(build.shapes.size()) {
    for (const auto& group : groups_) {
      const auto first = static_cast<std::size_t>(group.front());
      group_names_.push_back(measure.leave_out == LeaveOut::shape ? stem(group.front()) : subjects[first]);
    }
  }

  RefitGeneralization run() {
    ctx_.step("refit", 0);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const double fraction = static_cast<double>(g) / static_cast<double>(groups_.size());
      // The stages of the builds would be told as if the whole began anew; a stop request passes all the
      // same.
      const RunContext inner(ctx_.threads(), [&](const Progress&) { ctx_.step("refit", fraction); });
      try {
        leave_out(g, build_without(build_, groups_[g], options_, inner), inner);
      } catch (const Cancelled&) {
        throw;
      } catch (const Error& e) {
        for (const int i : groups_[g]) result_.failures.push_back({stem(i), group_names_[g], e.what()});
      }
    }
    measure_all();
    ctx_.step("refit", 1);
    return std::move(result_);
  }

 private:
  const std::string& stem(int shape) const {
    return build_.shapes[static_cast<std::size_t>(shape)].input.stem;
  }

  void leave_out(std::size_t g, ModelBuild without, const RunContext& ctx) {
    for (const LeftOut& other : without.left_out)
      result_.failures.push_back({other.stem, group_names_[g], other.reason});
    const std::vector<int>& group = groups_[g];
    std::vector<std::string> reasons(group.size());
    const RunContext single = ctx.with_threads(1);
    parallel_for(static_cast<int>(group.size()), ctx, [&](int k) {
      const auto shape = static_cast<std::size_t>(group[static_cast<std::size_t>(k)]);
      try {
        refitted_[shape] = {landmarks_on_unseen(build_.shapes[shape].input.mesh, without, options_, single),
                            models_.size()};
      } catch (const Cancelled&) {
        throw;
      } catch (const Error& e) {
        reasons[static_cast<std::size_t>(k)] = e.what();
      }
    });
    for (std::size_t k = 0; k < group.size(); ++k)
      if (!reasons[k].empty()) result_.failures.push_back({stem(group[k]), group_names_[g], reasons[k]});
    models_.push_back({std::move(without.procrustes), std::move(without.model)});
  }

  void measure_all() {
    std::size_t fewest_shapes = build_.shapes.size();
    for (const AlignedModel& model : models_)
      fewest_shapes = std::min(fewest_shapes, model.alignment.aligned.size());
    std::vector<std::size_t> entered;
    for (std::size_t i = 0; i < refitted_.size(); ++i)
      if (refitted_[i]) {
        entered.push_back(i);
        result_.names.push_back(build_.shapes[i].input.stem);
      }
    const std::vector<int> counts = mode_counts(static_cast<int>(fewest_shapes) - 1);
    std::vector<std::vector<ShapeError>> errors(entered.size());
    parallel_for(static_cast<int>(entered.size()), ctx_, [&](int k) {
      const std::size_t i = entered[static_cast<std::size_t>(k)];
      errors[static_cast<std::size_t>(k)] =
          unseen_errors(refitted_[i]->landmarks, build_.shapes[i].input.mesh, models_[refitted_[i]->model],
                        counts, measure_);
    });
    result_.generalization = {measure_.leave_out, static_cast<int>(models_.size()),
                              over_shapes(errors, counts)};
  }

  const ModelBuild& build_;
  const BuildOptions& options_;
  const GeneralizationOptions& measure_;
  const RunContext& ctx_;
  std::vector<std::vector<int>> groups_;
  std::vector<std::string> group_names_;
  std::vector<AlignedModel> models_;
  std::vector<std::optional<Refitted>> refitted_;  // unset: failed
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
    else if (input.stem == options.reference)
      others_options.reference = "auto";
  }
  return build_model(std::move(others), others_options, ctx);
}

std::vector<Vec3> landmarks_on_unseen(const Mesh& shape, const ModelBuild& build, const BuildOptions& options,
                                      const RunContext& ctx) {
  if (options.method == Method::icp) return landmarks_by_icp(shape, build, ctx);
  const RegisteredShape registered =
      options.objective == Objective::surface
          ? register_to_group(shape, build.reference_map, build.group_template, ctx, options.group)
          : register_shape(shape, build.reference_map, ctx, options.registration);
  return lift_to_surface(TorusLocator(shape, registered.shape_map.map), build.landmarks.turns);
}

RefitGeneralization refit_generalization(const ModelBuild& build, const std::vector<std::string>& subjects,
                                         const BuildOptions& options, const GeneralizationOptions& measure,
                                         const RunContext& ctx) {
  return Refit(build, subjects, options, measure, ctx).run();
}

}  // namespace foramen
