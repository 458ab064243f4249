#pragma once
/// \file
/// New surfaces registered to the mean of a finished model.

#include <memory>
#include <span>
#include <vector>

#include "foramen/correspond/register_group.hpp"

namespace foramen {

/// Registers surfaces to the mean of a model, which takes the place of both the reference and the template.
/// The shortest loops of the mean are found, and its torus map is expressed in their basis. One registrar
/// serves any number of surfaces; const calls may run in parallel.
class MeanRegistrar {
 public:
  /// \param mean  landmarks and their map to the torus  \param training  the model's shapes in its own
  /// coordinates, from which the prior of a new surface's displacement is learnt (CohortPriors::of_newcomer)
  /// Throws TopologyError if the mean is not closed and of genus 1; InvalidInput for numbers that do not fit.
  MeanRegistrar(const TemplateSurface& mean, std::span<const std::vector<Vec3>> training,
                const RunContext& ctx, const RegisterGroupOptions& options = {});
  ~MeanRegistrar();
  MeanRegistrar(MeanRegistrar&&) noexcept;
  MeanRegistrar& operator=(MeanRegistrar&&) noexcept;

  /// The landmarks on a closed surface of genus 1 in any pose, in the surface's own coordinates. The surface
  /// is registered as a member of a group is in register_group(), with one round and with all checks. Runs on
  /// one thread. Throws TopologyError or ConvergenceError with the reason if any check fails.
  std::vector<Vec3> landmarks_on(const Mesh& surface, const RunContext& ctx) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace foramen
