#pragma once
/// \file
/// The steps of the registration of one shape of a group.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/kept_results.hpp"
#include "correspond/feature_targets.hpp"
#include "correspond/register_group.hpp"
#include "correspond/register_shape.hpp"
#include "correspond/template_metric.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/match/bending_options.hpp"
#include "parameterize/optimise_map.hpp"
#include "simplify/working_mesh.hpp"

namespace foramen {

/// A template with the data that all shapes need, computed once per round.
struct PreparedTemplate {
  TemplateSurface surface;
  TemplateMetric metric;
  std::optional<FeatureField> features;  // unset if they have no weight
  Eigen::MatrixXd displacements;

  PreparedTemplate(TemplateSurface made, const RegisterGroupOptions& options);
};

/// The state of a shape after a step. This is what a store keeps of the step.
struct MemberState {
  RegisteredShape result;
  OptimisedMap map;  // map of the working mesh
  RigidTransform to_template = RigidTransform::Identity();
  std::vector<Vec3> bent;  // the vertices of the template bent onto the shape, in template coordinates
};

/// A shape during registration. Its meshes are in the coordinates of the shape.
struct Member : MemberState {
  const Mesh* input = nullptr;
  WorkingMesh working;
  StageKey made_from;       // the key of its present state
  int place_in_priors = 0;  // index of the shape in the group's CohortPriors
  // Attractor of the description length, like `bent`; empty if `bent` gives the targets.
  std::vector<Vec3> attractor;
};

/// The rigid transform of a similarity of scale 1.
RigidTransform rigid(const SimilarityTransform& transform);

/// The steps of register_group() for one shape, on one thread. They know the other shapes only through the
/// template and the prior.
class MemberSteps {
 public:
  MemberSteps(const Reference& reference, const RunContext& ctx, const RegisterGroupOptions& options)
      : reference_(reference), single_(ctx.with_threads(1)), options_(options) {}

  WorkingMesh simplified(const Mesh& input) const;
  /// Computes the first map, starting from the rigid alignment with the reference, and optimises it towards
  /// the first template. \pre member.working is set
  /// \param prior  of the template's displacement onto the shape; the smooth process by default
  void begin(Member& member, const Alignment& to_reference, const PreparedTemplate& to,
             const DisplacementPrior& prior = {}) const;
  /// Places the vertices of another template at the corresponding points of the shape, which the map gives.
  /// \pre to_template is up to date
  void place(Member& member, const PreparedTemplate& to) const;
  /// Bends the template that was placed and optimises the map again.
  /// \param prior  of the template's displacement onto the shape
  void again(Member& member, const PreparedTemplate& to, const DisplacementPrior& prior) const;
  /// A round for a shape outside the group. The points of the shape at these torus positions are aligned with
  /// those of the template; then the template is placed and bent, and the map optimised again.
  void newcomer_round(Member& member, std::span<const Vec2> turns, std::span<const Vec3> on_template,
                      const PreparedTemplate& to, const DisplacementPrior& prior) const;
  /// Optimises the map only, towards the template as it was bent last or towards the attractor.
  void improve(Member& member, const Mesh& aligned, const PreparedTemplate& to) const;
  /// Carries the map from the working mesh to the input mesh, with all checks, and fills the result.
  void finish(Member& member, const PreparedTemplate& to) const;

 private:
  OptimiseMapOptions optimise_options() const;
  std::vector<Vec3> bent_onto(const Mesh& aligned, const PreparedTemplate& to,
                              const DeformTemplateOptions& how, std::span<const Vec3> start,
                              const DisplacementPrior& prior) const;
  /// Optimises a map, with the distortion measured as options.distortion says.
  /// \param features  of the shape, to agree with the template's; null: they do not matter
  OptimisedMap optimised(const Mesh& aligned, const TorusMap& start, const PreparedTemplate& to,
                         const CorrespondenceObjective& pull, const VertexMap<Vec2>* features) const;
  /// As improve(), with the features of the shape; unset: they do not matter.
  void improve(Member& member, const Mesh& aligned, const PreparedTemplate& to,
               const std::optional<VertexMap<Vec2>>& features) const;
  /// Of the shape; unset if they do not matter.
  std::optional<VertexMap<Vec2>> features_of(const Member& member, const Mesh& aligned) const;
  std::unique_ptr<CorrespondenceObjective> objective(const Member& member, const Mesh& aligned,
                                                     const PreparedTemplate& to) const;

  const Reference& reference_;
  RunContext single_;
  const RegisterGroupOptions& options_;
};

}  // namespace foramen
