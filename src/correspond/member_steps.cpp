#include "correspond/member_steps.hpp"

#include <optional>
#include <utility>

#include "correspond/description_objective.hpp"
#include "correspond/feature_targets.hpp"
#include "correspond/first_map.hpp"
#include "correspond/map_steps.hpp"
#include "correspond/register_shape.hpp"
#include "correspond/shape_map.hpp"
#include "correspond/surface_targets.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/match/bending_options.hpp"
#include "match/deform_template.hpp"
#include "match/oriented_points.hpp"
#include "match/smooth_displacements.hpp"
#include "parameterize/optimise_map.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {
namespace {

// The shape with the bending of the template undone: every vertex is moved back by the displacement of the
// nearest vertex of the bent template.
Mesh bent_back(const Mesh& shape, const TemplateSurface& surface, const std::vector<Vec3>& bent) {
  const VertexMap<VertexId> near = nearest_vertices(shape, surface.mesh.with_positions(bent));
  std::vector<Vec3> positions;
  positions.reserve(bent.size());
  for (VertexId v : shape.vertices())
    positions.push_back(shape.position(v) + surface.mesh.position(near[v]) - bent[near[v].index]);
  return shape.with_positions(std::move(positions));
}

}  // namespace

RigidTransform rigid(const SimilarityTransform& transform) {
  RigidTransform out = RigidTransform::Identity();
  out.linear() = transform.rotation;
  out.translation() = transform.translation;
  return out;
}

PreparedTemplate::PreparedTemplate(TemplateSurface made, const RegisterGroupOptions& options)
    : surface(std::move(made)),
      metric(surface),
      displacements(options.bending == Bending::rigid
                        ? Eigen::MatrixXd()
                        : smooth_displacements(surface.mesh.positions(), options.displacements)) {
  if (options.features.weight_mm2 > 0)
    features.emplace(surface, surface.curvatures.values().empty()
                                  ? curvature_features(surface.mesh, options.features)
                                  : surface.curvatures);
}

OptimiseMapOptions MemberSteps::optimise_options() const {
  return {.lambda = options_.lambda,
          .relative_tolerance = options_.relative_tolerance,
          .iteration_limit = options_.iteration_limit};
}

WorkingMesh MemberSteps::simplified(const Mesh& input) const {
  return simplify(input, single_, {.target_vertices = options_.working_vertices});
}

void MemberSteps::begin(Member& member, const Alignment& to_reference, const PreparedTemplate& to,
                        const DisplacementPrior& prior) const {
  RegisteredShape& result = member.result;
  result.alignment = to_reference;
  member.to_template = result.alignment.transform;
  const Mesh aligned = transformed(member.working.mesh, member.to_template);
  member.bent = bent_onto(aligned, to, options_.first, {}, prior);

  const Mesh carried = bent_back(aligned, to.surface, member.bent);
  FirstMap first = placed_first_map(carried, aligned, reference_, options_.initial_map, options_.edge_cost);
  result.homology = first.homology;
  result.seifert = first.seifert;
  member.map.map = std::move(first.map);
  const auto targets = objective(member, aligned, to);
  // The first optimisation measures distortion in the plane, because the metric of the template is not
  // meaningful while the vertices are far from their targets.
  member.map = optimise_map(aligned, member.map.map, single_, optimise_options(), targets.get());
  const double energy = member.map.initial_energy;
  // A ridge of the shape may still be near another ridge of the template than its own.
  improve(member, aligned, to, std::nullopt);
  member.map.initial_energy = energy;
}

void MemberSteps::place(Member& member, const PreparedTemplate& to) const {
  const TorusLocator locator(member.working.mesh, member.map.map);
  member.bent = transformed(lift_to_surface(locator, to.surface.map.turns.values()), member.to_template);
}

