#include "foramen/correspond/correspond.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "core/freed_memory.hpp"
#include "core/kept_results.hpp"
#include "core/parallel.hpp"
#include "correspond/register_group.hpp"
#include "correspond/register_shape.hpp"
#include "correspond/registered_archive.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/register_options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "match/robust_weight.hpp"

namespace foramen {
namespace {

// The search for the loops of a reference takes seconds at this size and grows faster than its power 3/2.
constexpr int large_reference_vertices = 100000;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void require_enough(std::size_t usable, std::span<const FailedShape> failed) {
  if (usable >= fewest_shapes) return;
  Message message("a model needs at least " + std::to_string(fewest_shapes) + " usable shapes, found " +
                  std::to_string(usable));
  for (const FailedShape& shape : failed) message.append(shape.reason.about("\n  left out " + shape.name));
  throw TooFewShapes(message);
}

// The shapes to try as reference, in order.
std::vector<int> reference_candidates(std::span<const Shape> shapes, const std::string& name) {
  if (name == "auto") return rank_references(shapes);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (shapes[i].name == name) return {static_cast<int>(i)};
  throw InvalidInput("the reference " + name +
                     ": no usable input has this name; give the name of one, or auto");
}

struct MappedReference {
  int shape = 0;
  Reference reference;
  std::vector<FailedShape> refused;
};

// The first candidate that can be mapped. A valid surface may be too rough for a map, and this must not make
// the whole cohort fail.
MappedReference map_first_reference(std::span<const Shape> shapes, const CorrespondOptions& options,
                                    const RunContext& ctx) {
  MappedReference found;
  for (const int candidate : reference_candidates(shapes, options.reference)) {
    const Shape& shape = shapes[candidate];
    try {
      RegisterOptions how = options.registration;
      how.neighbours = {};  // they do not affect the reference
      found.reference = kept<Reference>(ctx, StageKey(ctx, "reference", shape.mesh, how),
                                        [&] { return map_reference(shape.mesh, ctx, how); });
      found.shape = candidate;
      return found;
    } catch (const ConvergenceError& e) {
      found.refused.push_back({shape.name, message_of(e)});
    }
  }
  const FailedShape& last = found.refused.back();
  throw ConvergenceError(last.reason.about(last.name + " cannot be the reference"));
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

// Registers each shape with the reference, independently of the others.
GroupRegistration register_each(std::span<const Shape> shapes, const MappedReference& mapped,
                                const CorrespondOptions& options, const RunContext& ctx) {
  GroupRegistration result;
  result.members.resize(shapes.size());
  // Each shape is registered on one thread: nested parallel loops would not be faster, and this needs less
  // memory.
  const RunContext single = ctx.with_threads(1);
  const StageKey to_reference(ctx, "mapped reference", mapped.reference);
  std::atomic<int> done{0};
  parallel_for(static_cast<int>(shapes.size()), ctx, [&](int i) {
    const Shape& shape = shapes[i];
    GroupMember& member = result.members[i];
    const auto start = std::chrono::steady_clock::now();
    try {
      if (i == mapped.shape)
        member.registered = reference_itself(mapped.reference);
      else if (options.method == Method::icp)
        member.registered = kept<RegisteredShape>(ctx, StageKey(ctx, "align", shape.mesh, to_reference), [&] {
          return only_aligned(shape.mesh, mapped.reference, single);
        });
      else
        member.registered = kept<RegisteredShape>(
            ctx, StageKey(ctx, "register", shape.mesh, to_reference, options.registration),
            [&] { return register_shape(shape.mesh, mapped.reference, single, options.registration); });
    } catch (const Cancelled&) {
      throw;
    } catch (const std::exception& e) {  // a defect of foramen must not affect the other shapes either
      member.failure = message_of(e);
    }
    member.seconds = seconds_since(start);
    ctx.step("register", static_cast<double>(++done) / static_cast<double>(shapes.size()), shape.name);
  });
  return result;
}

GroupRegistration register_all(std::span<const Shape> shapes, const MappedReference& mapped,
                               const CorrespondOptions& options, const RunContext& ctx) {
  if (!registered_together(options)) return register_each(shapes, mapped, options, ctx);
  std::vector<Mesh> meshes;
  for (const Shape& shape : shapes) meshes.push_back(shape.mesh);
  return register_group(meshes, mapped.reference, mapped.shape, ctx, options.group);
}

ShapeRegistration registration_of(const std::string& name, const RegisteredShape& shape, bool mapped,
                                  double seconds) {
  const ShapeMap& map = shape.shape_map;
  return {.name = name,
          .alignment = shape.alignment,
          .mapped = mapped,
          .certificate = map.certificate,
          .iterations = map.iterations,
          .initial_energy = map.initial_energy,
          .final_energy = map.final_energy,
          .distortion = map.distortion,
          .homology = shape.homology,
          .seifert = shape.seifert,
          .agreement = shape.agreement,
          .seconds = seconds};
}

}  // namespace

bool registered_together(const CorrespondOptions& options) {
  return options.method == Method::torus && options.objective == Objective::surface;
}

std::vector<int> rank_references(std::span<const Shape> shapes) {
  std::vector<double> areas, volumes;
  for (const Shape& shape : shapes) {
    areas.push_back(std::log(total_area(shape.mesh)));
    volumes.push_back(std::log(signed_volume(shape.mesh)));
  }
  const double area = upper_median(areas), volume = upper_median(volumes);
  std::vector<std::tuple<bool, double, int>> deviations;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    deviations.emplace_back(shapes[i].mesh.vertex_count() > large_reference_vertices,
                            std::abs(areas[i] - area) + std::abs(volumes[i] - volume), static_cast<int>(i));
  std::sort(deviations.begin(), deviations.end());
  std::vector<int> order;
  for (const auto& [large, deviation, shape] : deviations) order.push_back(shape);
  return order;
}

Correspondence correspond(std::span<const Shape> shapes, const CorrespondOptions& options,
                          const RunContext& ctx) {
  check_options("correspond", options);
  require_enough(shapes.size(), {});
  ctx.step("reference", 0);
  const auto start = std::chrono::steady_clock::now();
  MappedReference mapped = map_first_reference(shapes, options, ctx);
  return_freed_memory();
  const double reference_seconds = seconds_since(start);
  GroupRegistration group = register_all(shapes, mapped, options, ctx);
  const Message& reference_failure = group.members[mapped.shape].failure;
  if (!reference_failure.text.empty())
    throw ConvergenceError("the reference " + shapes[mapped.shape].name +
                               " cannot be registered with the mean of all shapes (" +
                               reference_failure.text + "); name another reference",
                           reference_failure.remedies);

  Correspondence result;
  CohortRegistration& cohort = result.registration;
  cohort.method = options.method;
  cohort.reference_seconds = reference_seconds;
  cohort.refused_references = std::move(mapped.refused);
  cohort.frame.reference = std::move(mapped.reference);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    GroupMember& member = group.members[i];
    if (!member.registered) {
      cohort.failed.push_back({shapes[i].name, std::move(member.failure)});
      continue;
    }
    const bool is_reference = static_cast<int>(i) == mapped.shape;
    if (is_reference) {
      cohort.reference = static_cast<int>(cohort.shapes.size());
      cohort.frame.reference.shape_map = member.registered->shape_map;
    }
    cohort.shapes.push_back(registration_of(shapes[i].name, *member.registered,
                                            is_reference || options.method == Method::torus, member.seconds));
    result.maps.push_back(std::move(member.registered->shape_map.map));
  }
  require_enough(cohort.shapes.size(), cohort.failed);
  cohort.frame.group = std::move(group.last_template);
  cohort.template_motion_mm = std::move(group.template_motion_mm);
  cohort.unexplained_shares = std::move(group.unexplained_shares);
  cohort.description_lengths = std::move(group.description_lengths);
  return result;
}

}  // namespace foramen
