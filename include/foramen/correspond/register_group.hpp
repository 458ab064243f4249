#pragma once
/// \file
/// Groupwise correspondence of a cohort: maps of all shapes to one torus, registered to a template that
/// becomes the mean.

#include <optional>
#include <string>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/correspond/cohort_prior.hpp"
#include "foramen/correspond/description_length.hpp"
#include "foramen/correspond/mean_template.hpp"
#include "foramen/correspond/register_shape.hpp"
#include "foramen/correspond/surface_targets.hpp"
#include "foramen/match/deform_template.hpp"
#include "foramen/match/smooth_displacements.hpp"

namespace foramen {

/// Where the distortion of a shape's map is measured.
enum class DistortionMeasure {
  on_template,  ///< of the map shape -> template: TemplateMetric
  in_plane,     ///< of the map shape -> flat torus
};
template <>
struct EnumWords<DistortionMeasure> {
  static constexpr std::pair<std::string_view, DistortionMeasure> all[] = {
      {"template", DistortionMeasure::on_template}, {"plane", DistortionMeasure::in_plane}};
};

/// How the template is deformed onto a shape before it gives targets for the shape's vertices.
enum class Bending {
  cohort,  ///< deform_template(). From the first round with a mean on, the prior of a shape's displacement is
           ///< learnt from the other shapes: cohort_priors().
  smooth,  ///< deform_template() with the smooth process as prior, independently for each shape
  rigid,   ///< the template is only aligned rigidly with the shape
};
template <>
struct EnumWords<Bending> {
  static constexpr std::pair<std::string_view, Bending> all[] = {
      {"cohort", Bending::cohort}, {"smooth", Bending::smooth}, {"rigid", Bending::rigid}};
};

struct RegisterGroupOptions {
  InitialMap initial_map = InitialMap::torus;
  EdgeCost edge_cost = EdgeCost::length_weighted;
  double lambda = 0.5;
  int working_vertices = 10000;
  double relative_tolerance = 1e-4;
  int iteration_limit = 200;
  TemplateOptions mean = {};
  DistortionMeasure distortion = DistortionMeasure::on_template;
  Bending bending = Bending::cohort;
  SmoothDisplacementOptions displacements = {};
  CohortPriorOptions cohort = {};
  DeformTemplateOptions first = {};
  DeformTemplateOptions again = {.noise_mm = {1, 0.5, 0.25}, .iterations = 2};
  SurfaceTargetsOptions targets = {};
  int metric_updates = 2;
  int round_limit = 4;
  /// Converged if the RMS motion of the mean is below this. With Bending::cohort there are at least two
  /// rounds.
  double still_mm = 0.15;
  int description_rounds = 0;
  DescriptionLengthOptions description = {};
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<RegisterGroupOptions> auto& o) {
  visit(o.lambda, {.name = "lambda",
                   .unit = "mm^2",
                   .range = above(0),
                   .meaning = "weight of distortion against the squared distance to the targets"});
  visit(o.initial_map, {.name = "initial_map", .meaning = "first map of a shape"});
  visit(o.edge_cost, {.name = "edge_cost", .meaning = "cost of an edge when loops are carried to a shape"});
  visit(o.distortion, {.name = "distortion",
                       .meaning = "where distortion is measured: on the template, or in the flat torus"});
  visit(o.bending,
        {.name = "bending",
         .meaning =
             "how the template is brought onto a shape: bent, with what the other shapes tell or each by "
             "itself, or only aligned"});
  visit(o.round_limit,
        {.name = "rounds",
         .range = at_least(0).up_to(100),
         .meaning = "most rounds with the mean as template; 0: the reference stays the template"});
  visit(o.still_mm, {.name = "still",
                     .unit = "mm",
                     .range = at_least(0),
                     .meaning = "RMS motion of the mean below which the rounds end"});
  visit(o.metric_updates,
        {.name = "metric_updates",
         .range = at_least(1),
         .meaning =
             "optimisations of a map in a round, each with the template's metric where the last one left the "
             "map"});
  visit(o.description_rounds,
        {.name = "description_rounds",
         .range = at_least(0),
         .meaning = "further rounds in which the description length of the cohort draws the maps"});
  visit(o.description, {.name = "description", .nesting = Nesting::prefixed});
  visit(o.mean, {.name = "template", .nesting = Nesting::prefixed});
  visit(o.displacements, {.name = "displacement", .nesting = Nesting::prefixed});
  visit(o.cohort, {.name = "cohort", .nesting = Nesting::prefixed});
  visit(o.first, {.name = "bending_first"});
  visit(o.again, {.name = "bending_again"});
  visit(o.targets, {.name = "targets", .nesting = Nesting::prefixed});
  visit(o.working_vertices, {.name = "working_vertices",
                             .range = at_least(16),
                             .meaning = "vertices of the simplified meshes that carry the search"});
  visit(o.relative_tolerance, {.name = "relative_tolerance",
                               .range = above(0),
                               .meaning = "relative decrease of the energy at which an optimisation stops"});
  visit(o.iteration_limit,
        {.name = "iteration_limit", .range = at_least(1), .meaning = "most iterations of an optimisation"});
}

/// The registration of one shape of a group.
struct GroupMember {
  std::optional<RegisteredShape> registered;  ///< unset: the shape was left out
  std::string failure;                        ///< why
  double seconds = 0;                         ///< computing time for this shape
};

/// The template of the last round, to which all shapes are registered.
struct GroupTemplate {
  /// Number of rounds with a mean as template; 0: only the reference was a template, and the fields below are
  /// empty.
  int rounds = 0;
  TemplateSurface surface;  ///< see MeanTemplate
  std::vector<Vec3> grid;   ///< see MeanTemplate
  DisplacementPrior prior;  ///< prior of the displacement onto a new shape, see CohortPriors
};

/// The registration of all shapes of a group.
struct GroupRegistration {
  std::vector<GroupMember> members;  ///< one per shape
  GroupTemplate last_template;
  std::vector<double> template_motion_mm;   ///< RMS motion of the mean between successive rounds
  std::vector<double> unexplained_shares;   ///< with Bending::cohort, one per round, see CohortPriors
  std::vector<double> description_lengths;  ///< before each of the description rounds, and after the last
};

/// Registers all shapes with each other, in three parts.
///
/// 1. Each shape is registered to the reference by itself. It is aligned rigidly, and the reference is bent
///    onto it (deform_template()). The reference's loops are transferred to the shape and give it a first map
///    (first_map()); for this, the bending is undone on the shape (its vertices are moved back). Then the map
///    is optimised: every vertex is attracted to its corresponding point on the reference (SurfaceTargets),
///    the distortion of the map shape -> reference is penalised, and no triangle is flipped.
/// 2. Rounds follow in which the Procrustes mean of all shapes is the template, so that the reference is a
///    shape like the others. In each round the template is bent and the map optimised again.
/// 3. Each map is extended to the input mesh of its shape, optimised there and certified. Its homology is
///    checked again (require_reference_homology()), and its direction is compared with that of the
///    reference's map (map_agreement()).
///
/// A shape that fails a check is left out with the reason, and the rest go on.
GroupRegistration register_group(const std::vector<Mesh>& shapes, const Reference& reference,
                                 int reference_index, const RunContext& ctx,
                                 const RegisterGroupOptions& options = {});

/// Registers one more shape to a group, which does not change. The steps are those of a member, but every
/// round uses the group's last template. There are as many rounds as the members had. Runs on one thread.
/// \param reference  the reference of the group, with its first or its final map
/// \param options  the options of the group
/// Throws TopologyError or ConvergenceError with the reason if any check fails; InvalidInput for
/// description_rounds > 0.
RegisteredShape register_to_group(const Mesh& shape, const Reference& reference, const GroupTemplate& group,
                                  const RunContext& ctx, const RegisterGroupOptions& options = {});

}  // namespace foramen
