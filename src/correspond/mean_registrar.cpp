#include "foramen/correspond/mean_registrar.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "correspond/cohort_prior.hpp"
#include "correspond/map_steps.hpp"
#include "correspond/member_steps.hpp"
#include "correspond/propagate_loops.hpp"
#include "correspond/subdivide.hpp"
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

// A coarser mean is subdivided: the loops of a mesh with so few vertices are coarse paths round thin parts,
// and its nearest vertices tell little about where a point belongs.
constexpr int fewest_vertices = 1000;

struct FineMean {
  TemplateSurface surface;
  std::vector<std::vector<Vec3>> training;
};

FineMean fine_enough(TemplateSurface surface, std::span<const std::vector<Vec3>> training) {
  FineMean mean{std::move(surface), {training.begin(), training.end()}};
  const auto fits = [&](const std::vector<Vec3>& shape) {
    return std::ssize(shape) == mean.surface.mesh.vertex_count();
  };
  if (!std::all_of(training.begin(), training.end(), fits)) return mean;  // cohort_priors() refuses them
  while (mean.surface.mesh.vertex_count() < fewest_vertices) {
    for (std::vector<Vec3>& shape : mean.training) shape = with_edge_midpoints(mean.surface.mesh, shape);
    mean.surface = subdivided(mean.surface);
  }
  return mean;
}

}  // namespace

struct MeanRegistrar::Impl {
  RegisterGroupOptions options;
  Reference reference;
  PreparedTemplate mean;
  DisplacementPrior prior;
  std::vector<Vec2> landmarks;  // torus positions, in the basis of the reference

  Impl(const FineMean& fine, int landmark_count, const RunContext& ctx, const RegisterGroupOptions& how)
      : options(how),
        reference(reference_of(fine.surface, ctx)),
        mean({fine.surface.mesh, reference.shape_map.map}, options),
        prior(cohort_priors(fine.surface.mesh, mean.displacements, fine.training, options.cohort)
                  .of_newcomer()) {
    const std::vector<Vec2>& turns = mean.surface.map.turns.values();
    landmarks.assign(turns.begin(), turns.begin() + landmark_count);
  }
};

MeanRegistrar::MeanRegistrar(const TemplateSurface& mean, std::span<const std::vector<Vec3>> training,
                             const RunContext& ctx, const RegisterGroupOptions& options)
    : impl_(std::make_unique<Impl>(fine_enough(mean, training), mean.mesh.vertex_count(), ctx, options)) {}
MeanRegistrar::~MeanRegistrar() = default;
MeanRegistrar::MeanRegistrar(MeanRegistrar&&) noexcept = default;
MeanRegistrar& MeanRegistrar::operator=(MeanRegistrar&&) noexcept = default;

std::vector<Vec3> MeanRegistrar::landmarks_on(const Mesh& surface, const RunContext& ctx) const {
  require_genus_one(surface);
  const RunContext single = ctx.with_threads(1);
  const std::vector<Vec2>& template_turns = impl_->mean.surface.map.turns.values();
  const MemberSteps steps(impl_->reference, single, impl_->options);
  Member member;
  member.input = &surface;
  member.working = steps.simplified(surface);
  steps.begin(member, align(surface, impl_->reference.mesh(), single), impl_->mean, impl_->prior);
  // A round that starts from the landmarks that the map gives; the surface is aligned by them, as the
  // training shapes are.
  steps.newcomer_round(member, template_turns, impl_->reference.mesh().positions(), impl_->mean,
                       impl_->prior);
  steps.finish(member, impl_->mean);
  return lift_to_surface(TorusLocator(surface, member.result.shape_map.map), impl_->landmarks);
}

}  // namespace foramen
