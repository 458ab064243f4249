#pragma once
/// \file
/// Correspondence of a whole cohort: every shape's map to one torus, through a template that becomes the
/// mean.

#include <optional>
#include <string>
#include <vector>

#include "foramen/correspond/register_shape.hpp"
#include "foramen/correspond/surface_targets.hpp"
#include "foramen/groupwise/cohort_prior.hpp"
#include "foramen/groupwise/description_length.hpp"
#include "foramen/groupwise/mean_template.hpp"
#include "foramen/match/deform_template.hpp"
#include "foramen/match/smooth_displacements.hpp"

namespace foramen {

/// Where the distortion of a shape's map is measured.
enum class DistortionMeasure {
  on_template,  ///< of the map shape -> template: TemplateMetric
  in_plane,     ///< of the map shape -> flat torus
};

/// How the template is brought onto a shape before targets are sought on it.
enum class Bending {
  cohort,  ///< deform_template(); from the first round with a mean on with what the other shapes tell:
           ///< cohort_priors()
  smooth,  ///< deform_template(), each shape by itself
  rigid,   ///< aligned only
};

struct RegisterGroupOptions {
  InitialMap initial_map = InitialMap::torus;
  EdgeCost edge_cost = EdgeCost::length_weighted;
  double lambda =
      0.5;  ///< Weight of distortion [mm^2]: E_target + lambda E_deg, both area-weighted means. > 0.
  int working_vertices = 10000;  ///< Of the meshes that carry the search.
  double relative_tolerance = 1e-4;
  int iteration_limit = 200;  ///< Of each optimisation.
  TemplateOptions mean = {};
  DistortionMeasure distortion = DistortionMeasure::on_template;
  Bending bending = Bending::cohort;
  SmoothDisplacementOptions displacements = {};
  CohortPriorOptions cohort = {};
  DeformTemplateOptions first = {};  ///< From the rigidly aligned template.
  DeformTemplateOptions again = {.noise_mm = {1, 0.5, 0.25}, .iterations = 2};  ///< From the last round's.
  SurfaceTargetsOptions targets = {};
  int metric_updates =
      2;                ///< Optimisations of a map in a round, each with the metric where the last left it.
  int round_limit = 4;  ///< Of rounds with the mean as template. >= 0.
  /// Rounds end when the mean moves by less than this (RMS) [mm]; with Bending::cohort after two at the
  /// earliest.
  double still_mm = 0.15;
  int description_rounds = 0;  ///< After those: rounds of all maps by description_length() instead. >= 0.
  DescriptionLengthOptions description = {};
};

struct GroupMember {
  std::optional<RegisteredShape> registered;  ///< unset: left out
  std::string failure;                        ///< why
  double seconds = 0;                         ///< of this shape alone
};

/// What the last round registered all shapes to.
struct GroupTemplate {
  int rounds = 0;           ///< with a mean as template; 0: the reference was the only one, the rest is empty
  TemplateSurface surface;  ///< see MeanTemplate
  std::vector<Vec3> grid;   ///< see MeanTemplate
  DisplacementPrior prior;  ///< of a newcomer's displacement: see CohortPriors
};

struct GroupRegistration {
  std::vector<GroupMember> members;  ///< one per shape
  GroupTemplate last_template;
  std::vector<double> template_motion_mm;   ///< RMS motion of the mean from round to round
  std::vector<double> unexplained_shares;   ///< with Bending::cohort, of every round: see CohortPriors
  std::vector<double> description_lengths;  ///< before each of the rounds by it, and after the last
};

/// Registers all shapes with each other.
///
/// First each shape by itself: rigid alignment to the reference, the reference bent onto it
/// (deform_template()), loops and first map by the reference's (first_map(), compared where the shape would
/// lie if it were bent back), and the map that brings every vertex to its place on the reference
/// (SurfaceTargets) with the least distortion of the map shape -> reference, without a flipped triangle. Then
/// rounds with the Procrustes mean of all shapes as template, so that no shape is the favourite. In the end
/// each map is carried to the shape's input mesh, optimised there and certified; its homology is checked anew
/// (require_reference_homology()) and its direction compared with the reference's (map_agreement()).
///
/// A shape that fails a check is left out, with the reason, and the rest go on. The reference is a shape like
/// the others once the mean is the template.
GroupRegistration register_group(const std::vector<Mesh>& shapes, const Reference& reference,
                                 int reference_index, const RunContext& ctx,
                                 const RegisterGroupOptions& options = {});

/// Registers one more shape to a group that stays as it is: as a member, but to the group's last template
/// only, for as many rounds as the members had. On one thread.
/// \param reference  the group's, with the map it was given or the one it has in the group
/// \param options  the group's
/// Throws TopologyError or ConvergenceError with the reason if any check fails; InvalidInput for
/// description_rounds > 0.
RegisteredShape register_to_group(const Mesh& shape, const Reference& reference, const GroupTemplate& group,
                                  const RunContext& ctx, const RegisterGroupOptions& options = {});

}  // namespace foramen
