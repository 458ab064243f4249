#include "foramen/correspond/mean_registrar.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "correspond/cohort_prior.hpp"
#include "correspond/map_steps.hpp"
#include "correspond/member_steps.hpp"
#include "correspond/own_loops.hpp"
#include "correspond/subdivide.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {
namespace {

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
        reference(with_own_loops(fine.surface, ctx).reference),
        mean({fine.surface.mesh, reference.shape_map.map, fine.surface.curvatures}, options),
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
