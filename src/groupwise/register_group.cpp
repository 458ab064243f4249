#include "foramen/groupwise/register_group.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/parallel.hpp"
#include "foramen/groupwise/description_objective.hpp"
#include "foramen/groupwise/template_metric.hpp"
#include "foramen/parameterize/refine_map.hpp"
#include "foramen/simplify/working_mesh.hpp"
#include "foramen/spatial/point_index.hpp"

namespace foramen {
namespace {

/// A template with what every shape needs of it, made once a round.
struct PreparedTemplate {
  TemplateSurface surface;
  TemplateMetric metric;
  Eigen::MatrixXd displacements;

  PreparedTemplate(TemplateSurface made, const RegisterGroupOptions& options)
      : surface(std::move(made)),
        metric(surface),
        displacements(options.bending == Bending::smooth
                          ? smooth_displacements(surface.mesh.positions(), options.displacements)
                          : Eigen::MatrixXd()) {}
};

/// A shape on its way. Meshes in the shape's own coordinates.
struct Member {
  const Mesh* input = nullptr;
  RegisteredShape result;
  WorkingMesh working;
  OptimisedMap map;  // of the working mesh
  RigidTransform to_template = RigidTransform::Identity();
  std::vector<Vec3> bent;       // the template's vertices bent onto the shape, in template coordinates
  std::vector<Vec3> attractor;  // the same for what the description length draws it to; empty: bent serves
};

RigidTransform rigid(const SimilarityTransform& transform) {
  RigidTransform out = RigidTransform::Identity();
  out.linear() = transform.rotation;
  out.translation() = transform.translation;
  return out;
}

// Where the shape would lie if the bending were undone: every vertex moved back by the displacement of the
// bent template's nearest vertex.
Mesh bent_back(const Mesh& shape, const TemplateSurface& surface, const std::vector<Vec3>& bent) {
  const auto normals = vertex_normals(shape);
  const auto bent_normals = vertex_normals(surface.mesh.with_positions(bent));
  const OrientedPointIndex index(bent, bent_normals.values(), vertebra_normal_weight_mm);
  std::vector<Vec3> positions;
  positions.reserve(bent.size());
  for (VertexId v : shape.vertices()) {
    const int near = index.nearest(shape.position(v), normals[v]).index;
    positions.push_back(shape.position(v) + surface.mesh.position(VertexId(near)) -
                        bent[static_cast<std::size_t>(near)]);
  }
  return shape.with_positions(std::move(positions));
}

class GroupRegistrar {
 public:
  GroupRegistrar(const std::vector<Mesh>& shapes, const Reference& reference, int reference_index,
                 const RunContext& ctx, const RegisterGroupOptions& options)
      : reference_(reference),
        reference_index_(reference_index),
        ctx_(ctx),
        single_(ctx.with_threads(1)),
        options_(options),
        members_(shapes.size()) {
    for (std::size_t i = 0; i < shapes.size(); ++i) members_[i].input = &shapes[i];
    result_.members.resize(shapes.size());
  }

  GroupRegistration run() {
    PreparedTemplate first(
        remeshed_template(reference_.mesh(), reference_.shape_map.map, options_.mean.vertices, ctx_),
        options_);
    for_each_member("register", [&](int i) { begin(i, first); });
    const PreparedTemplate* last = &first;
    std::unique_ptr<PreparedTemplate> mean;
    std::vector<Vec3> grid;
    for (int round = 0; round < options_.round_limit; ++round) {
      MeanTemplate next = next_mean();
      const double motion =
          grid.empty() ? std::numeric_limits<double>::infinity() : distance_of_means(grid, next.grid);
      grid = std::move(next.grid);
      if (round > 0) result_.template_motion_mm.push_back(motion);
      if (motion < options_.still_mm) break;
      mean = std::make_unique<PreparedTemplate>(std::move(next.surface), options_);
      last = mean.get();
      for_each_member("round " + std::to_string(round + 1), [&](int i) { again(i, *mean); });
    }
    for (int round = 0; round < options_.description_rounds; ++round) {
      describe(*last);
      for_each_member("describe " + std::to_string(round + 1), [&](int i) {
        Member& member = members_[static_cast<std::size_t>(i)];
        improve(member, transformed(member.working.mesh, member.to_template), *last);
      });
    }
    if (options_.description_rounds > 0) describe(*last);
    for_each_member("finish", [&](int i) { finish(i, *last); });
    for (std::size_t i = 0; i < members_.size(); ++i)
      if (result_.members[i].failure.empty()) result_.members[i].registered = std::move(members_[i].result);
    return std::move(result_);
  }

