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
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "match/robust_weight.hpp"

namespace foramen {
namespace {

// The search for the loops of a reference takes seconds at this size and grows faster than its power 3/2.
constexpr int large_reference_vertices = 100000;

// A reference with a smaller share of the median number of vertices has too few for its loops to be carried
// to the others reliably.
constexpr double coarse_reference_share = 0.25;

// Another reference is tried if more than one in so many shapes cannot be registered.
constexpr std::size_t shapes_per_lost_one = 20;
constexpr int most_references = 3;

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
};

// Maps the first of the candidates that can be mapped and removes it and those before it from the list. A
// valid surface may be too rough for a map, and this must not make the whole cohort fail.
MappedReference map_next_reference(std::span<const Shape> shapes, std::vector<int>& candidates,
                                   std::vector<FailedShape>& refused, const CorrespondOptions& options,
                                   const RunContext& ctx) {
  while (!candidates.empty()) {
    const int candidate = candidates.front();
    candidates.erase(candidates.begin());
    const Shape& shape = shapes[candidate];
    try {
      RegisterOptions how = options.registration;
      how.neighbours = {};  // they do not affect the reference
      return {candidate, kept<Reference>(ctx, StageKey(ctx, "reference", shape.mesh, how),
                                         [&] { return map_reference(shape.mesh, ctx, how); })};
    } catch (const ConvergenceError& e) {
      refused.push_back({shape.name, message_of(e)});
    }
  }
  const FailedShape& last = refused.back();
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

struct RegisteredCohort {
  MappedReference mapped;
  GroupRegistration group;
  double reference_seconds = 0;
  std::size_t lost = 0;  // shapes that could not be registered; all of them if the reference is one
};

RegisteredCohort registered_with_next(std::span<const Shape> shapes, std::vector<int>& candidates,
                                      std::vector<FailedShape>& refused, const CorrespondOptions& options,
                                      const RunContext& ctx) {
  const auto start = std::chrono::steady_clock::now();
  RegisteredCohort cohort;
  cohort.mapped = map_next_reference(shapes, candidates, refused, options, ctx);
  return_freed_memory();
  cohort.reference_seconds = seconds_since(start);
  cohort.group = register_all(shapes, cohort.mapped, options, ctx);
  const auto is_lost = [](const GroupMember& member) { return !member.registered; };
  cohort.lost = std::count_if(cohort.group.members.begin(), cohort.group.members.end(), is_lost);
  if (is_lost(cohort.group.members[cohort.mapped.shape])) cohort.lost = shapes.size();
  return cohort;
}

// Registers the shapes with the first reference by which few are lost, or with the one of those tried by
// which the fewest are.
RegisteredCohort register_with_best_reference(std::span<const Shape> shapes, const CorrespondOptions& options,
                                              std::vector<FailedShape>& refused, const RunContext& ctx) {
  std::vector<int> candidates = reference_candidates(shapes, options.reference);
  RegisteredCohort best = registered_with_next(shapes, candidates, refused, options, ctx);
  for (int tried = 1; tried < most_references && best.lost * shapes_per_lost_one > shapes.size(); ++tried) {
    RegisteredCohort other;
    std::vector<FailedShape> refused_now;
    if (candidates.empty()) break;
    try {
      other = registered_with_next(shapes, candidates, refused_now, options, ctx);
    } catch (const ConvergenceError&) {
      break;  // none of the other shapes can be the reference
    }
    if (other.lost >= best.lost) continue;
    refused.push_back({shapes[best.mapped.shape].name,
                       Message(std::to_string(best.lost) + " of " + std::to_string(shapes.size()) +
                               " shapes could not be registered with it")});
    refused.insert(refused.end(), refused_now.begin(), refused_now.end());
    best = std::move(other);
  }
  return best;
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
  std::vector<double> areas, volumes, vertices;
  for (const Shape& shape : shapes) {
    areas.push_back(std::log(total_area(shape.mesh)));
    volumes.push_back(std::log(signed_volume(shape.mesh)));
    vertices.push_back(shape.mesh.vertex_count());
  }
  const double area = upper_median(areas), volume = upper_median(volumes);
  const double few = coarse_reference_share * upper_median(vertices);
  std::vector<std::tuple<bool, bool, double, int>> deviations;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    deviations.emplace_back(shapes[i].mesh.vertex_count() > large_reference_vertices,
                            shapes[i].mesh.vertex_count() < few,
                            std::abs(areas[i] - area) + std::abs(volumes[i] - volume), static_cast<int>(i));
  std::sort(deviations.begin(), deviations.end());
  std::vector<int> order;
  for (const auto& [large, coarse, deviation, shape] : deviations) order.push_back(shape);
  return order;
}

Correspondence correspond(std::span<const Shape> shapes, const CorrespondOptions& options,
                          const RunContext& ctx) {
  check_options("correspond", options);
  require_enough(shapes.size(), {});
  ctx.step("reference", 0);
  std::vector<FailedShape> refused;
  auto [mapped, group, reference_seconds, lost] = register_with_best_reference(shapes, options, refused, ctx);
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
  cohort.refused_references = std::move(refused);
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
