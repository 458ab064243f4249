#pragma once
/// \file
/// Correspondence of a whole cohort: every shape's map to one torus, through a template that becomes the
/// mean.

#include <optional>
#include <string>
#include <vector>

#include "correspond/cohort_prior.hpp"
#include "correspond/description_length.hpp"
#include "correspond/mean_template.hpp"
#include "correspond/register_shape.hpp"
#include "correspond/surface_targets.hpp"
#include "foramen/core/remedy.hpp"
#include "foramen/correspond/group_options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "match/deform_template.hpp"
#include "match/smooth_displacements.hpp"

namespace foramen {

struct GroupMember {
  std::optional<RegisteredShape> registered;  ///< unset: left out
  Message failure;                            ///< why; no text if it is registered
  double seconds = 0;                         ///< of this shape alone
};

struct GroupRegistration {
  std::vector<GroupMember> members;  ///< one per shape
  GroupTemplate last_template;
  std::vector<double> template_motion_mm;   ///< RMS motion of the mean from round to round
  std::vector<double> unexplained_shares;   ///< with Bending::cohort, of every round: see CohortPriors
  std::vector<double> description_lengths;  ///< before each of the rounds by it, and after the last
};

/// Registers all shapes with each other, in three parts.
///
/// 1. Each shape is registered to the reference by itself. It is aligned rigidly, and the reference is bent
///    onto it (deform_template()). The reference's loops are carried to the shape and give it a first map
///    (first_map()); for this, the shape is moved to where it would lie if the bending were undone. Then the
///    map is optimised: every vertex is drawn to its place on the reference (SurfaceTargets), the distortion
///    of the map shape -> reference is kept low, and no triangle is flipped.
/// 2. Rounds follow in which the Procrustes mean of all shapes is the template, so that the reference is a
///    shape like the others. In each round the template is bent and the map optimised again.
/// 3. Each map is carried to the input mesh of its shape, optimised there and certified. Its homology is
///    checked anew (require_reference_homology()), and its direction is compared with that of the reference's
///    map (map_agreement()).
///
/// A shape that fails a check is left out with the reason, and the rest go on.
GroupRegistration register_group(const std::vector<Mesh>& shapes, const Reference& reference,
                                 int reference_index, const RunContext& ctx,
                                 const RegisterGroupOptions& options = {});

/// Registers one more shape to a group, which does not change. The steps are those of a member, but every
/// round uses the group's last template. There are as many rounds as the members had. Runs on one thread.
/// \param reference  that of the group, with the map it was given or the one it ended with
/// \param options  those of the group
/// Throws TopologyError or ConvergenceError with the reason if any check fails; InvalidInput for
/// description_rounds > 0.
RegisteredShape register_to_group(const Mesh& shape, const Reference& reference, const GroupTemplate& group,
                                  const RunContext& ctx, const RegisterGroupOptions& options = {});

}  // namespace foramen
