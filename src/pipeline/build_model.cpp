#include "foramen/pipeline/build_model.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/freed_memory.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/parallel.hpp"
#include "foramen/core/stage_store.hpp"
#include "correspond/registered_archive.hpp"
#include "pipeline/place_landmarks.hpp"

namespace foramen {
namespace {

constexpr int fewest_shapes = 3;
// The search for a reference's loops takes seconds at this size and grows with more than the square root of
// the cube.
constexpr int large_reference_vertices = 100000;
constexpr double least_variation_mm = 1e-5;  // of a landmark; rounding of coordinates in files is as large

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Runs one stage, notes how long it took, and holds no memory that it has freed.
template <class Stage>
void timed(ModelBuild& build, const char* name, const Stage& stage) {
  const Stopwatch watch;
  stage();
  return_freed_memory();
  build.stage_seconds.emplace_back(name, watch.seconds());
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void require_enough(const std::vector<LeftOut>& left_out, std::size_t usable) {
  if (usable >= fewest_shapes) return;
  std::string message = "a model needs at least " + std::to_string(fewest_shapes) + " usable shapes, found " +
                        std::to_string(usable);
  for (const LeftOut& shape : left_out) message += "\n  left out " + source_of(shape) + ": " + shape.reason;
  throw InvalidInput(message);
}

// Those to try, in order.
std::vector<int> reference_candidates(const std::vector<InputShape>& shapes, const std::string& name) {
  if (name == "auto") return rank_references(shapes);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (shapes[i].stem == name || source_of(shapes[i]) == name) return {static_cast<int>(i)};
  throw InvalidInput("--reference " + name + ": no usable input has this name");
}

// Maps the first candidate that can be mapped, and returns which. A surface that is usable as such may be too
// ragged for a map, and the cohort must not fail for it.
int map_first_reference(ModelBuild& build, const std::vector<InputShape>& shapes,
                        const CorrespondOptions& options, const RunContext& ctx) {
  const auto candidates = reference_candidates(shapes, options.reference);
  for (std::size_t c = 0;; ++c) {
    const InputShape& shape = shapes[static_cast<std::size_t>(candidates[c])];
    try {
      build.reference_map = kept<Reference>(ctx, "reference " + shape.stem, [&] {
        return map_reference(shape.mesh, ctx, options.registration);
      });
      return candidates[c];
    } catch (const ConvergenceError& e) {
      const std::string reason = source_of(shape) + " cannot be the reference: " + e.what();
      if (c + 1 == candidates.size()) throw ConvergenceError(reason);
      build.notes.push_back(reason);
    }
  }
}

RegisteredShape reference_itself(const Reference& reference) {
  RegisteredShape self;
  self.alignment.converged = true;
  self.shape_map = reference.shape_map;
  self.homology = Eigen::Matrix2i::Identity();
  self.seifert = reference.loops.seifert;
  self.agreement = Vec2::Ones();
  return self;
}

RegisteredShape only_aligned(const Mesh& shape, const Reference& reference, const RunContext& ctx) {
  RegisteredShape result;
  result.alignment = align(shape, reference.mesh(), ctx);
  return result;
}

struct Registrations {
  std::vector<ShapeOutcome> outcomes;
  std::vector<std::string> failures;  // empty: none
};

Registrations register_each(const ModelBuild& build, std::vector<InputShape> inputs, int reference,
                            const CorrespondOptions& options, const RunContext& ctx) {
  std::vector<ShapeOutcome> outcomes(inputs.size());
  std::vector<std::string> failures(inputs.size());
  // A thread pool inside a thread pool gains nothing here, and one shape at a time keeps the memory low.
  const RunContext single = ctx.with_threads(1);
  std::atomic<int> done{0};
  parallel_for(static_cast<int>(inputs.size()), ctx, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    ShapeOutcome& outcome = outcomes[k];
    outcome.input = std::move(inputs[k]);
    const Stopwatch watch;
    try {
      const Mesh& mesh = outcome.input.mesh;
      if (i == reference)
        outcome.registration = reference_itself(build.reference_map);
      else
        outcome.registration = kept<RegisteredShape>(ctx, "register " + std::to_string(i), [&] {
          return options.method == Method::icp
                     ? only_aligned(mesh, build.reference_map, single)
                     : register_shape(mesh, build.reference_map, single, options.registration);
        });
    } catch (const Cancelled&) {
      throw;
    } catch (const std::exception& e) {  // a defect of ours, too, must not cost the other shapes
      failures[k] = e.what();
    }
    outcome.seconds = watch.seconds();
    ctx.step("register", static_cast<double>(++done) / static_cast<double>(outcomes.size()),
             outcome.input.stem);
  });
  return {std::move(outcomes), std::move(failures)};
}

Registrations register_together(ModelBuild& build, std::vector<InputShape> inputs, int reference,
                                const CorrespondOptions& options, const RunContext& ctx) {
  std::vector<Mesh> meshes;
  for (const InputShape& input : inputs) meshes.push_back(input.mesh);
  GroupRegistration group = register_group(meshes, build.reference_map, reference, ctx, options.group);
  Registrations result{std::vector<ShapeOutcome>(inputs.size()), {}};
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    GroupMember& member = group.members[k];
    ShapeOutcome& outcome = result.outcomes[k];
    outcome.input = std::move(inputs[k]);
    outcome.seconds = member.seconds;
    if (member.registered) outcome.registration = std::move(*member.registered);
    result.failures.push_back(std::move(member.failure));
  }
  build.template_motion_mm = std::move(group.template_motion_mm);
  build.unexplained_shares = std::move(group.unexplained_shares);
  build.description_lengths = std::move(group.description_lengths);
  build.group_template = std::move(group.last_template);
  return result;
}

// Registers every shape; those that fail are moved to the ones left out.
void register_all(ModelBuild& build, std::vector<InputShape> inputs, int reference,
                  const CorrespondOptions& options, const RunContext& ctx) {
  auto [outcomes, failures] =
      (registered_together(options) ? register_together(build, std::move(inputs), reference, options, ctx)
                                    : register_each(build, std::move(inputs), reference, options, ctx));
  if (!failures[static_cast<std::size_t>(reference)].empty())
    throw ConvergenceError("the reference " + source_of(outcomes[static_cast<std::size_t>(reference)].input) +
                           " cannot be registered with the mean of all shapes (" +
                           failures[static_cast<std::size_t>(reference)] +
                           "); name another with --reference");
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    InputShape& input = outcomes[k].input;
    if (!failures[k].empty()) {
      build.left_out.push_back({input.stem, input.file_name, input.sha256, failures[k], input.label});
      continue;
    }
    if (static_cast<int>(k) == reference) {
      build.reference = static_cast<int>(build.shapes.size());
      build.reference_map.shape_map = outcomes[k].registration.shape_map;
    }
    build.shapes.push_back(std::move(outcomes[k]));
  }
  require_enough(build.left_out, build.shapes.size());
}