 private:
  // One shape at a time on each thread: a thread pool inside a thread pool gains nothing here.
  void for_each_member(const std::string& stage, const std::function<void(int)>& body) {
    std::atomic<int> done{0};
    parallel_for(static_cast<int>(members_.size()), ctx_, [&](int i) {
      GroupMember& member = result_.members[static_cast<std::size_t>(i)];
      if (!member.failure.empty()) return;
      const auto start = std::chrono::steady_clock::now();
      try {
        body(i);
      } catch (const Cancelled&) {
        throw;
      } catch (const Error& e) {
        member.failure = e.what();
      }
      member.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      ctx_.step(stage, static_cast<double>(++done) / static_cast<double>(members_.size()));
    });
  }

  OptimiseMapOptions optimise_options() const {
    return {.lambda = options_.lambda,
            .relative_tolerance = options_.relative_tolerance,
            .iteration_limit = options_.iteration_limit};
  }

  void begin(int i, const PreparedTemplate& to) {
    Member& member = members_[static_cast<std::size_t>(i)];
    RegisteredShape& result = member.result;
    if (i == reference_index_)
      result.alignment.converged = true;  // the identity
    else
      result.alignment = align(*member.input, reference_.mesh(), single_);
    member.to_template = result.alignment.transform;
    member.working = simplify(*member.input, single_, {.target_vertices = options_.working_vertices});
    const Mesh aligned = transformed(member.working.mesh, member.to_template);
    member.bent = bent_onto(aligned, to, options_.first, {});

    const Mesh carried = bent_back(aligned, to.surface, member.bent);
    FirstMap first = first_map(carried, aligned, reference_.loops, options_.initial_map, options_.edge_cost);
    result.homology = first.homology;
    result.seifert = first.seifert;
    first.map.lattice = to.surface.map.lattice;
    member.map.map =
        translated_onto(std::move(first.map), carried, reference_.mesh(), reference_.shape_map.map);
    const auto targets = objective(member, aligned, to);
    // The metric means nothing yet where the vertices are still far from their targets.
    member.map = optimise_map(aligned, member.map.map, single_, optimise_options(), targets.get());
    const double energy = member.map.initial_energy;
    improve(member, aligned, to);
    member.map.initial_energy = energy;
  }

  void again(int i, const PreparedTemplate& to) {
    Member& member = members_[static_cast<std::size_t>(i)];
    const Mesh aligned = transformed(member.working.mesh, member.to_template);
    // Corresponding points are where the last round left them.
    const TorusLocator locator(member.working.mesh, member.map.map);
    const auto start =
        transformed(lift_to_surface(locator, to.surface.map.turns.values()), member.to_template);
    member.bent = bent_onto(aligned, to, options_.again, start);
    improve(member, aligned, to);
  }

  std::vector<Vec3> bent_onto(const Mesh& aligned, const PreparedTemplate& to,
                              const DeformTemplateOptions& how, std::span<const Vec3> start) const {
    if (options_.bending == Bending::rigid)
      return {to.surface.mesh.positions().begin(), to.surface.mesh.positions().end()};
    return deform_template(to.surface.mesh, to.displacements, aligned, single_, how, start);
  }

  OptimisedMap optimised(const Mesh& aligned, const TorusMap& start, const PreparedTemplate& to,
                         const CorrespondenceObjective& pull) const {
    const std::optional<TargetMetric> metric = options_.distortion == DistortionMeasure::on_template
                                                   ? std::optional(to.metric.at(aligned, start))
                                                   : std::nullopt;
    return optimise_map(aligned, start, single_, optimise_options(), &pull, metric ? &*metric : nullptr);
  }

  std::unique_ptr<CorrespondenceObjective> objective(const Member& member, const Mesh& aligned,
                                                     const PreparedTemplate& to) const {
    if (!member.attractor.empty())
      return std::make_unique<DescriptionObjective>(aligned, to.metric.locator(), to.surface.map,
                                                    member.attractor);
    return std::make_unique<SurfaceTargets>(aligned, to.surface, to.metric.tensors(), member.bent,
                                            options_.targets);
  }

