#include "foramen/correspond/mean_registrar.hpp"

#include <utility>

#include "correspond/cohort_prior.hpp"
#include "correspond/map_steps.hpp"
#include "correspond/member_steps.hpp"
#include "correspond/propagate_loops.hpp"
#include "correspond/transfer_homology.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/group_options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "sampling/lift_to_surface.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

// The periods of the loops under the jumps of the map, one column per loop.
Eigen::Matrix2i periods(const TorusMap& map, const LoopSystem& loops) {
  const Cocycle form{map.jumps};
  Eigen::Matrix2i result;
  for (int k = 0; k < 2; ++k) result.col(k) = integrate(form, loops.loops[k]);
  return result;
}

Reference reference_of(const TemplateSurface& mean, const RunContext& ctx) {
  Reference reference{find_reference_loops(mean.mesh, ctx), {}};
  const Eigen::Matrix2i found = periods(mean.map, reference.loops.loops);
  reference.shape_map.map = change_basis(mean.map, inverse_unimodular(found));
  return reference;
}

}  // namespace

struct MeanRegistrar::Impl {
  RegisterGroupOptions options;
  Reference reference;
  PreparedTemplate mean;
  DisplacementPrior prior;

  Impl(const TemplateSurface& surface, std::span<const std::vector<Vec3>> training, const RunContext& ctx,
       const RegisterGroupOptions& how)
      : options(how),
        reference(reference_of(surface, ctx)),
        mean({surface.mesh, reference.shape_map.map}, options),
        prior(cohort_priors(surface.mesh, mean.displacements, training, options.cohort).of_newcomer()) {}
};

MeanRegistrar::MeanRegistrar(const TemplateSurface& mean, std::span<const std::vector<Vec3>> training,
                             const RunContext& ctx, const RegisterGroupOptions& options)
    : impl_(std::make_unique<Impl>(mean, training, ctx, options)) {}
MeanRegistrar::~MeanRegistrar() = default;
MeanRegistrar::MeanRegistrar(MeanRegistrar&&) noexcept = default;
MeanRegistrar& MeanRegistrar::operator=(MeanRegistrar&&) noexcept = default;

std::vector<Vec3> MeanRegistrar::landmarks_on(const Mesh& surface, const RunContext& ctx) const {
  require_genus_one(surface);
  const RunContext single = ctx.with_threads(1);
  const std::vector<Vec2>& landmarks = impl_->mean.surface.map.turns.values();
  const MemberSteps steps(impl_->reference, single, impl_->options);
  Member member;
  member.input = &surface;
  member.working = steps.simplified(surface);
  steps.begin(member, align(surface, impl_->reference.mesh(), single), impl_->mean, impl_->prior);
  // A round that starts from the landmarks that the map gives; the surface is aligned by them, as the
  // training shapes are.
  steps.newcomer_round(member, landmarks, impl_->reference.mesh().positions(), impl_->mean, impl_->prior);
  steps.finish(member, impl_->mean);
  return lift_to_surface(TorusLocator(surface, member.result.shape_map.map), landmarks);
}

}  // namespace foramen
