#pragma once
/// \file
/// Groupwise correspondence of a cohort: maps of all shapes to one torus, registered to a template that
/// becomes the mean.

#include <optional>
#include <string>
#include <vector>

#include "correspond/cohort_prior.hpp"
#include "correspond/description_length.hpp"
#include "correspond/mean_template.hpp"
#include "correspond/register_shape.hpp"
#include "correspond/surface_targets.hpp"
#include "foramen/core/remedy.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "match/deform_template.hpp"
#include "match/smooth_displacements.hpp"

namespace foramen {

/// The registration of one shape of a group.
struct GroupMember {
  std::optional<RegisteredShape> registered;  ///< unset: left out
  Message failure;                            ///< why; no text if it is registered
  double seconds = 0;                         ///< of this shape alone
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
///    the distortion of the map shape -> reference is penalised, and no triangle is flipped. A shape for
///    which this fails is registered in the same way to the mean of the others.
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