std::vector<std::vector<Vec3>> corresponding_shapes(const ModelBuild& build) {
  std::vector<std::vector<Vec3>> shapes;
  for (const ShapeOutcome& shape : build.shapes) shapes.push_back(shape.landmarks);
  return shapes;
}

}  // namespace

bool registered_together(const CorrespondOptions& options) {
  return options.method == Method::torus && options.objective == Objective::surface;
}

std::vector<int> rank_references(const std::vector<InputShape>& shapes) {
  std::vector<double> areas, volumes;
  for (const InputShape& shape : shapes) {
    areas.push_back(std::log(total_area(shape.mesh)));
    volumes.push_back(std::log(signed_volume(shape.mesh)));
  }
  const double area = median(areas), volume = median(volumes);
  std::vector<std::tuple<bool, double, int>> deviations;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    deviations.emplace_back(shapes[i].mesh.vertex_count() > large_reference_vertices,
                            std::abs(areas[i] - area) + std::abs(volumes[i] - volume), static_cast<int>(i));
  std::sort(deviations.begin(), deviations.end());
  std::vector<int> order;
  for (const auto& [large, deviation, shape] : deviations) order.push_back(shape);
  return order;
}

ModelBuild build_model(Cohort cohort, const BuildOptions& options, const RunContext& ctx) {
  ModelBuild build;
  build.left_out = std::move(cohort.left_out);
  require_enough(build.left_out, cohort.shapes.size());
  int reference = 0;
  timed(build, "reference", [&] {
    ctx.step("reference", 0);
    reference = map_first_reference(build, cohort.shapes, options.correspondence, ctx);
  });
  timed(build, "register",
        [&] { register_all(build, std::move(cohort.shapes), reference, options.correspondence, ctx); });
  timed(build, "resample", [&] {
    ctx.step("resample", 0);
    if (options.correspondence.method == Method::torus)
      place_landmarks(build, options.landmarks, ctx);
    else
      place_landmarks_by_icp(build, options.landmarks, ctx);
  });
  timed(build, "model", [&] {
    ctx.step("model", 0);
    const auto shapes = corresponding_shapes(build);
    const auto& triangles = build.landmarks.triangles;
    std::vector<double> weights =
        landmark_weights(shapes, triangles, options.model.scale, options.model.weights);
    build.procrustes = procrustes(shapes, options.model.scale, weights);
    build.model = build_shape_model(build.procrustes.aligned, triangles, std::move(weights));
    if (std::sqrt(build.model.variance().sum() / build.model.total_weight()) < least_variation_mm)
      throw InvalidInput(
          "all shapes are the same but for their position: there is no variation to make a model of; are "
          "they "
          "copies of one file?");
  });
  return build;
}

}  // namespace foramen