  void improve(Member& member, const Mesh& aligned, const PreparedTemplate& to) {
    const auto pull = objective(member, aligned, to);
    for (int k = 0; k < options_.metric_updates; ++k) {
      const int before = member.map.iterations;
      member.map = optimised(aligned, member.map.map, to, *pull);
      member.map.iterations += before;
    }
    require_converged(member.map, "working");
  }

  MeanTemplate next_mean() {
    std::vector<std::unique_ptr<TorusLocator>> locators(members_.size());
    for_each_member("mean", [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      locators[k] = std::make_unique<TorusLocator>(members_[k].working.mesh, members_[k].map.map);
    });
    std::vector<const TorusLocator*> present;
    std::vector<Member*> owners;
    for (std::size_t i = 0; i < members_.size(); ++i)
      if (locators[i]) {
        present.push_back(locators[i].get());
        owners.push_back(&members_[i]);
      }
    MeanTemplate mean = mean_template(present, reference_.shape_map.map.lattice, ctx_, options_.mean);
    for (std::size_t k = 0; k < owners.size(); ++k) owners[k]->to_template = rigid(mean.transforms[k]);
    return mean;
  }

  // The cohort as its maps have it now, and what its description length draws every shape to.
  void describe(const PreparedTemplate& to) {
    std::vector<std::vector<Vec3>> lifted;
    std::vector<Member*> owners;
    for (std::size_t i = 0; i < members_.size(); ++i) {
      if (!result_.members[i].failure.empty()) continue;
      const TorusLocator locator(members_[i].working.mesh, members_[i].map.map);
      lifted.push_back(lift_to_surface(locator, to.surface.map.turns.values()));
      owners.push_back(&members_[i]);
    }
    const std::vector<double> areas = vertex_areas(to.surface.mesh).values();
    const ProcrustesResult aligned = procrustes(lifted, ScaleMode::keep, areas);
    DescriptionLength length = description_length(aligned.aligned, areas, options_.description);
    result_.description_lengths.push_back(length.value);
    for (std::size_t k = 0; k < owners.size(); ++k) {
      owners[k]->to_template = rigid(aligned.transforms[k]);
      owners[k]->attractor = std::move(length.attractors[k]);
    }
  }

  static double distance_of_means(const std::vector<Vec3>& before, const std::vector<Vec3>& after) {
    const SimilarityTransform motion = fit_similarity(after, before, ScaleMode::keep);
    double squares = 0;
    for (std::size_t k = 0; k < before.size(); ++k) squares += (motion(after[k]) - before[k]).squaredNorm();
    return std::sqrt(squares / static_cast<double>(before.size()));
  }

  void finish(int i, const PreparedTemplate& to) {
    Member& member = members_[static_cast<std::size_t>(i)];
    const Mesh aligned = transformed(*member.input, member.to_template);
    const auto pull = objective(member, aligned, to);
    const TorusMap start = refine_map(*member.input, member.working, member.map.map);
    const OptimisedMap full = optimised(aligned, start, to, *pull);
    require_converged(full, "input");
    RegisteredShape& result = member.result;
    result.shape_map = certified(*member.input, member.map, full);
    const Mesh beside_reference = transformed(*member.input, result.alignment.transform);
    result.agreement =
        map_agreement(beside_reference, result.shape_map.map, reference_.mesh(), reference_.shape_map.map);
    if (result.agreement.minCoeff() <= 0)
      throw TopologyError(
          "the map of this shape runs against the reference's (the loops' directions disagree)");
  }

  const Reference& reference_;
  int reference_index_;
  RunContext ctx_, single_;
  const RegisterGroupOptions& options_;
  std::vector<Member> members_;
  GroupRegistration result_;
};

}  // namespace

GroupRegistration register_group(const std::vector<Mesh>& shapes, const Reference& reference,
                                 int reference_index, const RunContext& ctx,
                                 const RegisterGroupOptions& options) {
  FORAMEN_ASSERT(reference_index >= 0 && reference_index < static_cast<int>(shapes.size()));
  return GroupRegistrar(shapes, reference, reference_index, ctx, options).run();
}

}  // namespace foramen
