#pragma once
/// \file
/// New surfaces registered to the mean of a finished model.

#include <memory>
#include <span>
#include <vector>

#include "foramen/correspond/register_group.hpp"

namespace foramen {

/// The mean of a model, with its landmarks' torus map, in the place of both reference and template: its loops
/// are found (shortest over all basepoints) and the map brought to their basis. Made once, for any number of
/// surfaces; const calls may run in parallel.
class MeanRegistrar {
 public:
  /// \param mean  landmarks and their map to the torus  \param training  the model's shapes in its own
  /// coordinates: what they tell of a newcomer's displacement, see CohortPriors::of_newcomer
  /// Throws TopologyError if the mean is not closed and of genus 1; InvalidInput for numbers that do not fit.
  MeanRegistrar(const TemplateSurface& mean, std::span<const std::vector<Vec3>> training,
                const RunContext& ctx, const RegisterGroupOptions& options = {});
  ~MeanRegistrar();
  MeanRegistrar(MeanRegistrar&&) noexcept;
  MeanRegistrar& operator=(MeanRegistrar&&) noexcept;

  /// Where a closed surface of genus 1, in any pose, has the landmarks, in its own coordinates. As a member
  /// of a group in register_group(): aligned, the mean bent onto it, loops and first map, one round with what
  /// the training shapes tell, the map carried to the surface itself, with all checks. On one thread. Throws
  /// TopologyError or ConvergenceError with the reason if any check fails.
  std::vector<Vec3> landmarks_on(const Mesh& surface, const RunContext& ctx) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace foramen