void MemberSteps::again(Member& member, const PreparedTemplate& to, const DisplacementPrior& prior) const {
  const Mesh aligned = transformed(member.working.mesh, member.to_template);
  member.bent = bent_onto(aligned, to, options_.again, member.bent, prior);
  improve(member, aligned, to);
}

void MemberSteps::newcomer_round(Member& member, std::span<const Vec2> turns,
                                 std::span<const Vec3> on_template, const PreparedTemplate& to,
                                 const DisplacementPrior& prior) const {
  const TorusLocator locator(member.working.mesh, member.map.map);
  const std::vector<Vec3> lifted = lift_to_surface(locator, turns);
  member.to_template = rigid(fit_similarity(lifted, on_template, ScaleMode::keep));
  place(member, to);
  again(member, to, prior);
}

std::vector<Vec3> MemberSteps::bent_onto(const Mesh& aligned, const PreparedTemplate& to,
                                         const DeformTemplateOptions& how, std::span<const Vec3> start,
                                         const DisplacementPrior& prior) const {
  if (options_.bending == Bending::rigid)
    return {to.surface.mesh.positions().begin(), to.surface.mesh.positions().end()};
  return deform_template(to.surface.mesh, to.displacements, aligned, single_, how, start, prior);
}

OptimisedMap MemberSteps::optimised(const Mesh& aligned, const TorusMap& start, const PreparedTemplate& to,
                                    const CorrespondenceObjective& pull,
                                    const VertexMap<Vec2>* features) const {
  const std::optional<TargetMetric> metric = options_.distortion == DistortionMeasure::on_template
                                                 ? std::optional(to.metric.at(aligned, start))
                                                 : std::nullopt;
  const auto by = [&](const CorrespondenceObjective& objective) {
    return optimise_map(aligned, start, single_, optimise_options(), &objective, metric ? &*metric : nullptr);
  };
  if (features == nullptr || !to.features) return by(pull);
  return by(FeatureTargets(pull, *features, start, *to.features, to.metric.locator(), options_.features));
}

std::optional<VertexMap<Vec2>> MemberSteps::features_of(const Member& member, const Mesh& aligned) const {
  if (options_.features.weight_mm2 <= 0 || !member.attractor.empty()) return std::nullopt;
  return curvature_features(aligned, options_.features);
}

std::unique_ptr<CorrespondenceObjective> MemberSteps::objective(const Member& member, const Mesh& aligned,
                                                                const PreparedTemplate& to) const {
  if (!member.attractor.empty())
    return std::make_unique<DescriptionObjective>(aligned, to.metric.locator(), to.surface.map,
                                                  member.attractor);
  return std::make_unique<SurfaceTargets>(aligned, to.surface, to.metric.tensors(), member.bent,
                                          options_.targets);
}

void MemberSteps::improve(Member& member, const Mesh& aligned, const PreparedTemplate& to) const {
  improve(member, aligned, to, features_of(member, aligned));
}

void MemberSteps::improve(Member& member, const Mesh& aligned, const PreparedTemplate& to,
                          const std::optional<VertexMap<Vec2>>& features) const {
  const auto pull = objective(member, aligned, to);
  for (int k = 0; k < options_.metric_updates; ++k) {
    const int before = member.map.iterations;
    member.map = optimised(aligned, member.map.map, to, *pull, features ? &*features : nullptr);
    member.map.iterations += before;
  }
  require_converged(member.map, "working");
}

void MemberSteps::finish(Member& member, const PreparedTemplate& to) const {
  const Mesh& input = *member.input;
  const Mesh aligned = transformed(input, member.to_template);
  const auto pull = objective(member, aligned, to);
  const auto features = features_of(member, aligned);
  RegisteredShape& result = member.result;
  result.shape_map = finished_map(input, member.working, member.map, [&](const TorusMap& start) {
    return optimised(aligned, start, to, *pull, features ? &*features : nullptr);
  });
  result.agreement =
      require_map_like_reference(input, result.alignment.transform, result.shape_map.map, reference_);
}

}  // namespace foramen
